// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path_ros/parameters.h"

#include <ros/master.h>
#include <ros/package.h>

#include <cstdio>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"
#include "scan_to_path/pipeline/configuration.h"

namespace scan_to_path_ros {
namespace {

using scan_to_path::InputError;
using XmlRpc::XmlRpcValue;

constexpr const char* cell_parameter = "configuration";
constexpr const char* job_parameter = "job";
constexpr const char* bag_parameter = "job_bag";

std::string quoted(const std::string& text) {
  std::string yaml = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') yaml += '\\';
    if (c == '\n') {
      yaml += "\\n";
    } else {
      yaml += c;
    }
  }
  return yaml + "\"";
}

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

/// Elements between brackets, separated by commas.
template <class Values, class Write>
std::string flow(char open, const Values& values, char close, Write write) {
  std::string yaml(1, open);
  for (const auto& value : values) yaml += (yaml.size() > 1 ? ", " : "") + write(value);
  return yaml + close;
}

void apply(scan_to_path::pipeline::JobOptions& options, const ros::NodeHandle& nodes, const std::string& parameter) {
  XmlRpcValue tree;
  if (nodes.getParam(parameter, tree)) applyParameter(options, tree, nodes.resolveName(parameter));
}

}  // namespace

std::string toYaml(const XmlRpcValue& value) {
  XmlRpcValue copy = value;  // XmlRpcValue has no const access
  switch (copy.getType()) {
    case XmlRpcValue::TypeBoolean:
      return static_cast<bool>(copy) ? "true" : "false";
    case XmlRpcValue::TypeInt:
      return std::to_string(static_cast<int>(copy));
    case XmlRpcValue::TypeDouble:
      return number(static_cast<double>(copy));
    case XmlRpcValue::TypeString:
      return quoted(static_cast<std::string>(copy));
    case XmlRpcValue::TypeArray: {
      std::vector<XmlRpcValue> elements;
      for (int i = 0; i < copy.size(); ++i) elements.push_back(copy[i]);
      return flow('[', elements, ']', [](const XmlRpcValue& element) { return toYaml(element); });
    }
    case XmlRpcValue::TypeStruct:
      return flow('{', copy, '}', [](const auto& entry) { return quoted(entry.first) + ": " + toYaml(entry.second); });
    default:
      throw InputError("a parameter is of a type that no configuration has (binary, date or nothing)");
  }
}

void applyParameter(scan_to_path::pipeline::JobOptions& options, const XmlRpcValue& tree, const std::string& name) {
  XmlRpcValue copy = tree;
  const bool is_text = copy.getType() == XmlRpcValue::TypeString;
  scan_to_path::pipeline::applyYaml(scan_to_path::pipeline::fieldReferences(options),
                                    is_text ? static_cast<std::string>(copy) : toYaml(tree), "parameter " + name);
}

void checkMaster() {
  if (!ros::master::check()) throw InputError("no ROS master at " + ros::master::getURI());
}

scan_to_path::pipeline::JobOptions readJobOptions(const ros::NodeHandle& nodes) {
  checkMaster();  // without it every parameter looks as if it were not set
  scan_to_path::pipeline::JobOptions options;
  apply(options, nodes, cell_parameter);
  apply(options, nodes, job_parameter);
  return options;
}

void setJob(const ros::NodeHandle& nodes, const std::string& yaml, const std::string& bag) {
  scan_to_path::pipeline::JobOptions options = readJobOptions(nodes);
  scan_to_path::pipeline::applyYaml(scan_to_path::pipeline::fieldReferences(options), yaml, "the job's configuration");
  nodes.setParam(job_parameter, yaml);
  nodes.setParam(bag_parameter, bag);
}

void clearJob(const ros::NodeHandle& nodes) {
  nodes.deleteParam(job_parameter);
  nodes.deleteParam(bag_parameter);
}

std::string jobBag(const ros::NodeHandle& nodes) {
  std::string bag;
  nodes.getParam(bag_parameter, bag);
  return bag;
}

std::vector<std::filesystem::path> packagePath() {
  std::vector<std::filesystem::path> directories;
  const std::string own = ros::package::getPath("scan_to_path");
  if (!own.empty()) directories.emplace_back(own);
  const char* path = std::getenv("ROS_PACKAGE_PATH");
  const std::string list = path == nullptr ? "" : path;
  for (const auto directory : scan_to_path::split(list, ':')) {
    if (!directory.empty()) directories.emplace_back(directory);
  }
  return directories;
}

}  // namespace scan_to_path_ros
