// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path_ros/parameters.h"

#include <gmock/gmock.h>

#include <cstdlib>

#include "scan_to_path/pipeline/configuration.h"
#include "support/expect_input_error.h"

namespace scan_to_path_ros {
namespace {

namespace pipeline = scan_to_path::pipeline;
using scan_to_path::test::expectInputError;
using XmlRpc::XmlRpcValue;

/// The options as a parameter server has them: structs, scalars and lists, as rosparam makes of the YAML.
XmlRpcValue treeOf(const pipeline::JobOptions& options) {
  pipeline::JobOptions copy = options;
  XmlRpcValue tree;
  for (const auto& field : pipeline::fieldReferences(copy)) {
    XmlRpcValue* leaf = &tree;
    std::stringstream path(field.path);
    for (std::string key; std::getline(path, key, '.');) leaf = &(*leaf)[key];
    if (const auto* flag = std::get_if<bool*>(&field.value)) *leaf = **flag;
    if (const auto* integer = std::get_if<int*>(&field.value)) *leaf = **integer;
    if (const auto* number = std::get_if<double*>(&field.value)) *leaf = **number;
    if (const auto* number = std::get_if<std::optional<double>*>(&field.value)) {
      *leaf = **number ? XmlRpcValue(***number) : XmlRpcValue("unset");
    }
    if (const auto* text = std::get_if<std::string*>(&field.value)) *leaf = **text;
    if (const auto* name = std::get_if<pipeline::EnumReference>(&field.value)) *leaf = name->names[name->get()];
    if (const auto* vector = std::get_if<Eigen::Vector3d*>(&field.value)) {
      for (int i = 0; i < 3; ++i) (*leaf)[i] = (**vector)(i);
    }
    if (const auto* list = std::get_if<std::vector<double>*>(&field.value)) {
      leaf->setSize(static_cast<int>((*list)->size()));
      for (std::size_t i = 0; i < (*list)->size(); ++i) (*leaf)[static_cast<int>(i)] = (**list)[i];
    }
    if (const auto* list = std::get_if<std::vector<std::string>*>(&field.value)) {
      leaf->setSize(static_cast<int>((*list)->size()));
      for (std::size_t i = 0; i < (*list)->size(); ++i) (*leaf)[static_cast<int>(i)] = (**list)[i];
    }
    if (const auto* list = std::get_if<std::vector<Eigen::Vector2d>*>(&field.value)) {
      leaf->setSize(static_cast<int>((*list)->size()));
      for (int i = 0; i < leaf->size(); ++i) {
        for (int k = 0; k < 2; ++k) (*leaf)[i][k] = (**list)[static_cast<std::size_t>(i)][k];
      }
    }
  }
  return tree;
}

std::string yamlOf(pipeline::JobOptions options) { return pipeline::formatYaml(pipeline::fieldReferences(options)); }

TEST(Parameters, EveryOptionComesThroughAsItIs) {
  pipeline::JobOptions sent;
  sent.cell.sensor.xyz = {0.1, -0.2, 1.0 / 3.0};  // 17 digits
  sent.program.process_signal = "do \"spindle\", #1: 'on' \\ {x}\n";
  sent.scan.placement.max_joint_gap = 0.0123;
  sent.fit.with_surface = false;
  sent.path.region = {{0.0, 1.0 / 3.0}, {1.0, 0.0}, {0.5, -2.0}};
  pipeline::JobOptions received;
  ASSERT_NE(yamlOf(sent), yamlOf(received));
  applyParameter(received, treeOf(sent), "/cell/configuration");
  EXPECT_EQ(yamlOf(received), yamlOf(sent));
  EXPECT_EQ(received.cell.sensor.xyz, sent.cell.sensor.xyz);
  EXPECT_EQ(received.program.process_signal, sent.program.process_signal);
  sent.scan.placement.clock_offset = 1.0 / 3e3;
  applyParameter(received, treeOf(sent), "/cell/configuration");
  EXPECT_EQ(received.scan.placement.clock_offset, sent.scan.placement.clock_offset);
}

TEST(Parameters, TakesIntegersForNumbers) {
  XmlRpcValue tree;
  tree["scan"]["placement"]["clock_offset"] = 1;
  pipeline::JobOptions options;
  applyParameter(options, tree, "configuration");
  EXPECT_EQ(options.scan.placement.clock_offset, 1.0);
}

// A clock offset of 0 is one that is known.
TEST(Parameters, ZeroIsNotUnset) {
  XmlRpcValue tree;
  pipeline::JobOptions options;
  EXPECT_FALSE(options.scan.placement.clock_offset.has_value());
  tree["scan"]["placement"]["clock_offset"] = 0.0;
  applyParameter(options, tree, "configuration");
  EXPECT_EQ(options.scan.placement.clock_offset, 0.0);
  tree["scan"]["placement"]["clock_offset"] = "unset";
  applyParameter(options, tree, "job");
  EXPECT_FALSE(options.scan.placement.clock_offset.has_value());
}

TEST(Parameters, TakesATextInYaml) {
  pipeline::JobOptions options;
  applyParameter(options, XmlRpcValue("scan: {placement: {clock_offset: 0.25}}"), "job");
  EXPECT_EQ(options.scan.placement.clock_offset, 0.25);
  applyParameter(options, XmlRpcValue(""), "job");
  EXPECT_EQ(options.scan.placement.clock_offset, 0.25);
}

TEST(Parameters, NamesTheParameterAndTheKeyItDoesNotKnow) {
  XmlRpcValue tree;
  tree["scan"]["placement"]["clock_ofset"] = 0.1;
  pipeline::JobOptions options;
  expectInputError([&] { applyParameter(options, tree, "/cell/configuration"); }, "parameter /cell/configuration");
  expectInputError([&] { applyParameter(options, tree, "/cell/configuration"); }, "clock_ofset");
  expectInputError([&] { applyParameter(options, tree, "/cell/configuration"); }, "clock_offset");  // the nearest
}

TEST(Parameters, RefusesValuesOfAnotherType) {
  pipeline::JobOptions options;
  XmlRpcValue tree;
  tree["scan"]["placement"]["clock_offset"] = "soon";
  expectInputError([&] { applyParameter(options, tree, "job"); }, "clock_offset");
  XmlRpcValue list;
  list["scan"]["placement"]["clock_offset"][0] = 0.1;
  expectInputError([&] { applyParameter(options, list, "job"); }, "clock_offset");
  char bytes[] = {1, 2};
  XmlRpcValue binary;
  binary["scan"] = XmlRpcValue(bytes, 2);
  expectInputError([&] { applyParameter(options, binary, "job"); }, "binary");
}

TEST(Parameters, PackagePathIsRosPackagePath) {
  setenv("ROS_PACKAGE_PATH", "/one::/two", 1);
  const auto path = packagePath();
  ASSERT_GE(path.size(), 2U);
  EXPECT_EQ(path[path.size() - 2], "/one");
  EXPECT_EQ(path.back(), "/two");
}

}  // namespace
}  // namespace scan_to_path_ros
