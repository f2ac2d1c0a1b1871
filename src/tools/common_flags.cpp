// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "common_flags.h"

#include <cstdlib>

#include "scan_to_path/common/text.h"
#include "scan_to_path/pipeline/configuration.h"

namespace scan_to_path::tools {
namespace {

namespace fs = std::filesystem;

/// Six numbers: x y z [m], roll pitch yaw [rad].
void parsePose(const std::string& text, pipeline::MountOptions& mount) {
  std::vector<double> numbers;
  for (const auto word : split(trimmed(text), ' ')) {
    double number = 0.0;
    if (word.empty()) continue;
    if (!parseNumber(word, number)) break;
    numbers.push_back(number);
  }
  if (numbers.size() != 6)
    throw InputError("--workpiece-pose", "value", "'" + text + "'", "'x y z roll pitch yaw' in m and rad");
  mount.xyz = {numbers[0], numbers[1], numbers[2]};
  mount.rpy = {numbers[3], numbers[4], numbers[5]};
}

/// Where this package's files lie: beside the installed executable, or in the source tree it was built from.
fs::path ownPackage() {
  std::error_code error;
  const fs::path executable = fs::read_symlink("/proc/self/exe", error);
  for (const char* relative : {"../share/scan_to_path", "../../share/scan_to_path"}) {
    const fs::path candidate = (executable.parent_path() / relative).lexically_normal();
    if (!error && fs::exists(candidate / "urdf")) return candidate;
  }
  return SCAN_TO_PATH_SOURCE_DIR;
}

}  // namespace

void CommonFlags::addTo(CLI::App& command) {
  command.add_option("--config", config, "YAML file; what it does not say keeps its default (see --print-config)")
      ->type_name("FILE");
  command.add_option("--set", assignments, "one configuration value, e.g. --set path.lead=0.1 (repeatable)")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  command.add_flag("--print-config", print_config, "print the whole configuration with units and end");
  command.add_option("--robot", robot, "the arm, instead of the shipped ABB IRB 2400/16")->type_name("URDF");
  command
      .add_option("--package-path", package_path,
                  "directories in which package:// addresses are looked up (repeatable)")
      ->type_name("DIR")
      ->allow_extra_args(false);
  command
      .add_option("--workpiece-pose", workpiece_pose,
                  "of the workpiece in base_link: 'x y z roll pitch yaw' in m and rad")
      ->type_name("POSE");
  command.add_option("--threads", threads, "0: all cores")->check(CLI::Range(0, 1024))->capture_default_str();
  command.add_flag("--quiet", quiet, "no progress, no summary; errors only");
}

pipeline::JobOptions CommonFlags::options(pipeline::JobOptions defaults, std::set<std::string>* given) const {
  pipeline::JobOptions options = std::move(defaults);
  const auto fields = pipeline::fieldReferences(options);
  std::set<std::string> set;
  if (!config.empty()) set = pipeline::applyYamlFile(fields, config);
  for (const auto& assignment : assignments) set.insert(pipeline::applyAssignment(fields, assignment));
  if (given != nullptr) *given = set;
  if (!robot.empty()) options.cell.robot = robot;
  if (!workpiece_pose.empty()) parsePose(workpiece_pose, options.cell.workpiece);
  return options;
}

std::vector<fs::path> CommonFlags::packagePath() const {
  std::vector<fs::path> path = package_path;
  if (const char* ros = std::getenv("ROS_PACKAGE_PATH")) {
    for (const auto part : split(ros, ':')) {
      if (!part.empty()) path.emplace_back(std::string(part));
    }
  }
  path.push_back(ownPackage());
  return path;
}

}  // namespace scan_to_path::tools
