// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ros/node_handle.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include <filesystem>
#include <string>
#include <vector>

#include "scan_to_path/pipeline/job_options.h"

/// The configuration of a job as ROS parameters: the tree that a configuration file has, under `configuration`, and
/// under `job` what the job under way lays over it. Both are relative names: two cells keep apart by their namespace.
namespace scan_to_path_ros {

/// The parameters as the YAML a configuration file would have, to be read by the one reader there is.
/// Throws InputError for a type that YAML does not know (binary, date).
std::string toYaml(const XmlRpc::XmlRpcValue& value);

/// Overwrites the options that a parameter names: a tree, or a text in YAML. Throws InputError as a configuration
/// file's reader does, naming the parameter.
void applyParameter(scan_to_path::pipeline::JobOptions& options, const XmlRpc::XmlRpcValue& tree,
                    const std::string& name);

/// Throws InputError when no master answers.
void checkMaster();

/// Options from the defaults, `configuration` and `job`. Throws InputError as a configuration file's reader does,
/// naming the parameter, and when no master answers.
scan_to_path::pipeline::JobOptions readJobOptions(const ros::NodeHandle& nodes);

/// Lays a YAML text over the cell's configuration until clearJob; an empty text lays nothing. With a bag the job's
/// scan is that recording. Throws InputError, and changes nothing, when the text is not a configuration.
void setJob(const ros::NodeHandle& nodes, const std::string& yaml, const std::string& bag = "");
void clearJob(const ros::NodeHandle& nodes);

/// The recording that is the scan of the job under way; empty: it is a scan.
std::string jobBag(const ros::NodeHandle& nodes);

/// A parameter's value; its default, which it then has for everybody to see, when it is not set.
template <class Value>
Value parameter(const ros::NodeHandle& nodes, const std::string& name, const Value& otherwise) {
  Value value = otherwise;
  if (!nodes.getParam(name, value)) nodes.setParam(name, otherwise);
  return value;
}

/// Where package:// addresses are looked up: ROS_PACKAGE_PATH.
std::vector<std::filesystem::path> packagePath();

}  // namespace scan_to_path_ros
