// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "scan_to_path/pipeline/input.h"
#include "scan_to_path/pipeline/job.h"
#include "scan_to_path/pipeline/stages.h"

namespace scan_to_path::pipeline {

/// What a scan was taken from, as the report says it.
struct JobInput {
  std::string name;    ///< of the file, without directories
  std::string sha256;  ///< of its bytes
  InputKind kind = InputKind::samples;
  Units units = Units::m;
  std::optional<program::ProgramFile> record = std::nullopt;  ///< keeps the scan where the user has no file of it yet
};

/// Runs the stages of a job in their order. Here they run in this process; who has them run elsewhere overrides them.
/// path() and motion() are asked for the whole path only: what partialStage plans again, without what fails, is always
/// planned in this process.
/// All throw as the stage functions do.
class StageRunner {
public:
  StageRunner(const JobRequest& request, const JobOptions& options, const Cell& cell)
      : request_(request), options_(options), cell_(cell) {}
  virtual ~StageRunner() = default;
  StageRunner(const StageRunner&) = delete;
  StageRunner& operator=(const StageRunner&) = delete;

  /// Reads what the scan is taken from.
  virtual void read(const Progress&) {}
  virtual ScanStage scan(const Progress& progress) = 0;

  /// What the scan was taken from. Asked for last: a file that keeps it is work that no stage waits for.
  virtual JobInput input(const ScanStage& scanned) = 0;

  virtual FitStage fit(const ScanStage& scanned, const Progress& progress) {
    return fitStage(scanned, options_.scan, options_.fit, options_.report, request_.threads, progress);
  }
  virtual PathStage path(const process::Planner& planner, const FitStage& fitted, const Progress& progress) {
    return pathStage(planner, fitted.scan, options_.cell.base_link, options_, progress);
  }
  virtual MotionStage motion(const PathStage& driven, const Progress& progress) {
    return motionStage(driven, cell_, options_, progress);
  }

  /// Asked once, before anything is written: whether what was planned is wanted. May wait for somebody who looks at it.
  virtual bool accepts(const Progress&) { return true; }

protected:
  const JobRequest& request_;
  const JobOptions& options_;
  const Cell& cell_;
};

/// Takes the scan from request.input: a sample log or a cloud.
class FileRunner : public StageRunner {
public:
  using StageRunner::StageRunner;
  void read(const Progress& progress) override;
  ScanStage scan(const Progress& progress) override;
  JobInput input(const ScanStage&) override { return input_; }

private:
  JobInput input_;
  std::string content_;
  scan::SampleLog log_;
};

}  // namespace scan_to_path::pipeline
