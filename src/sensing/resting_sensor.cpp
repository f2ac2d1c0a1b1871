// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/sensing/resting_sensor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/median.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path::sensing {
namespace {

constexpr std::size_t fewest_differences = 1000;  // from which a scale is told
constexpr double least_noise = 1e-5;              // of the output's range: a third of a laser's repeatability

/// Equal voltages on end, all within the measuring range.
struct VoltageRun {
  std::size_t first = 0;
  std::size_t count = 0;
};

/// Nearly every log ends here, without a list of its runs.
bool hasLongRun(const std::vector<double>& voltage, std::size_t longest) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < voltage.size(); ++i) {
    count = i > 0 && voltage[i] == voltage[i - 1] ? count + 1 : 1;
    if (count > longest) return true;
  }
  return false;
}

std::vector<VoltageRun> equalVoltages(const std::vector<double>& voltage, const PointLaserOptions& laser) {
  std::vector<VoltageRun> runs;
  for (std::size_t i = 0, end = 0; i < voltage.size(); i = end) {
    end = i + 1;
    if (!distanceFromVoltage(laser, voltage[i])) continue;
    while (end < voltage.size() && voltage[end] == voltage[i]) ++end;
    runs.push_back({i, end - i});
  }
  return runs;
}

/// The voltages of all runs up to `longest`, NaN where others lie between them.
std::vector<double> withoutLongRuns(const std::vector<double>& voltage, const std::vector<VoltageRun>& runs,
                                    std::size_t longest) {
  std::vector<double> kept;
  std::size_t end = 0;
  for (const auto& run : runs) {
    if (run.first != end || run.count > longest) kept.push_back(std::numeric_limits<double>::quiet_NaN());
    if (run.count <= longest) kept.insert(kept.end(), run.count, voltage[run.first]);
    end = run.first + run.count;
  }
  return kept;
}

struct VoltageNoise {
  double sigma = 0.0;  ///< [V], by third differences, which a surface hardly has from sample to sample
  double step = 0.0;   ///< between neighbouring voltages [V]
};

/// Both 0 where there is too little to tell.
VoltageNoise noiseOf(const std::vector<double>& voltage) {
  std::vector<double> thirds, steps;
  for (std::size_t i = 3; i < voltage.size(); ++i) {
    const double* v = &voltage[i - 3];
    const double third = std::abs(v[3] - 3.0 * v[2] + 3.0 * v[1] - v[0]);
    if (!std::isfinite(third)) continue;
    thirds.push_back(third);
    if (v[3] != v[2]) steps.push_back(std::abs(v[3] - v[2]));
  }
  if (thirds.size() < fewest_differences || steps.empty()) return {};
  // One in a hundred of all steps is smaller: a few odd voltages are no steps.
  const auto small = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 100);
  std::nth_element(steps.begin(), small, steps.end());
  return {median(std::move(thirds)) / (0.6745 * std::sqrt(20.0)), *small};
}

/// A sensor slower than the log repeats every value as it is.
std::size_t usualRun(const std::vector<VoltageRun>& runs) {
  std::vector<double> counts;
  for (const auto& run : runs) counts.push_back(static_cast<double>(run.count));
  return static_cast<std::size_t>(median(std::move(counts)));
}

/// A dead sensor has no noise to tell it from a plate by; but no plate lies so level that nothing ever changes.
void checkThatVoltageChanges(const std::vector<VoltageRun>& runs, const scan::SampleLog& log) {
  const double only = log.voltage[runs.front().first];
  std::size_t count = 0;
  for (const auto& run : runs) {
    if (log.voltage[run.first] != only) return;
    count += run.count;
  }
  if (count < fewest_differences) return;
  throw InputError("sample log: all " + std::to_string(count) + " samples that measure say " + fixed(only, 6) +
                   " V: a sensor that is off, not connected or holds a value (cell.laser.max_repeats=0 takes it for a "
                   "plate)");
}

}  // namespace

void checkRestingSensor(const scan::SampleLog& log, const PointLaserOptions& laser) {
  const auto max_repeats = static_cast<std::size_t>(laser.max_repeats);
  if (max_repeats == 0 || !hasLongRun(log.voltage, max_repeats)) return;
  const auto runs = equalVoltages(log.voltage, laser);
  if (runs.empty()) return;
  checkThatVoltageChanges(runs, log);
  const std::size_t longest = max_repeats * usualRun(runs);
  const auto rest = std::find_if(runs.begin(), runs.end(), [&](const auto& run) { return run.count > longest; });
  if (rest == runs.end()) return;
  const VoltageNoise noise = noiseOf(withoutLongRuns(log.voltage, runs, longest));
  const double span = std::abs(laser.voltage_max - laser.voltage_min);
  if (!(noise.sigma >= std::max(noise.step, least_noise * span))) return;
  throw InputError("sample " + std::to_string(rest->first) + " at " + fixed(log.sensor_time[rest->first], 6) +
                   " s: the sensor rests at " + fixed(log.voltage[rest->first], 6) + " V for " +
                   std::to_string(rest->count) + " samples, in a log with a noise of " + fixed(1e3 * noise.sigma, 3) +
                   " mV (limit " + std::to_string(longest) +
                   ", cell.laser.max_repeats): an output that saturates, which a larger cell.laser.voltage_margin "
                   "takes for no return, or a sensor that holds its last value");
}

}  // namespace scan_to_path::sensing
