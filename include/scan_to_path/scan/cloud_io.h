// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "scan_to_path/scan/scan_cloud.h"

namespace scan_to_path::scan {

/// A cloud read from a file, in file order: that is taken for the order in which it was measured.
struct CloudFile {
  ScanCloud cloud;
  std::size_t no_return = 0;  ///< points without finite coordinates, left out
  /// From where to where the sensor looked, in the cloud's frame: PCD's VIEWPOINT, from its origin to the points'
  /// mean, or along its +z when it has no origin; nothing when the file does not say.
  std::optional<geometry::Vector3> viewing_direction;
};

/// True when the content starts as a PCD file does.
bool isPcd(std::string_view content);

/// Parses PCD 0.7 (ascii, binary, binary_compressed) or PLY without faces. Fields x, y, z (float or double, [m]);
/// `line` or `ring` (integer; no_line where it is 4294967295 or negative) and `time` or `t` (float or double [s],
/// integer [ns]) when they are there; others are skipped. `name` stands in messages. Throws InputError for anything
/// else, with the line or byte, and when no point is finite. A header that promises more than the file holds is
/// refused before memory is taken.
CloudFile parseCloud(std::string_view content, const std::string& name);
CloudFile readCloud(const std::filesystem::path& file);

/// Binary PCD with x, y, z, line, time. T_cloud_sensor is written as VIEWPOINT.
std::string formatPcd(const ScanCloud& cloud, const geometry::Frame& T_cloud_sensor = geometry::Frame::Identity());

}  // namespace scan_to_path::scan
