// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/report.h"

#include <Eigen/Core>
#include <algorithm>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>

#include "scan_to_path/common/text.h"
#include "scan_to_path/common/version.h"

namespace scan_to_path::pipeline {
namespace {

using Json = nlohmann::ordered_json;

/// Nine significant digits: more than any figure deserves, few enough to read. JSON has no NaN or infinity.
Json number(double value) {
  if (!std::isfinite(value)) return nullptr;
  char text[32];
  std::snprintf(text, sizeof(text), "%.8e", value);
  double rounded = 0.0;
  parseNumber(text, rounded);
  return rounded;
}

struct ToJson {
  Json operator()(const bool* value) const { return *value; }
  Json operator()(const int* value) const { return *value; }
  Json operator()(const double* value) const { return *value; }
  Json operator()(const std::optional<double>* value) const { return *value ? Json(**value) : Json(); }
  Json operator()(const std::string* value) const { return *value; }
  Json operator()(const Eigen::Vector3d* value) const { return {value->x(), value->y(), value->z()}; }
  Json operator()(const std::vector<double>* value) const { return *value; }
  Json operator()(const std::vector<std::string>* value) const { return *value; }
  Json operator()(const std::vector<Eigen::Vector2d>* value) const {
    Json points = Json::array();
    for (const auto& point : *value) points.push_back({point.x(), point.y()});
    return points;
  }
  Json operator()(const EnumReference& value) const { return value.names[value.get()]; }
};

Json configJson(const std::vector<FieldReference>& config) {
  Json root = Json::object();
  for (const auto& field : config) {
    Json* node = &root;
    for (const auto& part : split(field.path, '.')) node = &(*node)[std::string(part)];
    *node = std::visit(ToJson(), field.value);
  }
  return root;
}

Json stageJson(const StageReport& stage) {
  Json dropped = Json::object();
  for (const auto& entry : stage.dropped) dropped[entry.reason] = entry.count;
  return {{"name", stage.name}, {"in", stage.in}, {"out", stage.out}, {"dropped", dropped}};
}

Json accuracyJson(const std::vector<Accuracy>& figures) {
  Json root = Json::object();
  for (const auto& figure : figures) {
    Json entry = {{"value", number(figure.value)}, {"unit", figure.unit}};
    if (figure.limit) {
      entry["limit"] = number(*figure.limit);
      entry["pass"] = figure.pass();
    }
    root[figure.name] = entry;
  }
  return root;
}

Json verdictJson(const std::string& segment, const toolpath::WaypointVerdict& verdict) {
  return {{"segment", segment},
          {"index", verdict.index},
          {"verdict", enumName(verdict.verdict)},
          {"margin", number(verdict.margin)},
          {"unit", verdict.unit},
          {"reason", verdict.reason},
          {"remedy", verdict.remedy}};
}

Json waypointJson(const toolpath::ToolPath& path, const toolpath::WaypointVerdict& verdict) {
  return verdictJson(path.segments[static_cast<std::size_t>(verdict.segment)].name, verdict);
}

/// A verdict of its own only where the waypoint itself fails; else the one on what it is left out for.
Json leftOutJson(const LeftOut& left_out) {
  Json entry = {{"segment", left_out.segment}, {"index", left_out.index}};
  if (left_out.kind == LeftOutKind::fails) {
    entry = verdictJson(left_out.segment, left_out.verdict);
  } else {
    entry["reason"] = left_out.reason;
    entry["caused_by"] = verdictJson(left_out.caused_by, left_out.verdict);
  }
  entry["kind"] = enumName(left_out.kind);
  entry["x"] = number(left_out.position.x());
  entry["y"] = number(left_out.position.y());
  entry["z"] = number(left_out.position.z());
  return entry;
}

Json boxJson(const Eigen::AlignedBox3d& box) {
  Json corners = Json::object();
  for (const auto& [name, corner] : {std::pair("min", box.min()), std::pair("max", box.max())}) {
    corners[name] = {number(corner.x()), number(corner.y()), number(corner.z())};
  }
  return corners;
}

/// null without contacts.
Json placeJson(const PathPlace& place) {
  if (place.isEmpty()) return nullptr;
  return {{"frame", place.frame}, {"box", boxJson(place.in_frame)}, {"work_object", boxJson(place.in_work_object)}};
}

Json versionsJson() {
  return {{"scan_to_path", version},
          {"eigen", std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) + "." +
                        std::to_string(EIGEN_MINOR_VERSION)}};
}

}  // namespace

bool fails(const std::vector<Accuracy>& figures, const std::string& name) {
  return std::any_of(figures.begin(), figures.end(),
                     [&](const Accuracy& figure) { return figure.name == name && !figure.pass(); });
}

std::optional<std::string> worstPlaceNote(const std::vector<Accuracy>& figures, const std::string& name,
                                          const toolpath::ToolPath& path, const toolpath::WaypointIndex& at) {
  if (!fails(figures, name)) return std::nullopt;
  return name + " is largest at " + path.segments[static_cast<std::size_t>(at.segment)].name + " waypoint " +
         std::to_string(at.index) + (name == "chord_error" ? ", on the move that leads to it" : "");
}

std::string formatReport(const Report& report, const std::vector<FieldReference>& config,
                         const toolpath::ToolPath& path, const std::vector<toolpath::WaypointVerdict>& verdicts) {
  Json stages = Json::array();
  for (const auto& stage : report.stages) stages.push_back(stageJson(stage));
  Json waypoints = Json::array();
  std::size_t ok = 0;
  for (const auto& verdict : verdicts) {
    waypoints.push_back(waypointJson(path, verdict));
    if (verdict.verdict == toolpath::Verdict::ok) ++ok;
  }
  Json left_out = Json::array();
  for (const auto& waypoint : report.left_out) left_out.push_back(leftOutJson(waypoint));
  const Json summary = {{"ok", ok},
                        {"failed", verdicts.size() - ok},
                        {"left_out", report.left_out.size()},
                        {"left_out_share", number(report.left_out_share)},
                        {"exit", report.exit}};
  const Json root = {{"schema", "scan_to_path report 1"},
                     {"process", report.process},
                     {"input",
                      {{"file", report.input_file},
                       {"sha256", report.input_sha256},
                       {"kind", report.input_kind},
                       {"frame", report.input_frame},
                       {"units", report.input_units}}},
                     {"seed", report.seed},
                     {"versions", versionsJson()},
                     {"config", configJson(config)},
                     {"stages", stages},
                     {"accuracy", accuracyJson(report.accuracy)},
                     {"notes", report.notes},
                     {"place", placeJson(report.place)},
                     {"waypoints", waypoints},
                     {"left_out", left_out},
                     {"summary", summary}};
  return root.dump(1, ' ', true, Json::error_handler_t::replace) + "\n";
}

}  // namespace scan_to_path::pipeline
