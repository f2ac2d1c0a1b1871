// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path_ros/review.h"

#include <chrono>

namespace scan_to_path_ros {
namespace {

constexpr auto look_period = std::chrono::milliseconds(50);  // for a cancel

}  // namespace

Review::Review(ros::NodeHandle own) : service_(own.advertiseService("accept", &Review::answer, this)) {}

bool Review::wait(const scan_to_path::Progress& progress) {
  std::unique_lock<std::mutex> lock(mutex_);
  answer_.reset();
  waiting_ = true;
  try {
    do {
      progress.update("review", 0.0);
    } while (!answered_.wait_for(lock, look_period, [this] { return answer_.has_value(); }));
  } catch (...) {
    waiting_ = false;
    throw;
  }
  waiting_ = false;
  return *answer_;
}

bool Review::answer(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response) {
  const std::lock_guard<std::mutex> lock(mutex_);
  response.success = waiting_ && !answer_ ? 1 : 0;
  if (response.success != 0) {
    answer_ = request.data != 0;
    answered_.notify_all();
  } else {
    response.message = "no job waits to be accepted or rejected";
  }
  return true;
}

}  // namespace scan_to_path_ros
