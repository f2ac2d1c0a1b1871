// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scan_to_path/common/options.h"
#include "scan_to_path/robot/robot.h"

namespace scan_to_path::robot {

/// How encoder counts become joint angles; one value per joint. Spec cutting, step 1.
struct EncoderOptions {
  std::vector<double> counts_per_turn = std::vector<double>(6, 131072.0);
  std::vector<double> gear_ratio = std::vector<double>(6, 100.0);
  std::vector<double> sign = std::vector<double>(6, 1.0);
  std::vector<double> offset = std::vector<double>(6, 0.0);
  std::vector<double> coupling;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.counts_per_turn, Field{"counts_per_turn", "counts", "encoder counts per motor turn, after quadrature"});
    visit(self.gear_ratio, Field{"gear_ratio", "", "motor turns per joint turn"});
    visit(self.sign, Field{"sign", "", "+1 or -1: sense of counting"});
    visit(self.offset, Field{"offset", "rad", "joint angle at count 0"});
    visit(
        self.coupling,
        Field{
            "coupling", "",
            "n x n matrix, row by row, from motors to the axes that the controller counts (see axis_coupling for what "
            "they make of the joints); empty: identity"});
  }
};

/// theta = L C diag(sign 2 pi / (counts gear)) pulses + offset. L takes the controller's axes to the joints: identity,
/// but for the coupled axis, whose motor turns the sum of its joints.
class Encoders {
public:
  /// Throws InputError unless every list has one positive (sign: +1 or -1) value per joint and the coupling is
  /// invertible.
  Encoders(const EncoderOptions& options, const Robot& robot);

  JointVector angles(const double* counts) const;
  JointVector counts(const JointVector& angles) const;  ///< not rounded

private:
  JointMatrix angles_from_counts_;
  JointMatrix counts_from_angles_;
  JointVector offset_;
};

/// Undoes wraps of a 32-bit counter: returns the value nearest to `previous` that equals `raw` modulo 2^32.
double unwrapCount(double previous, double raw);

}  // namespace scan_to_path::robot
