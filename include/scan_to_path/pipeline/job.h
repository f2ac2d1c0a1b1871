// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scan_to_path/common/progress.h"
#include "scan_to_path/geometry/surface.h"
#include "scan_to_path/pipeline/input.h"
#include "scan_to_path/pipeline/job_options.h"
#include "scan_to_path/pipeline/report.h"

namespace scan_to_path::pipeline {

/// The stages of a job in order; also where it may be told to stop.
enum class Stage { scan, fit, path, motion, program };

/// What the robot program is written as.
enum class Output { abb, pulses };

/// One run from an input file to the files of a result.
struct JobRequest {
  std::string process = "cutting";
  std::filesystem::path input;
  std::optional<InputKind> input_kind;  ///< by content when not given
  std::optional<Units> units;           ///< of clouds and meshes; metres, checked for plausibility, when not given
  Stage stop_after = Stage::program;
  int threads = 1;         ///< 0: all
  std::uint64_t seed = 1;  ///< written to the report; cutting draws no random numbers
  std::filesystem::path out;
  /// Leave out waypoints that fail and write a program of the rest (partialStage); the exit status stays 1. Tolerances
  /// and read-backs that fail are never overridden.
  bool allow_partial = false;
  std::vector<Output> outputs = {Output::abb, Output::pulses};
  std::vector<std::filesystem::path> package_path;
  /// The true surface in base_link, for verification after planning only; null: none known.
  std::shared_ptr<const geometry::Surface> reference;
};

struct JobResult {
  int exit = 0;                      ///< 0, or 1 when a waypoint, a tolerance or a read-back fails
  std::vector<std::string> summary;  ///< what a user wants to know, a line each
};

/// Runs the job and writes its files into request.out, whole or not at all. Throws InputError (exit status 2, an older
/// result is left alone) and Interrupted (130).
JobResult runJob(const JobRequest& request, const JobOptions& options, const Progress& progress);

class StageRunner;
struct Cell;

/// The same with the stages run by `stages`; options are valid (validateJob), `cell` is made from them. Throws Rejected
/// when `stages` does not accept what was planned.
JobResult runJob(const JobRequest& request, const JobOptions& options, const Cell& cell, StageRunner& stages,
                 const Progress& progress);

/// Throws InputError for an option out of range, naming it.
void validateJob(const JobOptions& options);

}  // namespace scan_to_path::pipeline

namespace scan_to_path {
template <>
struct EnumNames<pipeline::Stage> {
  static constexpr std::array<const char*, 5> names = {"scan", "fit", "path", "motion", "program"};
};
template <>
struct EnumNames<pipeline::Output> {
  static constexpr std::array<const char*, 2> names = {"abb", "pulses"};
};
}  // namespace scan_to_path
