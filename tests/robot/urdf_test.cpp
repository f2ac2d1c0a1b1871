// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"
#include "scan_to_path/robot/robot.h"
#include "support/irb2400.h"
#include "support/urdfdom_leaks.h"

namespace scan_to_path::robot {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const char* const good_limit = R"(<limit lower="-1" upper="2" velocity="3" effort="0"/>)";

std::string joint(const std::string& name, const std::string& type, const std::string& parent, const std::string& child,
                  const std::string& inner = good_limit) {
  return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent + "'/><child link='" + child + "'/>" +
         inner + "</joint>";
}

std::string robotText(const std::string& body) {
  return "<?xml version='1.0'?><robot name='r'><link name='a'/><link name='b'/><link name='c'/>" + body + "</robot>";
}

/// What parseRobot says of `text`; "accepted" when nothing. Nothing may reach the console.
std::string complaint(const std::string& text, const std::string& base = "a", const std::string& tip = "c") {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  std::string message = "accepted";
  try {
    parseRobot(text, base, tip);
  } catch (const InputError& error) {
    message = error.what();
  }
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(message.find('\n'), std::string::npos);
  return message;
}

TEST(ParseRobot, FoldsFixedJointsIntoTheNextOne) {
  const Robot robot = parseRobot(
      robotText(joint("f", "fixed", "a", "b", "<origin xyz='1 2 3' rpy='0 0 1.5707963267948966'/>") +
                joint("j", "revolute", "b", "c", std::string("<origin xyz='1 0 0'/><axis xyz='0 2 0'/>") + good_limit)),
      "a", "c");
  ASSERT_EQ(robot.dof(), 1);
  EXPECT_LT((robot.joints[0].T_parent_joint.translation() - Vector3(1, 3, 3)).norm(), 1e-15);
  EXPECT_EQ(robot.joints[0].axis, Vector3::UnitY());
  EXPECT_EQ(robot.joints[0].lower, -1.0);
  EXPECT_EQ(robot.joints[0].upper, 2.0);
  EXPECT_EQ(robot.joints[0].max_velocity, 3.0);
  EXPECT_TRUE(robot.T_last_tip.isApprox(Frame::Identity()));
  EXPECT_EQ(robot.link_names, (std::vector<std::string>{"a", "b", "c"}));
}

TEST(ParseRobot, ContinuousJointsHaveNoLimits) {
  const Robot robot = parseRobot(robotText(joint("j", "continuous", "a", "b", "<limit velocity='2' effort='0'/>") +
                                           joint("f", "fixed", "b", "c", "")),
                                 "a", "c");
  EXPECT_EQ(robot.joints[0].lower, -std::numeric_limits<double>::infinity());
  EXPECT_EQ(robot.joints[0].upper, std::numeric_limits<double>::infinity());
}

TEST(ParseRobot, TakesAPartOfTheChain) {
  const Robot robot = parseRobot(readFile(test::irb2400File()), "link_2", "link_5");
  ASSERT_EQ(robot.dof(), 3);
  EXPECT_EQ(robot.joints[0].name, "joint_3");
}

TEST(ParseRobot, NamesTheMissingLinkAndTheNearestOne) {
  const std::string text = robotText(joint("i", "revolute", "a", "b") + joint("j", "revolute", "b", "c"));
  EXPECT_EQ(complaint(text), "accepted");
  EXPECT_THAT(complaint(text, "a", "cc"), AllOf(HasSubstr("no link cc"), HasSubstr("did you mean c")));
  EXPECT_THAT(complaint(text, "A", "c"), HasSubstr("no link A"));
}

TEST(ParseRobot, NamesAChainThatIsNoChain) {
  const std::string text = robotText(joint("i", "revolute", "a", "b") + joint("j", "revolute", "a", "c"));
  EXPECT_THAT(complaint(text, "b", "c"), HasSubstr("no chain of joints from b to c"));
  EXPECT_THAT(complaint(text, "a", "a"), HasSubstr("number of movable joints"));
}

TEST(ParseRobot, RefusesJointsItCannotDrive) {
  const auto with = [](const std::string& type, const std::string& inner) {
    return complaint(robotText(joint("bad_one", type, "a", "b", inner) + joint("f", "fixed", "b", "c", "")));
  };
  EXPECT_THAT(with("prismatic", good_limit), AllOf(HasSubstr("bad_one"), HasSubstr("revolute")));
  EXPECT_THAT(with("floating", ""), HasSubstr("bad_one"));
  EXPECT_THAT(with("revolute", std::string(good_limit) + "<mimic joint='f'/>"),
              AllOf(HasSubstr("bad_one"), HasSubstr("mimic")));
  EXPECT_THAT(with("revolute", ""), HasSubstr("bad_one"));
  EXPECT_THAT(with("continuous", ""), AllOf(HasSubstr("bad_one"), HasSubstr("limit is absent")));
  EXPECT_THAT(with("revolute", "<limit lower='1' upper='1' velocity='1' effort='0'/>"), HasSubstr("rising"));
  EXPECT_THAT(with("revolute", "<limit lower='-1' upper='1' velocity='0' effort='0'/>"), HasSubstr("velocity"));
  EXPECT_THAT(with("revolute", "<limit lower='nan' upper='1' velocity='1' effort='0'/>"), HasSubstr("bad_one"));
  EXPECT_THAT(with("revolute", "<limit lower='-1' upper='inf' velocity='1' effort='0'/>"), HasSubstr("bad_one"));
  EXPECT_THAT(with("revolute", std::string("<axis xyz='0 0 0'/>") + good_limit),
              AllOf(HasSubstr("axis"), HasSubstr("bad_one")));
  EXPECT_THAT(with("revolute", std::string("<origin xyz='nan 0 0'/>") + good_limit), HasSubstr("bad_one"));
  EXPECT_THAT(with("revolute", std::string("<origin xyz='1 0'/>") + good_limit), testing::Ne("accepted"));
}

TEST(ParseRobot, RefusesLimitsThatLookLikeDegrees) {
  const auto with = [](const std::string& type, const std::string& limit) {
    return complaint(robotText(joint("wrist", type, "a", "b", limit) + joint("f", "fixed", "b", "c", "")));
  };
  const auto degrees = AllOf(HasSubstr("wrist"), HasSubstr("looks like degrees"));
  EXPECT_THAT(with("revolute", "<limit lower='-100' upper='110' velocity='3' effort='0'/>"), degrees);
  EXPECT_THAT(with("revolute", "<limit lower='-60' upper='45' velocity='3' effort='0'/>"), degrees);
  EXPECT_THAT(with("revolute", "<limit lower='-1' upper='2' velocity='150' effort='0'/>"), degrees);
  EXPECT_THAT(with("continuous", "<limit velocity='360' effort='0'/>"), degrees);
  // 400 and 2700 degrees, as wrists have, at 1100 degrees per second.
  EXPECT_EQ(with("revolute", "<limit lower='-6.981' upper='6.981' velocity='19.2' effort='0'/>"), "accepted");
  EXPECT_EQ(with("revolute", "<limit lower='-47.12' upper='47.12' velocity='19.2' effort='0'/>"), "accepted");
}

TEST(ParseRobot, RefusesMoreThanEightJoints) {
  std::string body;
  for (int i = 0; i < 9; ++i) {
    body +=
        "<link name='l" + std::to_string(i) + "'/>" +
        joint("j" + std::to_string(i), "revolute", i == 0 ? "a" : "l" + std::to_string(i - 1), "l" + std::to_string(i));
  }
  body += joint("fb", "fixed", "a", "b", "") + joint("fc", "fixed", "a", "c", "");
  EXPECT_EQ(complaint(robotText(body), "a", "l7"), "accepted");
  EXPECT_THAT(complaint(robotText(body), "a", "l8"), AllOf(HasSubstr("is 9"), HasSubstr("[1, 8]")));
}

TEST(ParseRobot, NamesXacroAsSuch) {
  EXPECT_THAT(
      complaint("<robot name='r' xmlns:xacro='http://ros.org/wiki/xacro'><xacro:include filename='x'/></robot>"),
      HasSubstr("xacro"));
  // What xacro has expanded keeps the name space and its comments.
  EXPECT_EQ(complaint("<robot name='r' xmlns:xacro='http://ros.org/wiki/xacro'><!-- <xacro:arm/> -->"
                      "<link name='a'/><link name='c'/>" +
                      joint("j", "revolute", "a", "c") + "</robot>"),
            "accepted");
}

TEST(ParseRobot, RefusesWhatIsNoRobot) {
  for (const char* text : {"", "   ", "hello", "<", "<robot", "<robot name='r'/>", "<html><body/></html>",
                           "<robot name='r'><link/></robot>", "<robot><link name='a'/></robot>", "\xef\xbb\xbf",
                           "<?xml version='1.0'?>", "<!-- ", "<![CDATA["}) {
    EXPECT_NE(complaint(text), "accepted") << text;
  }
  EXPECT_NE(complaint(std::string("\0\0<robot/>", 10)), "accepted");
}

TEST(ParseRobot, SurvivesLoopsAndDeepNesting) {
  EXPECT_NE(complaint(robotText(joint("i", "revolute", "b", "c") + joint("j", "revolute", "c", "b"))), "accepted");
  EXPECT_NE(complaint(robotText(joint("i", "revolute", "a", "b") + joint("j", "revolute", "b", "a"))), "accepted");
  std::string deep;
  for (int i = 0; i < 200000; ++i) deep += i % 2 == 0 ? "<a x='/>'>" : "<_b>";
  EXPECT_THAT(complaint("<robot name='r'>" + deep), HasSubstr("depth"));
}

TEST(ParseRobot, SurvivesTruncationAtEveryByte) {
  const std::string text = readFile(test::irb2400File());
  const std::size_t end = text.rfind("</robot>");
  for (std::size_t length = 0; length < end; length += 7) {
    ASSERT_NE(complaint(text.substr(0, length), "base_link", "tool0"), "accepted") << length;
  }
}

TEST(ParseRobot, SurvivesMutations) {
  const std::string text = readFile(test::irb2400File());
  const std::string alphabet = "<>\"'/ =&;!-0919eE.+xn\0\x80\xff";
  Random random(6);
  const auto pick = [&random](std::size_t count) {
    return static_cast<std::size_t>(random.uniform() * static_cast<double>(count));
  };
  for (int k = 0; k < 2000; ++k) {
    std::string mutated = text;
    for (std::size_t changes = 1 + pick(6); changes > 0; --changes) {
      const std::size_t at = pick(mutated.size());
      if (pick(2) == 0)
        mutated[at] = alphabet[pick(alphabet.size())];
      else if (pick(2) == 0)
        mutated.erase(at, pick(40));
      else
        mutated.insert(at, mutated.substr(pick(mutated.size()), pick(200)));
    }
    complaint(mutated, "base_link", "tool0");
  }
}

}  // namespace
}  // namespace scan_to_path::robot
