// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "../../src/program/rapid_values.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/expect_input_error.h"

namespace scan_to_path::program {
namespace {

/// Evaluates the data of a module by name.
class Data {
public:
  explicit Data(const std::string& text)
      : modules_{parseRapidModule({"m.mod", "MODULE M\n" + text + "\nENDMODULE"})}, values_(modules_) {}

  RapidValues::Scope scope() const { return {&modules_[0], nullptr}; }
  static Expression name(const std::string& text) {
    Expression made;
    made.kind = Expression::Kind::name;
    made.text = text;
    return made;
  }
  double number(const std::string& text) const { return values_.number(name(text), scope()); }
  const RapidValues& values() const { return values_; }

private:
  std::vector<RapidModule> modules_;
  RapidValues values_;
};

TEST(RapidValues, ArithmeticHasItsPrecedence) {
  const Data data("CONST num a:=2+3*4-6/-(1+2);CONST num b:=-a*a;CONST num c:=8/2/2;CONST num d:=1-2-3;");
  EXPECT_DOUBLE_EQ(data.number("a"), 16.0);
  EXPECT_DOUBLE_EQ(data.number("b"), -256.0);
  EXPECT_DOUBLE_EQ(data.number("c"), 2.0);
  EXPECT_DOUBLE_EQ(data.number("d"), -4.0);
}

TEST(RapidValues, UserFrameThenObjectFrame) {
  // A quarter turn about z in the user frame carries the object's (10, 0, 0) to (0, 10, 0).
  const Data data("PERS wobjdata w:=[FALSE,TRUE,\"\",[[100,0,0],[0.70710678,0,0,0.70710678]],[[10,0,0],[0,0,1,0]]];");
  const auto pose = data.values().workobject(Data::name("w"), data.scope());
  EXPECT_NEAR(pose.t[0], 0.1, 1e-9);
  EXPECT_NEAR(pose.t[1], 0.01, 1e-9);
  EXPECT_NEAR(pose.r[1][0], -1.0, 1e-8);  // half a turn about y first: x to -x, then -x to -y
  EXPECT_NEAR(pose.r[2][2], -1.0, 1e-8);
}

TEST(RapidValues, RotationsOfQuaternionsByRodrigues) {
  // The matrix of a turn by an angle about an axis, by Rodrigues' formula instead of the quaternion's.
  for (const double angle : {0.0, 0.3, 1.7, 3.141, M_PI, -2.2}) {
    const geometry::Vector3 axis = geometry::Vector3(1, -2, 0.5).normalized();
    const double s = std::sin(angle / 2);
    const auto pose = RapidPose::fromQuaternion({std::cos(angle / 2), s * axis.x(), s * axis.y(), s * axis.z()}, {});
    for (int j = 0; j < 3; ++j) {
      const geometry::Vector3 e = geometry::Vector3::Unit(j);
      const geometry::Vector3 turned =
          e * std::cos(angle) + axis.cross(e) * std::sin(angle) + axis * axis.dot(e) * (1 - std::cos(angle));
      EXPECT_LT((pose.frame().linear().col(j) - turned).norm(), 1e-14) << angle;
    }
  }
}

TEST(RapidValues, WrongShapesAreNamed) {
  const Data data(
      "CONST zonedata z:=[FALSE,-1,0,0,0,0,0];PERS wobjdata w:=[TRUE,TRUE,\"\",[],[]];"
      "PERS tooldata t:=[TRUE,[[0,0,0],[1,0,0]],[]];CONST speeddata v:=[1,2,3];CONST num s:=1+TRUE;"
      "CONST robtarget p:=[[0,0,0],[1,0,0,0],[0,0.5,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];");
  const auto& values = data.values();
  const auto scope = data.scope();
  test::expectInputError([&] { values.zone(Data::name("z"), scope); }, "zone is negative");
  test::expectInputError([&] { values.workobject(Data::name("w"), scope); }, "robot holds");
  test::expectInputError([&] { values.tool(Data::name("t"), scope); }, "tooldata: expected 4 components");
  test::expectInputError([&] { values.speed(Data::name("v"), scope); }, "speeddata: expected 4 components");
  test::expectInputError([&] { values.target(Data::name("p"), scope); }, "whole number");
  test::expectInputError([&] { data.number("s"); }, "arithmetic with what is no number");
  test::expectInputError([&] { data.number("nothing"); }, "not declared");
}

}  // namespace
}  // namespace scan_to_path::program
