// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "rviz/job_choice.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <sstream>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path_rviz {
namespace {

using scan_to_path::InputError;

constexpr const char* region_forms = "x_min x_max y_min y_max, or corners such as 0 0, 0.1 0, 0.1 0.05";

std::vector<double> numbersOf(std::string_view text) {
  std::istringstream words{std::string(text)};
  std::vector<double> numbers;
  for (std::string word; words >> word;) {
    double number = 0.0;
    if (!scan_to_path::parseNumber(word, number)) throw InputError("region", "text", "\"" + word + "\"", region_forms);
    numbers.push_back(number);
  }
  return numbers;
}

YAML::Node parsed(const std::string& yaml) {
  try {
    YAML::Node root = YAML::Load(yaml);
    if (root.IsNull()) return YAML::Node(YAML::NodeType::Map);
    const bool has_sections = root.IsMap() && (!root["path"] || root["path"].IsMap() || root["path"].IsNull());
    if (!has_sections) throw InputError("options: must be sections of keys");
    return root;
  } catch (const YAML::Exception& error) {
    throw InputError("options line " + std::to_string(error.mark.line + 1) + ": not YAML: " + error.msg);
  }
}

YAML::Node listOf(const std::vector<Eigen::Vector2d>& corners) {
  YAML::Node list;
  for (const auto& corner : corners) {
    YAML::Node point;
    point.push_back(corner.x());
    point.push_back(corner.y());
    list.push_back(point);
  }
  list.SetStyle(YAML::EmitterStyle::Flow);
  return list;
}

}  // namespace

std::vector<Eigen::Vector2d> parseRegion(const std::string& text) {
  if (scan_to_path::trimmed(text).empty()) return {};
  const auto entries = scan_to_path::split(text, ',');
  if (entries.size() == 1) {
    const auto box = numbersOf(text);
    if (box.size() != 4) throw InputError("region", "text", "\"" + text + "\"", region_forms);
    return {{box[0], box[2]}, {box[1], box[2]}, {box[1], box[3]}, {box[0], box[3]}};
  }
  std::vector<Eigen::Vector2d> corners;
  for (const auto entry : entries) {
    const auto corner = numbersOf(entry);
    if (corner.size() != 2) throw InputError("region", "corner", "\"" + std::string(entry) + "\"", "two numbers, x y");
    corners.emplace_back(corner[0], corner[1]);
  }
  return corners;
}

std::string withChoice(const std::string& yaml, const JobChoice& choice) {
  const auto region = parseRegion(choice.region);
  const std::string skip_rows(scan_to_path::trimmed(choice.skip_rows));
  const std::string reverse_rows(scan_to_path::trimmed(choice.reverse_rows));
  if (region.empty() && skip_rows.empty() && reverse_rows.empty()) return yaml;
  YAML::Node root = parsed(yaml);
  if (!root["path"] || root["path"].IsNull()) root["path"] = YAML::Node(YAML::NodeType::Map);
  YAML::Node path = root["path"];
  if (!region.empty()) path["region"] = listOf(region);
  if (!skip_rows.empty()) path["skip_rows"] = skip_rows;
  if (!reverse_rows.empty()) path["reverse_rows"] = reverse_rows;
  YAML::Emitter emitter;
  emitter.SetDoublePrecision(17);
  emitter << root;
  return emitter.c_str();
}

}  // namespace scan_to_path_rviz
