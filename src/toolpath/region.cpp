// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/toolpath/region.h"

#include <algorithm>
#include <utility>

#include "scan_to_path/common/error.h"

namespace scan_to_path::toolpath {
namespace {

using Eigen::Vector2d;

constexpr int bisections = 60;  // of a chord: down to the last bit

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// On which side of the line from a to b: positive on the left.
double sideOf(const Vector2d& p, const Vector2d& a, const Vector2d& b) { return cross(b - a, p - a); }

bool isBetween(const Vector2d& p, const Vector2d& a, const Vector2d& b) { return (p - a).dot(p - b) <= 0.0; }

/// Whether two sides have a point in common, touching included.
bool meet(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
  const double ca = sideOf(a, c, d), cb = sideOf(b, c, d), ac = sideOf(c, a, b), ad = sideOf(d, a, b);
  if (((ca > 0.0) != (cb > 0.0)) && ((ac > 0.0) != (ad > 0.0)) && ca != 0.0 && cb != 0.0 && ac != 0.0 && ad != 0.0) {
    return true;
  }
  return (ca == 0.0 && isBetween(a, c, d)) || (cb == 0.0 && isBetween(b, c, d)) || (ac == 0.0 && isBetween(c, a, b)) ||
         (ad == 0.0 && isBetween(d, a, b));
}

/// Corners that stand twice, and sides that run back along the one before.
void checkNeighbours(const std::vector<Vector2d>& polygon, const std::string& name) {
  const std::size_t count = polygon.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vector2d& a = polygon[i];
    const Vector2d& b = polygon[(i + 1) % count];
    const Vector2d& c = polygon[(i + 2) % count];
    const std::string next = std::to_string((i + 1) % count);
    if (a == b) throw InputError(name + ": corner " + next + " is the one before");
    if (sideOf(c, a, b) == 0.0 && (b - a).dot(c - b) < 0.0) {
      throw InputError(name + ": side " + next + " runs back along the one before");
    }
  }
}

}  // namespace

void validateRegion(const std::vector<Vector2d>& polygon, const std::string& name) {
  const std::size_t count = polygon.size();
  if (count == 0) return;
  if (count < 3) throw InputError(name + " has " + std::to_string(count) + " corners, must have 3 at least or none");
  for (std::size_t i = 0; i < count; ++i) {
    if (!polygon[i].allFinite()) throw InputError(name + "[" + std::to_string(i) + "] is not finite");
  }
  checkNeighbours(polygon, name);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = i + 2; k < count; ++k) {
      if (i == 0 && k + 1 == count) continue;  // neighbours round the corner
      if (!meet(polygon[i], polygon[i + 1], polygon[k], polygon[(k + 1) % count])) continue;
      throw InputError(name + ": sides " + std::to_string(i) + " and " + std::to_string(k) +
                       " meet, must be a polygon that does not cross itself");
    }
  }
}

Region::Region(std::vector<Vector2d> polygon, const Frame& T_region_input)
    : polygon_(std::move(polygon)), T_region_input_(T_region_input) {}

bool Region::contains(const Vector3& p) const {
  if (isEverything()) return true;
  const Vector2d q = seen(p);
  bool is_inside = false;
  for (std::size_t i = 0; i < polygon_.size(); ++i) {
    Vector2d a = polygon_[i];
    Vector2d b = polygon_[(i + 1) % polygon_.size()];
    if (a.y() > b.y()) std::swap(a, b);
    if (a.y() <= q.y() && q.y() < b.y() && sideOf(q, a, b) <= 0.0) is_inside = !is_inside;
  }
  return is_inside;
}

std::vector<Interval> Region::inside(const std::function<Vector3(double)>& curve,
                                     const std::vector<double>& parameters) const {
  if (isEverything()) return {{parameters.front(), parameters.back()}};
  std::vector<double> cuts = {parameters.front()};
  std::vector<Vector2d> chords;
  for (const double t : parameters) chords.push_back(seen(curve(t)));
  for (std::size_t i = 1; i < parameters.size(); ++i) {
    for (std::size_t k = 0; k < polygon_.size(); ++k) {
      const Vector2d& a = polygon_[k];
      const Vector2d& b = polygon_[(k + 1) % polygon_.size()];
      if (!meet(chords[i - 1], chords[i], a, b)) continue;
      double low = parameters[i - 1];
      double high = parameters[i];
      const bool from_left = sideOf(chords[i - 1], a, b) > 0.0;
      for (int n = 0; n < bisections; ++n) {
        const double middle = 0.5 * (low + high);
        ((sideOf(seen(curve(middle)), a, b) > 0.0) == from_left ? low : high) = middle;
      }
      cuts.push_back(0.5 * (low + high));
    }
  }
  cuts.push_back(parameters.back());
  std::sort(cuts.begin(), cuts.end());
  std::vector<Interval> stretches;
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    if (!(cuts[i - 1] < cuts[i]) || !contains(curve(0.5 * (cuts[i - 1] + cuts[i])))) continue;
    const bool goes_on = !stretches.empty() && stretches.back().end == cuts[i - 1];
    if (goes_on) {
      stretches.back().end = cuts[i];
    } else {
      stretches.push_back({cuts[i - 1], cuts[i]});
    }
  }
  return stretches;
}

}  // namespace scan_to_path::toolpath
