// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "scan_to_path/common/options.h"
#include "scan_to_path/geometry/frames.h"

namespace scan_to_path::sensing {

using geometry::Frame;
using geometry::Vector3;

enum class RasterOrder { zig_zag, one_way };

/// The rows in which the sensor is carried over the workpiece, looking down its -z.
struct RasterOptions {
  double pitch = 0.004;
  double pitch_alternate = 0.0;
  double speed = 0.050;
  double acceleration = 1.0;
  double overscan = 0.005;
  double height = 0.080;
  double row_angle = 0.0;
  double beam_turn = M_PI;
  RasterOrder order = RasterOrder::zig_zag;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.pitch, Field{"pitch", "m", "distance of neighbouring rows", 1e-5, 1.0});
    visit(self.pitch_alternate,
          Field{"pitch_alternate", "m", "distance of every second pair of rows; 0: pitch", 0.0, 1.0});
    visit(self.speed, Field{"speed", "m/s", "along rows and between them", 1e-4, 10.0});
    visit(self.acceleration, Field{"acceleration", "m/s^2", "of the ramps at both ends of every move", 1e-3, 100.0});
    visit(self.overscan, Field{"overscan", "m", "how far rows go on beyond the part", 0.0, 1.0});
    visit(self.height, Field{"height", "m", "of the sensor above the workpiece's z = 0", -10.0, 10.0});
    visit(self.row_angle, Field{"row_angle", "rad", "of the rows from the workpiece's x about its z", -3.2, 3.2});
    visit(self.beam_turn, Field{"beam_turn", "rad", "of the sensor's x from the rows, about its beam", -3.2, 3.2});
    visit(self.order, Field{"order", "", "zig_zag, or one_way with unrecorded returns"});
  }
};

/// Straight move from rest to rest: ramp, constant speed if it is long enough, ramp.
class TrapezoidProfile {
public:
  /// length >= 0 [m], speed [m/s], acceleration [m/s^2]
  TrapezoidProfile(double length, double speed, double acceleration);

  double duration() const { return 2.0 * ramp_ + cruise_; }  ///< [s]
  /// Distance covered [m] at `time` after the start, in [0, duration] [s].
  double distanceAt(double time) const;
  double rampDuration() const { return ramp_; }  ///< [s]

private:
  double length_;
  double acceleration_;
  double ramp_;
  double cruise_;
};

/// A straight move of the sensor's origin in the workpiece frame.
struct RasterMove {
  Vector3 from = Vector3::Zero();  ///< [m]
  Vector3 to = Vector3::Zero();    ///< [m]
  int row = 0;                     ///< the row it is, or leads to
  bool is_row = true;              ///< false: from one row to the next
  bool is_recorded = true;         ///< false: nothing is logged on the way
  TrapezoidProfile profile{0.0, 1.0, 1.0};
  double begin = 0.0;  ///< [s] since the first row's start
};

struct RasterPlan {
  Eigen::Matrix3d R_workpiece_sensor = Eigen::Matrix3d::Identity();  ///< the same on all moves; z is the beam
  std::vector<RasterMove> moves;                                     ///< in order of time, without pauses
  int rows = 0;
  double duration = 0.0;  ///< [s]
};

/// Rows over a rectangle of the workpiece's x-y plane [m], as many as keep inside it when they are centred in it: each
/// row stands for a strip one pitch wide, none runs along the rectangle's border. Zig-zag moves between rows are part
/// of the scan, as in a real log. Throws InputError for an empty rectangle or options out of range.
RasterPlan planRaster(const Eigen::AlignedBox2d& rectangle, const RasterOptions& options);

/// Index of the move that is under way at `time`, in [0, duration]; `cursor` is where the search starts.
std::size_t moveAt(const RasterPlan& plan, double time, std::size_t cursor = 0);

}  // namespace scan_to_path::sensing

namespace scan_to_path {
template <>
struct EnumNames<sensing::RasterOrder> {
  static constexpr std::array<const char*, 2> names = {"zig_zag", "one_way"};
};
}  // namespace scan_to_path
