// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/robot/inverse_kinematics.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "chain_walk.h"

namespace scan_to_path::robot {

namespace {

constexpr double position_tolerance = 1e-7;  // promised [m]
constexpr double rotation_tolerance = 1e-7;  // promised [rad]
constexpr double converged = 1e-10;          // where the iteration stops: [m] and [rad]
constexpr int max_iterations = 50;
constexpr int configuration_starts = 200;  // for allConfigurations
constexpr int fallback_starts = 12;        // for solve, when its seed leads nowhere
constexpr double max_variants = 256;       // by whole turns, of one configuration
constexpr double turn = 2.0 * M_PI;

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Jacobian = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, 8>;

/// Farthest the tip can be from the first joint's origin [m].
double longestReach(const Robot& robot) {
  double reach = robot.T_last_tip.translation().norm();
  for (std::size_t i = 1; i < robot.joints.size(); ++i) reach += robot.joints[i].T_parent_joint.translation().norm();
  return reach;
}

/// Rotation vector of R [rad].
Vector3 rotationVector(const Eigen::Matrix3d& R) {
  const Vector3 v(0.5 * (R(2, 1) - R(1, 2)), 0.5 * (R(0, 2) - R(2, 0)), 0.5 * (R(1, 0) - R(0, 1)));
  const double c = 0.5 * (R.trace() - 1.0);
  if (c > 0.9) {
    const double s = v.norm();
    return s < 1e-6 ? v : Vector3(v * (std::asin(std::min(s, 1.0)) / s));
  }
  const Eigen::AngleAxisd angle_axis(R);
  return angle_axis.angle() * angle_axis.axis();
}

/// Term `index` of the van der Corput sequence: evenly filling [0, 1), the same numbers every time.
double vanDerCorput(int index, int base) {
  double value = 0.0;
  for (double digit = 1.0 / base; index > 0; index /= base, digit /= base) value += digit * (index % base);
  return value;
}

/// The interval of a joint to search, at most one turn.
std::pair<double, double> searchRange(const Joint& joint) {
  if (!std::isfinite(joint.upper - joint.lower)) return {-M_PI, M_PI};
  const double middle = 0.5 * (joint.lower + joint.upper), half = std::min(0.5 * (joint.upper - joint.lower), M_PI);
  return {middle - half, middle + half};
}

/// A Halton sequence over the joint ranges.
std::vector<JointVector> startingPoints(const Robot& robot) {
  constexpr std::array<int, 8> primes = {2, 3, 5, 7, 11, 13, 17, 19};
  std::vector<JointVector> starts;
  for (int k = 1; k <= configuration_starts; ++k) {
    JointVector q(robot.dof());
    for (int i = 0; i < robot.dof(); ++i) {
      const auto j = static_cast<std::size_t>(i);
      const auto [low, high] = searchRange(robot.joints[j]);
      q[i] = low + (high - low) * vanDerCorput(k, primes[j]);
    }
    starts.push_back(q);
  }
  return starts;
}

double nearestTurn(double angle, double reference) { return angle + turn * std::nearbyint((reference - angle) / turn); }

/// Whether two solutions of one pose are the same but for whole turns.
bool sameConfiguration(const JointVector& a, const JointVector& b) {
  constexpr double same = 1e-5;
  for (int i = 0; i < a.size(); ++i) {
    if (std::abs(nearestTurn(a[i], b[i]) - b[i]) > same) return false;
  }
  return true;
}

/// The angles of a joint that are whole turns from `angle` and within the limits, the nearest to the middle of its
/// range first; of a continuous joint one, nearest to 0.
std::vector<double> turnsWithin(const Joint& joint, double angle) {
  if (!std::isfinite(joint.upper - joint.lower)) return {nearestTurn(angle, 0.0)};
  std::vector<double> turns;
  for (double q = angle + turn * std::ceil((joint.lower - angle) / turn); q <= joint.upper; q += turn) {
    turns.push_back(q);
  }
  const double middle = 0.5 * (joint.lower + joint.upper);
  std::stable_sort(turns.begin(), turns.end(),
                   [middle](double a, double b) { return std::abs(a - middle) < std::abs(b - middle); });
  return turns;
}

/// Joints that all turn for long would have more variants than memory: the joint with the most loses the one farthest
/// from its middle, until no more than `max_variants` are left.
void limitVariants(std::vector<std::vector<double>>& turns) {
  const auto variants = [&turns] {
    double product = 1.0;
    for (const auto& angles : turns) product *= static_cast<double>(angles.size());
    return product;
  };
  while (variants() > max_variants) {
    std::max_element(turns.begin(), turns.end(), [](const auto& a, const auto& b) {
      return a.size() < b.size();
    })->pop_back();
  }
}

void appendProduct(const Robot& robot, const std::vector<std::vector<double>>& turns, int joint, JointVector& q,
                   std::vector<JointVector>& found) {
  if (joint == robot.dof()) {
    if (coupledMargin(robot, q) >= 0.0) found.push_back(q);
    return;
  }
  for (const double angle : turns[static_cast<std::size_t>(joint)]) {
    q[joint] = angle;
    appendProduct(robot, turns, joint + 1, q, found);
  }
}

/// Appends the variants of `q` by whole turns that are within the limits, the coupled axis's too.
void appendTurns(const Robot& robot, JointVector q, std::vector<JointVector>& found) {
  std::vector<std::vector<double>> turns;
  for (int i = 0; i < robot.dof(); ++i) turns.push_back(turnsWithin(robot.joints[static_cast<std::size_t>(i)], q[i]));
  limitVariants(turns);
  appendProduct(robot, turns, 0, q, found);
}

double distanceFromMiddle(const Robot& robot, const JointVector& q) {
  double sum = 0.0;
  for (int i = 0; i < robot.dof(); ++i) {
    const auto [low, high] = searchRange(robot.joints[static_cast<std::size_t>(i)]);
    sum += std::pow(q[i] - 0.5 * (low + high), 2);
  }
  return sum;
}

}  // namespace

struct InverseKinematics::Impl {
  explicit Impl(const Robot& source) : robot(source), reach(longestReach(source)), starts(startingPoints(source)) {}

  double beyondReach(const Frame& T_base_tip) const;
  bool iterate(const Frame& T_base_tip, JointVector& q, Miss& miss) const;
  bool search(const Frame& T_base_tip, JointVector& q, Miss& miss) const;
  bool accepted(const Frame& T_base_tip, const JointVector& q) const;

  Robot robot;
  double reach;
  std::vector<JointVector> starts;
};

/// How much farther than the stretched arm the pose is [m]; NaN for one that is not finite.
double InverseKinematics::Impl::beyondReach(const Frame& T_base_tip) const {
  return (T_base_tip.translation() - robot.joints.front().T_parent_joint.translation()).norm() - reach;
}

/// Newton-Raphson damped by the squared residual (Sugihara 2011, "Solvability-unconcerned inverse kinematics by the
/// Levenberg-Marquardt method"): far from the goal it is a gradient step, near it converges quadratically.
bool InverseKinematics::Impl::iterate(const Frame& T_base_tip, JointVector& q, Miss& miss) const {
  const double per_length = 1.0 / reach;
  Jacobian J(6, robot.dof());
  for (int k = 0; k < max_iterations; ++k) {
    const Frame T =
        walkChain(robot, q.data(), [&J](int i, const Vector3& p, const Eigen::Matrix3d& R, const Vector3& a) {
          J.col(i).head<3>() = p;
          J.col(i).tail<3>() = R * a;
        });
    Vector6 e;
    e.head<3>() = T_base_tip.translation() - T.translation();
    e.tail<3>() = rotationVector(T_base_tip.linear() * T.linear().transpose());
    miss = {e.head<3>().norm(), e.tail<3>().norm()};
    if (miss.position < converged && miss.rotation < converged) return true;
    for (int i = 0; i < robot.dof(); ++i) {
      const Vector3 origin = J.col(i).head<3>(), axis = J.col(i).tail<3>();
      J.col(i).head<3>() = per_length * axis.cross(T.translation() - origin);
    }
    e.head<3>() *= per_length;
    Eigen::Matrix<double, 6, 6> A = J * J.transpose();
    A.diagonal().array() += 0.5 * e.squaredNorm() + 1e-14;
    const JointVector step = J.transpose() * A.ldlt().solve(e);
    if (!step.allFinite()) return false;
    q += step;
  }
  return false;
}

/// Tries from q, then from the first fixed starts; `miss` is that of the closest try.
bool InverseKinematics::Impl::search(const Frame& T_base_tip, JointVector& q, Miss& miss) const {
  if (iterate(T_base_tip, q, miss)) return true;
  for (int k = 0; k < fallback_starts; ++k) {
    q = starts[static_cast<std::size_t>(k)];
    Miss other;
    if (iterate(T_base_tip, q, other)) return true;
    if (other.position < miss.position) miss = other;
  }
  return false;
}

bool InverseKinematics::Impl::accepted(const Frame& T_base_tip, const JointVector& q) const {
  const Frame T = forwardKinematics(robot, q);
  return (T.translation() - T_base_tip.translation()).norm() <= position_tolerance &&
         geometry::rotationAngle(T.linear(), T_base_tip.linear()) <= rotation_tolerance;
}

InverseKinematics::InverseKinematics(const Robot& robot) : impl_(std::make_unique<Impl>(robot)) {}
InverseKinematics::~InverseKinematics() = default;
InverseKinematics::InverseKinematics(InverseKinematics&&) noexcept = default;
InverseKinematics& InverseKinematics::operator=(InverseKinematics&&) noexcept = default;

std::optional<JointVector> InverseKinematics::solve(const Frame& T_base_tip, const JointVector& seed,
                                                    Miss* miss) const {
  Miss least{impl_->beyondReach(T_base_tip), 0.0};
  JointVector q = seed;
  const bool found = least.position <= 0.0 && impl_->search(T_base_tip, q, least) && impl_->accepted(T_base_tip, q);
  if (miss != nullptr) *miss = least;
  if (!found) return std::nullopt;
  for (int i = 0; i < q.size(); ++i) q[i] = nearestTurn(q[i], seed[i]);
  return q;
}

std::vector<JointVector> InverseKinematics::allConfigurations(const Frame& T_base_tip) const {
  std::vector<JointVector> distinct, found;
  if (!(impl_->beyondReach(T_base_tip) <= 0.0)) return found;
  Miss miss;
  for (const JointVector& start : impl_->starts) {
    JointVector q = start;
    if (!impl_->iterate(T_base_tip, q, miss) || !impl_->accepted(T_base_tip, q)) continue;
    const bool known = std::any_of(distinct.begin(), distinct.end(),
                                   [&q](const JointVector& other) { return sameConfiguration(q, other); });
    if (known) continue;
    distinct.push_back(q);
    appendTurns(impl_->robot, q, found);
  }
  std::stable_sort(found.begin(), found.end(), [this](const JointVector& a, const JointVector& b) {
    return distanceFromMiddle(impl_->robot, a) < distanceFromMiddle(impl_->robot, b);
  });
  return found;
}

}  // namespace scan_to_path::robot
