// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "scan_to_path/pipeline/cell.h"
#include "scan_to_path/scan/sample_log.h"

namespace scan_to_path_ros {

/// What a robot and its sensor said during a scan, in the units of messages; times count from the recording's start.
struct Recording {
  std::vector<std::string> joint_names;
  std::vector<std::int64_t> joint_time;                  ///< [ns], rising
  std::vector<scan_to_path::robot::JointVector> angles;  ///< [rad]
  std::vector<std::int64_t> sensor_time;                 ///< [ns], rising
  std::vector<double> range;                             ///< [m]; +Inf no return, -Inf too near, NaN fault (REP 117)
};

/// A sample log's counts and voltages as the cell's encoders and laser mean them.
Recording recordingFromLog(const scan_to_path::scan::SampleLog& log, const scan_to_path::pipeline::Cell& cell);

/// The one scan in a bag: `scan_samples` of `sensor_frame` and the `joint_states` around them, whatever their
/// namespace. Replayed it gives the scan cloud of the live run. Throws InputError for a file that is no whole bag
/// (one that was not closed, too), without samples or joint states, with those of several robots or several scans,
/// for messages that were lost or came out of order, numbers of joints that differ, samples of another frame.
Recording recordingFromBag(const std::filesystem::path& file, const std::string& sensor_frame);

}  // namespace scan_to_path_ros
