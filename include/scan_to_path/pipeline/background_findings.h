// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scan_to_path/pipeline/report.h"
#include "scan_to_path/scan/background.h"

namespace scan_to_path::pipeline {

/// What was taken for the table behind the part, and where the user should look whether it is.
struct BackgroundFindings {
  Accuracy share;                  ///< background_share, of all samples
  std::vector<std::string> notes;  ///< most of the scan went with the table, or much of the part may be one
};

/// `rows` are the clean ones that the scan was fitted to.
BackgroundFindings backgroundFindings(const scan::FittedScan& scan, const scan::SampleRows& rows,
                                      const scan::BackgroundOptions& options);

}  // namespace scan_to_path::pipeline
