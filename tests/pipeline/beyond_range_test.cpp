// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/beyond_range.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <optional>

namespace scan_to_path::pipeline {
namespace {

constexpr double range = 0.05;      // the sensor sees heights from 0 to this [m]
constexpr double spacing = 0.0005;  // of the samples along the rows [m]
constexpr double pitch = 0.004;     // of the rows [m]
constexpr double length = 0.1;      // of the rows [m], about x = 0

/// The part's height at (x, y); nothing where it has none.
using Part = std::function<std::optional<double>(double x, double y)>;

struct Scanned {
  scan::ScanCloud cloud;
  scan::SampleRows rows;
  scan::NoReturns no_returns;
};

/// Nine rows about y = 0, straight from above, by a sensor that tells what is too near or does not.
Scanned scanOf(const Part& part, bool tells_near) {
  Scanned scanned;
  scanned.rows.spacing = spacing;
  scanned.no_returns.range = range;
  for (int row = -4; row <= 4; ++row) {
    scan::RowPiece piece;
    piece.row = row + 4;
    for (double x = -0.5 * length; x < 0.5 * length; x += spacing) {
      const double y = pitch * row;
      const auto z = part(x, y);
      if (z && *z >= 0.0 && *z <= range) {
        piece.x.push_back(x);
        piece.y.push_back(y);
        piece.z.push_back(*z);
        piece.index.push_back(static_cast<std::uint32_t>(scanned.cloud.size()));
        scan::ScanPoint point;
        point.getVector3fMap() << static_cast<float>(x), static_cast<float>(y), static_cast<float>(*z);
        scanned.cloud.push_back(point);
      } else {
        const Eigen::Vector3f far_end(static_cast<float>(x), static_cast<float>(y), 0.0F);
        scanned.no_returns.beams.push_back({far_end, tells_near && z && *z > range});
      }
    }
    scanned.rows.pieces.push_back(piece);
  }
  return scanned;
}

BeyondRangeLengths lengthsOf(const Part& part, bool tells_near = true) {
  const Scanned scanned = scanOf(part, tells_near);
  return lengthsBeyondRange(scanned.cloud, scanned.rows, scanned.no_returns, pitch,
                            [](double x, double y) { return std::hypot(x, y) < 0.005; });
}

double sum(const BeyondRangeLengths& lengths) {
  return lengths.inside.too_near + lengths.inside.too_far + lengths.outside.too_near + lengths.outside.too_far;
}

// Patches are 4 mm long: each end of a stretch is known to one.
constexpr double patch = 0.004;

TEST(BeyondRange, APlaneThatLeavesTheRangeIsCutOffAtBothEnds) {
  const auto slope = [](double x, double) { return std::optional<double>(0.5 * range + x); };  // from -25 to 75 mm
  for (const bool tells_near : {true, false}) {
    const BeyondRangeLengths lengths = lengthsOf(slope, tells_near);
    EXPECT_NEAR(lengths.outside.too_near, 9 * 0.025, 9 * patch) << tells_near;
    EXPECT_NEAR(lengths.outside.too_far, 9 * 0.025, 9 * patch) << tells_near;
    EXPECT_EQ(lengths.inside.too_near + lengths.inside.too_far, 0.0);
  }
}

TEST(BeyondRange, AcrossTheRowsItIsFoundAsWell) {
  const auto slope = [](double, double y) { return std::optional<double>(0.01 - y); };  // two rows and a half too far
  EXPECT_NEAR(lengthsOf(slope).outside.too_far, 2 * length, 3 * patch);
}

// The twin of the two above: what ends within the range is a hole or an edge, however much does not come back.
TEST(BeyondRange, AnEdgeWithinTheRangeIsNone) {
  const auto plate = [](double x, double y) {
    const bool is_hole = std::abs(x) < 0.01 && std::abs(y) < 0.006;
    return std::abs(x) < 0.03 && !is_hole ? std::optional<double>(0.5 * range + 0.2 * x) : std::nullopt;
  };
  EXPECT_EQ(sum(lengthsOf(plate)), 0.0);
}

TEST(BeyondRange, APeakOnAPlateIsInsideAndTooNear) {
  const auto peak = [](double x, double y) {
    return std::optional<double>(0.04 + (std::hypot(x, y) < 0.013 ? 0.03 : 0.0));
  };
  const BeyondRangeLengths lengths = lengthsOf(peak);
  double expected = 0.0;
  for (int row = -3; row <= 3; ++row) expected += 2.0 * std::sqrt(0.013 * 0.013 - pitch * pitch * row * row);
  EXPECT_NEAR(lengths.inside.too_near + lengths.outside.too_near, expected - 7 * patch, 7 * patch);  // both ends
  EXPECT_GT(lengths.inside.too_near, 0.0);
  EXPECT_EQ(lengths.inside.too_far + lengths.outside.too_far, 0.0);
  // Steep sides and a sensor that does not tell: nothing says where the part has gone.
  EXPECT_EQ(sum(lengthsOf(peak, false)), 0.0);
}

}  // namespace
}  // namespace scan_to_path::pipeline
