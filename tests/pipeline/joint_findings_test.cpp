// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/joint_findings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/irb2400.h"

namespace scan_to_path::pipeline {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

sensing::PlacedScan hiding(double distance) {
  sensing::PlacedScan scan;
  scan.unseen_jumps.angle = distance / 0.8;
  scan.unseen_jumps.distance = distance;
  scan.unseen_jumps.joint = 1;
  scan.unseen_jumps.time = 12.5;
  return scan;
}

TEST(JointFindings, OfEvenReadingsAreNone) {
  const JointFindings found = jointFindings(sensing::PlacedScan(), test::irb2400(), {});
  ASSERT_EQ(found.accuracy.size(), 1U);
  EXPECT_EQ(found.accuracy[0].name, "unseen_joint_jump");
  EXPECT_EQ(found.accuracy[0].value, 0.0);
  EXPECT_TRUE(found.accuracy[0].pass());
  EXPECT_THAT(found.notes, IsEmpty());
}

TEST(JointFindings, NoteWhatCouldHideAndFailAboveTheLimit) {
  const auto robot = test::irb2400();
  EXPECT_THAT(jointFindings(hiding(0.9e-4), robot, {}).notes, IsEmpty());
  const JointFindings noted = jointFindings(hiding(4e-4), robot, {});
  EXPECT_THAT(noted.notes,
              ElementsAre(HasSubstr("a jump of joint_2 by up to 0.000500 rad, 0.40 mm at the sensor, would "
                                    "look like its motion at 12.500 s")));
  EXPECT_TRUE(noted.accuracy[0].pass());
  EXPECT_FALSE(jointFindings(hiding(1.1e-3), robot, {}).accuracy[0].pass());
  ReportOptions any;
  any.max_unseen_jump = 0.0;
  EXPECT_TRUE(jointFindings(hiding(1.1e-3), robot, any).accuracy[0].pass());
}

TEST(JointFindings, NotePausesAndRepeatedReadings) {
  sensing::PlacedScan scan;
  scan.unseen_jumps.pauses = 3;
  scan.times_repeated = 4;
  EXPECT_THAT(jointFindings(scan, test::irb2400(), {}).notes,
              ElementsAre(HasSubstr("move unseen in 3 pauses"), HasSubstr("each joint reading 4 times")));
}

}  // namespace
}  // namespace scan_to_path::pipeline
