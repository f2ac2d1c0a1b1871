// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/sensing/row_comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/sensing_cell.h"

namespace scan_to_path::sensing {
namespace {

using test::SensingCell;

/// Rows to and fro at y = 0, 1, 2, … mm.
std::vector<MotionRow> zigZag(std::size_t count) {
  std::vector<MotionRow> rows;
  for (std::size_t r = 0; r < count; ++r) rows.push_back({0, 1, r % 2 == 0, 0.001 * static_cast<double>(r)});
  return rows;
}

TEST(ChooseGroups, AllGroupsOfAZigZag) {
  EXPECT_THAT(chooseGroups(zigZag(7), 60), testing::ElementsAre(0U, 1U, 2U, 3U));
  EXPECT_TRUE(chooseGroups(zigZag(3), 60).empty());
  EXPECT_TRUE(chooseGroups({}, 60).empty());
}

TEST(ChooseGroups, GroupsDoNotReachOverIrregularities) {
  auto rows = zigZag(9);
  rows[4].is_forward = false;  // three in the same direction
  EXPECT_THAT(chooseGroups(rows, 60), testing::ElementsAre(0U, 5U));
  rows = zigZag(8);
  for (std::size_t r = 4; r < 8; ++r) rows[r].across += 0.02;  // a jump over to another field
  EXPECT_THAT(chooseGroups(rows, 60), testing::ElementsAre(0U, 4U));
  rows = zigZag(8);
  for (std::size_t r = 4; r < 8; ++r) rows[r].across = 0.007 - 0.001 * static_cast<double>(r);  // back over the part
  EXPECT_THAT(chooseGroups(rows, 60), testing::ElementsAre(0U, 4U));
}

TEST(ChooseGroups, ManyRowsAreSampledFromEndToEnd) {
  const auto groups = chooseGroups(zigZag(1000), 24);
  EXPECT_EQ(groups.size(), 3U * 5U);  // three blocks of eight rows
  EXPECT_EQ(groups.front(), 0U);
  EXPECT_EQ(groups.back(), 996U);
}

/// Comparisons of an error-free scan with samples placed `offset` too late.
std::vector<RowComparison> compare(const SensingCell& cell, double offset, const EmulationOptions& options = {}) {
  const auto log = cell.emulate(options).log;
  const auto encoders = cell.encoders();
  const JointReadings readings(log, cell.robot, encoders, 0.05);
  const SensorMotion motion(readings, cell.robot, cell.T_tip_sensor);
  const RowMotion rows = findRowMotion(log, motion, 0.0);
  return compareRows(log, cell.laser, motion, rows, chooseGroups(rows.rows, 60), {}, offset);
}

TEST(CompareRows, DifferencesAreGainTimesTheClocksError) {
  SensingCell cell = SensingCell::small();
  // A ridge along the rows' across direction: no third difference of its own.
  cell.scene = std::make_shared<geometry::PosedSurface>(std::make_shared<geometry::Cylinder>(0.2),
                                                        geometry::makeFrame({0.02, 0.01, -0.2}, {M_PI_2, 0.0, 0.0}));
  cell.rectangle.max().x() = 0.08;
  for (const double offset : {0.0, 1e-3, -3e-3}) {
    const auto comparisons = compare(cell, offset);
    EXPECT_GT(comparisons.size(), 40U);
    for (const auto& c : comparisons) {
      // Second order: (v dt)^2 z_xx / 2 with z_xx < 6 / m. Straight lines over W = 4 mm err by z_xx W^2 / 24 = 4 um
      // alike in all rows, but for the sampling's phase: half a sample of 0.25 mm at each end is 2 / 16 of that.
      EXPECT_NEAR(c.difference, -offset * c.gain, 3.0 * std::pow(0.05 * offset, 2) + 0.5e-6);
      EXPECT_LE(std::abs(c.gain), 0.05 * 0.4);
    }
  }
}

TEST(CompareRows, PlanesHaveNothingToCompare) {
  SensingCell cell = SensingCell::small();
  cell.scene = std::make_shared<geometry::Plane>();
  EXPECT_TRUE(compare(cell, 1e-3).empty());
  EmulationOptions options;
  options.errors = errorPreset(ErrorSet::white);
  options.errors.noise_sigma = 100e-6;
  EXPECT_TRUE(compare(cell, 1e-3, options).empty());
}

TEST(CompareRows, SpikesAndEdgesAreLeftOut) {
  SensingCell cell = SensingCell::small();
  EmulationOptions options;
  options.errors.spike_rate = 0.002;
  // 2 groups of up to 121 places; the part's third difference is below 0.3 um, a spike of 0.2 mm would be 10 um.
  const auto clean = compare(cell, 0.0);
  const auto spiked = compare(cell, 0.0, options);
  EXPECT_GT(spiked.size(), clean.size() / 2);
  for (const auto& c : spiked) EXPECT_LT(std::abs(c.difference), 2e-6);
}

}  // namespace
}  // namespace scan_to_path::sensing
