// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/sensing/place_samples.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/parallel.h"
#include "scan_to_path/common/text.h"
#include "scan_to_path/sensing/joint_readings.h"
#include "scan_to_path/sensing/resting_sensor.h"

namespace scan_to_path::sensing {
namespace {

// Sums are formed per block of this many samples and then over the blocks, so that they do not depend on threads.
constexpr std::size_t block_size = 4096;

enum Reason : std::size_t { no_return, sensor_fault, outside_readings, joint_gap, reasons };
constexpr std::array<const char*, reasons> reason_names = {"no return", "sensor fault", "no joint reading",
                                                           "joint readings too far apart"};

struct Block {
  std::size_t placed = 0;
  std::array<std::size_t, reasons> dropped{};
  Vector3 beam_sum = Vector3::Zero();
  std::vector<scan::NoReturn> no_returns;
};

/// What every sample needs, computed once.
struct Placement {
  const scan::SampleLog& log;
  const robot::Robot& robot;
  const PointLaserOptions& laser;
  const JointReadings& readings;
  double clock_offset;
  Vector3 origin_tip;             // of the sensor
  Vector3 beam_tip;               // unit
  std::vector<double> tolerance;  // by which each joint may be outside its limits [rad]
};

/// How far one count of every encoder can turn each joint [rad].
std::vector<double> angleOfOneCount(const robot::Robot& robot, const robot::Encoders& encoders) {
  std::array<double, 8> counts{};
  const robot::JointVector zero = encoders.angles(counts.data());
  robot::JointVector sum = robot::JointVector::Zero(robot.dof());
  for (int k = 0; k < robot.dof(); ++k) {
    counts[k] = 1.0;
    sum += (encoders.angles(counts.data()) - zero).cwiseAbs();
    counts[k] = 0.0;
  }
  return {sum.data(), sum.data() + sum.size()};
}

/// A controller does not let its axis out of its range: a log that does was not read as the controller counts.
void checkCoupledAxis(const Placement& placement, const robot::JointVector& angles, std::size_t sample) {
  if (!placement.robot.coupled_axis) return;
  double tolerance = 0.0;
  for (const int joint : placement.robot.coupled_axis->joints) {
    tolerance += placement.tolerance[static_cast<std::size_t>(joint)];
  }
  if (robot::coupledMargin(placement.robot, angles) >= -tolerance) return;
  const robot::CoupledAxis& coupled = *placement.robot.coupled_axis;
  const double angle = robot::controllerAxes(placement.robot, angles)[coupled.axis];
  throw InputError("sample " + std::to_string(sample) + " at " + fixed(placement.log.sensor_time[sample], 6) + " s",
                   robot::coupledAxisName(placement.robot), fixed(angle, 6) + " rad",
                   "in [" + fixed(coupled.lower, 6) + ", " + fixed(coupled.upper, 6) + "]");
}

void checkLimits(const Placement& placement, const robot::JointVector& angles, std::size_t sample) {
  for (std::size_t k = 0; k < placement.robot.joints.size(); ++k) {
    const auto& joint = placement.robot.joints[k];
    const double q = angles[static_cast<Eigen::Index>(k)];
    if (q >= joint.lower - placement.tolerance[k] && q <= joint.upper + placement.tolerance[k]) continue;
    throw InputError("sample " + std::to_string(sample) + " at " + fixed(placement.log.sensor_time[sample], 6) + " s",
                     joint.name, fixed(q, 6) + " rad",
                     "in [" + fixed(joint.lower, 6) + ", " + fixed(joint.upper, 6) + "]");
  }
  checkCoupledAxis(placement, angles, sample);
}

/// Adds where a beam without a return ends, as far as the joints at its time are known. A fault hides whatever is
/// there, be it too near.
void addNoReturn(const Placement& placement, std::size_t sample, std::size_t& cursor, Block& block) {
  robot::JointVector angles(placement.robot.dof());
  const double time = placement.log.sensor_time[sample] + placement.clock_offset;
  if (placement.readings.anglesAt(time, cursor, angles) != JointReadings::Status::found) return;
  const Frame T_base_tip = robot::forwardKinematics(placement.robot, angles);
  const Vector3 far_end_tip = placement.origin_tip + measuringRange(placement.laser).farthest * placement.beam_tip;
  const double voltage = placement.log.voltage[sample];
  block.no_returns.push_back(
      {(T_base_tip * far_end_tip).cast<float>(), std::isnan(voltage) || isTooNear(placement.laser, voltage)});
}

void placeBlock(const Placement& placement, std::size_t begin, std::size_t end, scan::ScanPoint* points, Block& block) {
  const auto& log = placement.log;
  std::size_t cursor = 0;
  robot::JointVector angles(placement.robot.dof());
  for (std::size_t i = begin; i < end; ++i) {
    const auto distance = distanceFromVoltage(placement.laser, log.voltage[i]);
    if (!distance) {
      ++block.dropped[std::isnan(log.voltage[i]) ? sensor_fault : no_return];
      addNoReturn(placement, i, cursor, block);
      continue;
    }
    const auto status = placement.readings.anglesAt(log.sensor_time[i] + placement.clock_offset, cursor, angles);
    if (status != JointReadings::Status::found) {
      ++block.dropped[status == JointReadings::Status::gap ? joint_gap : outside_readings];
      continue;
    }
    checkLimits(placement, angles, i);
    const Frame T_base_tip = robot::forwardKinematics(placement.robot, angles);  // Equation (1)
    const Vector3 beam = T_base_tip.linear() * placement.beam_tip;
    const Vector3 point = T_base_tip * placement.origin_tip + *distance * beam;  // Equation (2)
    scan::ScanPoint& target = points[block.placed++];
    target.getVector3fMap() = point.cast<float>();
    target.line = scan::no_line;
    target.time = log.sensor_time[i] - log.sensor_time.front();
    block.beam_sum += beam;
  }
}

void checkLog(const scan::SampleLog& log) {
  if (log.voltage.size() != log.sensor_time.size()) {
    throw InputError("sample log", "number of voltages", std::to_string(log.voltage.size()),
                     "one for each of " + std::to_string(log.sensor_time.size()) + " samples");
  }
}

std::vector<scan::Dropped> droppedByReason(const std::vector<Block>& blocks) {
  std::vector<scan::Dropped> dropped;
  for (std::size_t reason = 0; reason < reasons; ++reason) {
    std::size_t count = 0;
    for (const auto& block : blocks) count += block.dropped[reason];
    if (count > 0) dropped.push_back({reason_names[reason], count});
  }
  return dropped;
}

[[noreturn]] void throwNothingPlaced(const scan::SampleLog& log, const PointLaserOptions& laser,
                                     const std::vector<scan::Dropped>& dropped) {
  std::string message = "sample log: none of " + std::to_string(log.voltage.size()) + " samples can be placed";
  for (const auto& entry : dropped) message += ", " + std::to_string(entry.count) + " " + entry.reason;
  const bool is_out_of_range = std::any_of(dropped.begin(), dropped.end(),
                                           [](const auto& entry) { return entry.reason == reason_names[no_return]; });
  if (!is_out_of_range) throw InputError(message);
  const auto too_near = std::count_if(log.voltage.begin(), log.voltage.end(),
                                      [&laser](double voltage) { return isTooNear(laser, voltage); });
  throw InputError(
      message + " (" + std::to_string(too_near) +
      " of them too near): the part is beyond the sensor's range, sweep it a second time with the sensor " +
      (too_near > 0 ? "higher" : "lower"));
}

/// Closes the gaps that dropped samples left between the blocks.
void joinBlocks(const std::vector<Block>& blocks, scan::ScanCloud& cloud) {
  std::size_t placed = 0;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const auto from = cloud.points.begin() + static_cast<std::ptrdiff_t>(b * block_size);
    const auto to = cloud.points.begin() + static_cast<std::ptrdiff_t>(placed);
    if (from != to) std::copy(from, from + static_cast<std::ptrdiff_t>(blocks[b].placed), to);
    placed += blocks[b].placed;
  }
  cloud.points.resize(placed);
  cloud.width = static_cast<std::uint32_t>(placed);
  cloud.height = 1;
}

scan::NoReturns joinedNoReturns(const std::vector<Block>& blocks, const PointLaserOptions& laser) {
  scan::NoReturns joined;
  const MeasuringRange range = measuringRange(laser);
  joined.range = range.farthest - range.nearest;
  joined.nearest = range.nearest;
  for (const auto& block : blocks) {
    joined.beams.insert(joined.beams.end(), block.no_returns.begin(), block.no_returns.end());
  }
  return joined;
}

}  // namespace

PlacedScan placeSamples(const scan::SampleLog& log, const robot::Robot& robot, const robot::Encoders& encoders,
                        const PointLaserOptions& laser, const Frame& T_tip_sensor, const PlacementOptions& options,
                        int threads, const Progress& progress) {
  validateLaser(laser);
  validate(options, "placement");
  checkLog(log);
  checkRestingSensor(log, laser);
  progress.update("placing samples", 0.0);
  const JointReadings readings(log, robot, encoders, options.max_joint_gap);
  const Placement placement{log,
                            robot,
                            laser,
                            readings,
                            options.clock_offset.value_or(0.0),
                            T_tip_sensor.translation(),
                            T_tip_sensor.linear().col(2),
                            angleOfOneCount(robot, encoders)};
  const std::size_t samples = log.sensor_time.size();
  PlacedScan scan;
  scan.samples_in = samples;
  scan.cloud.header.frame_id = robot.base_link;
  scan.cloud.points.resize(samples);
  std::vector<Block> blocks((samples + block_size - 1) / block_size);
  parallelFor(blocks.size(), threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t b = first; b < last; ++b) {
      progress.checkCancelled();
      const std::size_t begin = b * block_size;
      placeBlock(placement, begin, std::min(begin + block_size, samples), &scan.cloud.points[begin], blocks[b]);
    }
  });
  if (options.max_joint_jump > 0.0) {
    const Vector3 spot_tip =
        placement.origin_tip + 0.5 * (laser.distance_min + laser.distance_max) * placement.beam_tip;
    const JointJumpLimits limits{options.max_joint_jump, options.max_joint_gap, placement.tolerance};
    scan.unseen_jumps = checkJointJumps(readings, robot, spot_tip, limits, threads, progress);
  }
  scan.times_repeated = readings.timesRepeated();
  scan.dropped = droppedByReason(blocks);
  joinBlocks(blocks, scan.cloud);
  scan.no_returns = joinedNoReturns(blocks, laser);
  if (scan.cloud.points.empty()) throwNothingPlaced(log, laser, scan.dropped);
  Vector3 beam_sum = Vector3::Zero();
  for (const auto& block : blocks) beam_sum += block.beam_sum;
  scan.mean_beam = geometry::roundedDirection(beam_sum);
  progress.update("placing samples", 1.0);
  return scan;
}

}  // namespace scan_to_path::sensing
