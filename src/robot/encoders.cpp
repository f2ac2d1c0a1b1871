// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/robot/encoders.h"

#include <cmath>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path::robot {

namespace {

/// `size` follows from the robot's joints.
template <class Accept>
void checkList(const std::vector<double>& values, std::size_t size, const Robot& robot, const std::string& name,
               const char* limit, Accept&& accept) {
  if (values.size() != size) {
    throw InputError("encoders." + name, "number of values", std::to_string(values.size()),
                     std::to_string(size) + ": the chain from " + robot.base_link + " to " + robot.tip_link + " has " +
                         std::to_string(robot.dof()) + " joints");
  }
  for (std::size_t i = 0; i < size; ++i) {
    if (!accept(values[i]))
      throw InputError("encoders." + name, "value " + std::to_string(i), fixed(values[i], 6), limit);
  }
}

bool isPositive(double value) { return value > 0.0 && std::isfinite(value); }
bool isSign(double value) { return value == 1.0 || value == -1.0; }
bool isFinite(double value) { return std::isfinite(value); }

/// The controller's axes from the joints (sign +1: L^-1), or the joints from the axes (sign -1: L), which differ only
/// in whether the coupled axis adds the other joints or takes them off.
JointMatrix coupledAxes(const Robot& robot, double sign) {
  JointMatrix axes = JointMatrix::Identity();
  if (!robot.coupled_axis) return axes;
  const int axis = robot.coupled_axis->axis;
  for (const int joint : robot.coupled_axis->joints) {
    if (joint != axis) axes(axis, joint) = sign;
  }
  return axes;
}

JointMatrix couplingMatrix(const std::vector<double>& values, const Robot& robot) {
  const int joints = robot.dof();
  JointMatrix C = JointMatrix::Identity();
  if (values.empty()) return C;
  checkList(values, static_cast<std::size_t>(joints * joints), robot, "coupling", "finite", isFinite);
  for (int i = 0; i < joints; ++i) {
    for (int k = 0; k < joints; ++k) C(i, k) = values[static_cast<std::size_t>(i * joints + k)];
  }
  return C;
}

}  // namespace

Encoders::Encoders(const EncoderOptions& options, const Robot& robot) {
  const int joints = robot.dof();
  const auto n = static_cast<std::size_t>(joints);
  checkList(options.counts_per_turn, n, robot, "counts_per_turn", "> 0", isPositive);
  checkList(options.gear_ratio, n, robot, "gear_ratio", "> 0", isPositive);
  checkList(options.sign, n, robot, "sign", "+1 or -1", isSign);
  checkList(options.offset, n, robot, "offset", "finite", isFinite);
  const JointMatrix C = couplingMatrix(options.coupling, robot);
  const Eigen::FullPivLU<JointMatrix> decomposition(C);
  if (!decomposition.isInvertible()) throw InputError("encoders.coupling", "matrix", "singular", "invertible");

  Eigen::Matrix<double, max_joints, 1> angle_per_count = Eigen::Matrix<double, max_joints, 1>::Ones();
  for (int i = 0; i < joints; ++i) {
    const auto k = static_cast<std::size_t>(i);
    angle_per_count[i] = options.sign[k] * 2.0 * M_PI / (options.counts_per_turn[k] * options.gear_ratio[k]);
  }
  // Spec cutting, step 1: theta = C diag(sign 2 pi / (counts gear)) pulses + offset, its C being L times
  // options.coupling.
  angles_from_counts_ = coupledAxes(robot, -1.0) * C * angle_per_count.asDiagonal();
  counts_from_angles_ = angle_per_count.cwiseInverse().asDiagonal() * decomposition.inverse() * coupledAxes(robot, 1.0);
  offset_ = Eigen::Map<const Eigen::VectorXd>(options.offset.data(), joints);
}

JointVector Encoders::angles(const double* counts) const {
  const auto joints = offset_.size();
  JointVector q = offset_;
  q.noalias() += angles_from_counts_.topLeftCorner(joints, joints) * Eigen::Map<const Eigen::VectorXd>(counts, joints);
  return q;
}

JointVector Encoders::counts(const JointVector& angles) const {
  const auto joints = offset_.size();
  return counts_from_angles_.topLeftCorner(joints, joints) * (angles - offset_);
}

double unwrapCount(double previous, double raw) {
  constexpr double range = 4294967296.0;  // 2^32
  return raw + range * std::nearbyint((previous - raw) / range);
}

}  // namespace scan_to_path::robot
