// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/joint_findings.h"

#include "scan_to_path/common/text.h"

namespace scan_to_path::pipeline {
namespace {

constexpr double noted_jump = 1e-4;  // [m]; what a path may be off on a part that nobody modelled

}  // namespace

JointFindings jointFindings(const sensing::PlacedScan& scan, const robot::Robot& robot, const ReportOptions& limits) {
  const sensing::UnseenJumps& unseen = scan.unseen_jumps;
  JointFindings found;
  found.accuracy = {{"unseen_joint_jump", unseen.distance, "m", limitUnlessZero(limits.max_unseen_jump)}};
  if (unseen.distance > noted_jump) {
    found.notes.push_back("a jump of " + robot.joints[static_cast<std::size_t>(unseen.joint)].name + " by up to " +
                          fixed(unseen.angle, 6) + " rad, " + fixed(1e3 * unseen.distance, 2) +
                          " mm at the sensor, would look like its motion at " + fixed(unseen.time, 3) +
                          " s: read the joints more often, or turn the robot more gently");
  }
  if (unseen.pauses > 0) {
    found.notes.push_back("the joints move unseen in " + std::to_string(unseen.pauses) +
                          " pauses of the log: a slip or a new home position in one of them does not show");
  }
  if (scan.times_repeated > 1) {
    found.notes.push_back("the log gives each joint reading " + std::to_string(scan.times_repeated) +
                          " times: the first of each counts");
  }
  return found;
}

}  // namespace scan_to_path::pipeline
