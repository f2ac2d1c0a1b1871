// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/timing.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace scan_to_path::pipeline {
namespace {

TEST(Timing, StagesAddUpToTheTotal) {
  Timing timing;
  timing.mark("scan");
  timing.mark("fit");
  const auto json = nlohmann::json::parse(timing.format(2, "in.csv", "out"));
  const double sum = json["stages_s"]["scan"].get<double>() + json["stages_s"]["fit"].get<double>();
  EXPECT_GE(json["stages_s"]["scan"].get<double>(), 0.0);
  EXPECT_LE(sum, json["total_s"].get<double>());
  EXPECT_EQ(json["threads"], 2);
  EXPECT_GT(json["peak_memory_bytes"].get<double>(), 1e5);
  EXPECT_EQ(json["input"].get<std::string>().front(), '/');
}

}  // namespace
}  // namespace scan_to_path::pipeline
