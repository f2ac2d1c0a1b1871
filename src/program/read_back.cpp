// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "axis_check.h"
#include "expected_moves.h"
#include "scan_to_path/common/angles.h"
#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"
#include "scan_to_path/program/program.h"
#include "scan_to_path/program/rapid_reader.h"

namespace scan_to_path::program {
namespace {

// The bars: what a program may differ from the plan by.
constexpr double position_limit = 1e-6;                     // [m]
constexpr double angle_limit = 0.001 / degrees_per_radian;  // [rad]
constexpr double feed_limit = 1e-6;                         // [m/s]
// Half the last bit of a 32-bit number of 256 to 512 degrees is 1.5e-5 degrees, half the last digit written 5e-7.
constexpr double axis_limit = 2e-5 / degrees_per_radian;  // [rad]
// Planned joint angles may miss the pose by 1 um and 0.001 degree; at 0.5 m of tool that turn moves the TCP by 9 um.
constexpr double start_position_limit = 10e-6;           // [m]
constexpr double start_angle_limit = 2.0 * angle_limit;  // [rad]

/// Angle between two rotations [rad] from the distance of their matrices: |A - B| = 2 sqrt(2) sin(angle / 2).
double rotationDistance(const Frame& a, const Frame& b) {
  return 2.0 * std::asin(std::min(1.0, (a.linear() - b.linear()).norm() / std::sqrt(8.0)));
}

class Comparison {
public:
  Comparison(const ProgramInput& input, const RapidProgram& program, std::size_t limit)
      : input_(input), program_(program), limit_(limit) {}

  std::vector<Discrepancy> run() {
    for (const auto& point : input_.plan.trajectory.points) {
      if (input_.robot.dof() != 6 || point.q.size() != 6) return {{-1, -1, "the plan is not for six axes"}};
    }
    const auto expected = expectedMoves(input_);
    for (const auto& at : expected) {
      if (at.q == nullptr) return {{at.segment, at.index, "the plan has no joint angles for it"}};
    }
    // The writer refuses that too; the two share no check, so that what one misses the other need not.
    if (input_.plan.feeds.size() != expected.size()) {
      return {{-1, -1,
               "the plan has " + std::to_string(input_.plan.feeds.size()) + " feeds for " +
                   std::to_string(expected.size()) + " waypoints"}};
    }
    const auto& moves = program_.moves;
    if (moves.size() != expected.size() + 1) {
      report(nullptr, "program has " + std::to_string(moves.size()) + " moves, the plan needs " +
                          std::to_string(expected.size() + 1) + " (one to the start, one to each waypoint)");
    }
    if (moves.empty() || expected.empty()) return std::move(found_);
    checkStart(moves.front(), expected.front());
    checkTool();
    const std::size_t count = std::min(moves.size() - 1, expected.size());
    for (std::size_t i = 0; i < count && found_.size() < limit_; ++i) {
      checkTarget(moves[i + 1], expected[i]);
      checkFeed(moves[i + 1], expected[i], i == 0 ? input_.options.start_speed : input_.plan.feeds[i]);
      if (i > 0) checkFeedAsked(moves[i + 1], expected[i]);
      checkProcess(moves[i + 1], expected[i]);
      if (i == 0 || !expected[i - 1].process_on) checkProcessDelay(moves[i + 1], expected[i]);
      for (const auto& text : axisDiscrepancies(input_.robot, moves[i + 1], *expected[i].q)) {
        report(&expected[i], text, &moves[i + 1]);
      }
      const bool last = i + 1 == expected.size();
      checkZone(i + 1, expected[i], last || expected[i + 1].segment != expected[i].segment);
    }
    return std::move(found_);
  }

private:
  void report(const ExpectedMove* at, const std::string& text, const RapidMove* move = nullptr) {
    if (found_.size() >= limit_) return;
    const std::string where = move != nullptr ? move->file + " line " + std::to_string(move->line) + ": " : "";
    found_.push_back({at != nullptr ? at->segment : -1, at != nullptr ? at->index : -1, where + text});
  }

  Frame plannedTarget(const ExpectedMove& at) const {
    return input_.T_base_path * at.waypoint->pose * input_.path.T_contact_tcp;
  }

  void checkTarget(const RapidMove& move, const ExpectedMove& at) {
    if (move.type != RapidMoveType::linear) report(&at, "the move is not linear", &move);
    const Frame planned = plannedTarget(at);
    const double distance = (move.T_base_tcp.translation() - planned.translation()).norm();
    if (!(distance <= position_limit)) {
      report(&at, "target is " + fixed(1e6 * distance, 3) + " um off the plan, limit 1 um", &move);
    }
    const double angle = rotationDistance(move.T_base_tcp, planned);
    if (!(angle <= angle_limit)) {
      report(&at, "target is turned " + fixed(degrees_per_radian * angle, 5) + " deg off the plan, limit 0.001 deg",
             &move);
    }
  }

  void checkFeed(const RapidMove& move, const ExpectedMove& at, double planned) {
    if (!(std::abs(move.speed - planned) <= feed_limit)) {
      report(&at, "feed is " + fixed(move.speed, 6) + " m/s, planned " + fixed(planned, 6) + " m/s", &move);
    }
    if (!(std::abs(move.orientation_speed - input_.options.orientation_speed) <= 1e-4)) {
      report(&at,
             "orientation speed is " + fixed(move.orientation_speed, 4) + " rad/s, planned " +
                 fixed(input_.options.orientation_speed, 4) + " rad/s",
             &move);
    }
  }

  /// The motion may lower a feed, but never raise it.
  void checkFeedAsked(const RapidMove& move, const ExpectedMove& at) {
    if (move.speed <= at.waypoint->feed + feed_limit) return;
    report(
        &at,
        "feed is " + fixed(move.speed, 6) + " m/s, the path asks for " + fixed(at.waypoint->feed, 6) + " m/s at most",
        &move);
  }

  void checkProcess(const RapidMove& move, const ExpectedMove& at) {
    const bool planned = at.process_on;
    if (move.process_on != planned) {
      report(&at,
             std::string("process is ") + (move.process_on ? "on" : "off") + ", planned " + (planned ? "on" : "off"),
             &move);
    }
    if (move.after_stop) report(&at, "an unplanned stop is before it", &move);
  }

  /// The tool must not move on before what process_signal starts runs.
  void checkProcessDelay(const RapidMove& move, const ExpectedMove& at) {
    const auto& options = input_.options;
    constexpr double digit = 1e-3;  // [s], the last one written
    if (!at.process_on || options.process_signal.empty()) return;
    if (!(move.process_wait >= options.process_delay - digit)) {
      report(&at,
             "the process runs for " + fixed(move.process_wait, 3) + " s before the tool moves on, planned " +
                 fixed(options.process_delay, 3) + " s (program.process_delay)",
             &move);
    }
  }

  /// The corner at moves[m] may be cut by the tolerance and the zones of neighbours must not meet.
  void checkZone(std::size_t m, const ExpectedMove& at, bool segment_end) {
    const auto& moves = program_.moves;
    if (moves[m].stop) return;
    if (segment_end) report(&at, "no stop at the end of a segment", &moves[m]);
    if (m < 2 || m + 1 >= moves.size()) return report(&at, "a zone at the first or last waypoint", &moves[m]);
    if (moves[m + 1].process_on != moves[m].process_on) report(&at, "no stop where the process is switched", &moves[m]);
    const geometry::Vector3 in = moves[m].T_base_tcp.translation() - moves[m - 1].T_base_tcp.translation();
    const geometry::Vector3 out = moves[m + 1].T_base_tcp.translation() - moves[m].T_base_tcp.translation();
    const double sine_half = std::sin(0.5 * geometry::angleBetween(in, out));
    const double tolerance = at.process_on ? input_.options.zone_tolerance : input_.options.air_tolerance;
    // The positions are written to 1e-4 mm: 0.1 um on the way of two neighbours, and on the corner that they form.
    const double rounding = 2e-7;
    if (moves[m].zone * sine_half > tolerance + rounding ||
        moves[m].zone > 0.5 * std::min(in.norm(), out.norm()) + rounding) {
      report(&at,
             "zone of " + fixed(1e3 * moves[m].zone, 3) + " mm leaves the path by more than " +
                 fixed(1e6 * tolerance, 1) + " um or meets its neighbour",
             &moves[m]);
    }
  }

  void checkStart(const RapidMove& move, const ExpectedMove& at) {
    if (move.type != RapidMoveType::absolute_joint) return report(&at, "the first move is not MoveAbsJ", &move);
    if (!move.stop) report(&at, "no stop at the start", &move);
    if (move.process_on) report(&at, "process is on while the arm moves to the start", &move);
    JointVector q(6);
    for (int i = 0; i < 6; ++i) q[i] = move.axes[static_cast<std::size_t>(i)];
    if (const auto& coupled = input_.robot.coupled_axis) q[coupled->axis] -= otherJoints(*coupled, q);
    for (int i = 0; i < 6; ++i) {
      if (!(std::abs(q[i] - (*at.q)[i]) <= axis_limit)) {
        report(&at,
               "start angle of joint " + std::to_string(i + 1) + " is " + fixed(degrees_per_radian * q[i], 6) +
                   " deg, planned " + fixed(degrees_per_radian * (*at.q)[i], 6) + " deg",
               &move);
      }
    }
    checkStartPose(move, at, q);
  }

  /// Forward kinematics of the start angles read against the first target read, which it does not come from.
  void checkStartPose(const RapidMove& move, const ExpectedMove& at, const JointVector& q) {
    if (program_.moves.size() < 2) return;
    const Frame reached = robot::forwardKinematics(input_.robot, q) * program_.tools[move.tool].T_tip_tcp;
    const Frame& target = program_.moves[1].T_base_tcp;
    const double distance = (reached.translation() - target.translation()).norm();
    const double angle = rotationDistance(reached, target);
    if (!(distance <= start_position_limit && angle <= start_angle_limit)) {
      report(&at,
             "start angles put the tool " + fixed(1e6 * distance, 3) + " um and " +
                 fixed(degrees_per_radian * angle, 5) + " deg off the first target",
             &move);
    }
  }

  void checkTool() {
    if (program_.tools.size() != 1) report(nullptr, "moves use " + std::to_string(program_.tools.size()) + " tools");
    const auto& tool = program_.tools.front();
    const auto& options = input_.options;
    if (!((tool.T_tip_tcp.translation() - input_.T_tip_tcp.translation()).norm() <= position_limit &&
          rotationDistance(tool.T_tip_tcp, input_.T_tip_tcp) <= angle_limit)) {
      report(nullptr, "tool frame differs from the tool mount");
    }
    if (!(std::abs(tool.mass - options.tool_mass) <= 1e-3 &&
          (tool.centre_of_gravity - options.tool_centre_of_gravity).norm() <= position_limit &&
          (tool.inertia - options.tool_inertia).norm() <= 1e-5)) {
      report(nullptr, "tool load differs from program.tool_mass, tool_centre_of_gravity, tool_inertia");
    }
  }

  const ProgramInput& input_;
  const RapidProgram& program_;
  std::size_t limit_;
  std::vector<Discrepancy> found_;
};

}  // namespace

ReadBack readBack(Controller controller, const ProgramInput& input, const std::vector<ProgramFile>& files,
                  std::size_t limit) {
  if (controller != Controller::abb) throw InputError("no program reader for this controller");
  RapidReadOptions options;
  options.process_on = input.options.process_on;
  options.process_off = input.options.process_off;
  options.process_signal = input.options.process_signal;
  try {
    const RapidProgram program = readRapid(files, options);
    const auto linear = std::count_if(program.moves.begin(), program.moves.end(),
                                      [](const auto& move) { return move.type == RapidMoveType::linear; });
    return {static_cast<std::size_t>(linear), Comparison(input, program, limit).run()};
  } catch (const InputError& error) {
    return {0, {{-1, -1, error.what()}}};
  }
}

}  // namespace scan_to_path::program
