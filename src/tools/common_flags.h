// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "scan_to_path/common/error.h"
#include "scan_to_path/geometry/surface.h"
#include "scan_to_path/pipeline/input.h"
#include "scan_to_path/pipeline/job_options.h"

namespace scan_to_path::tools {

/// The flags that all subcommands share, and what follows from them.
struct CommonFlags {
  std::string config;
  std::vector<std::string> assignments;
  bool print_config = false;
  std::string robot;
  std::vector<std::filesystem::path> package_path;
  std::string workpiece_pose;
  int threads = 0;
  bool quiet = false;

  void addTo(CLI::App& command);

  /// Default, then --config, then --set, then the flags that name an option themselves. `given`, when not null, gets
  /// the paths of what --config and --set say, be it the default or not.
  pipeline::JobOptions options(std::set<std::string>* given = nullptr) const;

  /// --package-path, then ROS_PACKAGE_PATH, then this package itself.
  std::vector<std::filesystem::path> packagePath() const;
};

/// The value of an enum flag. Throws InputError naming the choices.
template <class Enum>
Enum parseEnum(const std::string& flag, const std::string& text) {
  const auto& names = EnumNames<Enum>::names;
  std::string choices;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (text == names[i]) return static_cast<Enum>(i);
    choices += (i > 0 ? ", " : "") + std::string(names[i]);
  }
  throw InputError(flag, "value", "'" + text + "'", "one of " + choices);
}

/// A mesh file as a surface in metres, its own frame. Throws InputError, also for an implausible size when neither
/// unit nor scale was given.
struct Workpiece {
  std::shared_ptr<const geometry::Surface> surface;
  Eigen::AlignedBox3d bounds;
};
Workpiece readWorkpiece(const std::filesystem::path& file, std::optional<pipeline::Units> units,
                        std::optional<double> scale);

/// The S part of the seed, which is scanned and compared with when no file is given.
Workpiece sPart();

}  // namespace scan_to_path::tools
