// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/reference_stage.h"

#include <gtest/gtest.h>

#include <set>

#include "scan_to_path/geometry/scene.h"
#include "scan_to_path/pipeline/stages.h"
#include "small_scan.h"

namespace scan_to_path::pipeline {
namespace {

double valueOf(const std::vector<Accuracy>& figures, const std::string& name) {
  for (const auto& candidate : figures) {
    if (candidate.name == name) return candidate.value;
  }
  throw std::runtime_error("no figure " + name);
}

class ReferenceStage : public ::testing::Test {
protected:
  void SetUp() override {
    const Cell cell = makeCell(CellOptions(), source_package);
    scan_ = fitStage(scanFromSamples(smallScan(), cell, {}, {}, 1, {}), {}, {}, {}, 1, {}).scan;
    reference_ = std::make_shared<geometry::PosedSurface>(std::make_shared<geometry::Saddle>(smallPart()),
                                                          cell.T_base_workpiece);
  }
  process::PlannedPath planned(const JobOptions& options) const {
    return pathStage(*makePlanner("cutting", options), scan_, "base_link", options, {}).planned;
  }

  scan::FittedScan scan_;
  std::shared_ptr<geometry::PosedSurface> reference_;
};

TEST_F(ReferenceStage, MeasuresPathNormalsAndScallops) {
  const JobOptions options;
  const auto figures = compareWithReference(planned(options), scan_, options, *reference_, 1);
  // 2 um of noise over 1,200 samples and about ten control points a row.
  EXPECT_LT(valueOf(figures, "reference_path_rms"), 1e-6);
  EXPECT_LT(valueOf(figures, "reference_normal_mean"), 0.02 * M_PI / 180.0);
  // The planner's promise, plus the path's own error of less than 1 um.
  EXPECT_LE(valueOf(figures, "reference_scallop_largest"), options.path.scallop_height + 1e-6);
  EXPECT_GE(valueOf(figures, "reference_scallop_largest"), 0.85 * options.path.scallop_height);
  EXPECT_LT(valueOf(figures, "reference_deepest_cut"), 5e-6);
}

TEST_F(ReferenceStage, MeasuresTheLastPassOverStockAlone) {
  JobOptions options;
  const auto without_stock = compareWithReference(planned(options), scan_, options, *reference_, 1);
  options.path.stock = 2e-3;  // two passes, the first 1 mm above the part
  const auto figures = compareWithReference(planned(options), scan_, options, *reference_, 1);
  EXPECT_EQ(valueOf(figures, "reference_contacts"), valueOf(without_stock, "reference_contacts"));
  // The last pass is the path without stock, snapped to the digits of path.csv, 1 nm.
  EXPECT_NEAR(valueOf(figures, "reference_path_rms"), valueOf(without_stock, "reference_path_rms"), 1e-9);
  EXPECT_NEAR(valueOf(figures, "reference_path_largest"), valueOf(without_stock, "reference_path_largest"), 1e-9);
}

TEST_F(ReferenceStage, SeesALastPassThatIsOffAndACutOfAnEarlierOne) {
  JobOptions options;
  options.path.stock = 2e-3;
  for (const std::string pass : {"pass_0_row_7", "pass_1_row_7"}) {
    auto path = planned(options);
    for (auto& segment : path.path.segments) {
      if (segment.name != pass) continue;
      // The first pass is 1 mm above the part: it would cut 0.1 mm deep.
      for (auto& waypoint : segment.waypoints)
        waypoint.pose.translation().z() -= pass == "pass_0_row_7" ? 1.1e-3 : 1e-4;
    }
    const auto figures = compareWithReference(path, scan_, options, *reference_, 1);
    // Slopes up to 0.3 make the distance along the normal a twentieth less than that along z.
    EXPECT_NEAR(valueOf(figures, "reference_deepest_cut"), 1e-4, 1e-5) << pass;
    const double largest = valueOf(figures, "reference_path_largest");
    EXPECT_NEAR(largest, pass == "pass_0_row_7" ? 0.0 : 1e-4, 1e-5) << pass;
  }
}

TEST_F(ReferenceStage, HoldsTheFiguresToTheirLimits) {
  JobOptions options;
  auto path = planned(options);
  for (auto& segment : path.path.segments) {
    for (auto& waypoint : segment.waypoints) waypoint.pose.translation().z() -= 3e-4;  // 0.29 mm along the normal
  }
  const auto failing = [&] {
    std::set<std::string> names;
    for (const auto& figure : compareWithReference(path, scan_, options, *reference_, 1)) {
      if (!figure.pass()) names.insert(figure.name);
    }
    return names;
  };
  using Names = std::set<std::string>;
  EXPECT_EQ(failing(), (Names{"reference_path_largest", "reference_deepest_cut"}));
  options.report.max_reference_path = options.report.max_reference_cut = 3.1e-4;
  EXPECT_EQ(failing(), Names{});
  options.report.max_reference_path = options.report.max_reference_cut = 0.0;  // none
  EXPECT_EQ(failing(), Names{});
  path = planned(options);
  options.report.max_reference_scallop = 0.8 * options.path.scallop_height;
  EXPECT_EQ(failing(), Names{"reference_scallop_largest"});
}

// As a partial path may be: what an earlier pass leaves is on purpose, not off the part.
TEST_F(ReferenceStage, EarlierPassesAloneHaveNoDeviation) {
  JobOptions options;
  options.path.stock = 2e-3;
  auto path = planned(options);
  for (std::size_t s = 0; s < path.path.segments.size(); ++s) {
    if (path.allowances[s] > 0.0) continue;
    for (auto& waypoint : path.path.segments[s].waypoints) waypoint.process_on = false;
  }
  const auto figures = compareWithReference(path, scan_, options, *reference_, 1);
  EXPECT_THROW(valueOf(figures, "reference_path_rms"), std::runtime_error);
  EXPECT_GT(valueOf(figures, "reference_uncut_share"), 0.5);
}

TEST_F(ReferenceStage, SeesADroppedRow) {
  const JobOptions options;
  auto path = planned(options);
  for (auto& segment : path.path.segments) {
    if (segment.name == "row_7") {
      for (auto& waypoint : segment.waypoints) waypoint.process_on = false;
    }
  }
  const auto figures = compareWithReference(path, scan_, options, *reference_, 1);
  EXPECT_GT(valueOf(figures, "reference_scallop_largest"), 3.0 * options.path.scallop_height);
}

// A row that is missing makes a cusp four times as high, whatever height is meant: it is measured, not taken for uncut.
TEST_F(ReferenceStage, MeasuresADroppedRowAtAnyScallopHeight) {
  JobOptions options;
  for (const double height : {5e-5, 3e-4}) {
    options.path.scallop_height = height;
    auto path = planned(options);
    for (auto& segment : path.path.segments) {
      if (segment.name != "row_4") continue;
      for (auto& waypoint : segment.waypoints) waypoint.process_on = false;
    }
    const auto figures = compareWithReference(path, scan_, options, *reference_, 1);
    EXPECT_GT(valueOf(figures, "reference_scallop_largest"), 3.5 * height);
    EXPECT_LT(valueOf(figures, "reference_scallop_largest"), 4.2 * height);
    EXPECT_EQ(valueOf(figures, "reference_uncut_share"), 0.0);
  }
}

// Rows 15 mm apart leave 20 - sqrt(20^2 - 7.5^2) = 1.46 mm on a plane: that is what they were asked to. With every row
// but the first one gone the part is uncut.
TEST_F(ReferenceStage, MeasuresWhatAPitchLeaves) {
  JobOptions options;
  options.path.pitch = 0.015;
  auto path = planned(options);
  auto figures = compareWithReference(path, scan_, options, *reference_, 1);
  // The saddle bends by 1 / 0.15 m and more; a look misses a cusp by 0.05 mm, which is 0.05 * 7.5 / 20 = 0.02 mm of it.
  EXPECT_NEAR(valueOf(figures, "reference_scallop_largest"), 1.46e-3, 0.2e-3);
  EXPECT_EQ(valueOf(figures, "reference_uncut_share"), 0.0);
  for (auto& segment : path.path.segments) {
    if (segment.name == "row_0") continue;
    for (auto& waypoint : segment.waypoints) waypoint.process_on = false;
  }
  figures = compareWithReference(path, scan_, options, *reference_, 1);
  EXPECT_GT(valueOf(figures, "reference_uncut_share"), 0.5);
}

TEST_F(ReferenceStage, SameForAnyNumberOfThreads) {
  const JobOptions options;
  const auto path = planned(options);
  const auto one = compareWithReference(path, scan_, options, *reference_, 1);
  const auto three = compareWithReference(path, scan_, options, *reference_, 3);
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].value, three[i].value) << one[i].name;
}

}  // namespace
}  // namespace scan_to_path::pipeline
