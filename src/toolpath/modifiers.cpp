// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/toolpath/modifiers.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scan_to_path/common/error.h"
#include "scan_to_path/toolpath/contact_frame.h"

namespace scan_to_path::toolpath {
namespace {

constexpr double largest_turn = M_PI / 4.0;  // per waypoint of a link [rad]

Waypoint airWaypoint(const Frame& pose, double feed) {
  Waypoint waypoint;
  waypoint.pose = pose;
  waypoint.feed = feed;
  return waypoint;
}

Frame moved(Frame pose, const Vector3& by) {
  pose.translation() += by;
  return pose;
}

/// The row from its first to its last contact.
std::vector<Waypoint> contactsOf(const Segment& segment) {
  std::size_t first = segment.waypoints.size();
  std::size_t last = 0;
  for (std::size_t i = 0; i < segment.waypoints.size(); ++i) {
    if (!isContact(segment, i)) continue;
    first = std::min(first, i);
    last = i;
  }
  return {segment.waypoints.begin() + static_cast<std::ptrdiff_t>(first),
          segment.waypoints.begin() + static_cast<std::ptrdiff_t>(last) + 1};
}

void addLeads(Segment& row, const LeadOptions& options) {
  row.waypoints = contactsOf(row);
  const double feed = row.waypoints[1].feed;
  row.waypoints.front().feed = feed;
  if (options.length <= 0.0) return;
  const Vector3 in(-options.length * std::cos(options.angle), 0.0, options.length * std::sin(options.angle));
  const Vector3 out(-in.x(), 0.0, in.z());
  const Frame first = row.waypoints.front().pose;
  const Frame last = row.waypoints.back().pose;
  row.waypoints.insert(row.waypoints.begin(), airWaypoint(moved(first, first.linear() * in), feed));
  row.waypoints.push_back(airWaypoint(moved(last, last.linear() * out), feed));
}

/// What lies together, in a box, to find quickly what of it is below a link.
struct Shadow {
  Eigen::AlignedBox3d box;
  std::vector<Vector3> points;
};

Shadow shadowOf(std::vector<Vector3> points) {
  Shadow shadow;
  for (const auto& point : points) shadow.box.extend(point);
  shadow.points = std::move(points);
  return shadow;
}

/// Distance from p to the straight line between a and b, seen along `up`.
double distanceSeenAlong(const Vector3& up, const Vector3& a, const Vector3& b, const Vector3& p) {
  const auto flat = [&up](const Vector3& v) -> Vector3 { return v - up * up.dot(v); };
  const Vector3 ab = flat(b - a);
  const Vector3 ap = flat(p - a);
  const double length2 = ab.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp(ap.dot(ab) / length2, 0.0, 1.0) : 0.0;
  return (ap - t * ab).norm();
}

/// Half the diagonal of a box bounds how far its points are from its middle.
bool mayLieBelow(const Shadow& shadow, const Vector3& up, const Vector3& a, const Vector3& b, double corridor,
                 double height) {
  const double reach = 0.5 * shadow.box.diagonal().norm();
  return up.dot(shadow.box.center()) + reach > height &&
         distanceSeenAlong(up, a, b, shadow.box.center()) <= corridor + reach;
}

/// Height along `up` of the highest point under the link from a to b.
double heightBelow(const std::vector<Shadow>& shadows, const Vector3& up, const Vector3& a, const Vector3& b,
                   double corridor) {
  double height = std::max(up.dot(a), up.dot(b));
  for (const auto& shadow : shadows) {
    if (!mayLieBelow(shadow, up, a, b, corridor, height)) continue;
    for (const auto& p : shadow.points) {
      if (up.dot(p) > height && distanceSeenAlong(up, a, b, p) <= corridor) height = up.dot(p);
    }
  }
  return height;
}

Eigen::AngleAxisd otherWay(const Eigen::AngleAxisd& turn) {
  return Eigen::AngleAxisd(2.0 * M_PI - turn.angle(), -turn.axis());
}

/// Angle of a turn about `up`, given the attitude it starts from [rad].
double angleAbout(const Vector3& up, const Eigen::Matrix3d& from, const Eigen::AngleAxisd& turn) {
  return turn.angle() * up.dot(from * turn.axis());
}

/// The turn from one attitude to the other; a wide one by the side on which x passes the direction of travel, unless
/// it adds to the more than half a turn by which the tool has turned about `up` already.
Eigen::AngleAxisd turnBetween(const Eigen::Matrix3d& from, const Eigen::Matrix3d& to, const Vector3& travel,
                              const Vector3& up, double turned) {
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(from.transpose() * to));
  if (turn.angle() <= 0.5 * M_PI) return turn;
  const Eigen::AngleAxisd half(0.5 * turn.angle(), turn.axis());
  const Vector3 x_half_way = from * (half * Vector3::UnitX());
  const Eigen::AngleAxisd by_travel = x_half_way.dot(travel) >= 0.0 ? turn : otherWay(turn);
  const double after = turned + angleAbout(up, from, by_travel);
  return std::abs(after) > 1.5 * M_PI && std::abs(after) > std::abs(turned) ? otherWay(by_travel) : by_travel;
}

/// Straight across from one pose to the other while the tool turns; without `from` itself.
void appendCrossing(std::vector<Waypoint>& waypoints, const Frame& from, const Frame& to, const Eigen::AngleAxisd& turn,
                    double feed) {
  const Vector3 travel = to.translation() - from.translation();
  const int steps = std::max(1, static_cast<int>(std::ceil(turn.angle() / largest_turn - 1e-9)));
  for (int i = 1; i < steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    Frame pose = moved(from, share * travel);
    pose.linear() = from.linear() * Eigen::AngleAxisd(share * turn.angle(), turn.axis()).toRotationMatrix();
    waypoints.push_back(airWaypoint(pose, feed));
  }
  waypoints.push_back(airWaypoint(to, feed));
}

std::string nameInLinks(std::string name) {
  const auto at = name.find("row_");
  if (at != std::string::npos) name.erase(at, 4);
  return name;
}

/// Builds approach, links and retract of one path.
class Linker {
public:
  Linker(const std::vector<Segment>& rows, const Vector3& up, double corridor, const LinkOptions& options,
         std::vector<std::vector<Vector3>> also_below)
      : rows_(rows), up_(up), corridor_(corridor), options_(options) {
    for (const auto& row : rows) shadows_.push_back(shadowOf(positionsOf(row)));
    for (auto& points : also_below) shadows_.push_back(shadowOf(std::move(points)));
  }

  std::vector<Segment> joined() const {
    std::vector<Segment> segments = {approach(rows_.front())};
    double turned = 0.0;  // about up, since the first row [rad]
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (i > 0) segments.push_back(link(rows_[i - 1], rows_[i], turned));
      segments.push_back(rows_[i]);
      segments.back().waypoints.front().feed = options_.plunge_feed;
    }
    segments.push_back(retract(rows_.back()));
    return segments;
  }

private:
  Frame offRow(const Frame& pose) const { return moved(pose, options_.approach * pose.linear().col(2)); }

  Frame lifted(const Frame& pose, double height) const {
    return moved(pose, (height - up_.dot(pose.translation())) * up_);
  }

  double clearHeight(const Frame& a, const Frame& b) const {
    return heightBelow(shadows_, up_, a.translation(), b.translation(), corridor_) + options_.clearance;
  }

  Segment approach(const Segment& row) const {
    const Frame start = offRow(row.waypoints.front().pose);
    const double feed = options_.rapid_feed;
    return {"approach", {airWaypoint(lifted(start, clearHeight(start, start)), feed), airWaypoint(start, feed)}};
  }

  Segment link(const Segment& before, const Segment& after, double& turned) const {
    const Frame end = offRow(before.waypoints.back().pose);
    const Frame start = offRow(after.waypoints.front().pose);
    const double height = clearHeight(end, start);
    const double feed = options_.rapid_feed;
    Segment segment = {"link_" + nameInLinks(before.name) + "_" + nameInLinks(after.name), {}};
    segment.waypoints = {airWaypoint(end, feed), airWaypoint(lifted(end, height), feed)};
    const Vector3 travel = start.translation() - end.translation();
    const Eigen::AngleAxisd turn = turnBetween(end.linear(), start.linear(), travel, up_, turned);
    turned += angleAbout(up_, end.linear(), turn);
    appendCrossing(segment.waypoints, lifted(end, height), lifted(start, height), turn, feed);
    segment.waypoints.push_back(airWaypoint(start, feed));
    return segment;
  }

  Segment retract(const Segment& row) const {
    const Frame end = offRow(row.waypoints.back().pose);
    const double feed = options_.rapid_feed;
    return {"retract", {airWaypoint(end, feed), airWaypoint(lifted(end, clearHeight(end, end)), feed)}};
  }

  const std::vector<Segment>& rows_;
  std::vector<Shadow> shadows_;
  Vector3 up_;
  double corridor_;
  LinkOptions options_;
};

}  // namespace

ToolPath withLeads(ToolPath path, const LeadOptions& options) {
  validate(options, "leads");
  for (auto& segment : path.segments) {
    if (isRow(segment)) addLeads(segment, options);
  }
  return withArcLength(std::move(path));
}

ToolPath withLinks(ToolPath path, const Vector3& up, double corridor, const LinkOptions& options,
                   std::vector<std::vector<Vector3>> also_below) {
  validate(options, "links");
  std::vector<Segment> rows;
  for (auto& segment : path.segments) {
    if (isRow(segment)) rows.push_back(std::move(segment));
  }
  if (rows.empty()) throw InputError("tool path: no segment works, there is nothing to link");
  path.segments = Linker(rows, up, corridor, options, std::move(also_below)).joined();
  return withArcLength(std::move(path));
}

}  // namespace scan_to_path::toolpath
