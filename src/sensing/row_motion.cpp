// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/sensing/row_motion.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

#include "scan_to_path/common/median.h"

namespace scan_to_path::sensing {
namespace {

struct Look {
  std::size_t sample;
  double time;  // [s]
  SensorPose pose;
  double velocity;  // along the rows, to the next look [m/s]
};

std::vector<Look> lookAround(const scan::SampleLog& log, const SensorMotion& motion, double clock_offset,
                             std::size_t looks) {
  std::vector<Look> found;
  const std::size_t stride = std::max<std::size_t>(1, log.sensor_time.size() / std::max<std::size_t>(1, looks));
  std::size_t cursor = 0;
  for (std::size_t i = 0; i < log.sensor_time.size(); i += stride) {
    Look look{i, log.sensor_time[i], {}, 0.0};
    if (motion.poseAt(log.sensor_time[i] + clock_offset, cursor, look.pose)) found.push_back(look);
  }
  return found;
}

/// Time steps longer than this are pauses, of which nobody knows where the sensor was.
double longestStep(const std::vector<Look>& looks) {
  std::vector<double> steps;
  for (std::size_t i = 0; i + 1 < looks.size(); ++i) steps.push_back(looks[i + 1].time - looks[i].time);
  return 10.0 * median(std::move(steps));
}

/// z against the mean beam, x along the axis of most of the motion, towards the base's +x (or else +y).
Eigen::Matrix3d rowAxes(const std::vector<Look>& looks) {
  Vector3 beam = Vector3::Zero();
  for (const auto& look : looks) beam += look.pose.beam;
  const Vector3 z = -beam.normalized();
  const double longest = longestStep(looks);
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i + 1 < looks.size(); ++i) {
    if (looks[i + 1].time - looks[i].time > longest) continue;
    Vector3 step = looks[i + 1].pose.origin - looks[i].pose.origin;
    step -= z * z.dot(step);
    moments += step * step.transpose();
  }
  Vector3 x = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments).eigenvectors().col(2);
  const double sense = std::abs(x.x()) > 1e-6 ? x.x() : x.y();
  if (sense < 0.0) x = -x;
  return geometry::frameFromAxes(Vector3::Zero(), z, x).linear();
}

double medianSpeed(const std::vector<Look>& looks) {
  std::vector<double> speeds;
  for (const auto& look : looks) speeds.push_back(std::abs(look.velocity));
  return median(std::move(speeds));
}

double meanAcross(const std::vector<Look>& looks, std::size_t begin, std::size_t end, const Vector3& y) {
  double sum = 0.0;
  for (std::size_t i = begin; i < end; ++i) sum += y.dot(looks[i].pose.origin);
  return sum / static_cast<double>(end - begin);
}

void dropShortRows(std::vector<MotionRow>& rows) {
  std::size_t longest = 0;
  for (const auto& row : rows) longest = std::max(longest, row.last - row.first);
  rows.erase(std::remove_if(rows.begin(), rows.end(),
                            [longest](const MotionRow& row) { return 2 * (row.last - row.first) < longest; }),
             rows.end());
}

}  // namespace

bool SensorMotion::poseAt(double time, std::size_t& cursor, SensorPose& pose) const {
  robot::JointVector angles;
  if (readings_.anglesAt(time, cursor, angles) != JointReadings::Status::found) return false;
  const Frame T_base_sensor = robot::forwardKinematics(robot_, angles) * T_tip_sensor_;
  pose.origin = T_base_sensor.translation();
  pose.beam = T_base_sensor.linear().col(2);
  return true;
}

RowMotion findRowMotion(const scan::SampleLog& log, const SensorMotion& motion, double clock_offset,
                        std::size_t looks_wanted) {
  RowMotion result;
  std::vector<Look> looks = lookAround(log, motion, clock_offset, looks_wanted);
  if (looks.size() < 3) return result;
  result.R_base_row = rowAxes(looks);
  for (std::size_t i = 0; i + 1 < looks.size(); ++i) {
    const Vector3 step = looks[i + 1].pose.origin - looks[i].pose.origin;
    looks[i].velocity = result.R_base_row.col(0).dot(step) / (looks[i + 1].time - looks[i].time);
  }
  looks.back().velocity = 0.0;
  const double slowest = 0.5 * medianSpeed(looks);
  for (std::size_t begin = 0; begin < looks.size();) {
    const double velocity = looks[begin].velocity;
    std::size_t end = begin + 1;
    if (std::abs(velocity) <= slowest) {
      begin = end;
      continue;
    }
    while (end < looks.size() && looks[end].velocity * velocity > 0.0 && std::abs(looks[end].velocity) > slowest) ++end;
    if (end - begin >= 4) {
      result.rows.push_back({looks[begin].sample, looks[end - 1].sample, velocity > 0.0,
                             meanAcross(looks, begin, end, result.R_base_row.col(1))});
    }
    begin = end;
  }
  dropShortRows(result.rows);
  return result;
}

}  // namespace scan_to_path::sensing
