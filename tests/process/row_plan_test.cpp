// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/process/row_plan.h"

#include <gtest/gtest.h>

#include "scan_to_path/toolpath/scallop.h"
#include "support/expect_input_error.h"
#include "support/flat_plate.h"

namespace scan_to_path::process {
namespace {

constexpr double plan_radius = 0.02;  // [m]

/// From x = begin to x = end on the plate's plane, at y = 4 mm times its number.
Row straightRow(int number, double begin, double end) {
  Row row;
  row.row = number;
  for (int i = 0; i <= 10; ++i) {
    const double t = begin + (end - begin) * i / 10.0;
    row.points.push_back({t, {t, 0.004 * number, 0.01}, Vector3::UnitZ(), Vector3::UnitX()});
  }
  return row;
}

RowPlan plan(const std::vector<Row>& pieces, const std::vector<int>& numbers) {
  return planOf(pieces, numbers, pieces, Eigen::Vector2d::UnitY(), toolpath::ScanSurface(test::flatPlate().surface),
                plan_radius);
}

TEST(RowPlan, NumbersPiecesAndMeasuresBetweenNeighbours) {
  const RowPlan whole = plan({straightRow(2, 0.0, 0.04), straightRow(2, 0.06, 0.1), straightRow(3, 0.0, 0.1)}, {2, 3});
  EXPECT_EQ(whole.rows[1].piece, 1);
  EXPECT_EQ(whole.rows[1].pieces, 2);
  EXPECT_EQ(whole.last_row, 3);
  ASSERT_EQ(whole.distances.size(), 1U);
  EXPECT_NEAR(whole.distances[0], 0.004, 1e-15);
  // The cusp of two cylinders on a plane, to the rounding of a surface at z = 10 mm.
  EXPECT_NEAR(whole.widest_scallop, toolpath::scallopHeight(0.004, plan_radius, 0.0), 1e-12);
  EXPECT_EQ(rowCount(whole.rows), 2);
}

// Row 2 is there but not driven: between 1 and 3 nothing is known. Where the part has no row 2 they are neighbours.
TEST(RowPlan, NeighboursAreThoseOfTheWholePart) {
  const std::vector<Row> pieces = {straightRow(1, 0.0, 0.1), straightRow(3, 0.0, 0.1)};
  EXPECT_TRUE(plan(pieces, {1, 2, 3}).distances.empty());
  EXPECT_EQ(plan(pieces, {1, 2, 3, 4}).last_row, 4);
  ASSERT_EQ(plan(pieces, {1, 3}).distances.size(), 1U);
  EXPECT_NEAR(plan(pieces, {1, 3}).distances[0], 0.008, 1e-15);
  const std::vector<Row> far = {straightRow(0, 0.0, 0.1), straightRow(11, 0.0, 0.1)};  // 44 mm: a ball's width is 40
  test::expectInputError([&] { plan(far, {0, 11}); }, "are so far apart");
  EXPECT_NO_THROW(plan(far, {0, 5, 11}));
}

TEST(RowPlan, SkipsRowsAndLeavesSome) {
  const std::vector<Row> pieces = {straightRow(0, 0.0, 0.1), straightRow(1, 0.0, 0.04), straightRow(1, 0.06, 0.1),
                                   straightRow(2, 0.0, 0.1)};
  EXPECT_EQ(withoutSkipped(pieces, "").size(), 4U);
  EXPECT_EQ(withoutSkipped(pieces, "1").size(), 2U);
  test::expectInputError([&] { withoutSkipped(pieces, "0-2"); }, "path.skip_rows is \"0-2\": none of 3 rows is left");
  test::expectInputError([] { withoutSkipped({}, ""); }, "no row lies in path.region");
}

}  // namespace
}  // namespace scan_to_path::process
