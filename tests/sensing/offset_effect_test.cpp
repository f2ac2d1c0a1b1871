// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/sensing/offset_effect.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "scan_to_path/common/random.h"

namespace scan_to_path::sensing {
namespace {

constexpr double sample_period = 1e-3;  // [s]
constexpr double row_speed = 0.05;      // [m/s]
constexpr double clocks_off = 0.01;     // [s]: stretches of ten samples, 0.5 mm
constexpr double cut_out = std::numeric_limits<double>::quiet_NaN();

struct TimedRows {
  scan::SampleRows rows;
  scan::ScanCloud cloud;
};

using Height = std::function<double(double x, int row)>;

/// Ten rows of 0.1 m to and fro with samples 50 um apart; `height` of NaN cuts a row in two pieces.
TimedRows timedRows(const Height& height, double noise = 0.0) {
  TimedRows scan;
  Random random(3);
  for (int row = 0; row < 10; ++row) {
    bool is_cut = true;
    for (int i = 0; i < 2000; ++i) {
      const double x = (i + 0.5) * sample_period * row_speed;
      const double z = height(x, row) + noise * random.gaussian();
      if (std::isnan(z)) {
        is_cut = true;
        continue;
      }
      if (is_cut) scan.rows.pieces.emplace_back();
      is_cut = false;
      auto& piece = scan.rows.pieces.back();
      piece.row = row;
      piece.forward = row % 2 == 0;
      piece.x.push_back(x);
      piece.y.push_back(0.004 * row);
      piece.z.push_back(z);
      piece.index.push_back(static_cast<std::uint32_t>(scan.cloud.size()));
      scan::ScanPoint point;
      point.getVector3fMap() = Eigen::Vector3d(x, 0.004 * row, z).cast<float>();
      point.time = 3.0 * row + (piece.forward ? i : 2000 - i) * sample_period;
      scan.cloud.push_back(point);
    }
  }
  return scan;
}

OffsetEffect effectOf(const Height& height, double noise = 0.0) {
  const TimedRows scan = timedRows(height, noise);
  return offsetEffect(scan.rows, scan.cloud, clocks_off);
}

TEST(OffsetEffect, OfASlopeIsSpeedTimesOffsetTimesSlope) {
  EXPECT_EQ(effectOf([](double, int) { return 0.02; }).height, 0.0);
  for (const double slope : {-0.3, 0.001, 1.0}) {
    const OffsetEffect effect = effectOf([slope](double x, int) { return slope * x; });
    EXPECT_NEAR(effect.height, std::abs(slope) * row_speed * clocks_off, 1e-12);
    EXPECT_NEAR(effect.noise, 0.0, 1e-12);
  }
}

// On one row alone, as on all of them.
TEST(OffsetEffect, OfAStepIsItsHeight) {
  const auto step = [](double x, int row) { return row == 4 && x > 0.0512 ? 1e-3 : 0.0; };
  const OffsetEffect effect = effectOf(step);
  EXPECT_NEAR(effect.height, 1e-3, 1e-12);
  EXPECT_NEAR(effect.place.x(), 0.0512, 2.0 * row_speed * clocks_off);
  EXPECT_NEAR(effect.place.y(), 0.016, 1e-6);
  // Where the step cuts the row, and samples of its edge are gone.
  const auto cut = [](double x, int) { return std::abs(x - 0.05) < 0.0003 ? cut_out : (x > 0.05 ? 1e-3 : 0.0); };
  EXPECT_NEAR(effectOf(cut).height, 1e-3, 1e-12);
  // Beyond a hole of 5 mm begins another surface; a wall beside it has no place on this one.
  const auto hole = [](double x, int) { return std::abs(x - 0.05) < 0.0025 ? cut_out : (x > 0.05 ? 1e-3 : 0.0); };
  EXPECT_EQ(effectOf(hole).height, 0.0);
}

TEST(OffsetEffect, SeesTheLastSamplesOfARow) {
  EXPECT_NEAR(effectOf([](double x, int) { return x > 0.09965 ? 1e-3 : 0.0; }).height, 1e-3, 1e-12);
}

// Spikes of a realistic scan, and four on end: a stretch's median does not see them.
TEST(OffsetEffect, SpikesAreNone) {
  Random random(5);
  EXPECT_EQ(effectOf([&](double, int) { return random.uniform() < 0.002 ? 5e-3 : 0.0; }).height, 0.0);
  EXPECT_EQ(effectOf([](double x, int) { return x > 0.03 && x < 0.0302 ? 5e-3 : 0.0; }).height, 0.0);
  EXPECT_NEAR(effectOf([](double x, int) { return x > 0.03 && x < 0.031 ? 5e-3 : 0.0; }).height, 5e-3, 1e-12);
}

// A median of ten has 1.2 times (at most) the standard deviation of their mean; two of them, sqrt(2) times that.
TEST(OffsetEffect, KnowsItsNoiseWhateverTheShape) {
  constexpr double sigma = 1e-5;
  const double expected = 1.2 * sigma * std::sqrt(2.0 / 10.0);
  const OffsetEffect flat = effectOf([](double, int) { return 0.0; }, sigma);
  EXPECT_NEAR(flat.noise, expected, 0.1 * expected);  // of 2000 stretches, and the median's own factor
  EXPECT_LT(flat.height, 6.0 * flat.noise);
  const OffsetEffect wave = effectOf([](double x, int) { return 0.01 * std::sin(60.0 * x); }, sigma);
  // On a slope a median is the sample in the middle. Third differences of the wave itself are 0.27 um at most.
  EXPECT_GT(wave.noise, expected);
  EXPECT_LT(wave.noise, std::sqrt(2.0) * sigma);
  EXPECT_GT(wave.height, 20.0 * wave.noise);
  EXPECT_GT(effectOf([](double, int) { return 0.0; }, 2.0 * sigma).noise, 1.5 * expected);  // twin
}

TEST(OffsetEffect, SlowSensorsAreComparedOverFiveSamples) {
  const TimedRows scan = timedRows([](double x, int) { return 0.1 * x; });
  EXPECT_NEAR(offsetEffect(scan.rows, scan.cloud, 1e-4).height, 0.1 * 5.0 * sample_period * row_speed, 1e-12);
  EXPECT_EQ(offsetEffect({}, {}, clocks_off).height, 0.0);
}

}  // namespace
}  // namespace scan_to_path::sensing
