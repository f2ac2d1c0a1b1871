// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/toolpath/modifiers.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/expect_input_error.h"
#include "support/paths.h"
#include "support/surface_oracle.h"

namespace scan_to_path::toolpath {
namespace {

const Vector3 up = Vector3::UnitZ();

ToolPath zigZag() { return test::planeRows(4, 0.004, 0.1, 5, true); }

ToolPath complete() { return withLinks(withLeads(zigZag(), {}), up, 0.02, {}); }

TEST(Modifiers, AppliedTwiceEqualOnce) {
  const ToolPath with_leads = withLeads(zigZag(), {});
  EXPECT_EQ(test::largestDifference(withLeads(with_leads, {}), with_leads), 0.0);
  const ToolPath linked = complete();
  EXPECT_EQ(test::largestDifference(withLinks(linked, up, 0.02, {}), linked), 0.0);
  EXPECT_EQ(test::largestDifference(withLinks(withLeads(linked, {}), up, 0.02, {}), linked), 0.0);
}

TEST(Modifiers, LeadsRunOnAndOffAtTheirAngleWithTheProcessOff) {
  const LeadOptions options = {0.005, 0.2};
  const ToolPath path = withLeads(zigZag(), options);
  for (const Segment& row : path.segments) {
    ASSERT_EQ(row.waypoints.size(), 8U);
    const Frame& first = row.waypoints[1].pose;
    const Vector3 in = first.inverse() * row.waypoints[0].pose.translation();
    const Vector3 out = row.waypoints[6].pose.inverse() * row.waypoints[7].pose.translation();
    const Vector3 expected(0.005 * std::cos(0.2), 0.0, 0.005 * std::sin(0.2));
    EXPECT_LT((in - Vector3(-expected.x(), 0.0, expected.z())).norm(), 1e-15);
    EXPECT_LT((out - expected).norm(), 1e-15);
    EXPECT_FALSE(row.waypoints[0].process_on || row.waypoints[1].process_on || row.waypoints[7].process_on);
    EXPECT_TRUE(row.waypoints[2].process_on && row.waypoints[6].process_on);
    EXPECT_NEAR(row.waypoints[7].arc_length, 0.11, 1e-15);
  }
}

// As in passes over the same rows: where one ends and the next begins the tool turns back.
TEST(Modifiers, TheToolIsNotWoundUpFromPassToPass) {
  ToolPath path = zigZag();
  const std::vector<Segment> pass = path.segments;
  for (int i = 0; i < 3; ++i) path.segments.insert(path.segments.end(), pass.begin(), pass.end());
  double turned = 0.0;
  const Frame* before = nullptr;
  path = withLinks(withLeads(std::move(path), {}), up, 0.02, {});
  for (const Segment& segment : path.segments) {
    for (const Waypoint& waypoint : segment.waypoints) {
      if (before != nullptr) {
        const Vector3 x = before->linear().transpose() * waypoint.pose.linear().col(0);
        turned += std::atan2(x.y(), x.x());
      }
      before = &waypoint.pose;
      EXPECT_LT(std::abs(turned), M_PI + 1e-6) << segment.name;
    }
  }
}

TEST(Modifiers, NoLeadLeavesTheContactsAlone) {
  const ToolPath bare = withLeads(withLeads(zigZag(), {}), {0.0, 0.0});
  EXPECT_EQ(test::largestDifference(bare, zigZag()), 0.0);
}

TEST(Modifiers, LinksJoinAllRowsInOrder) {
  const ToolPath path = complete();
  ASSERT_EQ(path.segments.size(), 9U);
  const char* names[] = {"approach", "row_0", "link_0_1", "row_1", "link_1_2", "row_2", "link_2_3", "row_3", "retract"};
  for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(path.segments[i].name, names[i]);
  for (const Segment& segment : path.segments) {
    EXPECT_FALSE(segment.waypoints.front().process_on) << segment.name;
    if (!isRow(segment)) {
      for (const Waypoint& waypoint : segment.waypoints) EXPECT_FALSE(waypoint.process_on) << segment.name;
    }
  }
}

TEST(Modifiers, LinksKeepTheClearanceAndPlungeAlongTheNormal) {
  LinkOptions options;
  options.approach = 0.007;
  options.clearance = 0.03;
  options.plunge_feed = 0.003;
  const ToolPath path = withLinks(withLeads(zigZag(), {0.005, 0.0}), up, 0.02, options);
  for (std::size_t s = 2; s < 8; s += 2) {
    const auto& link = path.segments[s].waypoints;
    const auto& next = path.segments[s + 1].waypoints;
    EXPECT_NEAR(link.front().pose.translation().z(), 0.007, 1e-15);
    for (std::size_t i = 1; i + 1 < link.size(); ++i) {
      // Over contacts at z = 0 and over its own ends, which are an approach above them.
      EXPECT_NEAR(link[i].pose.translation().z(), 0.037, 1e-15);
    }
    EXPECT_LT((link.back().pose.translation() - next.front().pose.translation() - 0.007 * up).norm(), 1e-15);
    EXPECT_EQ(next.front().feed, 0.003);
    EXPECT_EQ(next[2].feed, 0.02);
    EXPECT_EQ(link.back().feed, options.rapid_feed);
  }
}

TEST(Modifiers, LinksClimbOverWhatLiesBelowThem) {
  ToolPath path = test::planeRows(3, 0.1, 0.1, 10);
  // One way: the link from row 0 to row 1 flies back over the part; a hump on row 0 lies within the corridor.
  path.segments[0].waypoints[5].pose.translation().z() = 0.05;
  const auto height = [](const ToolPath& linked, std::size_t segment) {
    return linked.segments[segment].waypoints[1].pose.translation().z();
  };
  LinkOptions options;
  EXPECT_NEAR(height(withLinks(path, up, 0.06, options), 2), 0.05 + options.clearance, 1e-12);
  EXPECT_NEAR(height(withLinks(path, up, 0.02, options), 2), options.approach + options.clearance, 1e-12);
  EXPECT_NEAR(height(withLinks(path, up, 0.06, options), 4), options.approach + options.clearance, 1e-12);
}

TEST(Modifiers, LinksClimbOverWhatIsNotDriven) {
  // A row between the two, 50 mm high, that is left out of the path.
  const ToolPath all = test::planeRows(3, 0.01, 0.1, 10);
  ToolPath path = all;
  path.segments.erase(path.segments.begin() + 1);
  Segment left_out = all.segments[1];
  for (auto& waypoint : left_out.waypoints) waypoint.pose.translation().z() = 0.05;
  LinkOptions options;
  const auto height = [](const ToolPath& linked) { return linked.segments[2].waypoints[1].pose.translation().z(); };
  EXPECT_NEAR(height(withLinks(path, up, 0.02, options)), options.approach + options.clearance, 1e-12);
  EXPECT_NEAR(height(withLinks(path, up, 0.02, options, {positionsOf(left_out)})), 0.05 + options.clearance, 1e-12);
}

TEST(Modifiers, TheToolTurnsToAndFroBetweenZigZagRows) {
  const ToolPath path = complete();
  double turned = 0.0;
  for (std::size_t s = 2; s < 8; s += 2) {
    const auto& link = path.segments[s].waypoints;
    double turn = 0.0;
    for (std::size_t i = 1; i < link.size(); ++i) {
      const Eigen::Matrix3d R = link[i - 1].pose.linear().transpose() * link[i].pose.linear();
      const Eigen::AngleAxisd step(R);
      EXPECT_LE(step.angle(), M_PI / 4 + 1e-9);
      turn += step.angle() * step.axis().z();
    }
    EXPECT_NEAR(std::abs(turn), M_PI, 1e-9);
    turned += turn;
    EXPECT_LT(std::abs(turned), M_PI + 1e-9);  // never adds up
  }
}

TEST(Modifiers, MoveWithThePath) {
  Random random(5);
  const Frame T = test::randomFrame(random);
  const ToolPath moved = withLinks(withLeads(test::moved(zigZag(), T), {}), T.linear() * up, 0.02, {});
  EXPECT_LT(test::largestDifference(moved, test::moved(complete(), T)), 1e-12);
}

TEST(Modifiers, RejectWhatTheyCannotDo) {
  test::expectInputError([] { withLinks({}, up, 0.02, {}); }, "no segment works");
  test::expectInputError([] { withLeads(zigZag(), {-1.0, 0.0}); }, "leads.length is -1 m");
  LinkOptions options;
  options.rapid_feed = 0.0;
  test::expectInputError([&] { withLinks(zigZag(), up, 0.02, options); }, "links.rapid_feed");
}

}  // namespace
}  // namespace scan_to_path::toolpath
