// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ros/node_handle.h>

#include <functional>
#include <string>

namespace scan_to_path::tools {

/// Has the cell's trajectory_player in namespace `cell` play the trajectory it has, and waits for its end. Gives a line
/// with the largest deviations. Throws InputError when it refuses, is not there, or says nothing for 10 s; Interrupted
/// as soon as `is_interrupted` says so, and the player is stopped.
std::string playBack(const ros::NodeHandle& nodes, const std::string& cell,
                     const std::function<bool()>& is_interrupted);

}  // namespace scan_to_path::tools
