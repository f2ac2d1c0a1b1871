// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/joint_findings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace scan_to_path::pipeline {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

sensing::UnseenJumps hiding(double distance) {
  sensing::UnseenJumps unseen;
  unseen.distance = distance;
  unseen.what = "joint_2 by up to 0.000500 rad";
  unseen.time = 12.5;
  return unseen;
}

TEST(JointFindings, OfEvenReadingsAreNone) {
  const JointFindings found = jointFindings({}, 1, {});
  ASSERT_EQ(found.accuracy.size(), 2U);
  EXPECT_EQ(found.accuracy[0].name, "unseen_joint_jump");
  EXPECT_EQ(found.accuracy[0].value, 0.0);
  EXPECT_TRUE(found.accuracy[0].pass());
  EXPECT_EQ(found.accuracy[1].name, "unseen_pauses");
  EXPECT_TRUE(found.accuracy[1].pass());
  EXPECT_THAT(found.notes, IsEmpty());
}

TEST(JointFindings, NoteWhatCouldHideAndFailAboveTheLimit) {
  EXPECT_THAT(jointFindings(hiding(4.9e-4), 1, {}).notes, IsEmpty());
  const JointFindings noted = jointFindings(hiding(6e-4), 1, {});
  EXPECT_THAT(noted.notes,
              ElementsAre(HasSubstr("a jump of joint_2 by up to 0.000500 rad, 0.60 mm at the sensor, would "
                                    "look like motion at 12.500 s")));
  EXPECT_TRUE(noted.accuracy[0].pass());
  EXPECT_FALSE(jointFindings(hiding(1.1e-3), 1, {}).accuracy[0].pass());
  ReportOptions any;
  any.max_unseen_jump = 0.0;
  EXPECT_TRUE(jointFindings(hiding(1.1e-3), 1, any).accuracy[0].pass());
}

TEST(JointFindings, NotePausesAndRepeatedReadings) {
  sensing::UnseenJumps unseen;
  unseen.pauses = 3;
  EXPECT_FALSE(jointFindings(unseen, 4, {}).accuracy[1].pass());
  ReportOptions three;
  three.max_unseen_pauses = 3;
  EXPECT_TRUE(jointFindings(unseen, 4, three).accuracy[1].pass());
  EXPECT_THAT(jointFindings(unseen, 4, {}).notes,
              ElementsAre(HasSubstr("moves unseen in 3 pauses"), HasSubstr("each joint reading 4 times")));
}

}  // namespace
}  // namespace scan_to_path::pipeline
