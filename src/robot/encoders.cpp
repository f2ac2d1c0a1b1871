// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/robot/encoders.h"

#include <cmath>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path::robot {

namespace {

template <class Accept>
void checkList(const std::vector<double>& values, std::size_t size, const std::string& name, const char* limit,
               Accept&& accept) {
  if (values.size() != size) {
    throw InputError("encoders." + name, "number of values", std::to_string(values.size()), std::to_string(size));
  }
  for (std::size_t i = 0; i < size; ++i) {
    if (!accept(values[i]))
      throw InputError("encoders." + name, "value " + std::to_string(i), fixed(values[i], 6), limit);
  }
}

bool isPositive(double value) { return value > 0.0 && std::isfinite(value); }
bool isSign(double value) { return value == 1.0 || value == -1.0; }
bool isFinite(double value) { return std::isfinite(value); }

/// L^-1: the controller's axes from the joints.
Eigen::MatrixXd axesFromJoints(const Robot& robot) {
  Eigen::MatrixXd axes = Eigen::MatrixXd::Identity(robot.dof(), robot.dof());
  if (!robot.coupled_axis) return axes;
  for (const int joint : robot.coupled_axis->joints) axes(robot.coupled_axis->axis, joint) = 1.0;
  return axes;
}

Eigen::MatrixXd couplingMatrix(const std::vector<double>& values, int joints) {
  if (values.empty()) return Eigen::MatrixXd::Identity(joints, joints);
  checkList(values, static_cast<std::size_t>(joints * joints), "coupling", "finite", isFinite);
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  return Eigen::Map<const RowMajor>(values.data(), joints, joints);
}

}  // namespace

Encoders::Encoders(const EncoderOptions& options, const Robot& robot) {
  const int joints = robot.dof();
  const auto n = static_cast<std::size_t>(joints);
  checkList(options.counts_per_turn, n, "counts_per_turn", "> 0", isPositive);
  checkList(options.gear_ratio, n, "gear_ratio", "> 0", isPositive);
  checkList(options.sign, n, "sign", "+1 or -1", isSign);
  checkList(options.offset, n, "offset", "finite", isFinite);
  const Eigen::MatrixXd C = couplingMatrix(options.coupling, joints);
  const Eigen::FullPivLU<Eigen::MatrixXd> decomposition(C);
  if (!decomposition.isInvertible()) throw InputError("encoders.coupling", "matrix", "singular", "invertible");

  Eigen::VectorXd angle_per_count(joints);
  for (int i = 0; i < joints; ++i) {
    const auto k = static_cast<std::size_t>(i);
    angle_per_count[i] = options.sign[k] * 2.0 * M_PI / (options.counts_per_turn[k] * options.gear_ratio[k]);
  }
  // Spec cutting, step 1: theta = C diag(sign 2 pi / (counts gear)) pulses + offset, its C being L times
  // options.coupling.
  const Eigen::MatrixXd axes = axesFromJoints(robot);
  angles_from_counts_ = axes.inverse() * C * angle_per_count.asDiagonal();
  counts_from_angles_ = angle_per_count.cwiseInverse().asDiagonal() * decomposition.inverse() * axes;
  offset_ = Eigen::Map<const Eigen::VectorXd>(options.offset.data(), joints);
}

JointVector Encoders::angles(const double* counts) const {
  JointVector q = offset_;
  q.noalias() += angles_from_counts_ * Eigen::Map<const Eigen::VectorXd>(counts, offset_.size());
  return q;
}

JointVector Encoders::counts(const JointVector& angles) const {
  JointVector counts(offset_.size());
  counts.noalias() = counts_from_angles_ * (angles - offset_);
  return counts;
}

double unwrapCount(double previous, double raw) {
  constexpr double range = 4294967296.0;  // 2^32
  return raw + range * std::nearbyint((previous - raw) / range);
}

}  // namespace scan_to_path::robot
