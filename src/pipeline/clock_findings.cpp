// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/clock_findings.h"

#include <algorithm>
#include <cmath>

#include "scan_to_path/common/text.h"

namespace scan_to_path::pipeline {
namespace {

using sensing::Observability;

// Of the noise: of 100000 places, one in 5000 scans has one.
constexpr double sure = 6.0;

bool isFlat(const sensing::OffsetEffect& effect, const sensing::ClockOffsetOptions& options) {
  return effect.height <= std::max(options.max_effect, sure * effect.noise);
}

/// What the largest offset that may be would do.
std::string effectText(const sensing::OffsetEffect& effect, double offset, bool is_flat) {
  const std::string shift = "an offset of " + fixed(1e3 * offset, 1) + " ms moves the surface by ";
  const std::string height = fixed(1e6 * effect.height, 0) + " um in height";
  if (is_flat) return "; the part is flat along them, " + shift + "no more than " + height + ", noise included";
  const Vector3& p = effect.place;
  return ", yet " + shift + "up to " + height + " at (" + fixed(p.x(), 4) + ", " + fixed(p.y(), 4) + ", " +
         fixed(p.z(), 4) + ")";
}

/// Where the log does not tell the offset, only its user can: what is placed by an offset that nobody knows is wrong by
/// the feed of the scan times it.
ClockFindings unknownOffset(const sensing::ClockOffsetEstimate& estimate,
                            const std::optional<sensing::OffsetEffect>& effect, const ScanSection& options,
                            const ReportOptions& limits) {
  ClockFindings found;
  std::string note = "clock offset between sensor and encoders not observable: " + estimate.reason;
  const bool is_flat = effect && isFlat(*effect, options.clock_offset);
  if (effect) note += effectText(*effect, options.clock_offset.largest_offset, is_flat);
  if (!is_flat && !options.placement.clock_offset && limits.max_clock_offset > 0.0) {
    found.accuracy.push_back({"clock_offset_unknown", 1.0, "", 0.0});
    note += estimate.observability == Observability::none ? "; scan rows to and fro, state" : "; state";
    note +=
        " a calibrated one in scan.placement.clock_offset (0 where both have one clock), or take it as it is "
        "with --set report.max_clock_offset=0";
  }
  found.notes.push_back(std::move(note));
  return found;
}

}  // namespace

ClockFindings clockFindings(const sensing::ClockOffsetEstimate& estimate,
                            const std::optional<sensing::OffsetEffect>& effect, const ScanSection& options, double used,
                            const ReportOptions& limits) {
  const bool is_uncertain = estimate.observability == Observability::uncertain;
  if (estimate.observability != Observability::observable && !is_uncertain) {
    return unknownOffset(estimate, effect, options, limits);
  }
  ClockFindings found;
  const std::optional<double> limit = limitUnlessZero(limits.max_clock_offset);
  const double left = estimate.offset - used, error = estimate.standard_error;
  found.accuracy.push_back({"clock_offset", estimate.offset, "s"});
  const bool is_stated = options.placement.clock_offset.has_value();
  found.accuracy.push_back({"clock_offset_standard_error", error, "s", is_stated ? std::nullopt : limit});
  // An uncertain estimate says that there is an offset where two standard errors do not explain it.
  const double surely_left = std::max(std::abs(left) - (is_uncertain ? 2.0 * error : 0.0), 0.0);
  const Accuracy figure = {"clock_offset_left", surely_left, "s", limit};
  found.accuracy.push_back(figure);
  if (is_uncertain) found.notes.push_back("clock offset between sensor and encoders uncertain: " + estimate.reason);
  if (!figure.pass()) {
    found.notes.push_back("the sensor's clock is off the encoders' by " + fixed(1e3 * left, 3) + " ms; " +
                          (is_uncertain ? "state a calibrated offset in scan.placement.clock_offset"
                                        : "correct it with --set scan.correct_clock_offset=true"));
  }
  return found;
}

}  // namespace scan_to_path::pipeline
