// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <ros/ros.h>

#include <QApplication>

int main(int argc, char** argv) {
  testing::InitGoogleMock(&argc, argv);
  ros::init(argc, argv, "rviz_test");
  const ros::NodeHandle nodes;  // keeps the node up from one test to the next
  const QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
