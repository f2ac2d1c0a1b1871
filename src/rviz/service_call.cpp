// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "rviz/service_call.h"

#include <ros/service.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <chrono>

namespace scan_to_path_rviz {

template <class Service>
void ServiceCall::start(const std::string& name, const Service& service) {
  if (running()) return;
  answer_ = std::async(std::launch::async, [name, called = service]() mutable -> std::string {
    if (!ros::service::exists(name, false)) return name + " is not there; is its nodelet running?";
    if (!ros::service::call(name, called)) return name + " did not answer";
    return called.response.success != 0 ? "" : name + ": " + called.response.message;
  });
}

void ServiceCall::start(const std::string& name) { start(name, std_srvs::Trigger()); }

void ServiceCall::start(const std::string& name, bool data) {
  std_srvs::SetBool service;
  service.request.data = static_cast<std::uint8_t>(data);
  start(name, service);
}

std::optional<std::string> ServiceCall::takeAnswer() {
  if (!running() || answer_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return std::nullopt;
  return answer_.get();
}

}  // namespace scan_to_path_rviz
