// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "rviz/service_call.h"

#include <ros/service.h>
#include <std_srvs/Trigger.h>

#include <chrono>

namespace scan_to_path_rviz {

void ServiceCall::start(const std::string& name) {
  if (running()) return;
  answer_ = std::async(std::launch::async, [name]() -> std::string {
    std_srvs::Trigger trigger;
    if (!ros::service::exists(name, false)) return name + " is not there; is its nodelet running?";
    if (!ros::service::call(name, trigger)) return name + " did not answer";
    return trigger.response.success != 0 ? "" : name + ": " + trigger.response.message;
  });
}

std::optional<std::string> ServiceCall::takeAnswer() {
  if (!running() || answer_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return std::nullopt;
  return answer_.get();
}

}  // namespace scan_to_path_rviz
