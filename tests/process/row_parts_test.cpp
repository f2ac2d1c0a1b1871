// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/process/row_parts.h"

#include <gtest/gtest.h>

#include "scan_to_path/toolpath/modifiers.h"
#include "support/paths.h"

namespace scan_to_path::process {
namespace {

using toolpath::WaypointIndex;

std::set<std::pair<int, int>> pairs(const std::set<WaypointIndex>& places) {
  std::set<std::pair<int, int>> result;
  for (const auto& at : places) result.insert({at.segment, at.index});
  return result;
}

/// Two rows of eleven contacts, 10 mm apart, with leads: contacts 1 to 11 of segments 0 and 1.
toolpath::ToolPath rows(int count = 2) { return toolpath::withLeads(test::planeRows(count, 0.004, 0.1, 10, true), {}); }

TEST(RowParts, AWholeRowStaysAsItIs) {
  const CutRows cut = cutRows(rows(), {}, 1.0);
  ASSERT_EQ(cut.rows.size(), 2U);
  EXPECT_EQ(cut.rows[1].name, "row_1");
  EXPECT_EQ(cut.rows[1].waypoints.size(), 11U);
  EXPECT_EQ(cut.parts[1].source, 1);
  EXPECT_EQ(cut.parts[1].first, 1);
  EXPECT_TRUE(cut.left_out.empty());
}

TEST(RowParts, RunsBetweenLeftOutContacts) {
  // Row 0 without contacts 3 and 8: runs of 2, 4 and 3 contacts, 10, 30 and 20 mm long.
  const std::set<WaypointIndex> out = {{0, 3}, {0, 8}};
  const CutRows cut = cutRows(rows(), out, 0.0199);
  ASSERT_EQ(cut.rows.size(), 3U);
  EXPECT_EQ(cut.rows[0].name, "row_0_part_0");
  EXPECT_EQ(cut.rows[1].name, "row_0_part_1");
  EXPECT_EQ(cut.rows[2].name, "row_1");
  EXPECT_EQ(cut.parts[0].first, 4);
  EXPECT_EQ(cut.parts[1].first, 9);
  EXPECT_EQ(cut.rows[0].waypoints.size(), 4U);
  EXPECT_FALSE(cut.rows[0].waypoints.front().process_on);
  EXPECT_TRUE(cut.rows[0].waypoints[1].process_on);
  EXPECT_EQ(pairs(cut.left_out), (std::set<std::pair<int, int>>{{0, 1}, {0, 2}, {0, 3}, {0, 8}}));
  // No run joins what lay on both sides of a contact that is left out.
  for (const auto& row : cut.rows) {
    for (std::size_t i = 1; i < row.waypoints.size(); ++i) {
      const double step = (row.waypoints[i].pose.translation() - row.waypoints[i - 1].pose.translation()).norm();
      EXPECT_NEAR(step, 0.01, 1e-12);
    }
  }
}

TEST(RowParts, ASingleContactIsNoRow) { EXPECT_EQ(cutRows(rows(1), {{0, 2}}, 0.0).rows.size(), 1U); }

TEST(RowParts, SourceOfFindsTheWaypointAgain) {
  const auto whole = rows();
  const CutRows cut = cutRows(whole, {{0, 3}, {0, 8}}, 0.0);
  toolpath::ToolPath path = whole;
  path.segments = cut.rows;
  path = toolpath::withLeads(path, {});
  for (int s = 0; s < static_cast<int>(path.segments.size()); ++s) {
    const auto& waypoints = path.segments[static_cast<std::size_t>(s)].waypoints;
    EXPECT_FALSE(sourceOf(path, cut.parts, {s, 0}));
    EXPECT_FALSE(sourceOf(path, cut.parts, {s, static_cast<int>(waypoints.size()) - 1}));
    for (int i = 1; i + 1 < static_cast<int>(waypoints.size()); ++i) {
      const auto source = sourceOf(path, cut.parts, {s, i});
      ASSERT_TRUE(source);
      const auto& pose = whole.segments[static_cast<std::size_t>(source->segment)]
                             .waypoints[static_cast<std::size_t>(source->index)]
                             .pose;
      EXPECT_EQ((pose.translation() - waypoints[static_cast<std::size_t>(i)].pose.translation()).norm(), 0.0);
    }
  }
}

TEST(RowParts, WhatAPassLeavesOutTheNextDoesToo) {
  // Three passes over two rows: what pass 0 drops as too short, passes 1 and 2 must drop as well, but pass 0 keeps what
  // only pass 1 leaves out.
  const CutRows cut = cutPasses(rows(6), {{0, 3}, {3, 8}}, 3, 0.0199);
  const std::set<std::pair<int, int>> expected = {{0, 1}, {0, 2}, {0, 3}, {2, 1}, {2, 2}, {2, 3},
                                                  {4, 1}, {4, 2}, {4, 3}, {3, 8}, {5, 8}};
  EXPECT_EQ(pairs(cut.left_out), expected);
}

}  // namespace
}  // namespace scan_to_path::process
