// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "scan_to_path/common/error.h"
#include "scan_to_path/pipeline/job_options.h"

namespace scan_to_path::tools {

/// What a seed may be: what the configuration's may.
inline CLI::Range seedRange() { return CLI::Range(0, 2147483647); }

/// The default of a flag holds where it is not given: an empty text is a variable that was not set.
inline CLI::Validator notEmpty() {
  return CLI::Validator([](std::string& text) { return std::string(text.empty() ? "is empty" : ""); }, "");
}

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

  /// `defaults`, then --config, then --set, then the flags that name an option themselves. `given`, when not null, gets
  /// the paths of what --config and --set say, be it the default or not.
  pipeline::JobOptions options(pipeline::JobOptions defaults = {}, std::set<std::string>* given = nullptr) const;

  /// --package-path, then ROS_PACKAGE_PATH, then this package itself.
  std::vector<std::filesystem::path> packagePath() const;
};

}  // namespace scan_to_path::tools
