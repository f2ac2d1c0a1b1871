// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/motion/trajectory.h"

#include <gmock/gmock.h>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/random.h"

namespace scan_to_path::motion {
namespace {

Trajectory randomTrajectory(int points) {
  Random random(1);
  Trajectory trajectory;
  trajectory.joint_names = {"joint_1", "joint_2", "joint_3", "joint_4", "joint_5", "joint_6"};
  double time = 0.0;
  for (int i = 0; i < points; ++i) {
    JointVector q(6);
    for (double& angle : q) angle = random.uniform(-7, 7);
    trajectory.points.push_back({time, i / 10, i % 10, q});
    time += random.uniform(2e-6, 0.1);
  }
  return trajectory;
}

TEST(FormatTrajectory, HasFixedDigits) {
  Trajectory trajectory;
  trajectory.joint_names = {"a", "b"};
  trajectory.points.push_back({0.0, 0, 0, JointVector::Zero(2)});
  trajectory.points.push_back({1.0 / 3.0, 2, 17, JointVector::Constant(2, -1e-12)});
  EXPECT_EQ(formatTrajectory(trajectory),
            "t,segment,index,a,b\n0.000000,0,0,0.000000000,0.000000000\n"
            "0.333333,2,17,0.000000000,0.000000000\n");
}

TEST(FormatTrajectory, RoundTripIsExactToItsDigits) {
  const Trajectory trajectory = randomTrajectory(500);
  const std::string text = formatTrajectory(trajectory);
  const Trajectory parsed = parseTrajectory(text, "trajectory.csv");
  ASSERT_EQ(parsed.points.size(), trajectory.points.size());
  EXPECT_EQ(parsed.joint_names, trajectory.joint_names);
  for (std::size_t i = 0; i < parsed.points.size(); ++i) {
    EXPECT_NEAR(parsed.points[i].time, trajectory.points[i].time, 0.5e-6 + 1e-12);
    EXPECT_EQ(parsed.points[i].segment, trajectory.points[i].segment);
    EXPECT_EQ(parsed.points[i].index, trajectory.points[i].index);
    EXPECT_LT((parsed.points[i].q - trajectory.points[i].q).cwiseAbs().maxCoeff(), 0.5e-9 + 1e-14);
  }
  EXPECT_EQ(formatTrajectory(parsed), text);
}

TEST(FormatPulses, AreWithinHalfACount) {
  const Trajectory trajectory = randomTrajectory(500);
  robot::EncoderOptions options;
  options.offset = {0.1, -0.2, 0.3, -0.4, 0.5, -0.6};
  options.sign = {1, -1, 1, -1, 1, -1};
  robot::Robot robot;
  robot.joints.resize(6);
  const robot::Encoders encoders(options, robot);
  const std::string text = formatPulses(trajectory, encoders);
  EXPECT_EQ(text.find('.', text.find('.') + 7), text.find('.', text.find('\n', text.find('.'))));  // only times
  const Trajectory parsed = parsePulses(text, "pulses.csv", encoders);
  const double half_count = 0.5 * 2.0 * M_PI / (131072.0 * 100.0);
  for (std::size_t i = 0; i < parsed.points.size(); ++i) {
    EXPECT_LT((parsed.points[i].q - trajectory.points[i].q).cwiseAbs().maxCoeff(), half_count * (1 + 1e-6));
  }
}

TEST(ParseTrajectory, NamesTheLineAndWhatIsWrong) {
  const auto complaint = [](const std::string& text) -> std::string {
    try {
      parseTrajectory(text, "t.csv");
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  using testing::AllOf;
  using testing::HasSubstr;
  const std::string header = "t,segment,index,a\n";
  EXPECT_EQ(complaint(header + "0,0,0,1\n1,0,1,2\n"), "accepted");
  EXPECT_EQ(complaint(header), "accepted");
  EXPECT_THAT(complaint(""), HasSubstr("t.csv line 1: header"));
  EXPECT_THAT(complaint("t,segment,index\n"), HasSubstr("header"));
  EXPECT_THAT(complaint("t,segment,index,1,2,3,4,5,6,7,8,9\n"), HasSubstr("header"));
  EXPECT_THAT(complaint(header + "0,0,0\n"), AllOf(HasSubstr("line 2"), HasSubstr("cells")));
  EXPECT_THAT(complaint(header + "0,0,0,1\n0,0,1,1\n"), AllOf(HasSubstr("line 3"), HasSubstr("t is")));
  EXPECT_THAT(complaint(header + "0,0,0,nan\n"), AllOf(HasSubstr("line 2"), HasSubstr("a is 'nan'")));
  EXPECT_THAT(complaint(header + "0,-1,0,1\n"), HasSubstr("segment"));
  EXPECT_THAT(complaint(header + "0,0,1.5,1\n"), HasSubstr("index"));
  EXPECT_THAT(complaint(header + "0,0,1e300,1\n"), HasSubstr("index"));
  EXPECT_THAT(complaint(header + "\n\n"), HasSubstr("line 2"));
}

}  // namespace
}  // namespace scan_to_path::motion
