// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/background_findings.h"

#include <gmock/gmock.h>

#include <cmath>

#include "scan_to_path/scan/fit_scan.h"
#include "support/raster_scan.h"

namespace scan_to_path::pipeline {
namespace {

using ::testing::HasSubstr;

/// What is found of a cap 60 mm wide that stands `raised` on a table of 100 mm by 84 mm.
BackgroundFindings findingsOf(double raised, const scan::BackgroundOptions& options = {}) {
  test::RasterScan raster;
  raster.x_min = -0.05;
  raster.x_max = 0.05;
  raster.rows = test::evenRows(-0.042, 0.004, 22);
  raster.spacing = 1e-4;
  raster.noise = 2e-6;
  raster.T_cloud_scan.translation().z() = 0.45;
  const auto cap = [raised](double x, double y) {
    return std::hypot(x, y) < 0.03 ? raised + std::sqrt(0.05 * 0.05 - x * x - y * y) - 0.04 : 0.0;
  };
  scan::ScanOptions cleaning;
  cleaning.background = options;
  const auto rows = scan::cleanRows(scanRaster(raster, cap), -Vector3::UnitZ(), cleaning);
  scan::FittedScan scan;
  scan.samples_in = rows.samples_in;
  scan.dropped = rows.dropped;
  return backgroundFindings(scan, rows, options);
}

TEST(BackgroundFindings, ATableThatIsMachinedIsNoted) {
  const auto found = findingsOf(0.0);
  EXPECT_EQ(found.share.name, "background_share");
  EXPECT_EQ(found.share.value, 0.0);
  ASSERT_EQ(found.notes.size(), 1U);
  EXPECT_THAT(found.notes[0], HasSubstr("scan.background.mode=height and scan.background.height=0.4500"));
}

TEST(BackgroundFindings, ATableThatIsGoneIsAShare) {
  const auto found = findingsOf(0.003);
  EXPECT_GT(found.share.value, 0.5);
  EXPECT_LT(found.share.value, 0.8);
  ASSERT_EQ(found.notes.size(), 1U);
  EXPECT_THAT(found.notes[0], HasSubstr("were taken for a table behind the part"));
}

TEST(BackgroundFindings, WhoeverHasSaidItIsToldNothing) {
  scan::BackgroundOptions options;
  options.mode = scan::BackgroundMode::none;
  EXPECT_TRUE(findingsOf(0.0, options).notes.empty());
}

}  // namespace
}  // namespace scan_to_path::pipeline
