// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path_ros/review.h"

#include <gtest/gtest.h>
#include <ros/ros.h>
#include <ros/service.h>

#include <atomic>
#include <future>

namespace scan_to_path_ros {
namespace {

using scan_to_path::Interrupted;
using scan_to_path::Progress;

/// What the service says to an answer.
std_srvs::SetBool::Response tell(bool is_wanted) {
  std_srvs::SetBool service;
  service.request.data = static_cast<std::uint8_t>(is_wanted);
  EXPECT_TRUE(ros::service::call("~accept", service));
  return service.response;
}

class ReviewTest : public testing::Test {
protected:
  ReviewTest() { spinner_.start(); }

  /// A job that waits, and has said so.
  std::future<bool> waiting() {
    std::promise<void> said;
    auto is_said = said.get_future();
    auto answer = std::async(std::launch::async, [this, said = std::move(said)]() mutable {
      bool first = true;
      const Progress progress(
          [&](const std::string& stage, double) {
            EXPECT_EQ(stage, "review");
            if (first) said.set_value();
            first = false;
          },
          &cancelled_);
      return review_.wait(progress);
    });
    EXPECT_EQ(is_said.wait_for(std::chrono::seconds(10)), std::future_status::ready);
    return answer;
  }

  ros::AsyncSpinner spinner_{1};
  Review review_{ros::NodeHandle("~")};
  std::atomic<bool> cancelled_{false};
};

TEST_F(ReviewTest, GivesTheAnswer) {
  for (const bool is_wanted : {true, false}) {
    auto answer = waiting();
    EXPECT_TRUE(tell(is_wanted).success);
    EXPECT_EQ(answer.get(), is_wanted);
  }
}

TEST_F(ReviewTest, RefusesAnAnswerWhileNobodyWaits) {
  EXPECT_FALSE(tell(true).success);
  EXPECT_EQ(tell(true).message, "no job waits to be accepted or rejected");
  auto answer = waiting();  // an answer of before does not count
  EXPECT_TRUE(tell(false).success);
  EXPECT_FALSE(answer.get());
  EXPECT_FALSE(tell(true).success);
}

TEST_F(ReviewTest, IsCancelled) {
  auto answer = waiting();
  cancelled_ = true;
  EXPECT_THROW(answer.get(), Interrupted);
  EXPECT_FALSE(tell(true).success);
}

}  // namespace
}  // namespace scan_to_path_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "review_test");
  return RUN_ALL_TESTS();
}
