// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/verification/path_deviation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scan_to_path/geometry/height_field.h"
#include "scan_to_path/geometry/worlds.h"
#include "support/expect_input_error.h"
#include "support/paths.h"
#include "support/surface_oracle.h"

namespace scan_to_path::verification {
namespace {

using geometry::Vector3;

/// Rows on the S part, exact, with every contact moved by `off` along its normal and tilted by `tilt`.
toolpath::ToolPath rowsOnSPart(double off, double tilt) {
  const geometry::SPart part;
  toolpath::ToolPath path = test::planeRows(5, 0.03, 0.2, 40);
  for (auto& segment : path.segments) {
    for (auto& waypoint : segment.waypoints) {
      const Vector3 xy = waypoint.pose.translation() + Vector3(0.02, 0.02, 0.0);
      const auto at = part.at(xy.x(), xy.y());
      waypoint.pose = toolpath::contactFrame(at.point + off * at.normal, at.normal, Vector3::UnitX());
      waypoint.pose = waypoint.pose * Eigen::AngleAxisd(tilt, Vector3(1.0, 1.0, 0.0).normalized());
    }
  }
  return path;
}

TEST(PathDeviation, IsZeroOnTheSurface) {
  const auto deviation = measureDeviation(rowsOnSPart(0.0, 0.0), geometry::SPart());
  EXPECT_EQ(deviation.contacts, 205U);
  EXPECT_LT(deviation.largest, 1e-12);
  EXPECT_LT(deviation.normal_largest, 1e-9);
}

TEST(PathDeviation, MeasuresOffsetsWithTheirSign) {
  for (const double off : {3e-5, -3e-5}) {
    const auto deviation = measureDeviation(rowsOnSPart(off, 0.0), geometry::SPart());
    EXPECT_NEAR(deviation.mean, off, 1e-11);
    EXPECT_NEAR(deviation.rms, 3e-5, 1e-11);
    EXPECT_NEAR(deviation.largest, 3e-5, 1e-11);
  }
}

TEST(PathDeviation, MeasuresTiltedNormals) {
  const auto deviation = measureDeviation(rowsOnSPart(0.0, 0.01), geometry::SPart());
  EXPECT_NEAR(deviation.normal_mean, 0.01, 1e-9);
  EXPECT_NEAR(deviation.normal_rms, 0.01, 1e-9);
  EXPECT_LT(deviation.largest, 1e-12);
}

TEST(PathDeviation, NamesTheWorstContact) {
  toolpath::ToolPath path = rowsOnSPart(0.0, 0.0);
  path.segments[3].waypoints[17].pose.translation().z() += 1e-4;
  path.segments[1].waypoints[5].pose = path.segments[1].waypoints[5].pose * Eigen::AngleAxisd(0.02, Vector3::UnitX());
  const auto deviation = measureDeviation(path, geometry::SPart());
  EXPECT_EQ(deviation.largest_at.segment, 3);
  EXPECT_EQ(deviation.largest_at.index, 17);
  EXPECT_EQ(deviation.normal_largest_at.segment, 1);
  EXPECT_EQ(deviation.normal_largest_at.index, 5);
  EXPECT_GT(deviation.largest, 8e-5);  // one part in many: the RMS hides it
  EXPECT_LT(deviation.rms, 1e-5);
}

TEST(PathDeviation, LeavesOutWhatIsInTheAir) {
  toolpath::ToolPath path = rowsOnSPart(0.0, 0.0);
  toolpath::Waypoint high = path.segments[0].waypoints[0];
  high.pose.translation().z() += 0.1;
  path.segments[0].waypoints.insert(path.segments[0].waypoints.begin(), high);
  path.segments.push_back({"retract", {high}});
  const auto deviation = measureDeviation(path, geometry::SPart());
  EXPECT_EQ(deviation.contacts, 205U);
  EXPECT_LT(deviation.largest, 1e-12);
}

TEST(PathDeviation, TakesTheReferencesFrameIntoAccount) {
  Random random(1);
  const Frame T_path_reference = test::randomFrame(random);
  const toolpath::ToolPath path = test::moved(rowsOnSPart(2e-5, 0.003), T_path_reference);
  const auto deviation = measureDeviation(path, geometry::SPart(), T_path_reference.inverse());
  EXPECT_NEAR(deviation.rms, 2e-5, 1e-10);
  EXPECT_NEAR(deviation.normal_mean, 0.003, 1e-9);
  // Twin: the transform taken the wrong way round is noticed.
  EXPECT_GT(measureDeviation(path, geometry::SPart(), T_path_reference).rms, 1e-2);
}

TEST(PathDeviation, RejectsPathsThatDoNotWork) {
  test::expectInputError([] { measureDeviation({}, geometry::Plane()); }, "no move of the path works");
}

}  // namespace
}  // namespace scan_to_path::verification
