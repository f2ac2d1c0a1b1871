// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "rviz/job_choice.h"

#include <gtest/gtest.h>

#include "scan_to_path/pipeline/configuration.h"
#include "scan_to_path/pipeline/job_options.h"
#include "support/expect_input_error.h"

namespace scan_to_path_rviz {
namespace {

using scan_to_path::test::expectInputError;
using Corners = std::vector<Eigen::Vector2d>;

scan_to_path::pipeline::JobOptions read(const std::string& yaml) {
  scan_to_path::pipeline::JobOptions options;
  scan_to_path::pipeline::applyYaml(scan_to_path::pipeline::fieldReferences(options), yaml, "job");
  return options;
}

TEST(JobChoice, TakesABoxOrCorners) {
  EXPECT_EQ(parseRegion(" "), Corners());
  EXPECT_EQ(parseRegion("0 0.1 -1 2"), (Corners{{0.0, -1.0}, {0.1, -1.0}, {0.1, 2.0}, {0.0, 2.0}}));
  EXPECT_EQ(parseRegion("0 0, 0.1 0,0.1 1e-2"), (Corners{{0.0, 0.0}, {0.1, 0.0}, {0.1, 0.01}}));
  expectInputError([] { parseRegion("0 1 2"); }, "x_min x_max y_min y_max");
  expectInputError([] { parseRegion("0 1 x 2"); }, "region: text is \"x\"");
  expectInputError([] { parseRegion("0 1, 2"); }, "region: corner is \" 2\", must be two numbers");
}

TEST(JobChoice, IsReadBackToTheBit) {
  const auto options = read(withChoice("path: {pitch: 0.002}\nfit: {with_surface: true}\n",
                                       {"0.1 0.30000000000000004 0 0.2", " 3, 7-9 ", "2"}));
  EXPECT_EQ(options.path.pitch, 0.002);
  EXPECT_EQ(options.path.region,
            (Corners{{0.1, 0.0}, {0.30000000000000004, 0.0}, {0.30000000000000004, 0.2}, {0.1, 0.2}}));
  EXPECT_EQ(options.path.skip_rows, "3, 7-9");
  EXPECT_EQ(options.path.reverse_rows, "2");
  EXPECT_EQ(read(withChoice("", {"", "4", ""})).path.skip_rows, "4");
  EXPECT_EQ(read(withChoice("path:\n", {"", "", "1"})).path.reverse_rows, "1");
}

TEST(JobChoice, OfNothingLeavesTheTextAlone) {
  EXPECT_EQ(withChoice("path: [not, a, section]", {"", " ", ""}), "path: [not, a, section]");
  expectInputError([] { withChoice("path: [not, a, section]", {"", "3", ""}); }, "options: must be sections of keys");
  expectInputError([] { withChoice("path: {", {"", "3", ""}); }, "not YAML");
}

}  // namespace
}  // namespace scan_to_path_rviz
