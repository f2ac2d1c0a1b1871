// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/verification/pulse_check.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path::verification {
namespace {

using motion::Trajectory;
using motion::TrajectoryPoint;

constexpr double time_limit = 1e-6;  // [s]; written to 1e-6, so half of it is rounding
constexpr std::size_t leading = 3;   // cells before the joints': t, segment, index

/// A line of the file as it stands there.
struct PulseLine {
  double time = 0.0;
  double segment = 0.0;
  double index = 0.0;
  Eigen::VectorXd pulses;
};

struct PulseFile {
  std::vector<std::string> joint_names;
  std::vector<PulseLine> lines;
};

double cellValue(std::string_view cell, std::size_t line, bool is_whole) {
  double value = 0.0;
  if (!parseNumber(cell, value) || !std::isfinite(value) || (is_whole && value != std::floor(value))) {
    throw InputError("pulses.csv line " + std::to_string(line), "cell", "'" + std::string(cell) + "'",
                     is_whole ? "a whole number" : "a finite number");
  }
  return value;
}

PulseLine readLine(const std::vector<std::string_view>& cells, std::size_t number) {
  PulseLine line;
  line.time = cellValue(cells[0], number, false);
  line.segment = cellValue(cells[1], number, true);
  line.index = cellValue(cells[2], number, true);
  line.pulses.resize(static_cast<Eigen::Index>(cells.size() - leading));
  for (std::size_t k = leading; k < cells.size(); ++k) {
    line.pulses[static_cast<Eigen::Index>(k - leading)] = cellValue(cells[k], number, true);
  }
  return line;
}

/// Every line ends with a line feed; all have as many cells as the first.
PulseFile readPulses(const std::string& text) {
  PulseFile file;
  if (text.empty() || text.back() != '\n') throw InputError("pulses.csv: the last line has no end");
  std::size_t cell_count = 0;
  std::size_t number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    const auto cells = split(std::string_view(text).substr(begin, end - begin), ',');
    begin = end + 1;
    if (++number == 1) {
      cell_count = cells.size();
      if (cell_count <= leading || cells[0] != "t" || cells[1] != "segment" || cells[2] != "index") {
        throw InputError("pulses.csv: header must be t,segment,index and the joints' names");
      }
      file.joint_names.assign(cells.begin() + leading, cells.end());
      continue;
    }
    if (cells.size() != cell_count) {
      throw InputError("pulses.csv line " + std::to_string(number), "number of cells", std::to_string(cells.size()),
                       std::to_string(cell_count));
    }
    file.lines.push_back(readLine(cells, number));
  }
  return file;
}

/// From pulses to joint angles and back to what differences of angles are in counts, by the settings as they stand.
class Pulses {
public:
  Pulses(const robot::EncoderOptions& options, const robot::Robot& robot)
      : options_(options), robot_(robot), joints_(static_cast<std::size_t>(robot.dof())) {
    const auto n = static_cast<Eigen::Index>(joints_);
    Eigen::MatrixXd coupling = Eigen::MatrixXd::Identity(n, n);
    for (std::size_t i = 0; i < options.coupling.size(); ++i) {
      coupling(static_cast<Eigen::Index>(i / joints_), static_cast<Eigen::Index>(i % joints_)) = options.coupling[i];
    }
    coupling_ = coupling;
    solver_.compute(coupling);
  }

  Eigen::VectorXd angles(const Eigen::VectorXd& pulses) const {
    Eigen::VectorXd motors(pulses.size());
    for (std::size_t k = 0; k < joints_; ++k) {
      motors[at(k)] = options_.sign[k] * 2.0 * M_PI * pulses[at(k)] / countsPerTurn(k);
    }
    Eigen::VectorXd joints = coupling_ * motors;
    if (robot_.coupled_axis) joints[robot_.coupled_axis->axis] -= sumOfOthers(joints);
    for (std::size_t k = 0; k < joints_; ++k) joints[at(k)] += options_.offset[k];
    return joints;
  }

  /// Largest difference of any motor [counts] for a difference of joint angles.
  double largestInCounts(Eigen::VectorXd joints) const {
    if (robot_.coupled_axis) joints[robot_.coupled_axis->axis] += sumOfOthers(joints);
    const Eigen::VectorXd motors = solver_.solve(joints);
    double largest = 0.0;
    for (std::size_t k = 0; k < joints_; ++k) {
      largest = std::max(largest, std::abs(motors[at(k)]) * countsPerTurn(k) / (2.0 * M_PI));
    }
    return largest;
  }

private:
  static Eigen::Index at(std::size_t k) { return static_cast<Eigen::Index>(k); }

  double countsPerTurn(std::size_t k) const { return options_.counts_per_turn[k] * options_.gear_ratio[k]; }

  double sumOfOthers(const Eigen::VectorXd& joints) const {
    double sum = 0.0;
    for (const int joint : robot_.coupled_axis->joints) sum += joint != robot_.coupled_axis->axis ? joints[joint] : 0.0;
    return sum;
  }

  const robot::EncoderOptions& options_;
  const robot::Robot& robot_;
  std::size_t joints_;
  Eigen::MatrixXd coupling_;
  Eigen::FullPivLU<Eigen::MatrixXd> solver_;
};

/// The difference of two points in words; empty when they are the same but for their angles.
std::string mismatchOf(const PulseLine& read, const TrajectoryPoint& planned) {
  if (read.segment != planned.segment || read.index != planned.index) return "names another waypoint";
  return std::abs(read.time - planned.time) <= time_limit ? "" : "is at another time";
}

void addMismatch(PulseCheck& check, const std::string& text) {
  if (check.mismatches++ == 0) check.first_mismatch = text;
}

void comparePoints(const PulseFile& file, const Trajectory& trajectory, const Pulses& pulses, PulseCheck& check) {
  for (std::size_t i = 0; i < file.lines.size(); ++i) {
    const TrajectoryPoint& planned = trajectory.points[i];
    const std::string mismatch = mismatchOf(file.lines[i], planned);
    if (!mismatch.empty()) addMismatch(check, "pulses.csv point " + std::to_string(i) + " " + mismatch);
    const double off = pulses.largestInCounts(pulses.angles(file.lines[i].pulses) - planned.q);
    check.largest_difference = std::max(check.largest_difference, off);
  }
}

}  // namespace

PulseCheck checkPulses(const std::string& text, const Trajectory& trajectory, const robot::EncoderOptions& options,
                       const robot::Robot& robot) {
  PulseCheck check;
  PulseFile file;
  try {
    file = readPulses(text);
  } catch (const InputError& error) {
    addMismatch(check, error.what());
    return check;
  }
  check.points = file.lines.size();
  if (file.joint_names != trajectory.joint_names) {
    addMismatch(check, "pulses.csv names other joints");
    if (file.joint_names.size() != static_cast<std::size_t>(robot.dof())) return check;
  }
  if (file.lines.size() != trajectory.points.size()) {
    addMismatch(check, "pulses.csv has " + std::to_string(file.lines.size()) + " points, the trajectory " +
                           std::to_string(trajectory.points.size()));
    return check;
  }
  comparePoints(file, trajectory, Pulses(options, robot), check);
  return check;
}

}  // namespace scan_to_path::verification
