// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/unseen_share.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "scan_to_path/geometry/scene.h"
#include "scan_to_path/geometry/worlds.h"
#include "scan_to_path/pipeline/stages.h"
#include "small_scan.h"

namespace scan_to_path::pipeline {
namespace {

using geometry::FlatPart;
using geometry::Rectangle;
using ::testing::HasSubstr;
using Surfaces = std::vector<std::shared_ptr<const geometry::Surface>>;

/// Plates at z = 0.
Surfaces plates(const std::vector<Rectangle>& rectangles) {
  Surfaces surfaces;
  for (const auto& rectangle : rectangles) surfaces.push_back(std::make_shared<FlatPart>(rectangle));
  return surfaces;
}

std::shared_ptr<const geometry::Surface> floorAt(double z) {
  return std::make_shared<geometry::PosedSurface>(std::make_shared<geometry::Plane>(),
                                                  geometry::makeFrame({0, 0, z}, Vector3::Zero()));
}

FitStage fitted(const scan::SampleLog& log, const ReportOptions& limits = {}) {
  const Cell cell = makeCell(CellOptions(), source_package);
  return fitStage(scanFromSamples(log, cell, {}, {}, 1, {}), {}, {}, limits, 1, {});
}

FitStage fitted(Surfaces surfaces, const ReportOptions& limits = {}) {
  return fitted(smallScan(geometry::Scene(std::move(surfaces))), limits);
}

/// A plane at 45 degrees through the middle of the range, turned about the workpiece's x or y.
scan::SampleLog slope(double about_x, double about_y) {
  const geometry::PosedSurface plane(std::make_shared<geometry::Plane>(),
                                     geometry::makeFrame({0, 0, 0}, {about_x, about_y, 0.0}));
  return smallScan(plane);
}

UnseenShare shareOf(const scan::SampleLog& log) {
  const Cell cell = makeCell(CellOptions(), source_package);
  const ScanStage scanned = scanFromSamples(log, cell, {}, {}, 1, {});
  const auto rows = scan::cleanRows(*scanned.cloud, scanned.mean_beam, {});
  return unseenShare(*scanned.cloud, rows, scanned.no_returns, 0.002);
}

const Accuracy* figureOf(const FitStage& fit) {
  const auto found = std::find_if(fit.accuracy.begin(), fit.accuracy.end(),
                                  [](const Accuracy& figure) { return figure.name == "unseen_share"; });
  return found == fit.accuracy.end() ? nullptr : &*found;
}

double unseen(const FitStage& fit) { return figureOf(fit) != nullptr ? figureOf(fit)->value : -1.0; }

// 60 mm by 60 mm, rows at y = -28, -24, … 28 mm; a pocket of 20 mm by 20 mm takes a third of the five within +-10 mm.
const std::vector<Rectangle> pocketed = {
    {-0.03, -0.01, -0.03, 0.03}, {0.01, 0.03, -0.03, 0.03}, {-0.01, 0.01, -0.03, -0.01}, {-0.01, 0.01, 0.01, 0.03}};
constexpr double pocket_share = 5.0 * 0.020 / (15.0 * 0.060);
// A row's ends and a gap's are known to a sample, 50 um: 4 of them on 20 mm, 2 on 60 mm.
constexpr double tolerance = pocket_share * (4 * 50e-6 / 0.020 + 2 * 50e-6 / 0.060);

TEST(UnseenShare, OfAWholePlateIsNothing) {
  const FitStage fit = fitted(plates({{-0.03, 0.03, -0.03, 0.03}}));
  EXPECT_EQ(unseen(fit), 0.0);
  EXPECT_TRUE(fit.notes.empty());
}

// The pocket's floor is 140 mm from the sensor, which sees to 105 mm.
TEST(UnseenShare, OfAPocketBeyondTheRangeIsItsShareOfTheRows) {
  auto surfaces = plates(pocketed);
  surfaces.push_back(floorAt(-0.06));
  const FitStage fit = fitted(surfaces);
  EXPECT_NEAR(unseen(fit), pocket_share, tolerance);
  ASSERT_EQ(fit.notes.size(), 2U);
  EXPECT_THAT(fit.notes[0], HasSubstr("% no return, 0.0 % table or dropped)"));
  ReportOptions limits;
  limits.note_unseen_share = 0.2;
  // Where nothing was measured is said in any case.
  const FitStage allowed = fitted(surfaces, limits);
  ASSERT_EQ(allowed.notes.size(), 1U);
  EXPECT_THAT(allowed.notes[0], HasSubstr("nothing was measured in 1 place"));
}

TEST(UnseenShare, TheNoteNamesShareAndRemedy) {
  EXPECT_EQ(unseenNote({0.0, 0.0, 0.1, 0.025}, 0.05),
            "12.5 % of the part's rows was not seen as part (0.0 % too near for the sensor, 0.0 % too far, 10.0 % no "
            "return, 2.5 % table or dropped): where that is no hole, sweep the part a second time from another height "
            "or direction");
  EXPECT_THAT(*unseenNote({0.1, 0.0, 0.0, 0.0}, 0.05), HasSubstr("a second time with the sensor higher"));
  EXPECT_THAT(*unseenNote({0.0, 0.1, 0.0, 0.0}, 0.05), HasSubstr("a second time with the sensor lower"));
  EXPECT_THAT(*unseenNote({0.1, 0.1, 0.0, 0.0}, 0.05), HasSubstr("higher for what is too near, and lower for"));
  EXPECT_FALSE(unseenNote({0.0, 0.0, 0.1, 0.025}, 0.2));
}

// The sensor, 80 mm above, sees from 25 mm above to 25 mm below: 50 mm of rows that run 5 mm over the 60 mm on both
// sides. Where a row is cut is known to a cell of ten samples, 0.5 mm, on both sides.
constexpr double slope_share = 10.0 / 70.0;
constexpr double slope_tolerance = 2 * 0.5e-3 / 0.070;

TEST(UnseenShare, ASlopeOutOfTheRangeAlongTheRowsIsToldByItsEnds) {
  const UnseenShare share = shareOf(slope(0.0, M_PI / 4));
  EXPECT_NEAR(share.too_near, slope_share, slope_tolerance);
  EXPECT_NEAR(share.too_far, slope_share, slope_tolerance);
  EXPECT_EQ(share.no_return, 0.0);
  EXPECT_EQ(share.other, 0.0);
}

// The first and the last of 15 rows, 28 mm off the middle, are out of the range whole.
TEST(UnseenShare, ASlopeOutOfTheRangeAcrossTheRowsIsToldByItsRows) {
  const UnseenShare share = shareOf(slope(M_PI / 4, 0.0));
  EXPECT_NEAR(share.too_near, 1.0 / 15.0, slope_tolerance);
  EXPECT_NEAR(share.too_far, 1.0 / 15.0, slope_tolerance);
}

TEST(UnseenShare, ASensorThatDoesNotSayTooNearIsTold) {
  scan::SampleLog log = slope(0.0, M_PI / 4);
  for (double& voltage : log.voltage) voltage = voltage < -5.0 ? 9.0 : voltage;
  const UnseenShare share = shareOf(log);
  EXPECT_NEAR(share.too_near, slope_share, slope_tolerance);
  EXPECT_NEAR(share.too_far, slope_share, slope_tolerance);
}

TEST(UnseenShare, MoreThanItsLimitIsNoSuccess) {
  const FitStage fit = fitted(slope(0.0, M_PI / 4));
  ASSERT_NE(figureOf(fit), nullptr);
  EXPECT_FALSE(figureOf(fit)->pass());
  ASSERT_EQ(fit.notes.size(), 1U);
  EXPECT_THAT(fit.notes[0], HasSubstr("higher for what is too near, and lower for what is too far"));
  ReportOptions holes;
  holes.max_unseen_share = 0.5;
  const FitStage allowed = fitted(slope(0.0, M_PI / 4), holes);
  EXPECT_TRUE(figureOf(allowed)->pass());
}

TEST(UnseenShare, ATableSeenThroughThePartIsTold) {
  auto surfaces = plates(pocketed);
  surfaces.push_back(floorAt(-0.024));
  const FitStage fit = fitted(surfaces);
  EXPECT_NEAR(unseen(fit), pocket_share, tolerance);
  ASSERT_EQ(fit.notes.size(), 1U);
  EXPECT_THAT(fit.notes[0], HasSubstr("0.0 % no return, 11.1 % table or dropped)"));
}

// A slot of 20 mm along the rows, through and through: 5 of 15 rows.
TEST(UnseenShare, MissingRowsCountToo) {
  const FitStage fit = fitted(plates({{-0.03, 0.03, -0.03, -0.01}, {-0.03, 0.03, 0.01, 0.03}}));
  EXPECT_NEAR(unseen(fit), 5.0 / 15.0, 2 * 50e-6 / 0.060);
  EXPECT_EQ(fit.notes.size(), 1U);
}

TEST(UnseenShare, AlternatingPitchesAreNoGap) {
  scan::SampleRows rows;
  rows.spacing = 0.001;
  std::uint32_t index = 0;
  double y = 0.0;
  for (int row = 0; row < 20; ++row) {
    scan::RowPiece piece;
    piece.row = row;
    for (int i = 0; i < 10; ++i) {
      piece.x.push_back(0.001 * i);
      piece.y.push_back(y);
      piece.z.push_back(0.0);
      piece.index.push_back(index++);
    }
    rows.pieces.push_back(piece);
    y += row % 2 == 0 ? 0.001 : 0.004;
  }
  EXPECT_EQ(unseenShare({}, rows, {}, 0.002).sum(), 0.0);
  rows.pieces.erase(rows.pieces.begin() + 5, rows.pieces.begin() + 11);
  EXPECT_GT(unseenShare({}, rows, {}, 0.002).sum(), 0.1);
  EXPECT_EQ(unseenShare({}, {}, {}, 0.002).sum(), 0.0);
}

// A post of 4 mm by 4 mm on a plate, nearer than the sensor sees: little of the part, and all the way in the way.
TEST(UnseenShare, WhatIsTooNearStandsInTheWayAsHighAsTheSensorWent) {
  auto surfaces = plates({{-0.03, 0.03, -0.03, 0.03}});
  surfaces.push_back(
      std::make_shared<geometry::PosedSurface>(std::make_shared<FlatPart>(Rectangle{-0.002, 0.002, -0.002, 0.002}),
                                               geometry::makeFrame({0.0, 0.0, 0.04}, Vector3::Zero())));
  const FitStage fit = fitted(surfaces);
  ASSERT_FALSE(fit.scan.obstacles.empty());
  const Cell cell = makeCell(CellOptions(), source_package);
  const geometry::Frame T_part_scan = cell.T_base_workpiece.inverse() * fit.scan.T_cloud_scan;
  double highest = 0.0;
  for (const auto& obstacle : fit.scan.obstacles) {
    const Vector3 p = T_part_scan * obstacle.cast<double>();
    EXPECT_LT(p.head<2>().cwiseAbs().maxCoeff(), 0.0025);
    highest = std::max(highest, p.z());
  }
  EXPECT_NEAR(highest, 0.08, 1e-3);  // the sensor goes 80 mm above the plate, in the middle of its range
  JobOptions options;
  options.path.ball_radius = 0.005;
  const PathStage path = pathStage(*makePlanner("cutting", options), fit.scan, "base_link", options, {});
  EXPECT_FALSE(path.planned.findings.empty());
  EXPECT_TRUE(fitted(plates({{-0.03, 0.03, -0.03, 0.03}})).scan.obstacles.empty());
}

}  // namespace
}  // namespace scan_to_path::pipeline
