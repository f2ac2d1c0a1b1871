// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scan_to_path/motion/motion_plan.h"
#include "scan_to_path/robot/inverse_kinematics.h"

namespace scan_to_path::motion {

/// A robot with a tool, and how exactly it is to move.
struct MoveSolver {
  const robot::Robot& robot;
  const robot::InverseKinematics& inverse;
  Frame T_tip_tcp;
  double tolerance;     ///< largest distance of the tool centre point from the straight line [m]
  double largest_step;  ///< of a joint between neighbouring points [rad]
};

/// The pose a fraction u of the way from T to the one that is `way` [m] off and turned by the rotation vector `turn`
/// [rad], both in T's parent frame.
Frame interpolatePose(const Frame& T, const Vector3& way, const Vector3& turn, double u);

/// Joint angles along the straight move from q_a to the tip pose T_base_tip, without q_a: the last ones put the tip
/// there, those before, if any, are at most 0.25 rad of turn and 0.1 m apart. Each is found from the one before, whole
/// turns nearest to it. A half turn is as far either way round: the one whose end is nearer to the middle of the joint
/// ranges is taken. Empty when a pose on the way has no joint angles; `miss`, when not null, says by how much.
std::vector<JointVector> followMove(const MoveSolver& solver, const JointVector& q_a, const Frame& T_base_tip,
                                    robot::Miss* miss = nullptr);

/// Largest distance [m] of the tool centre point from the straight line between T_base_tcp's a and b while the joints
/// go linearly from q_a to q_b, sampled at the quarters of the move.
double chordError(const MoveSolver& solver, const JointVector& q_a, const JointVector& q_b, const Vector3& a,
                  const Vector3& b);

struct StraightMove {
  std::vector<JointVector> between;  ///< intermediate points, without the ends
  double chord_error = 0.0;          ///< what is left, over all pieces [m]
};

/// Halves the move from q_a to q_b until every piece is within the tolerance and no joint's step is too large. Halving
/// ends, with what is left reported, after ten halvings or where a pose on the line has no joint angles next to its
/// neighbours'.
StraightMove straightMove(const MoveSolver& solver, const JointVector& q_a, const JointVector& q_b);

}  // namespace scan_to_path::motion
