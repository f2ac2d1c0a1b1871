// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "picture_comparison.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace scan_to_path::test_support {
namespace {

using Rgb = std::array<double, 3>;

constexpr double colour_tolerance = 24.0;  // of 255, distance in RGB: averaged edges and rounding

Rgb rgbOf(QRgb pixel) {
  return {static_cast<double>(qRed(pixel)), static_cast<double>(qGreen(pixel)), static_cast<double>(qBlue(pixel))};
}

double dot(const Rgb& a, const Rgb& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Rgb minus(const Rgb& a, const Rgb& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

double distanceToSegment(const Rgb& p, const Rgb& a, const Rgb& b) {
  const Rgb ab = minus(b, a);
  const Rgb ap = minus(p, a);
  const double length2 = dot(ab, ab);
  const double share = length2 > 0.0 ? std::clamp(dot(ap, ab) / length2, 0.0, 1.0) : 0.0;
  const Rgb off = minus(ap, {share * ab[0], share * ab[1], share * ab[2]});
  return std::sqrt(dot(off, off));
}

bool differs(QRgb a, QRgb b) {
  return std::abs(qRed(a) - qRed(b)) > channel_tolerance || std::abs(qGreen(a) - qGreen(b)) > channel_tolerance ||
         std::abs(qBlue(a) - qBlue(b)) > channel_tolerance;
}

std::string percent(double share) { return std::to_string(100.0 * share) + " %"; }

}  // namespace

int pixelsOf(const DisplayColour& colour, const QImage& picture) {
  const Rgb from = rgbOf(colour.from.rgb());
  const Rgb to = rgbOf(colour.to.rgb());
  int count = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      if (distanceToSegment(rgbOf(picture.pixel(x, y)), from, to) <= colour_tolerance) ++count;
    }
  }
  return count;
}

double differingShare(const QImage& golden, const QImage& picture) {
  if (golden.isNull() || golden.size() != picture.size()) return 1.0;
  int count = 0;
  for (int y = 0; y < golden.height(); ++y) {
    for (int x = 0; x < golden.width(); ++x) {
      if (differs(golden.pixel(x, y), picture.pixel(x, y))) ++count;
    }
  }
  return static_cast<double>(count) / (static_cast<double>(golden.width()) * golden.height());
}

std::vector<std::string> compare(const QImage& golden, const QImage& picture,
                                 const std::vector<DisplayColour>& displays) {
  std::vector<std::string> wrong;
  const double share = differingShare(golden, picture);
  if (share > differing_share) wrong.push_back(percent(share) + " of the pixels differ");
  for (const DisplayColour& colour : displays) {
    const int before = pixelsOf(colour, golden);
    const int now = pixelsOf(colour, picture);
    if (before < least_golden_pixels) {
      wrong.push_back(colour.display + " has only " + std::to_string(before) + " pixels in the golden picture");
    } else if (now < covered_share * before) {
      wrong.push_back(colour.display + " covers " + std::to_string(now) + " of " + std::to_string(before) + " pixels");
    }
  }
  return wrong;
}

}  // namespace scan_to_path::test_support
