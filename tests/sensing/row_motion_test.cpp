// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/sensing/row_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/sensing_cell.h"

namespace scan_to_path::sensing {
namespace {

using test::SensingCell;

RowMotion rowsOf(const SensingCell& cell, const scan::SampleLog& log) {
  const auto encoders = cell.encoders();
  const JointReadings readings(log, cell.robot, encoders, 0.05);
  return findRowMotion(log, SensorMotion(readings, cell.robot, cell.T_tip_sensor), 0.0);
}

void expectRows(const SensingCell& cell, const EmulationOptions& options, bool to_and_fro) {
  const auto scan = cell.emulate(options);
  const RowMotion motion = rowsOf(cell, scan.log);
  const RasterPlan plan = planRaster(cell.rectangle, options.raster);
  ASSERT_EQ(motion.rows.size(), static_cast<std::size_t>(plan.rows));
  const Vector3 along = cell.T_base_workpiece.linear() * (plan.moves[0].to - plan.moves[0].from).normalized();
  EXPECT_NEAR(std::abs(motion.R_base_row.col(0).dot(along)), 1.0, 1e-9);
  EXPECT_NEAR(motion.R_base_row.determinant(), 1.0, 1e-12);
  for (std::size_t r = 0; r < motion.rows.size(); ++r) {
    const MotionRow& row = motion.rows[r];
    if (r > 0) {
      EXPECT_EQ(row.is_forward != motion.rows[r - 1].is_forward, to_and_fro);
      // The axis of most of the motion is the rows', to rounding, and so is the pitch.
      EXPECT_NEAR(std::abs(row.across - motion.rows[r - 1].across), options.raster.pitch, 1e-7);
    }
    const RasterMove& move = plan.moves[moveAt(plan, scan.log.sensor_time[(row.first + row.last) / 2])];
    EXPECT_TRUE(move.is_row);
    EXPECT_EQ(move.row, static_cast<int>(r));
    // The row but its ramps, each of which takes 50 ms, and a look at either end.
    const double duration = scan.log.sensor_time[row.last - 1] - scan.log.sensor_time[row.first];
    EXPECT_NEAR(duration, move.profile.duration() - move.profile.rampDuration(), 0.03);
  }
}

TEST(RowMotion, ZigZagRowsAreFound) { expectRows(SensingCell::small(), {}, true); }

TEST(RowMotion, OneWayRowsAreFound) {
  EmulationOptions options;
  options.raster.order = RasterOrder::one_way;
  expectRows(SensingCell::small(), options, false);
}

TEST(RowMotion, TurnedWorkpiecesAndRowsAreFound) {
  SensingCell cell;
  cell.T_base_workpiece = geometry::makeFrame({0.8, -0.05, 0.42}, {0.1, -0.05, 0.4});
  EmulationOptions options;
  options.raster.row_angle = M_PI_2;
  options.raster.pitch = 0.02;
  expectRows(cell, options, true);
}

TEST(RowMotion, ASensorAtRestMakesNoRows) {
  const SensingCell cell = SensingCell::small();
  auto log = cell.emulate({}).log;
  for (std::size_t k = 6; k < log.counts.size(); ++k) log.counts[k] = log.counts[k - 6];
  EXPECT_TRUE(rowsOf(cell, log).rows.empty());
  log.sensor_time.resize(2);
  log.voltage.resize(2);
  EXPECT_TRUE(rowsOf(cell, log).rows.empty());
}

}  // namespace
}  // namespace scan_to_path::sensing
