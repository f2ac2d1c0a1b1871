// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/stage_runner.h"

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path::pipeline {

void FileRunner::read(const Progress& progress) {
  progress.update("read", 0.0);
  content_ = readFile(request_.input);
  input_.name = request_.input.filename().string();
  input_.sha256 = sha256(content_);
  input_.kind = request_.input_kind ? *request_.input_kind : detectInput(content_, input_.name);
  input_.units = request_.units.value_or(Units::m);
  if (input_.kind != InputKind::samples) return;
  if (request_.units) throw InputError("--units: " + input_.name + " is a sample log, which has its own units");
  log_ = scan::parseSampleLog(content_, input_.name);
  content_ = std::string();
}

ScanStage FileRunner::scan(const Progress& progress) {
  if (input_.kind == InputKind::samples) {
    const scan::SampleLog log = std::move(log_);  // not needed any more
    return scanFromSamples(log, cell_, options_.scan, options_.report, request_.threads, progress);
  }
  if (input_.kind == InputKind::cloud) {
    return scanFromCloud(content_, input_.name, input_.units, request_.units.has_value(), options_.scan);
  }
  throw InputError(input_.name + ": is a " + enumName(input_.kind) + "; " + request_.process +
                   " plans from a scan: a sample log or a cloud (scan a mesh with: scan_to_path emulate --workpiece " +
                   input_.name + ")");
}

}  // namespace scan_to_path::pipeline
