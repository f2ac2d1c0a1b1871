// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/sensing/emulate_scan.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/parallel.h"
#include "scan_to_path/sensing/laser_spot.h"
#include "scan_to_path/sensing/robot_motion.h"

namespace scan_to_path::sensing {
namespace {

constexpr std::size_t batch_size = 32768;  // samples between two reports of progress
constexpr double microsecond = 1e-6;

using Ticks = std::vector<std::int64_t>;  // [us] of true time, from the first row's start

/// Everything that is the same for all samples.
struct Setup {
  const geometry::Surface& scene;
  const RasterPlan& plan;
  const RobotMotion& motion;
  const Drift& drift;
  const LaserSpot& spot;
  const robot::Robot& robot;
  Frame T_workpiece_base;
  Frame T_tip_sensor;
};

/// What is read at `rate`, while the raster is recorded.
Ticks ticksOf(const RasterPlan& plan, double rate) {
  Ticks ticks;
  ticks.reserve(static_cast<std::size_t>(plan.duration * rate) + 1);
  std::size_t move = 0;
  for (std::int64_t k = 0;; ++k) {
    const std::int64_t tick = std::llround(static_cast<double>(k) / rate / microsecond);
    const double time = static_cast<double>(tick) * microsecond;
    if (time > plan.duration) return ticks;
    move = moveAt(plan, time, move);
    if (plan.moves[move].is_recorded) ticks.push_back(tick);
  }
}

/// Stamps of a clock that shows `shift` at true time 0.
std::vector<double> stampsOf(const Ticks& ticks, std::int64_t shift) {
  std::vector<double> stamps;
  stamps.reserve(ticks.size());
  for (const auto tick : ticks) stamps.push_back(static_cast<double>(tick + shift) / 1e6);
  return stamps;
}

robot::JointVector jointsAt(const Setup& setup, double time, std::size_t& move) {
  move = moveAt(setup.plan, time, move);
  const RasterMove& at = setup.plan.moves[move];
  return setup.motion.jointsAt(move, at.profile.distanceAt(time - at.begin));
}

/// `work(tick's index, tick's time, move)` for all ticks, in batches that report progress.
template <class Work>
void forEachTick(const Ticks& ticks, const char* stage, int threads, const Progress& progress, const Work& work) {
  for (std::size_t batch = 0; batch < ticks.size(); batch += batch_size) {
    progress.update(stage, static_cast<double>(batch) / static_cast<double>(ticks.size()));
    const std::size_t count = std::min(batch_size, ticks.size() - batch);
    parallelFor(count, threads, [&](std::size_t begin, std::size_t end) {
      std::size_t move = 0;
      for (std::size_t i = batch + begin; i < batch + end; ++i) {
        work(i, static_cast<double>(ticks[i]) * microsecond, move);
      }
    });
  }
  progress.update(stage, 1.0);
}

std::vector<LaserSpot::Reading> readSensor(const Setup& setup, const Ticks& ticks, int threads,
                                           const Progress& progress) {
  std::vector<LaserSpot::Reading> readings(ticks.size());
  forEachTick(ticks, "scanning", threads, progress, [&](std::size_t i, double time, std::size_t& move) {
    Frame T_base_sensor = robot::forwardKinematics(setup.robot, jointsAt(setup, time, move)) * setup.T_tip_sensor;
    T_base_sensor.translation() += setup.drift.at(time);
    readings[i] = setup.spot.read(setup.scene, setup.T_workpiece_base * T_base_sensor);
  });
  return readings;
}

std::vector<double> readEncoders(const Setup& setup, const robot::Encoders& encoders, bool quantise, const Ticks& ticks,
                                 int threads, const Progress& progress) {
  const std::size_t joints = setup.robot.joints.size();
  std::vector<double> counts(ticks.size() * joints);
  forEachTick(ticks, "reading encoders", threads, progress, [&](std::size_t i, double time, std::size_t& move) {
    const robot::JointVector exact = encoders.counts(jointsAt(setup, time, move));
    for (std::size_t k = 0; k < joints; ++k) {
      const double count = exact[static_cast<Eigen::Index>(k)];
      counts[i * joints + k] = quantise ? std::round(count) : count;
    }
  });
  return counts;
}

RangeEvidence evidenceOf(const std::vector<LaserSpot::Reading>& readings, const PointLaserOptions& laser) {
  const MeasuringRange range = measuringRange(laser);
  RangeEvidence evidence;
  evidence.samples = readings.size();
  for (const auto& reading : readings) {
    if (!reading.on_axis) {
      ++evidence.nothing;
      continue;
    }
    const double distance = *reading.on_axis;
    if (distance < range.nearest) ++evidence.too_near;
    if (distance > range.farthest) ++evidence.too_far;
    const bool is_first = evidence.farthest == 0.0;
    evidence.nearest = is_first ? distance : std::min(evidence.nearest, distance);
    evidence.farthest = std::max(evidence.farthest, distance);
  }
  return evidence;
}

std::vector<double> voltagesOf(const std::vector<LaserSpot::Reading>& readings, const EmulationOptions& options,
                               const PointLaserOptions& laser) {
  RangeErrors errors(options.errors, laser, static_cast<std::uint64_t>(options.seed));
  std::vector<double> voltages;
  voltages.reserve(readings.size());
  for (const auto& reading : readings) {
    const double voltage = errors.voltageOf(reading.distance);
    const bool is_too_near = !reading.distance && reading.on_axis && *reading.on_axis < laser.distance_min;
    voltages.push_back(is_too_near ? errors.nearVoltage() : voltage);
  }
  return voltages;
}

}  // namespace

EmulatedScan emulateScan(const geometry::Surface& scene, const Eigen::AlignedBox2d& rectangle,
                         const Frame& T_base_workpiece, const robot::Robot& robot, const robot::Encoders& encoders,
                         const PointLaserOptions& laser, const Frame& T_tip_sensor, const EmulationOptions& options,
                         int threads, const Progress& progress) {
  validate(options, "emulate");
  validateErrors(options.errors);
  validateLaser(laser);
  const RasterPlan plan = planRaster(rectangle, options.raster);
  const RobotMotion motion(plan, robot, T_base_workpiece, T_tip_sensor, progress);
  const Drift drift(options.errors, static_cast<std::uint64_t>(options.seed), plan.duration);
  const LaserSpot spot(options.errors.spot_diameter, laser);
  const Setup setup{scene, plan, motion, drift, spot, robot, T_base_workpiece.inverse(), T_tip_sensor};

  const Ticks sensor_ticks = ticksOf(plan, options.sample_rate);
  const Ticks joint_ticks = ticksOf(plan, options.joint_rate);
  const auto readings = readSensor(setup, sensor_ticks, threads, progress);
  // The sensor's time plus the offset is the encoders' time; both clocks start late enough to show no negative time.
  const std::int64_t offset = std::llround(options.errors.clock_offset / microsecond);
  const std::int64_t joint_shift = std::max<std::int64_t>(0, offset);

  EmulatedScan result;
  for (const auto& joint : robot.joints) result.log.joint_names.push_back(joint.name);
  result.log.joint_time = stampsOf(joint_ticks, joint_shift);
  result.log.counts = readEncoders(setup, encoders, options.errors.quantise_encoders, joint_ticks, threads, progress);
  result.log.sensor_time = stampsOf(sensor_ticks, joint_shift - offset);
  result.log.voltage = voltagesOf(readings, options, laser);
  result.range = evidenceOf(readings, laser);
  result.rows = plan.rows;
  result.duration = plan.duration;
  return result;
}

}  // namespace scan_to_path::sensing
