// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scan_to_path/pipeline/configuration.h"
#include "scan_to_path/pipeline/path_place.h"
#include "scan_to_path/scan/fitted_scan.h"
#include "scan_to_path/toolpath/tool_path.h"
#include "scan_to_path/toolpath/verdict.h"

namespace scan_to_path::pipeline {

using geometry::Vector3;

/// What a stage took, gave and left out.
struct StageReport {
  std::string name;
  std::size_t in = 0;
  std::size_t out = 0;
  std::vector<scan::Dropped> dropped;
};

/// A measured figure; with a limit it passes or fails the job.
struct Accuracy {
  std::string name;
  double value = 0.0;
  std::string unit;
  std::optional<double> limit = std::nullopt;  ///< the value must not exceed it

  bool pass() const { return !limit || value <= *limit; }
};

/// The limit that an option sets; 0 stands for none.
inline std::optional<double> limitUnlessZero(double limit) {
  return limit > 0.0 ? std::optional<double>(limit) : std::nullopt;
}

/// True when there is a figure of that name and it exceeds its limit.
bool fails(const std::vector<Accuracy>& figures, const std::string& name);

/// Says where a figure that fails is largest: at a waypoint, or on the move that leads to it. Nothing when it passes.
std::optional<std::string> worstPlaceNote(const std::vector<Accuracy>& figures, const std::string& name,
                                          const toolpath::ToolPath& path, const toolpath::WaypointIndex& at);

/// How a waypoint comes to be left out: it fails, the way to or from the row's end that it is at does, or it goes with
/// others that are left out.
enum class LeftOutKind { fails, way_fails, with_others };

/// A waypoint of the planned path that is not driven, and why. Segments and indices are those of the path as planned,
/// which is not the one that is written.
struct LeftOut {
  std::string segment;  ///< name
  int index = 0;
  Vector3 position = Vector3::Zero();  ///< of the contact, in the path's frame [m]
  LeftOutKind kind = LeftOutKind::fails;
  toolpath::WaypointVerdict verdict;  ///< its own when it fails itself, else on what it is left out for
  std::string caused_by;              ///< name of the verdict's segment
  std::string reason;                 ///< why it is left out although it does not fail itself; else empty
};

/// Everything report.json holds (docs/report.schema.json). Nothing in it depends on time, host or thread count.
struct Report {
  std::string process;
  std::string input_file;  ///< name without directories
  std::string input_sha256;
  std::string input_kind;
  std::string input_frame;
  std::string input_units;
  std::uint64_t seed = 0;
  std::vector<StageReport> stages;
  std::vector<Accuracy> accuracy;
  PathPlace place;                 ///< of the path that is driven
  std::vector<LeftOut> left_out;   ///< of a partial path, in the planned path's order; empty: all is driven
  double left_out_share = 0.0;     ///< of the planned cutting length
  std::vector<std::string> notes;  ///< what the user should know and no figure says
  int exit = 0;
};

/// The text of report.json. `path` names the segments that `verdicts` refer to; `config` is written out whole.
std::string formatReport(const Report& report, const std::vector<FieldReference>& config,
                         const toolpath::ToolPath& path, const std::vector<toolpath::WaypointVerdict>& verdicts);

}  // namespace scan_to_path::pipeline

namespace scan_to_path {
template <>
struct EnumNames<pipeline::LeftOutKind> {
  static constexpr std::array<const char*, 3> names = {"fails", "way_fails", "with_others"};
};
}  // namespace scan_to_path
