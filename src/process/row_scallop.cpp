// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/process/row_scallop.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"
#include "scan_to_path/toolpath/outline_clip.h"

namespace scan_to_path::process {
namespace {

using toolpath::ScanSurface;

/// The ball centres of a row, joined by straight lines, with the place where the last search ended.
class CentreLine {
public:
  CentreLine(const Row& row, double radius) : row_(row) {
    for (const auto& p : row.points) centres_.push_back(p.point + radius * p.normal);
  }

  double firstT() const { return row_.points.front().t; }
  double lastT() const { return row_.points.back().t; }

  /// The centre where the row passes t; calls must come with rising t.
  Vector3 atRising(double t) {
    while (at_ + 2 < centres_.size() && row_.points[at_ + 1].t < t) ++at_;
    const double t0 = row_.points[at_].t;
    const double share = std::clamp((t - t0) / (row_.points[at_ + 1].t - t0), 0.0, 1.0);
    return centres_[at_] + share * (centres_[at_ + 1] - centres_[at_]);
  }

  /// Unit direction of the centres where the last atRising() was.
  Vector3 directionHere() const { return (centres_[at_ + 1] - centres_[at_]).normalized(); }

  const RowPoint& pointHere() const { return row_.points[at_]; }

  /// The nearest centre to p, searched from the place of the last atRising() as long as it gets nearer.
  Vector3 nearest(const Vector3& p) const {
    Vector3 best = nearestOn(at_, p);
    const auto improves = [&](std::size_t i) {
      const Vector3 candidate = nearestOn(i, p);
      if ((candidate - p).squaredNorm() > (best - p).squaredNorm()) return false;
      best = candidate;
      return true;
    };
    for (std::size_t i = at_ + 1; i + 1 < centres_.size() && improves(i);) ++i;
    for (std::size_t i = at_; i > 0 && improves(i - 1);) --i;
    return best;
  }

private:
  Vector3 nearestOn(std::size_t i, const Vector3& p) const {
    const Vector3 along = centres_[i + 1] - centres_[i];
    const double share = std::clamp((p - centres_[i]).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return centres_[i] + share * along;
  }

  const Row& row_;
  std::vector<Vector3> centres_;
  std::size_t at_ = 0;
};

/// Where the envelope of the balls along a, a circle in the plane across it at `centre`, meets that of b below them.
/// Nothing where they do not meet: the rows are too far apart.
std::optional<Vector3> cuspBelow(const CentreLine& a, const CentreLine& b, const Vector3& centre, double radius) {
  const Vector3 along = a.directionHere();
  const auto across = [&along](const Vector3& v) -> Vector3 { return v - along * along.dot(v); };
  const Vector3 way = across(b.nearest(centre) - centre);
  const double half = 0.5 * way.norm();
  if (!(half < radius)) return std::nullopt;
  if (half == 0.0) return centre - radius * a.pointHere().normal;  // the same row
  const Vector3 aside = way / (2.0 * half);
  const Vector3 up = across(a.pointHere().normal);
  const Vector3 down = -(up - aside * aside.dot(up)).normalized();
  const auto onCircle = [&](double w) -> Vector3 {
    return centre + w * aside + std::sqrt(std::max(0.0, radius * radius - w * w)) * down;
  };
  // Between the two contacts: rows that nearly coincide run through each other anywhere.
  const double contact_a = -radius * a.pointHere().normal.dot(aside);
  const double contact_b = 2.0 * half - radius * b.pointHere().normal.dot(aside);
  const auto [first, last] = std::minmax(contact_a, contact_b);
  // Half way between parallel rows; Newton's method with their slope brings it to where the others meet.
  double w = std::clamp(half, first, last);
  for (int i = 0; i < 4; ++i) {
    const Vector3 cusp = onCircle(w);
    const double outside = (cusp - b.nearest(cusp)).norm() - radius;
    w = std::clamp(w + outside * radius / (2.0 * half), first, last);
  }
  return onCircle(w);
}

double heightOver(const ScanSurface& surface, const Vector3& p) {
  const auto jet = surface.jet(p.x(), p.y());
  // Along the normal instead of along z: exact for a plane, and second order in the tiny height elsewhere.
  return (p.z() - jet.z) / std::sqrt(1.0 + jet.zx * jet.zx + jet.zy * jet.zy);
}

bool gouges(const RowPoint& p, const ScanSurface& surface, double radius) {
  return toolpath::smallestCurvature(surface.jet(p.point.x(), p.point.y())) * radius <= -1.0;
}

/// Nothing where the ball does not fit into the surface: its centres run through each other there.
std::optional<double> cuspHeight(CentreLine& a, CentreLine& b, double t, const ScanSurface& surface, double radius) {
  const Vector3 centre = a.atRising(t);
  b.atRising(t);
  if (gouges(a.pointHere(), surface, radius) || gouges(b.pointHere(), surface, radius)) return std::nullopt;
  const auto cusp = cuspBelow(a, b, centre, radius);
  if (!cusp) return std::numeric_limits<double>::infinity();
  return heightOver(surface, *cusp);
}

/// A row's waypoints and the middles between them [m].
std::vector<double> placesLookedAt(const Row& row) {
  std::vector<double> places;
  for (std::size_t i = 0; i < row.points.size(); ++i) {
    if (i > 0) places.push_back(0.5 * (row.points[i - 1].t + row.points[i].t));
    places.push_back(row.points[i].t);
  }
  return places;
}

/// Of rows a and b at the places between which `where` lies, and at those inside.
std::optional<double> widestWithin(const Row& a, const Row& b, const toolpath::Interval& where,
                                   const ScanSurface& surface, double ball_radius) {
  CentreLine line_a(a, ball_radius);
  CentreLine line_b(b, ball_radius);
  const double begin = std::max(line_a.firstT(), line_b.firstT());
  const double end = std::min(line_a.lastT(), line_b.lastT());
  std::optional<double> widest;
  const std::vector<double> places = placesLookedAt(a);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double t = places[i];
    const double before = i > 0 ? places[i - 1] : t;
    const double after = i + 1 < places.size() ? places[i + 1] : t;
    if (t < begin || t > end || after < where.begin || before > where.end) continue;
    const auto height = cuspHeight(line_a, line_b, t, surface, ball_radius);
    if (height) widest = std::max(widest.value_or(*height), *height);
  }
  return widest;
}

/// Whether `piece` can have been cut out of `row`.
bool holds(const Row& row, const Row& piece) {
  return row.points.front().t <= piece.points.front().t && piece.points.back().t <= row.points.back().t;
}

}  // namespace

std::optional<double> widestScallop(const Row& a, const Row& b, const ScanSurface& surface, double ball_radius) {
  return widestWithin(a, b, {a.points.front().t, a.points.back().t}, surface, ball_radius);
}

std::optional<double> widestScallop(const std::vector<Row>& a, const std::vector<Row>& b, const ScanSurface& surface,
                                    double ball_radius) {
  std::optional<double> widest;
  for (const Row& row_a : a) {
    for (const Row& row_b : b) {
      const auto height = widestScallop(row_a, row_b, surface, ball_radius);
      if (height) widest = std::max(widest.value_or(*height), *height);
    }
  }
  return widest;
}

std::optional<double> widestScallopOfCut(const std::vector<Row>& a, const std::vector<Row>& b,
                                         const std::vector<Row>& whole_a, const std::vector<Row>& whole_b,
                                         const ScanSurface& surface, double ball_radius) {
  std::optional<double> widest;
  for (const Row& piece_a : a) {
    for (const Row& piece_b : b) {
      const toolpath::Interval both = {std::max(piece_a.points.front().t, piece_b.points.front().t),
                                       std::min(piece_a.points.back().t, piece_b.points.back().t)};
      if (!(both.begin <= both.end)) continue;
      for (const Row& row_a : whole_a) {
        if (!holds(row_a, piece_a)) continue;
        for (const Row& row_b : whole_b) {
          if (!holds(row_b, piece_b)) continue;
          const auto height = widestWithin(row_a, row_b, both, surface, ball_radius);
          if (height) widest = std::max(widest.value_or(*height), *height);
        }
      }
    }
  }
  return widest;
}

void checkThatBallsMeet(double scallop, int row, double ball_radius) {
  if (std::isfinite(scallop)) return;
  throw InputError("cutting: rows " + std::to_string(row - 1) + " and " + std::to_string(row) +
                   " are so far apart that a ball of radius " + fixed(1e3 * ball_radius, 3) +
                   " mm leaves a strip uncut between them");
}

}  // namespace scan_to_path::process
