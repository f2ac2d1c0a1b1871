// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "../src/pipeline/row_cuts.h"

#include <gtest/gtest.h>

#include "scan_to_path/toolpath/modifiers.h"
#include "support/paths.h"

namespace scan_to_path::pipeline {
namespace {

using toolpath::Verdict;
using toolpath::WaypointIndex;

/// Two rows of 101 contacts, 1 mm apart, without some of their contacts: approach, rows, links and retract.
process::PlannedPath rowsWithout(const std::set<WaypointIndex>& left_out) {
  const toolpath::ToolPath whole = test::planeRows(2, 0.004, 0.1, 100);
  const process::CutRows cut = process::cutRows(whole, left_out, 0.005);
  process::PlannedPath planned;
  planned.path = whole;
  planned.path.segments = cut.rows;
  planned.path = toolpath::withLinks(toolpath::withLeads(planned.path, {}), geometry::Vector3::UnitZ(), 0.02, {});
  auto next = cut.parts.begin();
  for (const auto& segment : planned.path.segments) {
    planned.parts.push_back(toolpath::isRow(segment) ? *next++ : process::RowPart{});
  }
  return planned;
}

std::vector<toolpath::WaypointVerdict> failingAt(const std::vector<WaypointIndex>& places) {
  std::vector<toolpath::WaypointVerdict> verdicts;
  for (const auto& at : places) verdicts.push_back({at.segment, at.index, Verdict::jump, -1.0, "rad", "why", "how"});
  return verdicts;
}

std::size_t leftOutOf(const RowCuts& cuts, int row) {
  std::size_t count = 0;
  for (const auto& [place, cause] : cuts.causes()) count += place.segment == row ? 1 : 0;
  return count;
}

TEST(RowCuts, EveryRowEndGoesBackByItself) {
  // Contacts are 1 mm apart: going back by 2.6, 5.2, 10.4 mm from an end leaves out 3, 6, 11 contacts.
  RowCuts cuts(0.0026);
  constexpr int row_0 = 1, link = 2, row_1 = 3;
  for (const std::size_t expected : {3U, 9U, 20U}) {
    const auto planned = rowsWithout(cuts.places());
    // The lead-in of row 0 and the approach to it are one end: it goes back once a round.
    ASSERT_TRUE(cuts.cutRowEnds(planned, failingAt({{0, 1}, {row_0, 0}})));
    EXPECT_EQ(leftOutOf(cuts, 0), expected);
  }
  // The first failure elsewhere costs an eighth again, whatever row 0's start has come to.
  const auto planned = rowsWithout(cuts.places());
  ASSERT_TRUE(cuts.cutRowEnds(planned, failingAt({{link, 0}, {row_1, 0}})));
  EXPECT_EQ(leftOutOf(cuts, 0), 23U);
  EXPECT_EQ(leftOutOf(cuts, 1), 3U);
  EXPECT_EQ(cuts.causes().count({0, 100}), 1U);
  EXPECT_EQ(cuts.causes().at({1, 2}).verdict.index, 0);  // the contact at the end whose way fails
}

TEST(RowCuts, ContactsThatFailAreCountedOnce) {
  RowCuts cuts(0.0026);
  const auto planned = rowsWithout({});
  EXPECT_EQ(cuts.cutContacts(planned, failingAt({{0, 0}, {1, 1}, {1, 2}})), 2U);  // the approach is no contact
  EXPECT_EQ(cuts.cutContacts(planned, failingAt({{1, 2}})), 0U);
  EXPECT_EQ(cuts.causes().at({0, 1}).kind, LeftOutKind::fails);
}

}  // namespace
}  // namespace scan_to_path::pipeline
