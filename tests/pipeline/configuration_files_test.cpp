// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "scan_to_path/common/text.h"
#include "scan_to_path/pipeline/cell.h"
#include "scan_to_path/pipeline/configuration.h"
#include "scan_to_path/pipeline/job_options.h"
#include "scan_to_path/process/cutting.h"

namespace scan_to_path::pipeline {
namespace {

namespace fs = std::filesystem;

const fs::path source = SCAN_TO_PATH_SOURCE_DIR;

std::set<fs::path> shippedFiles() {
  std::set<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(source / "config")) {
    if (entry.path().extension() == ".yaml") files.insert(entry.path());
  }
  return files;
}

/// Values that differ from the defaults.
std::size_t changes(JobOptions options) {
  JobOptions defaults;
  const auto set = fieldReferences(options);
  const auto unset = fieldReferences(defaults);
  std::size_t count = 0;
  for (std::size_t i = 0; i < set.size(); ++i) count += formatValue(set[i]) != formatValue(unset[i]) ? 1 : 0;
  return count;
}

TEST(ConfigurationFiles, EveryShippedOneMakesAJob) {
  const auto files = shippedFiles();
  ASSERT_GE(files.size(), 2u);
  for (const fs::path& file : files) {
    SCOPED_TRACE(file.filename());
    JobOptions options;
    ASSERT_NO_THROW(applyYaml(fieldReferences(options), readFile(file), file.filename().string()));
    EXPECT_NO_THROW(validate(options, ""));
    EXPECT_NO_THROW(process::validateCutting(options.path, "path"));
    EXPECT_NO_THROW(makeCell(options.cell, {source}));
    EXPECT_GT(changes(options), 0u);
  }
}

}  // namespace
}  // namespace scan_to_path::pipeline
