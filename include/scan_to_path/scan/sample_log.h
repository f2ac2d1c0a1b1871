// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace scan_to_path::scan {

/// What the robot and the sensor said, each on its own clock ticks; nothing is interpolated yet.
struct SampleLog {
  std::vector<std::string> joint_names;
  std::vector<double> joint_time;   ///< [s], strictly rising
  std::vector<double> counts;       ///< encoder counts, joint_time.size() rows of joint_names.size()
  std::vector<double> sensor_time;  ///< [s], strictly rising
  std::vector<double> voltage;      ///< [V]; NaN: the sensor reported a fault
};

/// Parses samples.csv (first line `# scan_to_path samples 1`, header `t,<joints…>,voltage`, empty cells where a
/// channel has no sample at that time). `name` stands in messages. Throws InputError with the line number for
/// anything that is not a sample log, time not strictly rising, infinite or NaN counts, a row with some joints only.
/// A voltage of `nan` is a sensor fault and kept; an infinite one is an error.
SampleLog parseSampleLog(std::string_view text, const std::string& name);
SampleLog readSampleLog(const std::filesystem::path& file);

/// The text of the log. Round trip: parseSampleLog(formatSampleLog(log)) equals the log to 1e-6 s (times on a 1 us
/// grid are exact), 1e-6 V and 1e-3 counts.
std::string formatSampleLog(const SampleLog& log);

}  // namespace scan_to_path::scan
