// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/summary.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "scan_to_path/common/text.h"

namespace scan_to_path::pipeline {
namespace {

constexpr std::size_t listed_waypoints = 5;

const Accuracy* find(const Report& report, const std::string& name) {
  const auto found = std::find_if(report.accuracy.begin(), report.accuracy.end(),
                                  [&](const auto& figure) { return figure.name == name; });
  return found == report.accuracy.end() ? nullptr : &*found;
}

/// A figure in the unit in which people speak of it, with so many digits more than they care for.
std::string shown(double value, const std::string& unit, int more = 0) {
  if (unit == "m" && std::abs(value) < 1e-8) return fixed(1e9 * value, 2 + more) + " nm";
  if (unit == "m" && std::abs(value) < 1e-4) return fixed(1e6 * value, 2 + more) + " um";
  if (unit == "m" && std::abs(value) < 1.0) return fixed(1e3 * value, 3 + more) + " mm";
  if (unit == "m") return fixed(value, 3 + more) + " m";
  if (unit == "m^2") return fixed(1e6 * value, 1 + more) + " mm^2";
  if (unit == "rad") return fixed(value * 180.0 / M_PI, (std::abs(value) < 1e-6 ? 9 : 5) + more) + " deg";
  if (unit == "s" && std::abs(value) < 1.0) return fixed(1e3 * value, 3 + more) + " ms";
  if (unit == "s") return fixed(value, 1 + more) + " s";
  return fixed(value, value == std::floor(value) ? 0 : 4 + more);
}

/// A figure that fails and its limit, with digits enough to tell one from the other.
std::string failureText(const Accuracy& figure) {
  constexpr int most_digits = 12;
  int more = 0;
  while (more < most_digits && shown(figure.value, figure.unit, more) == shown(*figure.limit, figure.unit, more))
    ++more;
  return figure.name + " is " + shown(figure.value, figure.unit, more) + ", limit " +
         shown(*figure.limit, figure.unit, more);
}

/// "text value" for the figures that are there, separated by commas.
std::string figures(const Report& report, const std::vector<std::pair<std::string, std::string>>& names) {
  std::string line;
  for (const auto& [name, text] : names) {
    const Accuracy* figure = find(report, name);
    if (figure == nullptr) continue;
    line += (line.empty() ? "" : ", ") + (text.empty() ? "" : text + " ") + shown(figure->value, figure->unit);
  }
  return line;
}

void add(std::vector<std::string>& lines, const std::string& heading, const std::string& text) {
  if (!text.empty()) lines.push_back(heading + std::string(heading.size() < 10 ? 10 - heading.size() : 1, ' ') + text);
}

std::string stageText(const StageReport& stage) {
  std::string text = std::to_string(stage.in) + " in, " + std::to_string(stage.out) + " out";
  for (const auto& entry : stage.dropped) text += ", " + std::to_string(entry.count) + " " + entry.reason;
  return text;
}

void addFailures(std::vector<std::string>& lines, const Report& report, const toolpath::ToolPath& path,
                 const std::vector<toolpath::WaypointVerdict>& verdicts) {
  for (const auto& figure : report.accuracy) {
    if (figure.pass()) continue;
    add(lines, "FAILED", failureText(figure));
  }
  std::map<toolpath::Verdict, std::size_t> failed;
  std::size_t listed = 0;
  for (const auto& verdict : verdicts) {
    if (verdict.verdict == toolpath::Verdict::ok) continue;
    ++failed[verdict.verdict];
    if (++listed > listed_waypoints) continue;
    add(lines, "FAILED",
        path.segments[static_cast<std::size_t>(verdict.segment)].name + " waypoint " + std::to_string(verdict.index) +
            ": " + enumName(verdict.verdict) + ": " + verdict.reason + "; " + verdict.remedy);
  }
  for (const auto& [verdict, count] : failed) {
    add(lines, "FAILED",
        std::to_string(count) + " of " + std::to_string(verdicts.size()) + " waypoints: " + enumName(verdict));
  }
}

std::string leftOutText(const LeftOut& left_out) {
  const std::string verdict =
      std::string(enumName(left_out.verdict.verdict)) + ": " + left_out.verdict.reason + "; " + left_out.verdict.remedy;
  if (left_out.kind == LeftOutKind::fails) return verdict;
  return left_out.reason + ", " + left_out.caused_by + " waypoint " + std::to_string(left_out.verdict.index) + " " +
         verdict;
}

/// What a partial path does without: how much, then the first waypoint that fails with each verdict, and the first of
/// those that do not fail themselves.
void addLeftOut(std::vector<std::string>& lines, const Report& report) {
  if (report.left_out.empty()) return;
  add(lines, "LEFT OUT",
      std::to_string(report.left_out.size()) + " waypoints, " + fixed(100.0 * report.left_out_share, 2) +
          " % of the planned cutting length: PARTIAL, the part is not finished; see report.json");
  std::map<std::pair<LeftOutKind, std::string>, std::pair<std::size_t, const LeftOut*>> kinds;
  for (const auto& left_out : report.left_out) {
    const bool fails = left_out.kind == LeftOutKind::fails;
    const std::string text = fails ? enumName(left_out.verdict.verdict) : left_out.reason;
    auto& [count, first] = kinds[{left_out.kind, text}];
    if (count++ == 0) first = &left_out;
  }
  for (const auto& [key, kind] : kinds) {
    const LeftOut& first = *kind.second;
    const std::string what = first.kind == LeftOutKind::fails ? key.second : "that do not fail themselves";
    add(lines, "LEFT OUT",
        std::to_string(kind.first) + " " + what + ", the first " + first.segment + " waypoint " +
            std::to_string(first.index) + ": " + leftOutText(first));
  }
}

/// What no row reaches: the summary's own line, where there is any.
std::string uncoveredText(const Report& report) {
  const Accuracy* area = find(report, "path_uncovered_area");
  const Accuracy* share = find(report, "path_uncovered_share");
  if (area == nullptr || share == nullptr || area->value <= 0.0) return "";
  return shown(area->value, area->unit) + ", " + fixed(100.0 * share->value, 2) + " % of the part's outline";
}

/// How well lines and surface hold the samples, and how much of the rows the figure between them covers.
std::string accuracyText(const Report& report) {
  std::string text = figures(
      report,
      {{"line_residual_rms", "lines fit to RMS"}, {"line_noise", "noise"}, {"surface_residual_rms", "surface to RMS"}});
  const Accuracy* share = find(report, "between_rows_share");
  const double covered = share == nullptr ? 1.0 : share->value;
  if (covered <= 0.0) return text + ", between rows unknown";
  const std::string between = figures(report, {{"between_rows_rms", "between rows RMS"}});
  if (!between.empty()) text += (text.empty() ? "" : ", ") + between;
  if (covered < 1.0) text += " (over " + fixed(100.0 * covered, 1) + " % of them)";
  return text;
}

/// What was planned and, of a partial path, the share of it that is not driven.
std::string pathText(const Report& report) {
  std::string text = figures(report, {{"path_rows", "rows"},
                                      {"path_row_distance_median", "apart"},
                                      {"path_scallop", "scallop"},
                                      {"path_waypoints", "waypoints"},
                                      {"path_cutting_length", "cutting"}});
  if (!report.left_out.empty()) text += ", left out " + fixed(100.0 * report.left_out_share, 2) + " % of the cutting";
  return text;
}

}  // namespace

std::vector<std::string> summarise(const Report& report, const toolpath::ToolPath& path,
                                   const std::vector<toolpath::WaypointVerdict>& verdicts) {
  std::vector<std::string> lines;
  for (const auto& stage : report.stages) {
    if (stage.name == "scan" || stage.name == "fit") add(lines, stage.name, stageText(stage));
  }
  add(lines, "clocks",
      figures(report, {{"clock_offset", "sensor against encoders"}, {"clock_offset_standard_error", "+-"}}));
  add(lines, "accuracy", accuracyText(report));
  add(lines, "path", pathText(report));
  add(lines, "place", placeText(report.place));
  add(lines, "uncovered", uncoveredText(report));
  add(lines, "reference",
      figures(report, {{"reference_path_rms", "path off it RMS"},
                       {"reference_path_largest", "max"},
                       {"reference_normal_mean", "normals mean"},
                       {"reference_normal_largest", "max"},
                       {"reference_scallop_largest", "scallop max"}}));
  add(lines, "motion",
      figures(report, {{"duration", "takes"},
                       {"playback_position", "played back within"},
                       {"playback_angle", ""},
                       {"chord_error", "chord error"}}));
  for (const auto& note : report.notes) add(lines, "note", note);
  addLeftOut(lines, report);
  addFailures(lines, report, path, verdicts);
  return lines;
}

}  // namespace scan_to_path::pipeline
