// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/sensing/clock_offset.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "scan_to_path/common/text.h"
#include "scan_to_path/sensing/joint_readings.h"
#include "scan_to_path/sensing/row_motion.h"

namespace scan_to_path::sensing {
namespace {

constexpr std::size_t group = 4;           // rows of a third difference
constexpr int samples_per_cell = 8;
constexpr int fewest_samples = 6;          // of a cell's line fit
constexpr std::size_t fewest_groups = 3;   // else there is no scatter between them to speak of
constexpr std::size_t fewest_cells = 30;
constexpr int most_iterations = 12;
constexpr double converged = 1e-6;         // [s]

/// The straight line that fits a row's samples around the middle of a cell.
struct Cell {
  bool is_valid = false;
  double height = 0.0;       // in the middle [m]
  double slope = 0.0;
  double velocity = 0.0;     // [m/s]
  double rms = 0.0;          // of the residuals [m]
  double slope_sigma = 0.0;  // of the slope, by the residuals
};

/// The cells first, first + 1, … of one row; cell c is about x = c times the cell's size.
struct RowCells {
  long first = 0;
  std::vector<Cell> cells;

  const Cell* at(long index) const {
    const long i = index - first;
    if (i < 0 || i >= static_cast<long>(cells.size())) return nullptr;
    return &cells[static_cast<std::size_t>(i)];
  }
};

/// A place where four rows are compared: `difference` = dt * `gain` + the part's third difference + noise.
struct Comparison {
  double difference;  // [m]
  double gain;        // [m/s]
  std::size_t group_index;
};

struct Solution {
  double dt = 0.0;
  double standard_error = 0.0;
};

struct RowSample {
  double x, z, time;  // x and z in the row frame [m]
};

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// What the estimate reads, and reads again in every iteration.
struct Source {
  const scan::SampleLog& log;
  const PointLaserOptions& laser;
  const SensorMotion& motion;
  const RowMotion& rows;
  const ClockOffsetOptions& options;
};

/// Samples of a row, x rising, about samples_per_cell in a cell's size.
std::vector<RowSample> placeRow(const Source& source, const MotionRow& row, double clock_offset) {
  std::vector<RowSample> samples;
  const auto& log = source.log;
  std::size_t cursor = 0;
  SensorPose begin, end;
  if (!source.motion.poseAt(log.sensor_time[row.first] + clock_offset, cursor, begin) ||
      !source.motion.poseAt(log.sensor_time[row.last - 1] + clock_offset, cursor, end)) {
    return samples;
  }
  const double wanted = (end.origin - begin.origin).norm() / source.options.cell * samples_per_cell;
  const std::size_t stride = std::max<std::size_t>(1, static_cast<std::size_t>((row.last - row.first) / (wanted + 1.0)));
  const Vector3 x = source.rows.R_base_row.col(0);
  const Vector3 z = source.rows.R_base_row.col(2);
  SensorPose pose;
  for (std::size_t i = row.first; i < row.last; i += stride) {
    const auto distance = distanceFromVoltage(source.laser, log.voltage[i]);
    if (!distance || !source.motion.poseAt(log.sensor_time[i] + clock_offset, cursor, pose)) continue;
    const Vector3 point = pose.origin + *distance * pose.beam;
    samples.push_back({x.dot(point), z.dot(point), log.sensor_time[i]});
  }
  if (!row.is_forward) std::reverse(samples.begin(), samples.end());
  return samples;
}

/// Least-squares line through samples [begin, end) about `x`; not valid unless they surround it.
Cell fitCell(const RowSample* begin, const RowSample* end, double x, double size) {
  Cell cell;
  const double n = static_cast<double>(end - begin);
  if (n < fewest_samples || begin->x > x - 0.5 * size || (end - 1)->x < x + 0.5 * size) return cell;
  double mean_x = 0.0, mean_z = 0.0;
  for (auto s = begin; s != end; ++s) {
    mean_x += s->x / n;
    mean_z += s->z / n;
  }
  double sxx = 0.0, sxz = 0.0, szz = 0.0;
  for (auto s = begin; s != end; ++s) {
    const double dx = s->x - mean_x, dz = s->z - mean_z;
    sxx += dx * dx;
    sxz += dx * dz;
    szz += dz * dz;
  }
  cell.is_valid = true;
  cell.slope = sxz / sxx;
  cell.height = mean_z + cell.slope * (x - mean_x);
  cell.velocity = ((end - 1)->x - begin->x) / ((end - 1)->time - begin->time);
  cell.rms = std::sqrt(std::max(0.0, szz - cell.slope * sxz) / (n - 2.0));
  cell.slope_sigma = cell.rms / std::sqrt(sxx);
  return cell;
}

RowCells fitRow(const std::vector<RowSample>& samples, double size) {
  RowCells row;
  if (samples.empty()) return row;
  row.first = std::lround(samples.front().x / size);
  const long last = std::lround(samples.back().x / size);
  const RowSample* begin = samples.data();
  const RowSample* end = begin;
  const RowSample* const stop = begin + samples.size();
  for (long c = row.first; c <= last; ++c) {
    const double x = static_cast<double>(c) * size;
    while (begin != stop && begin->x < x - size) ++begin;
    if (end < begin) end = begin;
    while (end != stop && end->x <= x + size) ++end;
    row.cells.push_back(fitCell(begin, end, x, size));
  }
  return row;
}

/// Cells with a spike, a jump or an edge in them fit badly: they are not used.
void dropBadCells(std::vector<RowCells>& rows) {
  std::vector<double> rms;
  for (const auto& row : rows) {
    for (const auto& cell : row.cells) {
      if (cell.is_valid) rms.push_back(cell.rms);
    }
  }
  if (rms.empty()) return;
  const double limit = 5.0 * median(std::move(rms)) + 1e-6;
  for (auto& row : rows) {
    for (auto& cell : row.cells) cell.is_valid = cell.is_valid && cell.rms <= limit;
  }
}

double slopeNoise(const std::vector<RowCells>& rows) {
  std::vector<double> sigma;
  for (const auto& row : rows) {
    for (const auto& cell : row.cells) {
      if (cell.is_valid) sigma.push_back(cell.slope_sigma);
    }
  }
  return sigma.empty() ? 0.0 : median(std::move(sigma));
}

/// Four neighbouring rows, to and fro in turn, one beside the other.
bool isGroup(const MotionRow* row) {
  for (std::size_t k = 1; k < group; ++k) {
    if (row[k].is_forward == row[k - 1].is_forward) return false;
    const double step = row[k].across - row[k - 1].across;
    const double first_step = row[1].across - row[0].across;
    if (!(step * first_step > 0.0 && std::abs(step) < 5.0 * std::abs(first_step))) return false;
  }
  return true;
}

/// Weights of the third divided difference over the rows' places across, scaled so that their sizes add up to 1.
std::array<double, group> thirdDifference(const MotionRow* row) {
  std::array<double, group> weights;
  double sum = 0.0;
  for (std::size_t k = 0; k < group; ++k) {
    weights[k] = 1.0;
    for (std::size_t m = 0; m < group; ++m) weights[k] /= m == k ? 1.0 : row[k].across - row[m].across;
    sum += std::abs(weights[k]);
  }
  for (auto& weight : weights) weight /= sum;
  return weights;
}

void compareGroup(const MotionRow* motion, const RowCells* rows, double min_slope, std::size_t group_index,
                  std::vector<Comparison>& comparisons) {
  const auto weights = thirdDifference(motion);
  for (std::size_t i = 0; i < rows[0].cells.size(); ++i) {
    const long index = rows[0].first + static_cast<long>(i);
    Comparison comparison{0.0, 0.0, group_index};
    double speed = 0.0;
    bool is_valid = true;
    for (std::size_t k = 0; k < group && is_valid; ++k) {
      const Cell* cell = rows[k].at(index);
      is_valid = cell != nullptr && cell->is_valid;
      if (!is_valid) break;
      comparison.difference += weights[k] * cell->height;
      comparison.gain += weights[k] * cell->velocity * cell->slope;
      speed += std::abs(weights[k] * cell->velocity);
    }
    if (is_valid && std::abs(comparison.gain) >= min_slope * speed) comparisons.push_back(comparison);
  }
}

/// Comparisons of all groups, with samples placed at `clock_offset`.
std::vector<Comparison> compareRows(const Source& source, const std::vector<std::size_t>& groups,
                                    double clock_offset) {
  std::vector<RowCells> cells(source.rows.rows.size());
  std::vector<bool> is_placed(cells.size(), false);
  for (const auto first : groups) {
    for (std::size_t r = first; r < first + group; ++r) {
      if (!is_placed[r]) cells[r] = fitRow(placeRow(source, source.rows.rows[r], clock_offset), source.options.cell);
      is_placed[r] = true;
    }
  }
  dropBadCells(cells);
  // Below a few times its own noise a slope is none: it would pull the estimate towards 0.
  const double min_slope = std::max(source.options.min_slope, 5.0 * slopeNoise(cells));
  std::vector<Comparison> comparisons;
  for (const auto first : groups) {
    compareGroup(&source.rows.rows[first], &cells[first], min_slope, first, comparisons);
  }
  return comparisons;
}

/// Weighted median of difference / gain, weights |gain|: half of the comparisons may be wrong.
double robustStart(const std::vector<Comparison>& comparisons) {
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

double residualScale(const std::vector<Comparison>& comparisons, double dt) {
  std::vector<double> sizes;
  for (const auto& c : comparisons) sizes.push_back(std::abs(c.difference - dt * c.gain));
  return 1.4826 * median(std::move(sizes)) + 1e-12;
}

double biweight(double residual, double scale) {
  const double u = residual / (4.685 * scale);
  return std::abs(u) < 1.0 ? (1.0 - u * u) * (1.0 - u * u) : 0.0;
}

/// dt by iteratively reweighted least squares, its standard error by the scatter between groups of rows.
Solution solveOffset(const std::vector<Comparison>& comparisons) {
  Solution solution;
  solution.dt = robustStart(comparisons);
  double information = 0.0;
  double scale = 0.0;
  for (int iteration = 0; iteration < 10; ++iteration) {
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
  double variance = 0.0;
  double groups = 0.0;
  for (std::size_t i = 0; i < comparisons.size(); ++groups) {
    const std::size_t group_index = comparisons[i].group_index;
    double score = 0.0;
    for (; i < comparisons.size() && comparisons[i].group_index == group_index; ++i) {
      const double residual = comparisons[i].difference - solution.dt * comparisons[i].gain;
      score += biweight(residual, scale) * comparisons[i].gain * residual;
    }
    variance += score * score;
  }
  // A row stands in up to four groups: their scores are not independent, the variance at most four times theirs.
  variance *= static_cast<double>(group) * groups / std::max(1.0, groups - 1.0);
  solution.standard_error = std::sqrt(variance) / information;
  return solution;
}

/// First rows of the groups to look at: blocks of neighbouring groups spread over the scan, at most max_rows rows.
std::vector<std::size_t> chooseGroups(const std::vector<MotionRow>& rows, int max_rows) {
  std::vector<std::size_t> all;
  for (std::size_t r = 0; r + group <= rows.size(); ++r) {
    if (isGroup(&rows[r])) all.push_back(r);
  }
  if (rows.size() <= static_cast<std::size_t>(max_rows)) return all;
  constexpr std::size_t block = 2 * group;  // rows, that is, five groups
  const std::size_t blocks = std::max<std::size_t>(1, static_cast<std::size_t>(max_rows) / block);
  std::vector<std::size_t> chosen;
  for (const auto r : all) {
    for (std::size_t b = 0; b < blocks; ++b) {
      const std::size_t first = blocks > 1 ? b * (rows.size() - block) / (blocks - 1) : 0;
      if (r < first || r + group > first + block) continue;
      chosen.push_back(r);
      break;
    }
  }
  return chosen;
}

int rowsOf(const std::vector<std::size_t>& groups) {
  std::size_t rows = 0, seen = 0;
  for (const auto first : groups) {
    rows += first + group - std::max(seen, first);
    seen = first + group;
  }
  return static_cast<int>(rows);
}

std::string whyTooFewGroups(const std::vector<MotionRow>& rows) {
  const auto forward = std::count_if(rows.begin(), rows.end(), [](const MotionRow& row) { return row.is_forward; });
  if (rows.size() >= group && (forward == 0 || forward == static_cast<std::ptrdiff_t>(rows.size()))) {
    return "all rows run in one direction";
  }
  return "too few neighbouring rows run to and fro in turn, " + std::to_string(rows.size()) + " rows found, needs " +
         std::to_string(group + fewest_groups - 1);
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
  const RowMotion rows = findRowMotion(log, motion, placement.clock_offset);
  const Source source{log, laser, motion, rows, options};
  const auto groups = chooseGroups(rows.rows, options.max_rows);

  ClockOffsetEstimate estimate;
  estimate.offset = placement.clock_offset;
  estimate.rows = rowsOf(groups);
  if (groups.size() < fewest_groups) {
    estimate.reason = whyTooFewGroups(rows.rows);
    return estimate;
  }
  for (estimate.iterations = 1; estimate.iterations <= most_iterations; ++estimate.iterations) {
    progress.checkCancelled();
    const auto comparisons = compareRows(source, groups, estimate.offset);
    estimate.cells = static_cast<int>(comparisons.size());
    if (comparisons.size() < fewest_cells) {
      estimate.reason = "the part has no slopes along the rows, " + std::to_string(comparisons.size()) + " places";
      return estimate;
    }
    const Solution solution = solveOffset(comparisons);
    estimate.offset += solution.dt;
    estimate.standard_error = solution.standard_error;
    if (std::abs(solution.dt) < converged) break;
  }
  if (estimate.iterations > most_iterations) {
    estimate.reason = "rows do not come to agree";
  } else if (estimate.standard_error > options.max_standard_error) {
    estimate.reason = "the standard error is " + fixed(estimate.standard_error * 1e6, 1) + " us, above " +
                      fixed(options.max_standard_error * 1e6, 1) + " us";
  }
  estimate.is_observable = estimate.reason.empty();
  if (!estimate.is_observable) estimate.offset = placement.clock_offset;
  progress.update("estimating the clock offset", 1.0);
  return estimate;
}

}  // namespace scan_to_path::sensing
