// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "scan_to_path/common/text.h"
#include "scan_to_path/pipeline/job.h"
#include "scan_to_path/scan/sample_log.h"
#include "small_scan.h"

namespace scan_to_path::pipeline {

/// Jobs on a sample log of the small part, samples.csv, in a directory of their own.
class JobTest : public ::testing::Test {
protected:
  static void SetUpTestSuite() {
    directory_ = new std::filesystem::path(freshDirectory("job"));
    std::ofstream(*directory_ / "samples.csv") << scan::formatSampleLog(smallScan());
  }
  static void TearDownTestSuite() {
    std::filesystem::remove_all(*directory_);
    delete directory_;
  }

  static JobRequest request(const std::string& out) {
    JobRequest request;
    request.input = *directory_ / "samples.csv";
    request.out = *directory_ / out;
    request.package_path = source_package;
    return request;
  }
  static std::string file(const JobRequest& request, const std::string& name) { return readFile(request.out / name); }
  static std::set<std::string> files(const JobRequest& request) {
    std::set<std::string> names;
    if (!std::filesystem::exists(request.out)) return names;
    for (const auto& entry : std::filesystem::directory_iterator(request.out)) names.insert(entry.path().filename());
    return names;
  }
  static std::string errorOf(const JobRequest& request, const JobOptions& options = {}) {
    try {
      runJob(request, options, {});
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }

  static inline std::filesystem::path* directory_ = nullptr;
};

}  // namespace scan_to_path::pipeline
