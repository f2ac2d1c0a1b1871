// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/input.h"

#include <gmock/gmock.h>

#include "scan_to_path/common/error.h"

namespace scan_to_path::pipeline {
namespace {

using ::testing::HasSubstr;

TEST(Input, IsDetectedByContent) {
  const auto kind = [](const std::string& content) { return detectInput(content, "f"); };
  EXPECT_EQ(kind("# scan_to_path samples 1\nt,j,voltage\n"), InputKind::samples);
  EXPECT_EQ(kind("\xEF\xBB\xBF# scan_to_path samples 1\nt,j,voltage\n"), InputKind::samples);
  EXPECT_EQ(kind("# .PCD v0.7\nVERSION 0.7\n"), InputKind::cloud);
  EXPECT_EQ(kind("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n0\n"), InputKind::cloud);
  EXPECT_EQ(kind("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nelement face 1\n"
                 "property list uchar int vertex_indices\nend_header\n0\n3 0 0 0\n"),
            InputKind::mesh);
  EXPECT_EQ(kind("solid part\nendsolid part\n"), InputKind::mesh);
  EXPECT_EQ(kind(std::string(80, ' ') + std::string("\1\0\0\0", 4) + std::string(50, '\0')), InputKind::mesh);
  EXPECT_EQ(kind("OFF\n3 1 0\n"), InputKind::mesh);
  EXPECT_EQ(kind("# Blender\n\no part\nv 0 0 0\n"), InputKind::mesh);
  EXPECT_EQ(kind("ISO-10303-21;\n"), InputKind::cad);
  EXPECT_EQ(kind(std::string(72, ' ') + "S      1\n"), InputKind::cad);
  EXPECT_EQ(kind("DBRep_DrawableShape\n"), InputKind::cad);
}

TEST(Input, SaysWhatItIsNot) {
  const auto error = [](const std::string& content) -> std::string {
    try {
      detectInput(content, "f");
    } catch (const InputError& e) {
      return e.what();
    }
    return "no error";
  };
  EXPECT_EQ(error(""), "f: is empty");
  EXPECT_THAT(error("#ROSBAG V2.0\n"), HasSubstr("ROS bag"));
  EXPECT_THAT(error("hello\n"), HasSubstr("is none of"));
  EXPECT_THAT(error(std::string("\0\1\2", 3)), HasSubstr("is none of"));
}

TEST(Input, ImplausibleSizeSuggestsTheUnitThatFits) {
  const auto error = [](double size, Units units) -> std::string {
    try {
      checkPlausibleSize({Eigen::Vector3d::Zero(), Eigen::Vector3d(size, 0.0, 0.0)}, units, "f");
    } catch (const InputError& e) {
      return e.what();
    }
    return "no error";
  };
  EXPECT_EQ(error(0.1, Units::m), "no error");
  EXPECT_EQ(error(0.005, Units::m), "no error");
  EXPECT_EQ(error(20.0, Units::m), "no error");
  EXPECT_THAT(error(240.0, Units::m), HasSubstr("if the file is in mm (0.240 m), say --units mm"));
  EXPECT_THAT(error(0.00024, Units::mm), HasSubstr("say --units m"));
  EXPECT_THAT(error(1e9, Units::m), HasSubstr("say --units to insist"));
  try {
    checkPlausibleSize({Eigen::Vector3d::Zero(), Eigen::Vector3d(240.0, 0.0, 0.0)}, Units::m, "f", "--other-units");
    ADD_FAILURE() << "240 m are plausible";
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), HasSubstr("(0.240 m), say --other-units mm or inch (6.096 m), say --other-units inch"));
  }
}

TEST(Input, UnitsAreExact) {
  EXPECT_EQ(metresPerUnit(Units::m), 1.0);
  EXPECT_EQ(metresPerUnit(Units::mm), 0.001);
  EXPECT_EQ(metresPerUnit(Units::inch), 0.0254);
}

}  // namespace
}  // namespace scan_to_path::pipeline
