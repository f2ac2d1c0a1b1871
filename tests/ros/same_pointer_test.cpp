// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <nodelet/nodelet.h>
#include <pcl_ros/point_cloud.h>
#include <ros/ros.h>

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <vector>

#include "scan_to_path/scan/scan_cloud.h"

namespace scan_to_path_ros {
namespace {

using Cloud = scan_to_path::scan::ScanCloud;

/// Publishes clouds when told to.
class Source : public nodelet::Nodelet {
public:
  void publish(const boost::shared_ptr<const Cloud>& cloud) { clouds_.publish(cloud); }
  std::uint32_t listeners() const { return clouds_.getNumSubscribers(); }

private:
  void onInit() override { clouds_ = getNodeHandle().advertise<Cloud>("clouds", 1); }
  ros::Publisher clouds_;
};

/// Keeps the cloud that came, and when.
class Sink : public nodelet::Nodelet {
public:
  /// The cloud after the one that was kept, null when none comes within a second.
  boost::shared_ptr<const Cloud> take(ros::WallTime& at) {
    std::unique_lock<std::mutex> lock(mutex_);
    came_.wait_for(lock, std::chrono::seconds(1), [this] { return cloud_ != nullptr; });
    at = at_;
    return std::move(cloud_);
  }

private:
  void onInit() override { clouds_ = getNodeHandle().subscribe("clouds", 1, &Sink::keep, this); }
  void keep(const boost::shared_ptr<const Cloud>& cloud) {
    const std::lock_guard<std::mutex> lock(mutex_);
    cloud_ = cloud;
    at_ = ros::WallTime::now();
    came_.notify_all();
  }
  ros::Subscriber clouds_;
  std::mutex mutex_;
  std::condition_variable came_;
  boost::shared_ptr<const Cloud> cloud_;
  ros::WallTime at_;
};

TEST(SamePointer, AMillionPointsPassThroughAManagerAsThePointerThatWasPublished) {
  const auto source = boost::make_shared<Source>();
  const auto sink = boost::make_shared<Sink>();
  source->init("/source", {}, {});
  sink->init("/sink", {}, {});
  const ros::WallTime limit = ros::WallTime::now() + ros::WallDuration(10.0);
  while (source->listeners() == 0 && ros::WallTime::now() < limit) ros::WallDuration(0.001).sleep();

  const auto cloud = boost::make_shared<Cloud>();
  cloud->resize(1000000);
  std::vector<double> delays;
  for (int i = 0; i < 21; ++i) {
    ros::WallTime came;
    const ros::WallTime sent = ros::WallTime::now();
    source->publish(cloud);
    const auto received = sink->take(came);
    ASSERT_EQ(received.get(), cloud.get());
    delays.push_back((came - sent).toSec());
  }
  // The median: a busy machine may hold a thread up now and then; a copy of 32 MB takes 10 ms every time.
  std::nth_element(delays.begin(), delays.begin() + 10, delays.end());
  std::printf("1,000,000 points between nodelets: %.3f ms\n", 1e3 * delays[10]);
  EXPECT_LT(delays[10], 1e-3);
}

}  // namespace
}  // namespace scan_to_path_ros

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "same_pointer_test");
  ros::AsyncSpinner spinner(2);
  spinner.start();
  ros::NodeHandle node;
  return RUN_ALL_TESTS();
}
