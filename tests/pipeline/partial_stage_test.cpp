// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/partial_stage.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "scan_to_path/toolpath/ball_tool.h"
#include "scan_to_path/toolpath/contact_frame.h"
#include "scan_to_path/toolpath/modifiers.h"
#include "small_scan.h"
#include "support/fitted_scans.h"

namespace scan_to_path::pipeline {
namespace {

using ::testing::HasSubstr;
using toolpath::ToolPath;
using toolpath::Verdict;

const geometry::Rectangle area = {0.0, 0.13, 0.0, 0.05};
constexpr double hump = 0.09;

/// The analytic world along x: a groove whose bottom has a radius of 6 mm, out of reach of a ball of 20 mm, and a hump
/// 5 mm high with feet of 32 mm.
double height(double x) {
  return -0.012 * std::exp(-std::pow((x - 0.035) / 0.012, 2)) + 0.005 * std::exp(-std::pow((x - hump) / 0.012, 2));
}

const Frame T_base_part = geometry::makeFrame(Vector3(0.85, -0.03, 0.45), Vector3::Zero());

/// How deep a ball about `centre` (in the part's frame) enters the world [m], by the nearest of its points on a grid of
/// 0.25 mm; the world does not change along y, but ends at the area's borders. The grid misses the nearest point by at
/// most 0.125 mm along x, and the depth by 0.125^2 / 2 (1 / 20 + 1 / 6) mm = 1.7 um, so it is never overstated.
double depthOf(const Vector3& centre, double radius) {
  const double beside = std::max({area.y_min - centre.y(), centre.y() - area.y_max, 0.0});
  double nearest = std::numeric_limits<double>::infinity();
  for (double x = area.x_min; x <= area.x_max + 1e-9; x += 0.25e-3) {
    nearest = std::min(nearest, std::hypot(x - centre.x(), std::hypot(beside, height(x) - centre.z())));
  }
  return radius - nearest;
}

/// The deepest that the straight moves of a path go into the world, looked at every millimetre.
double deepest(const ToolPath& path, double radius) {
  double depth = -1.0;
  const Frame* before = nullptr;
  for (const auto& segment : path.segments) {
    for (const auto& waypoint : segment.waypoints) {
      const Frame T = T_base_part.inverse() * waypoint.pose;
      const Vector3 b = T.translation() + radius * T.linear().col(2);
      Vector3 a = b;
      if (before != nullptr) {
        const Frame T_before = T_base_part.inverse() * *before;
        a = T_before.translation() + radius * T_before.linear().col(2);
      }
      const int steps = std::max(1, static_cast<int>((b - a).norm() / 1e-3));
      for (int i = 1; i <= steps; ++i) depth = std::max(depth, depthOf(a + (b - a) * i / steps, radius));
      before = &waypoint.pose;
    }
  }
  return depth;
}

/// The part before an arm whose first axis turns only so far to the left: the rows there are out of its reach.
class PartialTest : public ::testing::Test {
protected:
  PartialTest()
      : scan_(test::fittedScan([](double x, double) { return height(x); }, area, 0.004, 200, 8, T_base_part)),
        cell_(makeCell(CellOptions(), source_package)) {
    // Axis 1 points at (x, y): y = 0.016 at x = 0.95 and 0.0145 at x = 0.85.
    cell_.robot.joints[0].upper = std::atan2(0.0155, 0.9);
    planner_ = makePlanner("cutting", options_);
    whole_ = pathStage(*planner_, scan_, "base_link", options_, {});
    blockHump();
  }

  /// Something stands in the way over the hump of the third row.
  void blockHump() {
    auto& planned = whole_.planned;
    const auto row = std::find_if(planned.path.segments.begin(), planned.path.segments.end(),
                                  [](const auto& segment) { return segment.name == "row_2"; });
    blocked_ = static_cast<int>(row - planned.path.segments.begin());
    for (std::size_t i = 0; i < row->waypoints.size(); ++i) {
      const double x = (T_base_part.inverse() * row->waypoints[i].pose).translation().x();
      if (!toolpath::isContact(*row, i) || std::abs(x - hump) > 0.012) continue;
      planned.findings.push_back({blocked_, static_cast<int>(i), Verdict::collision, -1.0, "m", "a clamp", "move it"});
    }
    std::sort(planned.findings.begin(), planned.findings.end(), [](const auto& a, const auto& b) {
      return a.segment != b.segment ? a.segment < b.segment : a.index < b.index;
    });
  }

  /// The shipped arm, slow enough for the groove: nothing fails.
  void makeEasy() {
    cell_ = makeCell(CellOptions(), source_package);
    whole_.planned.findings.clear();
    for (auto& segment : whole_.planned.path.segments) {
      for (auto& waypoint : segment.waypoints) waypoint.feed = 0.002;
    }
  }

  /// A plate before the shipped arm: nothing fails.
  void makeFlat() {
    cell_ = makeCell(CellOptions(), source_package);
    scan_ = test::fittedScan([](double, double) { return 0.0; }, area, 0.004, 200, 8, T_base_part);
    whole_ = pathStage(*planner_, scan_, "base_link", options_, {});
  }

  PartialStage partial() const {
    const MotionStage motion = motionStage(airRun(whole_, cell_, options_.program), cell_, options_, {});
    return partialStage(*planner_, whole_, motion, scan_, cell_, options_, {});
  }

  scan::FittedScan scan_;
  Cell cell_;
  JobOptions options_;
  std::unique_ptr<process::Planner> planner_;
  PathStage whole_;
  int blocked_ = -1;
};

TEST_F(PartialTest, DrivesWhatIsLeftAndNeverThroughThePart) {
  const PartialStage stage = partial();
  ASSERT_FALSE(stage.path.planned.path.segments.empty());
  EXPECT_TRUE(std::all_of(stage.motion.verdicts.begin(), stage.motion.verdicts.end(),
                          [](const auto& verdict) { return verdict.verdict == Verdict::ok; }));
  for (const auto& figure : stage.motion.accuracy) EXPECT_TRUE(figure.pass()) << figure.name << " " << figure.value;
  const double radius = options_.path.ball_radius;
  // The gouge tolerance, and the chords' own.
  EXPECT_LT(deepest(stage.path.planned.path, radius), options_.path.gouge_tolerance + options_.path.chord_tolerance);
  EXPECT_GT(deepest(whole_.planned.path, radius), 1e-3);
}

// The mutation twin: a row without what fails, joined straight across, as a partial program must not be.
TEST_F(PartialTest, JoiningStraightOverAGapIsSeen) {
  ToolPath joined = whole_.planned.path;
  joined.segments = {joined.segments[static_cast<std::size_t>(blocked_)]};
  auto& waypoints = joined.segments[0].waypoints;
  for (auto finding = whole_.planned.findings.rbegin(); finding != whole_.planned.findings.rend(); ++finding) {
    if (finding->segment == blocked_) waypoints.erase(waypoints.begin() + finding->index);
  }
  EXPECT_GT(deepest(joined, options_.path.ball_radius), 1e-3);
}

/// The highest waypoint of the links between pieces of the same row, in the part's frame [m].
double highestLinkWithin(const ToolPath& path) {
  double highest = -1.0;
  for (std::size_t s = 1; s + 1 < path.segments.size(); ++s) {
    const auto row = [&](std::size_t k) {
      return path.segments[k].name.substr(0, path.segments[k].name.find("_part"));
    };
    if (toolpath::isRow(path.segments[s]) || row(s - 1) != row(s + 1)) continue;
    for (const auto& waypoint : path.segments[s].waypoints) {
      highest = std::max(highest, (T_base_part.inverse() * waypoint.pose).translation().z());
    }
  }
  return highest;
}

TEST_F(PartialTest, LinksClearWhatIsLeftOutToo) {
  constexpr double high = 0.04;  // [m] twice the links' clearance
  const auto dune = [](double x, double) { return high * std::exp(-std::pow((x - 0.065) / 0.025, 2)); };
  const auto scan = test::fittedScan(dune, area, 0.004, 200, 8, T_base_part);
  const auto whole = planner_->plan({&scan, "base_link"}, {});
  std::set<toolpath::WaypointIndex> left_out;
  for (int s = 0; s < static_cast<int>(whole.path.segments.size()); ++s) {
    const auto& segment = whole.path.segments[static_cast<std::size_t>(s)];
    for (std::size_t i = 0; i < segment.waypoints.size(); ++i) {
      const Vector3 p = (T_base_part.inverse() * segment.waypoints[i].pose).translation();
      if (toolpath::isContact(segment, i) && p.z() > 0.01) left_out.insert({s, static_cast<int>(i)});
    }
  }
  ToolPath path = planner_->without(whole, left_out, {&scan, "base_link"}, {}).path;
  const double clearance = options_.path.links.clearance;
  EXPECT_GE(highestLinkWithin(path), 0.99 * high + clearance);  // the contacts are not on the very top
  // The mutation twin: links that know only of the rows that are left.
  path = toolpath::withLinks(path, Vector3::UnitZ(), options_.path.ball_radius, options_.path.links);
  EXPECT_LT(highestLinkWithin(path), high);
}

TEST_F(PartialTest, ShortensRowsThatEndOutOfReachAndDropsWhatIsOutOfIt) {
  const PartialStage stage = partial();
  std::set<std::string> driven;
  for (const auto& segment : stage.path.planned.path.segments) {
    if (toolpath::isRow(segment)) driven.insert(segment.name.substr(0, segment.name.find("_part")));
  }
  std::set<std::string> planned;
  for (const auto& segment : whole_.planned.path.segments) {
    if (toolpath::isRow(segment)) planned.insert(segment.name);
  }
  EXPECT_LT(driven.size(), planned.size());  // a row all of which is too far to the left
  EXPECT_EQ(driven.count("row_0"), 1U);
  EXPECT_EQ(driven.count("row_" + std::to_string(planned.size() - 1)), 0U);
  for (const auto& segment : stage.path.planned.path.segments) {
    for (const auto& waypoint : segment.waypoints) EXPECT_LT(waypoint.pose.translation().y(), 0.03);
  }
}

TEST_F(PartialTest, EveryWaypointIsEitherDrivenOrNamed) {
  const PartialStage stage = partial();
  std::size_t planned = 0;
  std::size_t driven = 0;
  const auto count = [](const ToolPath& path, std::size_t& contacts) {
    for (const auto& segment : path.segments) {
      for (std::size_t i = 0; i < segment.waypoints.size(); ++i) contacts += toolpath::isContact(segment, i) ? 1 : 0;
    }
  };
  count(whole_.planned.path, planned);
  count(stage.path.planned.path, driven);
  EXPECT_EQ(planned, driven + stage.left_out.size());
  std::set<Verdict> verdicts;
  std::set<std::string> reasons;
  for (const auto& left_out : stage.left_out) {
    const auto& verdict = left_out.verdict;
    const auto& cause = whole_.planned.path.segments[static_cast<std::size_t>(verdict.segment)];
    EXPECT_EQ(cause.name, left_out.caused_by);
    EXPECT_EQ(cause.name, left_out.segment);  // there is one pass only
    EXPECT_NE(verdict.verdict, Verdict::ok);
    EXPECT_FALSE(verdict.reason.empty() || verdict.remedy.empty());
    if (left_out.kind == LeftOutKind::fails) {
      EXPECT_EQ(verdict.index, left_out.index);
      EXPECT_EQ(cause.waypoints[static_cast<std::size_t>(left_out.index)].pose.translation(), left_out.position);
      verdicts.insert(verdict.verdict);
    }
    reasons.insert(left_out.reason);
  }
  EXPECT_EQ(reasons, (std::set<std::string>{"", "the way to it or from it fails",
                                            "less than 20.0 mm of the row is left here, or an earlier pass left it "
                                            "out"}));
  EXPECT_EQ(verdicts.count(Verdict::gouge), 1U);
  EXPECT_EQ(verdicts.count(Verdict::collision), 1U);
  EXPECT_GT(verdicts.size(), 2U);  // and what the arm cannot do
  for (const char* dropped : {"path_rows", "path_row_distance_median", "path_scallop"}) {
    EXPECT_TRUE(std::none_of(stage.path.accuracy.begin(), stage.path.accuracy.end(), [&](const auto& figure) {
      return figure.name == dropped;
    })) << dropped;
  }
  EXPECT_EQ(stage.path.report.out, toolpath::waypointCount(stage.path.planned.path));
  EXPECT_GT(stage.left_out_share, 0.1);
  EXPECT_LT(stage.left_out_share, 0.9);
  RecordProperty("left_out_share", std::to_string(stage.left_out_share));
}

std::size_t failing(const MotionStage& motion) {
  return static_cast<std::size_t>(std::count_if(motion.verdicts.begin(), motion.verdicts.end(),
                                                [](const auto& verdict) { return verdict.verdict != Verdict::ok; }));
}

// Axis 2 stoops the less the higher the tool is: with its limit where a third of the contacts are beyond, the lifted
// path does not fail where the one on the part does, so the air run is to drive the same anyway.
TEST_F(PartialTest, AnAirRunDrivesTheRealProgramsPath) {
  makeEasy();
  std::vector<double> stoop;
  for (const auto& point : motionStage(whole_, cell_, options_, {}).plan.trajectory.points) stoop.push_back(point.q[1]);
  std::sort(stoop.begin(), stoop.end());
  cell_.robot.joints[1].upper = stoop[stoop.size() * 2 / 3];
  const PartialStage real = partial();
  options_.program.dry_offset = 0.05;
  const PartialStage air = partial();
  // The case is a case: cuts decided in the air would be others.
  const auto part_verdicts = motionStage(whole_, cell_, {}, {}).verdicts;
  const auto air_verdicts = motionStage(airRun(whole_, cell_, options_.program), cell_, options_, {}).verdicts;
  std::size_t only_on_part = 0;
  for (std::size_t i = 0; i < part_verdicts.size(); ++i) {
    only_on_part += part_verdicts[i].verdict != Verdict::ok && air_verdicts[i].verdict == Verdict::ok ? 1 : 0;
  }
  ASSERT_GT(only_on_part, 100U);
  ASSERT_FALSE(real.path.planned.path.segments.empty());
  EXPECT_EQ(air.refusal, "");
  EXPECT_EQ(failing(air.motion), 0U);
  EXPECT_TRUE(air.path.planned.path.lift.isZero(0.0));
  EXPECT_EQ(air.left_out.size(), real.left_out.size());
  const ToolPath& up_there = air.driven.planned.path;
  const ToolPath& on_part = real.driven.planned.path;
  ASSERT_EQ(up_there.segments.size(), on_part.segments.size());
  for (std::size_t s = 0; s < on_part.segments.size(); ++s) {
    EXPECT_EQ(up_there.segments[s].name, on_part.segments[s].name);
    ASSERT_EQ(up_there.segments[s].waypoints.size(), on_part.segments[s].waypoints.size());
    for (std::size_t i = 0; i < on_part.segments[s].waypoints.size(); ++i) {
      Frame pose = up_there.segments[s].waypoints[i].pose;
      pose.translation() -= up_there.lift;
      // One sum and one difference of coordinates below 2 m: two roundings of 2.2e-16 each.
      EXPECT_LT((pose.matrix() - on_part.segments[s].waypoints[i].pose.matrix()).norm(), 1e-15);
    }
  }
  EXPECT_EQ(air.motion.verdicts.size(), toolpath::waypointCount(up_there));
  EXPECT_LT(deepest(up_there, options_.path.ball_radius), -0.015);
}

TEST_F(PartialTest, AnAirRunThatFailsIsRefusedAndCutsNothingMore) {
  const std::size_t left_out = partial().left_out.size();
  options_.program.dry_offset = 2.0;
  const PartialStage air = partial();
  EXPECT_THAT(air.refusal, HasSubstr("fail in its air run: lower program.dry_offset"));
  EXPECT_GT(failing(air.motion), 0U);
  EXPECT_EQ(air.left_out.size(), left_out);
}

TEST_F(PartialTest, NothingIsLeftOutWhenNothingFails) {
  makeFlat();
  const PartialStage stage = partial();
  EXPECT_TRUE(stage.left_out.empty());
  EXPECT_EQ(stage.refusal, "");
  EXPECT_EQ(toolpath::waypointCount(stage.path.planned.path), toolpath::waypointCount(whole_.planned.path));
}

/// A planner on whose paths without something more waypoints fail than on the one before: `growth` times as many.
class Growing : public process::Planner {
public:
  Growing(const process::Planner& planner, std::size_t first, double growth)
      : planner_(planner), failing_(static_cast<double>(first)), growth_(growth) {}
  process::PlannedPath plan(const process::PlannerInput& input, const Progress& progress) const override {
    return planner_.plan(input, progress);
  }
  process::PlannedPath without(const process::PlannedPath& whole, const std::set<toolpath::WaypointIndex>& left_out,
                               const process::PlannerInput& input, const Progress& progress) const override {
    auto planned = planner_.without(whole, left_out, input, progress);
    failing_ *= growth_;
    planned.findings = firstContacts(planned.path, static_cast<std::size_t>(failing_));
    return planned;
  }
  double shortestPiece() const override { return planner_.shortestPiece(); }

  static std::vector<toolpath::WaypointVerdict> firstContacts(const ToolPath& path, std::size_t count) {
    std::vector<toolpath::WaypointVerdict> findings;
    for (int s = 0; s < static_cast<int>(path.segments.size()); ++s) {
      const auto& segment = path.segments[static_cast<std::size_t>(s)];
      for (std::size_t i = 0; i < segment.waypoints.size() && findings.size() < count; ++i) {
        if (!toolpath::isContact(segment, i)) continue;
        findings.push_back({s, static_cast<int>(i), Verdict::collision, -1.0, "m", "another clamp", "move it"});
      }
    }
    return findings;
  }

private:
  const process::Planner& planner_;
  mutable double failing_;
  double growth_;
};

TEST_F(PartialTest, CutsThatMakeMoreFailAreRefused) {
  makeFlat();
  constexpr std::size_t first = 5;
  whole_.planned.findings = Growing::firstContacts(whole_.planned.path, first);
  const MotionStage motion = motionStage(whole_, cell_, options_, {});
  ASSERT_EQ(failing(motion), first);
  const auto cut = [&](double growth) {
    const Growing planner(*planner_, first, growth);
    return partialStage(planner, whole_, motion, scan_, cell_, options_, {});
  };
  const PartialStage growing = cut(1.5);
  EXPECT_EQ(growing.refusal.find("once the 5 contacts that fail were left out, 7 others fail"), 0U) << growing.refusal;
  EXPECT_TRUE(growing.left_out.empty());
  EXPECT_EQ(failing(growing.motion), first);  // so that nothing is written
  EXPECT_EQ(toolpath::waypointCount(growing.path.planned.path), toolpath::waypointCount(whole_.planned.path));
  // Halved each time, 5 + 2 + 1 fail themselves. All are at the start of one row: what goes with them is shorter than a
  // piece.
  const PartialStage shrinking = cut(0.5);
  EXPECT_EQ(shrinking.refusal, "");
  EXPECT_EQ(failing(shrinking.motion), 0U);
  std::size_t fails = 0;
  for (const auto& left_out : shrinking.left_out) fails += left_out.kind == LeftOutKind::fails ? 1 : 0;
  EXPECT_EQ(fails, 8U);
}

}  // namespace
}  // namespace scan_to_path::pipeline
