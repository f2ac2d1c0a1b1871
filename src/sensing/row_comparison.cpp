// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/sensing/row_comparison.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scan_to_path/common/median.h"

namespace scan_to_path::sensing {
namespace {

constexpr int samples_per_cell = 8;
constexpr int fewest_samples = 6;  // of a cell's line fit

/// The straight line that fits a row's samples around the middle of a cell.
struct Cell {
  bool is_valid = false;
  double height = 0.0;  // in the middle [m]
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

struct RowSample {
  double x, z, time;  // x and z in the row frame [m]
};

/// What is compared.
struct Source {
  const scan::SampleLog& log;
  const PointLaserOptions& laser;
  const SensorMotion& motion;
  const RowMotion& rows;
  const ComparisonSettings& settings;
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
  const double wanted = (end.origin - begin.origin).norm() / source.settings.cell * samples_per_cell;
  const std::size_t stride =
      std::max<std::size_t>(1, static_cast<std::size_t>((row.last - row.first) / (wanted + 1.0)));
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
  return median(std::move(sigma));
}

/// Weights of the third divided difference over the rows' places across, scaled so that their sizes add up to 1.
std::array<double, rows_compared> thirdDifference(const MotionRow* row) {
  std::array<double, rows_compared> weights;
  double sum = 0.0;
  for (std::size_t k = 0; k < rows_compared; ++k) {
    weights[k] = 1.0;
    for (std::size_t m = 0; m < rows_compared; ++m) weights[k] /= m == k ? 1.0 : row[k].across - row[m].across;
    sum += std::abs(weights[k]);
  }
  for (auto& weight : weights) weight /= sum;
  return weights;
}

/// The four rows at the place `index`; false when one of them has no cell there, or they have no slope.
bool compareAt(const RowCells* rows, const std::array<double, rows_compared>& weights, long index, double min_slope,
               RowComparison& comparison) {
  double speed = 0.0;
  for (std::size_t k = 0; k < rows_compared; ++k) {
    const Cell* cell = rows[k].at(index);
    if (cell == nullptr || !cell->is_valid) return false;
    comparison.difference += weights[k] * cell->height;
    comparison.gain += weights[k] * cell->velocity * cell->slope;
    speed += std::abs(weights[k] * cell->velocity);
  }
  return std::abs(comparison.gain) >= min_slope * speed;
}

void compareGroup(const MotionRow* motion, const RowCells* rows, double min_slope, std::size_t first_row,
                  std::vector<RowComparison>& comparisons) {
  const auto weights = thirdDifference(motion);
  for (std::size_t i = 0; i < rows[0].cells.size(); ++i) {
    RowComparison comparison{0.0, 0.0, first_row};
    const long index = rows[0].first + static_cast<long>(i);
    if (compareAt(rows, weights, index, min_slope, comparison)) comparisons.push_back(comparison);
  }
}

/// Four neighbouring rows, to and fro in turn, one beside the other.
bool isGroup(const MotionRow* row) {
  for (std::size_t k = 1; k < rows_compared; ++k) {
    if (row[k].is_forward == row[k - 1].is_forward) return false;
    const double ratio = (row[k].across - row[k - 1].across) / (row[1].across - row[0].across);
    if (!(ratio > 0.2 && ratio < 5.0)) return false;
  }
  return true;
}

}  // namespace

std::vector<std::size_t> chooseGroups(const std::vector<MotionRow>& rows, int max_rows) {
  std::vector<std::size_t> all;
  for (std::size_t r = 0; r + rows_compared <= rows.size(); ++r) {
    if (isGroup(&rows[r])) all.push_back(r);
  }
  if (rows.size() <= static_cast<std::size_t>(max_rows)) return all;
  constexpr std::size_t block = 2 * rows_compared;  // rows, that is, five groups
  const std::size_t blocks = std::max<std::size_t>(1, static_cast<std::size_t>(max_rows) / block);
  std::vector<std::size_t> chosen;
  for (const auto r : all) {
    for (std::size_t b = 0; b < blocks; ++b) {
      const std::size_t first = blocks > 1 ? b * (rows.size() - block) / (blocks - 1) : 0;
      if (r < first || r + rows_compared > first + block) continue;
      chosen.push_back(r);
      break;
    }
  }
  return chosen;
}

std::vector<RowComparison> compareRows(const scan::SampleLog& log, const PointLaserOptions& laser,
                                       const SensorMotion& motion, const RowMotion& rows,
                                       const std::vector<std::size_t>& groups, const ComparisonSettings& settings,
                                       double clock_offset) {
  const Source source{log, laser, motion, rows, settings};
  std::vector<RowCells> cells(source.rows.rows.size());
  std::vector<bool> is_placed(cells.size(), false);
  for (const auto first : groups) {
    for (std::size_t r = first; r < first + rows_compared; ++r) {
      if (!is_placed[r]) cells[r] = fitRow(placeRow(source, source.rows.rows[r], clock_offset), source.settings.cell);
      is_placed[r] = true;
    }
  }
  dropBadCells(cells);
  // Below a few times its own noise a slope is none: it would pull the estimate towards 0.
  const double min_slope = std::max(source.settings.min_slope, 5.0 * slopeNoise(cells));
  std::vector<RowComparison> comparisons;
  for (const auto first : groups) {
    compareGroup(&source.rows.rows[first], &cells[first], min_slope, first, comparisons);
  }
  return comparisons;
}

}  // namespace scan_to_path::sensing
