// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/sensing/clock_offset.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scan_to_path/common/median.h"
#include "scan_to_path/common/text.h"
#include "scan_to_path/sensing/joint_readings.h"
#include "scan_to_path/sensing/row_comparison.h"

namespace scan_to_path::sensing {
namespace {

constexpr std::size_t fewest_groups = 3;  // else there is no scatter between them to speak of
constexpr std::size_t fewest_comparisons = 30;
constexpr int most_iterations = 12;
constexpr int most_reweightings = 10;
constexpr double converged = 1e-6;  // [s]

struct Solution {
  double dt = 0.0;
  double standard_error = 0.0;
};

/// Weighted median of difference / gain, weights |gain|: half of the comparisons may be wrong.
double robustStart(const std::vector<RowComparison>& comparisons) {
  std::vector<std::pair<double, double>> ratios;
  double total = 0.0;
  for (const auto& c : comparisons) {
    ratios.emplace_back(c.difference / c.gain, std::abs(c.gain));
    total += std::abs(c.gain);
  }
  std::sort(ratios.begin(), ratios.end());
  double sum = 0.0;
  for (const auto& [ratio, weight] : ratios) {
    sum += weight;
    if (sum >= 0.5 * total) return ratio;
  }
  return ratios.back().first;
}

double residualScale(const std::vector<RowComparison>& comparisons, double dt) {
  std::vector<double> sizes;
  for (const auto& c : comparisons) sizes.push_back(std::abs(c.difference - dt * c.gain));
  return 1.4826 * median(std::move(sizes)) + 1e-12;
}

double biweight(double residual, double scale) {
  const double u = residual / (4.685 * scale);
  return std::abs(u) < 1.0 ? (1.0 - u * u) * (1.0 - u * u) : 0.0;
}

/// Standard error of dt by the scatter between groups of rows (sandwich estimator).
double standardError(const std::vector<RowComparison>& comparisons, double dt, double scale, double information) {
  double variance = 0.0;
  double groups = 0.0;
  for (std::size_t i = 0; i < comparisons.size(); ++groups) {
    const std::size_t group = comparisons[i].group;
    double score = 0.0;
    for (; i < comparisons.size() && comparisons[i].group == group; ++i) {
      const double residual = comparisons[i].difference - dt * comparisons[i].gain;
      score += biweight(residual, scale) * comparisons[i].gain * residual;
    }
    variance += score * score;
  }
  // A row stands in up to four groups: their scores are not independent, the variance at most four times theirs.
  variance *= static_cast<double>(rows_compared) * groups / std::max(1.0, groups - 1.0);
  return std::sqrt(variance) / information;
}

/// dt by iteratively reweighted least squares.
Solution solveOffset(const std::vector<RowComparison>& comparisons) {
  Solution solution;
  solution.dt = robustStart(comparisons);
  double information = 0.0;
  double scale = 0.0;
  for (int i = 0; i < most_reweightings; ++i) {
    scale = residualScale(comparisons, solution.dt);
    double moment = 0.0;
    information = 0.0;
    for (const auto& c : comparisons) {
      const double weight = biweight(c.difference - solution.dt * c.gain, scale);
      moment += weight * c.gain * c.difference;
      information += weight * c.gain * c.gain;
    }
    solution.dt = moment / information;
  }
  solution.standard_error = standardError(comparisons, solution.dt, scale, information);
  return solution;
}

int rowsOf(const std::vector<std::size_t>& groups) {
  std::size_t rows = 0, seen = 0;
  for (const auto first : groups) {
    rows += first + rows_compared - std::max(seen, first);
    seen = first + rows_compared;
  }
  return static_cast<int>(rows);
}

std::string whyTooFewGroups(const std::vector<MotionRow>& rows) {
  const auto forward = std::count_if(rows.begin(), rows.end(), [](const MotionRow& row) { return row.is_forward; });
  if (rows.size() >= rows_compared && (forward == 0 || forward == static_cast<std::ptrdiff_t>(rows.size()))) {
    return "all rows run in one direction";
  }
  return "too few neighbouring rows run to and fro in turn, " + std::to_string(rows.size()) + " rows found, needs " +
         std::to_string(rows_compared + fewest_groups - 1);
}

/// Gauss-Newton steps from estimate.offset.
template <class Compare>
void iterate(const ClockOffsetOptions& options, const Progress& progress, ClockOffsetEstimate& estimate,
             const Compare& compare) {
  const double start = estimate.offset;
  const auto giveUp = [&](Observability observability, const std::string& reason) {
    estimate.observability = observability;
    estimate.reason = reason;
    if (observability != Observability::uncertain) estimate.offset = start;
  };
  for (estimate.iterations = 1; estimate.iterations <= most_iterations; ++estimate.iterations) {
    progress.checkCancelled();
    const std::vector<RowComparison> comparisons = compare(estimate.offset);
    estimate.cells = static_cast<int>(comparisons.size());
    if (comparisons.size() < fewest_comparisons) {
      return giveUp(Observability::few_slopes, "too few slopes along the rows to compare, " +
                                                   std::to_string(comparisons.size()) + " places, needs " +
                                                   std::to_string(fewest_comparisons));
    }
    const Solution solution = solveOffset(comparisons);
    estimate.offset += solution.dt;
    estimate.standard_error = solution.standard_error;
    if (std::abs(solution.dt) >= converged) continue;
    estimate.observability = Observability::observable;
    if (estimate.standard_error <= options.max_standard_error) return;
    return giveUp(Observability::uncertain, "the standard error is " + fixed(estimate.standard_error * 1e6, 1) +
                                                " us, above " + fixed(options.max_standard_error * 1e6, 1) + " us");
  }
  giveUp(Observability::none, "rows do not come to agree in " + std::to_string(most_iterations) + " steps");
}

}  // namespace

ClockOffsetEstimate estimateClockOffset(const scan::SampleLog& log, const robot::Robot& robot,
                                        const robot::Encoders& encoders, const PointLaserOptions& laser,
                                        const Frame& T_tip_sensor, const PlacementOptions& placement,
                                        const ClockOffsetOptions& options, const Progress& progress) {
  validateLaser(laser);
  validate(placement, "placement");
  validate(options, "clock offset");
  progress.update("estimating the clock offset", 0.0);
  const JointReadings readings(log, robot, encoders, placement.max_joint_gap);
  const SensorMotion motion(readings, robot, T_tip_sensor);
  const double start = placement.clock_offset.value_or(0.0);
  const RowMotion rows = findRowMotion(log, motion, start);

  ClockOffsetEstimate estimate;
  // Where the slopes are few they may lie in rows that were not looked at.
  const int all_rows = static_cast<int>(rows.rows.size());
  for (const int most_rows : {options.max_rows, std::max(options.max_rows, all_rows)}) {
    const auto groups = chooseGroups(rows.rows, most_rows);
    estimate.offset = start;
    estimate.rows = rowsOf(groups);
    if (groups.size() < fewest_groups) {
      estimate.reason = whyTooFewGroups(rows.rows);
      return estimate;
    }
    iterate(options, progress, estimate, [&](double offset) {
      return compareRows(log, laser, motion, rows, groups, {options.cell, options.min_slope}, offset);
    });
    if (estimate.observability != Observability::few_slopes || all_rows <= most_rows) break;
  }
  progress.update("estimating the clock offset", 1.0);
  return estimate;
}

}  // namespace scan_to_path::sensing
