// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace scan_to_path_rviz {

/// What a person chooses of a part's rows, as typed.
struct JobChoice {
  std::string region;  ///< "x_min x_max y_min y_max" of a box, or corners "x y, x y, x y" [m]
  std::string skip_rows;
  std::string reverse_rows;
};

/// The corners of a region as typed; none of an empty text. Throws InputError for anything but numbers in fours or
/// pairs.
std::vector<Eigen::Vector2d> parseRegion(const std::string& text);

/// A job's configuration with the choice laid over it; the very text when nothing is chosen. Throws InputError for a
/// region that is none, and for a text that is no YAML with sections.
std::string withChoice(const std::string& yaml, const JobChoice& choice);

}  // namespace scan_to_path_rviz
