// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/common/progress.h"

#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <utility>
#include <vector>

namespace scan_to_path {
namespace {

TEST(Progress, DefaultIsSilent) {
  const Progress progress;
  EXPECT_NO_THROW(progress.update("fit", 0.5));
  EXPECT_NO_THROW(progress.checkCancelled());
}

TEST(Progress, ReportsStageAndFraction) {
  using Reports = std::vector<std::pair<std::string, double>>;
  Reports reports;
  const Progress progress([&](const std::string& stage, double fraction) { reports.emplace_back(stage, fraction); });
  const Progress copy = progress;
  copy.update("scan", 0.0);
  copy.update("scan", 1.0);
  EXPECT_EQ(reports, (Reports{{"scan", 0.0}, {"scan", 1.0}}));
}

TEST(Progress, CancelStopsBeforeTheReport) {
  std::atomic<bool> cancelled = false;
  int reports = 0;
  const Progress progress([&](const std::string&, double) { ++reports; }, &cancelled);
  progress.update("fit", 0.1);
  cancelled = true;
  EXPECT_THROW(progress.update("fit", 0.2), Interrupted);
  EXPECT_THROW(progress.checkCancelled(), Interrupted);
  EXPECT_EQ(reports, 1);
}

}  // namespace
}  // namespace scan_to_path
