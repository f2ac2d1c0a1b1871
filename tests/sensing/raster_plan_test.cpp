// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/sensing/raster_plan.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scan_to_path/common/random.h"
#include "support/expect_input_error.h"

namespace scan_to_path::sensing {
namespace {

Eigen::AlignedBox2d sPartRectangle() { return {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(0.24, 0.16)}; }

std::vector<RasterMove> rowsOf(const RasterPlan& plan) {
  std::vector<RasterMove> rows;
  for (const auto& move : plan.moves) {
    if (move.is_row) rows.push_back(move);
  }
  return rows;
}

TEST(TrapezoidProfile, KeepsSpeedAndAcceleration) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const double length = random.uniform(0.0, 0.3), speed = random.uniform(0.01, 0.5), a = random.uniform(0.1, 5.0);
    const TrapezoidProfile profile(length, speed, a);
    EXPECT_EQ(profile.distanceAt(0.0), 0.0);
    EXPECT_NEAR(profile.distanceAt(profile.duration()), length, 1e-15);
    const double h = profile.duration() / 200.0;
    for (int k = 1; k < 200 && length > 0.0; ++k) {
      const double before = profile.distanceAt((k - 1) * h), here = profile.distanceAt(k * h);
      const double after = profile.distanceAt((k + 1) * h);
      EXPECT_GE(here, before);
      EXPECT_LE(here - before, speed * h * (1.0 + 1e-9));
      // Rounding of a second difference of lengths below 0.3 m.
      EXPECT_LE(std::abs(after - 2.0 * here + before), a * h * h + 4.0 * 0.3 * 2.3e-16);
    }
  }
}

TEST(TrapezoidProfile, LongMovesCruiseShortOnesDoNot) {
  const TrapezoidProfile row(0.25, 0.05, 1.0);
  EXPECT_NEAR(row.rampDuration(), 0.05, 1e-15);
  EXPECT_NEAR(row.duration(), 0.25 / 0.05 + 0.05, 1e-12);
  EXPECT_NEAR(row.distanceAt(0.05), 0.00125, 1e-15);
  const TrapezoidProfile step(0.001, 0.05, 1.0);
  EXPECT_NEAR(step.duration(), 2.0 * std::sqrt(0.001), 1e-12);
}

TEST(RasterPlan, SPartHasFortyRowsInsideIt) {
  const RasterPlan plan = planRaster(sPartRectangle(), {});
  const auto rows = rowsOf(plan);
  ASSERT_EQ(rows.size(), 40U);
  EXPECT_EQ(plan.rows, 40);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double y = 0.002 + 0.004 * static_cast<double>(i);
    const double sense = i % 2 == 0 ? 1.0 : -1.0;
    EXPECT_LT((rows[i].from - Vector3(0.12 - sense * 0.125, y, 0.08)).norm(), 1e-12);
    EXPECT_LT((rows[i].to - Vector3(0.12 + sense * 0.125, y, 0.08)).norm(), 1e-12);
    EXPECT_EQ(rows[i].row, static_cast<int>(i));
  }
}

TEST(RasterPlan, MovesFollowOneAnotherWithoutPause) {
  const RasterPlan plan = planRaster(sPartRectangle(), {});
  double time = 0.0;
  for (std::size_t i = 0; i < plan.moves.size(); ++i) {
    EXPECT_NEAR(plan.moves[i].begin, time, 1e-9);
    if (i > 0) {
      EXPECT_EQ(plan.moves[i].from, plan.moves[i - 1].to);
    }
    time += plan.moves[i].profile.duration();
    EXPECT_TRUE(plan.moves[i].is_recorded);
  }
  EXPECT_NEAR(plan.duration, time, 1e-9);
}

TEST(RasterPlan, PitchesTakeTurns) {
  RasterOptions options;
  options.pitch = 0.003;
  options.pitch_alternate = 0.005;
  const auto rows = rowsOf(planRaster(sPartRectangle(), options));
  ASSERT_EQ(rows.size(), 40U);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    EXPECT_NEAR(rows[i].from.y() - rows[i - 1].from.y(), i % 2 == 1 ? 0.003 : 0.005, 1e-12);
  }
  EXPECT_NEAR(rows.front().from.y(), 0.16 - rows.back().from.y(), 1e-12);
}

TEST(RasterPlan, OneWayRowsRunOneWayAndReturnUnrecorded) {
  RasterOptions options;
  options.order = RasterOrder::one_way;
  const RasterPlan plan = planRaster(sPartRectangle(), options);
  for (const auto& move : plan.moves) {
    EXPECT_EQ(move.is_recorded, move.is_row);
    EXPECT_EQ(move.to.x() > move.from.x(), move.is_row);
  }
}

TEST(RasterPlan, TurnedRowsCoverTheRectangle) {
  for (const double angle : {M_PI_2, -0.7, 0.3}) {
    RasterOptions options;
    options.row_angle = angle;
    const auto rows = rowsOf(planRaster(sPartRectangle(), options));
    const Eigen::Vector2d along(std::cos(angle), std::sin(angle)), across(-std::sin(angle), std::cos(angle));
    Random random(3);
    for (int i = 0; i < 500; ++i) {
      const Eigen::Vector2d p(random.uniform(0.0, 0.24), random.uniform(0.0, 0.16));
      double nearest = 1.0;
      for (const auto& row : rows) {
        const Eigen::Vector2d from = row.from.head<2>(), to = row.to.head<2>();
        EXPECT_NEAR(std::abs((to - from).normalized().dot(along)), 1.0, 1e-12);
        if ((p - from).dot(along) * (p - to).dot(along) > 0.0) continue;
        nearest = std::min(nearest, std::abs((p - from).dot(across)));
      }
      EXPECT_LE(nearest, 0.5 * options.pitch + 1e-12);
    }
  }
}

TEST(RasterPlan, SensorLooksDownAndTurnsAboutItsBeam) {
  RasterOptions options;
  options.row_angle = 0.4;
  options.beam_turn = 0.3;
  const Eigen::Matrix3d R = planRaster(sPartRectangle(), options).R_workpiece_sensor;
  EXPECT_LT((R.col(2) + Vector3::UnitZ()).norm(), 1e-12);
  EXPECT_NEAR(R.determinant(), 1.0, 1e-12);
  // Turning about a beam that points down is turning the other way seen from above.
  EXPECT_LT((R.col(0) - Vector3(std::cos(0.1), std::sin(0.1), 0.0)).norm(), 1e-12);
}

TEST(RasterPlan, MoveAtFindsTheMoveFromAnyCursor) {
  const RasterPlan plan = planRaster(sPartRectangle(), {});
  Random random(4);
  for (int i = 0; i < 1000; ++i) {
    const double t = random.uniform(0.0, plan.duration);
    const std::size_t move = moveAt(plan, t, static_cast<std::size_t>(random.uniform(0.0, 100.0)));
    EXPECT_LE(plan.moves[move].begin, t);
    if (move + 1 < plan.moves.size()) {
      EXPECT_GT(plan.moves[move + 1].begin, t);
    }
  }
}

TEST(RasterPlan, BadInputIsNamed) {
  RasterOptions options;
  options.pitch = 0.0;
  test::expectInputError([&] { planRaster(sPartRectangle(), options); }, "raster.pitch is 0 m, must be in [1e-05, 1]");
  options = {};
  options.pitch_alternate = 1e-7;
  test::expectInputError([&] { planRaster(sPartRectangle(), options); }, "100000th of the width");
  options = {};
  options.speed = std::nan("");
  test::expectInputError([&] { planRaster(sPartRectangle(), options); }, "raster.speed is nan");
  test::expectInputError(
      [] {
        planRaster({Eigen::Vector2d(0, 0), Eigen::Vector2d(0.24, 0)}, {});
      },
      "raster: extent along y is 0.000000 m, must be positive and finite");
  test::expectInputError([] { planRaster(Eigen::AlignedBox2d(), {}); }, "extent along x");
}

}  // namespace
}  // namespace scan_to_path::sensing
