// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/cell.h"

#include <algorithm>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/quote.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path::pipeline {
namespace {

namespace fs = std::filesystem;

Frame mounted(const MountOptions& mount, const std::string& name, const std::string& parent) {
  if (mount.parent != parent) {
    throw InputError("cell." + name, "parent", inQuotes(mount.parent), "'" + parent + "'");
  }
  return mount.frame();
}

void checkFrameNames(const robot::Robot& robot) {
  for (const char* frame : {"sensor", "tcp", "workpiece"}) {
    if (std::find(robot.link_names.begin(), robot.link_names.end(), frame) != robot.link_names.end()) {
      throw InputError("robot " + robot.name + ": has a link called '" + frame +
                       "', which is the name of the cell's own frame; rename the link");
    }
  }
}

/// A package is known by its directory's name or, as a checkout may have any name, by its package.xml.
bool isPackage(const fs::path& directory, const std::string& name) {
  if (directory.filename() == name) return true;
  const fs::path manifest = directory / "package.xml";
  return fs::exists(manifest) && readFile(manifest).find("<name>" + name + "</name>") != std::string::npos;
}

}  // namespace

fs::path resolveFile(const std::string& address, const std::vector<fs::path>& package_path) {
  const std::string scheme = "package://";
  if (address.compare(0, scheme.size(), scheme) != 0) return address;
  const auto slash = address.find('/', scheme.size());
  const std::string package = address.substr(scheme.size(), slash - scheme.size());
  const std::string file = slash == std::string::npos ? "" : address.substr(slash + 1);
  for (const auto& directory : package_path) {
    for (const auto& candidate : {directory / package, directory}) {
      if (isPackage(candidate, package) && fs::exists(candidate / file)) return candidate / file;
    }
  }
  throw InputError("cannot find " + address + ": no package '" + package + "' with this file on the package path");
}

Cell makeCell(const CellOptions& options, const std::vector<fs::path>& package_path) {
  validate(options, "cell");
  sensing::validateLaser(options.laser);
  robot::Robot robot = robot::readRobot(resolveFile(options.robot, package_path), options.base_link, options.tip_link);
  robot.coupled_axis = robot::coupledAxis(options.axis_coupling, robot);
  checkFrameNames(robot);
  return Cell{robot,
              robot::Encoders(options.encoders, robot),
              options.laser,
              mounted(options.sensor, "sensor", options.tip_link),
              mounted(options.tool, "tool", options.tip_link),
              mounted(options.workpiece, "workpiece", options.base_link),
              options.encoders};
}

}  // namespace scan_to_path::pipeline
