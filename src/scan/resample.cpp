// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/scan/resample.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "line_table.h"
#include "scan_to_path/common/error.h"

namespace scan_to_path::scan {
namespace {

/// Cumulated "number of steps" along a line at tabulated parameters, with its derivative at both ends of every cell.
struct StepTable {
  std::vector<double> u;
  std::vector<double> steps;
  std::vector<double> density;  ///< steps per parameter
};

/// Steps per unit of the parameter: the speed |C'| over the step length wanted.
double stepDensity(const LineTable::Jet& jet, const ResampleOptions& options) {
  const double speed = jet.first.norm();
  double step = options.spacing;
  if (options.chord_error > 0.0) {
    const double curvature = jet.first.cross(jet.second).norm() / (speed * speed * speed);
    // 8 where the curvature is constant; a step that starts in an inflection would be 2/sqrt(3) off with it.
    constexpr double factor = 6.9;
    if (curvature * step * step > factor * options.chord_error)
      step = std::sqrt(factor * options.chord_error / curvature);
  }
  return speed / step;
}

StepTable tabulate(const LineTable& line, const ResampleOptions& options) {
  constexpr int cells_per_span = 8;
  StepTable table;
  std::size_t hint = 0;
  for (std::size_t k = 0; k + 1 < line.breaks().size(); ++k) {
    const double low = std::max(line.breaks()[k], line.begin());
    const double high = std::min(line.breaks()[k + 1], line.end());
    if (!(low < high)) continue;
    if (table.u.empty()) table.u.push_back(low);
    for (int c = 1; c <= cells_per_span; ++c) table.u.push_back(low + (high - low) * c / cells_per_span);
  }
  for (const double u : table.u) table.density.push_back(stepDensity(line.jet(u, hint), options));
  table.steps.push_back(0.0);
  hint = 0;
  for (std::size_t i = 1; i < table.u.size(); ++i) {
    const double width = table.u[i] - table.u[i - 1];
    const double middle = stepDensity(line.jet(table.u[i - 1] + 0.5 * width, hint), options);
    const double mean = (table.density[i - 1] + 4.0 * middle + table.density[i]) / 6.0;  // Simpson's rule
    table.steps.push_back(table.steps.back() + width * mean);
  }
  return table;
}

/// The parameter within cell i where the cumulated steps reach s: cubic Hermite interpolation of the inverse.
double inverse(const StepTable& table, std::size_t i, double s) {
  const double rise = table.steps[i + 1] - table.steps[i];
  const double t = (s - table.steps[i]) / rise;
  const double m0 = rise / table.density[i];
  const double m1 = rise / table.density[i + 1];
  const double width = table.u[i + 1] - table.u[i];
  return table.u[i] + t * (m0 + t * (3.0 * width - 2.0 * m0 - m1 + t * (m0 + m1 - 2.0 * width)));
}

}  // namespace

std::vector<double> resampleParameters(const FittedLine& line, const ResampleOptions& options) {
  validate(options, "resample");
  if (!(line.begin < line.end)) {
    throw InputError("fitted line of row " + std::to_string(line.row), "end", std::to_string(line.end),
                     "after its begin " + std::to_string(line.begin));
  }
  const StepTable table = tabulate(LineTable(line, Frame::Identity()), options);
  const double total = table.steps.back();
  constexpr double rounding = 1e-6;  // a length that is a multiple of the spacing but for rounding is one
  const auto count = static_cast<std::size_t>(std::max(1.0, std::ceil(total - rounding)));
  std::vector<double> parameters(count + 1);
  std::size_t cell = 0;
  for (std::size_t k = 1; k < count; ++k) {
    const double s = total * static_cast<double>(k) / static_cast<double>(count);
    while (cell + 2 < table.steps.size() && table.steps[cell + 1] < s) ++cell;
    parameters[k] = inverse(table, cell, s);
  }
  parameters.front() = line.begin;
  parameters.back() = line.end;
  return parameters;
}

}  // namespace scan_to_path::scan
