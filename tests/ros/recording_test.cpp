// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path_ros/recording.h"

#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <scan_to_path/ScanSamples.h>
#include <sensor_msgs/JointState.h>
#include <unistd.h>

#include <fstream>
#include <functional>
#include <limits>

#include "support/expect_input_error.h"

namespace scan_to_path_ros {
namespace {

namespace core = scan_to_path;
namespace fs = std::filesystem;

struct Messages {
  std::vector<sensor_msgs::JointState> joints;
  std::vector<core::ScanSamples> samples;
  std::string joint_topic = "/cell/joint_states";
  std::string sample_topic = "/cell/scan_samples";
};

/// A tenth of a second: joints every 5 ms, two samples in each message of 10 ms; the first has no return.
Messages messages() {
  Messages messages;
  for (int i = 0; i <= 20; ++i) {
    sensor_msgs::JointState joints;
    joints.header.stamp = ros::Time(105.0) + ros::Duration(0.005 * i);
    joints.name = {"joint_1", "joint_2"};
    joints.position = {0.01 * i, 1.0 / (i + 3)};
    messages.joints.push_back(joints);
  }
  for (int i = 0; i < 10; ++i) {
    core::ScanSamples samples;
    samples.header.frame_id = "sensor";
    samples.header.stamp = ros::Time(105.0) + ros::Duration(0.01 * i + 0.001);
    samples.time_offset = {0.0, 0.005};
    samples.range = {i == 0 ? std::numeric_limits<double>::infinity() : 0.08 + 1e-4 * i, 0.081};
    messages.samples.push_back(samples);
  }
  return messages;
}

class RecordingTest : public ::testing::Test {
protected:
  void SetUp() override {
    file_ = fs::path(::testing::TempDir()) / ("scan_to_path_" + std::to_string(::getpid()) + ".bag");
  }
  void TearDown() override { fs::remove(file_); }

  void write(const Messages& messages) const {
    rosbag::Bag bag(file_.string(), rosbag::bagmode::Write);
    for (const auto& msg : messages.joints) bag.write(messages.joint_topic, msg.header.stamp, msg);
    for (const auto& msg : messages.samples) bag.write(messages.sample_topic, msg.header.stamp, msg);
  }
  void expectRefused(const std::function<void(Messages&)>& change, const std::string& why) const {
    Messages changed = messages();
    change(changed);
    write(changed);
    core::test::expectInputError([&] { recordingFromBag(file_, "sensor"); }, why);
  }

  fs::path file_;
};

TEST_F(RecordingTest, ABagGivesBackWhatWasSaid) {
  const Messages said = messages();
  write(said);
  const Recording read = recordingFromBag(file_, "sensor");
  EXPECT_EQ(read.joint_names, said.joints[0].name);
  ASSERT_EQ(read.joint_time.size(), said.joints.size());
  for (std::size_t i = 0; i < said.joints.size(); ++i) {
    EXPECT_EQ(read.joint_time[i], 5000000 * static_cast<std::int64_t>(i));
    EXPECT_EQ(read.angles[i][1], said.joints[i].position[1]) << "to the last bit";
  }
  ASSERT_EQ(read.range.size(), 20U);
  EXPECT_EQ(read.sensor_time[3], 16000000);
  EXPECT_TRUE(std::isinf(read.range[0]));
  EXPECT_EQ(read.range[2], said.samples[1].range[0]);
}

TEST_F(RecordingTest, LeavesOutWhereTheRobotStood) {
  Messages said = messages();
  for (int i = 10; i > 0; --i) {
    auto rest = messages().joints.front();
    rest.header.stamp = ros::Time(105.0) - ros::Duration(0.5 * i);
    said.joints.insert(said.joints.end() - 21, rest);
  }
  write(said);
  const Recording read = recordingFromBag(file_, "sensor");
  // Of ten readings half a second apart the one second before the first sample, at 105.001 s, holds one.
  EXPECT_EQ(read.joint_time.size(), 22U);
  EXPECT_EQ(read.joint_time.front(), 0);
}

TEST_F(RecordingTest, RefusesWhatIsNoWholeScan) {
  expectRefused([](auto& m) { m.samples.clear(); }, "has no scan_samples");
  expectRefused([](auto& m) { m.joints.clear(); }, "has no joint_states");
  expectRefused([](auto& m) { m.joint_topic = "/cell/joints"; }, "has no joint_states");
  expectRefused([](auto& m) { m.samples[4].header.frame_id = "camera"; }, "the frame is 'camera', must be 'sensor'");
  expectRefused([](auto& m) { m.samples[4].range.pop_back(); }, "not as many");
  expectRefused([](auto& m) { m.joints[4].name[0] = "joint_9"; }, "joint state 4 is of other joints");
  expectRefused([](auto& m) { m.joints[4].position[0] = std::nan(""); }, "joint state 4 is not finite");
  expectRefused([](auto& m) { m.samples[9].header.stamp += ros::Duration(3.0); }, "nothing comes for 3");
  expectRefused(
      [](auto& m) {
        for (auto& joints : m.joints) joints.header.stamp += ros::Duration(100.0);
      },
      "do not overlap");
}

TEST_F(RecordingTest, RefusesFilesThatAreNoBagOrCutShort) {
  std::ofstream(file_) << "no bag at all";
  core::test::expectInputError([&] { recordingFromBag(file_, "sensor"); }, "not a whole bag");
  write(messages());
  fs::resize_file(file_, fs::file_size(file_) / 2);
  core::test::expectInputError([&] { recordingFromBag(file_, "sensor"); }, "not a whole bag");
  fs::remove(file_);
  core::test::expectInputError([&] { recordingFromBag(file_, "sensor"); }, file_.string());
}

}  // namespace
}  // namespace scan_to_path_ros
