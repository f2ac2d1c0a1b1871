// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "tools/run_job/play_back.h"

#include <ros/callback_queue.h>
#include <ros/service.h>
#include <scan_to_path/PlaybackDeviation.h>
#include <std_srvs/Trigger.h>

#include <cstdio>

#include "scan_to_path/common/angles.h"
#include "scan_to_path/common/error.h"

namespace scan_to_path::tools {
namespace {

constexpr double silence = 10.0;  // [s]; the player reports every second

void call(const std::string& service) {
  std_srvs::Trigger trigger;
  if (!ros::service::call(service, trigger)) throw InputError(service + ": nobody answers; is its nodelet running?");
  if (trigger.response.success == 0) throw InputError(service + ": " + trigger.response.message);
}

std::string line(const PlaybackDeviation& off) {
  char text[200];
  std::snprintf(text, sizeof text, "played back: %zu waypoints, tool off the path by %.4f um and %.6f deg at most%s",
                static_cast<std::size_t>(off.waypoints), 1e6 * off.position_largest,
                degrees_per_radian * off.angle_largest,
                off.missing > 0 ? (", " + std::to_string(off.missing) + " not seen").c_str() : "");
  return text;
}

}  // namespace

std::string playBack(const ros::NodeHandle& nodes, const std::string& cell,
                     const std::function<bool()>& is_interrupted) {
  ros::CallbackQueue queue;
  ros::NodeHandle own(nodes);
  own.setCallbackQueue(&queue);
  PlaybackDeviationConstPtr last;
  ros::WallTime heard = ros::WallTime::now();
  const auto subscriber =
      own.subscribe<PlaybackDeviation>(cell + "playback_deviation", 10, [&](const PlaybackDeviationConstPtr& msg) {
        heard = ros::WallTime::now();
        if (msg->finished == 0 || last) last = msg;  // not what an earlier playback left
      });
  while (subscriber.getNumPublishers() == 0 && (ros::WallTime::now() - heard).toSec() < silence)
    ros::WallDuration(0.01).sleep();
  call(own.resolveName(cell + "trajectory_player/start"));
  while (!last || last->finished == 0) {
    queue.callAvailable(ros::WallDuration(0.05));
    if (is_interrupted()) {
      call(own.resolveName(cell + "trajectory_player/stop"));
      throw Interrupted();
    }
    if ((ros::WallTime::now() - heard).toSec() > silence) {
      throw InputError("the player reports nothing: no planned path to compare with");
    }
  }
  return line(*last);
}

}  // namespace scan_to_path::tools
