// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/sensing/place_samples.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "support/expect_input_error.h"
#include "support/sensing_cell.h"

namespace scan_to_path::sensing {
namespace {

using test::SensingCell;

Vector3 pointAt(const PlacedScan& scan, std::size_t i) { return scan.cloud.points[i].getVector3fMap().cast<double>(); }

std::size_t droppedFor(const PlacedScan& scan, const std::string& reason) {
  for (const auto& entry : scan.dropped) {
    if (entry.reason == reason) return entry.count;
  }
  return 0;
}

/// The arm's joints at rest at a few random places, one sample each, laser at 80 mm.
scan::SampleLog randomStills(const SensingCell& cell, std::vector<robot::JointVector>& joints) {
  scan::SampleLog log;
  Random random(11);
  const auto encoders = cell.encoders();
  for (const auto& joint : cell.robot.joints) log.joint_names.push_back(joint.name);
  for (int i = 0; i < 100; ++i) {
    joints.push_back(test::randomJoints(cell.robot, random));
    const auto counts = encoders.counts(joints.back());
    log.counts.insert(log.counts.end(), counts.data(), counts.data() + counts.size());
    log.joint_time.push_back(2.0 + i);
    log.sensor_time.push_back(2.0 + i);
    log.voltage.push_back(0.0);
  }
  return log;
}

double largestDistance(const PlacedScan& scan, const geometry::Surface& scene, const Frame& T_base_workpiece) {
  const Frame T_workpiece_base = T_base_workpiece.inverse();
  double largest = 0.0;
  for (std::size_t i = 0; i < scan.cloud.size(); i += 3) {
    const Vector3 p = T_workpiece_base * pointAt(scan, i);
    largest = std::max(largest, (scene.closestPoint(p).point - p).norm());
  }
  return largest;
}

bool areSameBytes(const PlacedScan& a, const PlacedScan& b) {
  if (a.cloud.size() != b.cloud.size() || a.mean_beam != b.mean_beam) return false;
  for (std::size_t i = 0; i < a.cloud.size(); ++i) {
    const auto& p = a.cloud[i];
    const auto& q = b.cloud[i];
    if (std::memcmp(p.data, q.data, 3 * sizeof(float)) != 0 || p.line != q.line || p.time != q.time) return false;
  }
  return true;
}

TEST(PlaceSamples, AgreesWithDenavitHartenberg) {
  const SensingCell cell;
  std::vector<robot::JointVector> joints;
  const auto log = randomStills(cell, joints);
  const PlacedScan scan = cell.place(log);
  ASSERT_EQ(scan.cloud.size(), joints.size());
  EXPECT_TRUE(scan.dropped.empty());
  EXPECT_EQ(scan.cloud.header.frame_id, "base_link");
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const Vector3 expected = test::denavitHartenberg(joints[i].data()) * cell.T_tip_sensor * Vector3(0, 0, 0.08);
    // Half a unit in the last place of floats below 4 m in each coordinate.
    EXPECT_LT((pointAt(scan, i) - expected).lpNorm<Eigen::Infinity>(), 1.2e-7);
    EXPECT_EQ(scan.cloud[i].line, scan::no_line);
    EXPECT_NEAR(scan.cloud[i].time, static_cast<double>(i), 1e-12);
  }
}

TEST(PlaceSamples, SamplesAtRestStayWhereTheyAreUnderAnyClockOffset) {
  SensingCell cell;
  std::vector<robot::JointVector> joints;
  auto log = randomStills(cell, joints);
  for (std::size_t k = 6; k < log.counts.size(); ++k) log.counts[k] = log.counts[k - 6];
  PlacementOptions options;
  options.clock_offset = 0.5;
  options.max_joint_gap = 2.0;
  const PlacedScan moved = cell.place(log, options);
  EXPECT_EQ(droppedFor(moved, "no joint reading"), 1U);
  ASSERT_EQ(moved.cloud.size(), 99U);
  // Rounding of the interpolation and of floats below 4 m.
  for (std::size_t i = 1; i < 99; ++i) EXPECT_LT((pointAt(moved, i) - pointAt(moved, 0)).norm(), 3e-7);
}

TEST(PlaceSamples, ErrorFreeScanLiesOnTheSurface) {
  const SensingCell cell;
  const auto emulated = cell.emulate({});
  const PlacedScan scan = cell.place(emulated.log);
  EXPECT_EQ(scan.cloud.size(), emulated.log.voltage.size());
  EXPECT_LT((scan.mean_beam + Vector3::UnitZ()).norm(), 1e-9);
  // Floats below 2 m, 0.5 m and 0.5 m: half a unit in the last place is 60, 15 and 15 nm.
  EXPECT_LT(largestDistance(scan, *cell.scene, cell.T_base_workpiece), 6.5e-8);

  // Twins that must fail the bar of 1 um: a mount off by 10 um along the beam, a clock off by 1 ms.
  SensingCell wrong_mount = cell;
  wrong_mount.T_tip_sensor.translation().z() += 10e-6;
  EXPECT_GT(largestDistance(wrong_mount.place(emulated.log), *cell.scene, cell.T_base_workpiece), 1e-6);
  PlacementOptions wrong_clock;
  wrong_clock.clock_offset = 1e-3;
  EXPECT_GT(largestDistance(cell.place(emulated.log, wrong_clock), *cell.scene, cell.T_base_workpiece), 1e-6);
}

TEST(PlaceSamples, LogFileKeepsTheScanOnTheSurface) {
  const SensingCell cell = SensingCell::small();
  const auto emulated = cell.emulate({});
  const auto log = scan::parseSampleLog(scan::formatSampleLog(emulated.log), "samples.csv");
  // Six decimals of a volt are 2.5 nm, three of a count 0.24 nrad on each joint, 1 nm at 1.5 m reach; floats 65 nm.
  EXPECT_LT(largestDistance(cell.place(log), *cell.scene, cell.T_base_workpiece), 7.5e-8);
}

/// Realistic scan from 74 mm, where crests come too near; `rail` is what a voltage beyond +-5 V is read as.
template <class Rail>
scan::SampleLog scanTooNear(const SensingCell& cell, const Rail& rail) {
  EmulationOptions options;
  options.errors = errorPreset(ErrorSet::realistic);
  options.raster.height = 0.074;
  auto log = cell.emulate(options).log;
  for (double& voltage : log.voltage) {
    if (std::abs(voltage) > 5.0) voltage = std::copysign(rail(), voltage);
  }
  return log;
}

// Sensors and converters do not say -5.5 V as the emulator does: they rest at the end of their output, or near it.
TEST(PlaceSamples, ASensorAtItsRailMeasuresNothing) {
  const SensingCell cell = SensingCell::small();
  const auto log = scanTooNear(cell, [] { return 5.5; });
  const PlacedScan beyond = cell.place(log);
  EXPECT_GT(droppedFor(beyond, "no return"), log.voltage.size() / 50);
  Random random(1);
  const auto clamped = scanTooNear(cell, [] { return 5.0; });
  const auto noisy = scanTooNear(cell, [&] { return 4.998 + 0.0003 * std::round(3.0 * random.gaussian()); });
  for (const auto* railed : {&clamped, &noisy}) {
    const PlacedScan scan = cell.place(*railed);
    EXPECT_TRUE(areSameBytes(scan, beyond));
    ASSERT_EQ(scan.no_returns.beams.size(), beyond.no_returns.beams.size());
    for (std::size_t i = 0; i < scan.no_returns.beams.size(); ++i) {
      EXPECT_EQ(scan.no_returns.beams[i].is_too_near, beyond.no_returns.beams[i].is_too_near);
    }
  }
  // Twin: without the margin the rail is a distance, and the crests are cut off flat. The next line of defence is that
  // no sensor with noise says the same for so long.
  SensingCell trusting = cell;
  trusting.laser.voltage_margin = 0.0;
  test::expectInputError([&] { trusting.place(clamped); }, "the sensor rests at -5.000000 V for ");
  trusting.laser.max_repeats = 0;
  EXPECT_GT(trusting.place(clamped).cloud.size(), beyond.cloud.size() + log.voltage.size() / 50);
}

/// Position errors of a scan against the same samples placed with joints read with each sample.
struct SlowJointErrors {
  double cruise_rms = 0.0;
  double ramp_max = 0.0;
};

SlowJointErrors slowJointErrors(double joint_rate) {
  const SensingCell cell = SensingCell::small();
  EmulationOptions options;
  const PlacedScan truth = cell.place(cell.emulate(options).log);
  options.joint_rate = joint_rate;
  const PlacedScan slow = cell.place(cell.emulate(options).log);
  const RasterPlan plan = planRaster(cell.rectangle, options.raster);
  SlowJointErrors errors;
  std::size_t cruising = 0;
  for (std::size_t i = 0; i < slow.cloud.size(); ++i) {
    const double error = (pointAt(slow, i) - pointAt(truth, i)).norm();
    const RasterMove& move = plan.moves[moveAt(plan, slow.cloud[i].time)];
    const double t = slow.cloud[i].time - move.begin;
    // The cubic looks one reading beyond its interval: that far a ramp reaches into the cruise.
    const double margin = move.profile.rampDuration() + 2.0 / joint_rate;
    if (move.is_row && t > margin && t < move.profile.duration() - margin) {
      errors.cruise_rms += error * error;
      ++cruising;
    } else {
      errors.ramp_max = std::max(errors.ramp_max, error);
    }
  }
  errors.cruise_rms = std::sqrt(errors.cruise_rms / static_cast<double>(cruising));
  return errors;
}

TEST(PlaceSamples, SlowJointsDoNotShow) {
  const SlowJointErrors errors = slowJointErrors(250.0);
  RecordProperty("cruise_rms_nm", std::to_string(errors.cruise_rms * 1e9));
  RecordProperty("ramp_max_um", std::to_string(errors.ramp_max * 1e6));
  EXPECT_LE(errors.cruise_rms, 0.2e-6);
  EXPECT_LE(errors.ramp_max, 2e-6);
  // The kink of a ramp errs by (1/4) (4/27) a h^2 = 0.6 um, twice that where one ramp turns into the opposite one;
  // at 100 Hz by 3.7 um, which the bar must not let through.
  EXPECT_GT(slowJointErrors(100.0).ramp_max, 2e-6);
}

TEST(PlaceSamples, CounterWrapsDoNotShow) {
  SensingCell cell = SensingCell::small();
  EmulationOptions options;
  options.errors.quantise_encoders = true;
  const auto log = cell.emulate(options).log;
  const PlacedScan truth = cell.place(log);
  // Move joint 1's counter so that it runs over the end of 32 bits in the middle of the scan.
  const double range = 4294967296.0, middle = std::floor(log.counts[log.counts.size() / 2 / 6 * 6]);
  const double shift = 0.5 * range - middle;
  auto wrapped = log;
  for (std::size_t k = 0; k < log.counts.size(); k += 6) {
    wrapped.counts[k] = log.counts[k] + shift;
    if (wrapped.counts[k] >= 0.5 * range) wrapped.counts[k] -= range;
  }
  const double first = wrapped.counts[0] - log.counts[0];  // where the counter starts is part of the calibration
  cell.encoder_options.offset[0] = -first * 2.0 * M_PI / (131072.0 * 100.0);
  const PlacedScan scan = cell.place(wrapped);
  ASSERT_EQ(scan.cloud.size(), truth.cloud.size());
  // Rounding of angles of 1000 rad, 1e-13, at 1 m reach, then of floats below 2 m.
  for (std::size_t i = 0; i < scan.cloud.size(); i += 7) {
    EXPECT_LT((pointAt(scan, i) - pointAt(truth, i)).norm(), 2e-7);
  }
}

TEST(PlaceSamples, DroppedSamplesAreCountedByReason) {
  const SensingCell cell = SensingCell::small();
  auto log = cell.emulate({}).log;
  log.voltage[100] = std::nan("");
  log.voltage[101] = 5.1;
  log.voltage[102] = -5.1;
  // Joint readings 0 … 9, 5000 … 5099 and the last three are missing: 10 + 3 samples have none around them, and of
  // the gap's 100 none is placed, while the samples on its first and last reading are.
  const auto erase = [&log](std::size_t begin, std::size_t end) {
    log.joint_time.erase(log.joint_time.begin() + static_cast<std::ptrdiff_t>(begin),
                         log.joint_time.begin() + static_cast<std::ptrdiff_t>(end));
    log.counts.erase(log.counts.begin() + static_cast<std::ptrdiff_t>(6 * begin),
                     log.counts.begin() + static_cast<std::ptrdiff_t>(6 * end));
  };
  const std::size_t readings = log.joint_time.size();
  erase(readings - 3, readings);
  erase(5000, 5100);
  erase(0, 10);
  const PlacedScan scan = cell.place(log);
  EXPECT_EQ(scan.samples_in, log.voltage.size());
  EXPECT_EQ(droppedFor(scan, "no return"), 2U);
  ASSERT_EQ(scan.no_returns.beams.size(), 3U);
  EXPECT_TRUE(scan.no_returns.beams[0].is_too_near);  // for all that a fault says
  EXPECT_FALSE(scan.no_returns.beams[1].is_too_near);
  EXPECT_TRUE(scan.no_returns.beams[2].is_too_near);
  EXPECT_EQ(droppedFor(scan, "sensor fault"), 1U);
  EXPECT_EQ(droppedFor(scan, "no joint reading"), 13U);
  EXPECT_EQ(droppedFor(scan, "joint readings too far apart"), 100U);
  EXPECT_EQ(scan.cloud.size() + 116, scan.samples_in);
  EXPECT_EQ(scan.cloud.width, scan.cloud.size());
  EXPECT_LT(largestDistance(scan, *cell.scene, cell.T_base_workpiece), 6.5e-8);
  for (std::size_t i = 1; i < scan.cloud.size(); ++i) ASSERT_GT(scan.cloud[i].time, scan.cloud[i - 1].time);
}

TEST(PlaceSamples, SameBytesWithAnyNumberOfThreads) {
  const SensingCell cell = SensingCell::small();
  EmulationOptions options;
  options.errors = errorPreset(ErrorSet::realistic);
  options.joint_rate = 250.0;
  const auto log = cell.emulate(options).log;
  const PlacedScan one = cell.place(log, {}, 1);
  EXPECT_TRUE(areSameBytes(one, cell.place(log, {}, 2)));
  EXPECT_TRUE(areSameBytes(one, cell.place(log, {}, 7)));
}

TEST(PlaceSamples, TurningTheFirstJointTurnsTheCloud) {
  SensingCell cell = SensingCell::small();
  const auto log = cell.emulate({}).log;
  const PlacedScan before = cell.place(log);
  cell.encoder_options.offset[0] += 0.3;
  const PlacedScan after = cell.place(log);
  const Eigen::AngleAxisd turn(0.3, Vector3::UnitZ());
  // Floats below 2 m, twice.
  for (std::size_t i = 0; i < before.cloud.size(); i += 11) {
    EXPECT_LT((pointAt(after, i) - turn * pointAt(before, i)).norm(), 2e-7);
  }
}

TEST(PlaceSamples, BadInputIsNamed) {
  SensingCell cell = SensingCell::small();
  const auto good = cell.emulate({}).log;

  auto log = good;
  log.counts[6 * 4000 + 1] = 131072.0 * 100.0;  // a full turn of joint 2
  test::expectInputError([&] { cell.place(log); }, "sample 4000 at 4.000000 s: joint_2 is 6.283185 rad, must be in [");
  log = good;
  log.voltage.pop_back();
  test::expectInputError([&] { cell.place(log); }, "sample log: number of voltages is");
  log = good;
  for (auto& voltage : log.voltage) voltage = 7.0;
  test::expectInputError([&] { cell.place(log); },
                         "none of " + std::to_string(log.voltage.size()) + " samples can be placed");
  test::expectInputError([&] { cell.place(log); }, "sweep it a second time with the sensor lower");
  for (auto& voltage : log.voltage) voltage = -7.0;
  test::expectInputError([&] { cell.place(log); }, "sweep it a second time with the sensor higher");
  test::expectInputError([&] { cell.place(scan::SampleLog{}); }, "sample log: no column for joint joint_1");
  PlacementOptions options;
  options.clock_offset = 2.0;
  test::expectInputError([&] { cell.place(good, options); }, "placement.clock_offset is 2 s, must be in [-1, 1]");
}

// A controller keeps its axis 3 in range: a log that does not was made by another arm, or counts otherwise.
TEST(PlaceSamples, TheControllersAxisHasLimitsToo) {
  SensingCell cell = SensingCell::small();
  const auto log = cell.emulate({}).log;
  cell.robot.coupled_axis->upper = cell.robot.coupled_axis->lower + 0.01;
  test::expectInputError([&] { cell.place(log); }, "sample 0 at 0.000000 s: controller axis joint_2 + joint_3 is ");
  test::expectInputError([&] { cell.emulate({}); }, "controller axis joint_2 + joint_3 is ");
}

TEST(PlaceSamples, AJointMayBeOneCountOutsideItsLimit) {
  SensingCell cell = SensingCell::small();
  EmulationOptions options;
  options.errors.quantise_encoders = true;
  const auto log = cell.emulate(options).log;
  const double count = 2.0 * M_PI / (131072.0 * 100.0);
  double highest = -10.0;
  for (std::size_t k = 1; k < log.counts.size(); k += 6) highest = std::max(highest, log.counts[k] * count);
  cell.robot.joints[1].upper = highest - 0.9 * count;
  EXPECT_NO_THROW(cell.place(log));
  cell.robot.joints[1].upper = highest - 1.1 * count;
  test::expectInputError([&] { cell.place(log); }, "joint_2 is");
}

}  // namespace
}  // namespace scan_to_path::sensing
