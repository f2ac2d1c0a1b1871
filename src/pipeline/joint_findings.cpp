// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/joint_findings.h"

#include "scan_to_path/common/text.h"

namespace scan_to_path::pipeline {
namespace {

constexpr double noted_jump = 5e-4;  // [m]; a ramp of 1 m/s^2 hides half of it in any log

}  // namespace

JointFindings jointFindings(const sensing::UnseenJumps& unseen, std::size_t times_repeated,
                            const ReportOptions& limits) {
  JointFindings found;
  found.accuracy = {{"unseen_joint_jump", unseen.distance, "m", limitUnlessZero(limits.max_unseen_jump)}};
  if (unseen.distance > noted_jump) {
    found.notes.push_back("a jump of " + unseen.what + ", " + fixed(1e3 * unseen.distance, 2) +
                          " mm at the sensor, would look like motion at " + fixed(unseen.time, 3) +
                          " s: read the joints more often, or turn the robot more gently");
  }
  found.accuracy.push_back(
      {"unseen_pauses", static_cast<double>(unseen.pauses), "1", static_cast<double>(limits.max_unseen_pauses)});
  if (unseen.pauses > 0) {
    found.notes.push_back("the robot moves unseen in " + std::to_string(unseen.pauses) +
                          " pauses of the readings, where a slip or a new home position does not show: record without "
                          "pauses, or allow them with --set report.max_unseen_pauses=" +
                          std::to_string(unseen.pauses));
  }
  if (times_repeated > 1) {
    found.notes.push_back("the log gives each joint reading " + std::to_string(times_repeated) +
                          " times: the first of each counts");
  }
  return found;
}

}  // namespace scan_to_path::pipeline
