// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/configuration.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <set>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/quote.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path::pipeline {
namespace {

constexpr std::size_t longest_key = 80;  // that a message shows
constexpr std::size_t longest_yaml_message = 200;
constexpr const char* unset = "unset";  // a number that is not given; ROS parameters have no null

/// Where a text comes from: a file's, by lines, or what --set gives one key.
struct Source {
  std::string name;
  bool has_lines = true;

  /// Lines count from 0.
  std::string at(int line) const { return line < 0 || !has_lines ? name : name + " line " + std::to_string(line + 1); }
  std::string at(const YAML::Node& node) const { return at(node.Mark().line); }
};

std::string shown(const YAML::Node& node) {
  if (node.IsScalar()) return inQuotes(node.Scalar());
  if (node.IsSequence()) return "a list of " + std::to_string(node.size());
  return node.IsMap() ? "a section" : "empty";
}

/// One value from its YAML node, for each type a field may have.
class Assign {
public:
  /// `where` says which key it is, and of what.
  Assign(const FieldReference& field, const YAML::Node& node, std::string where)
      : field_(field), node_(node), where_(std::move(where)) {}

  void operator()(bool* value) const {
    const std::string text = node_.IsScalar() ? node_.Scalar() : "";
    if (text != "true" && text != "false") reject("true or false");
    *value = text == "true";
  }
  void operator()(int* value) const {
    const double number = toNumber(node_);
    if (number != std::floor(number) || std::abs(number) > std::numeric_limits<int>::max()) reject("a whole number");
    *value = static_cast<int>(number);
  }
  void operator()(double* value) const { *value = toNumber(node_); }
  void operator()(std::optional<double>* value) const {
    const bool is_unset = node_.IsScalar() && node_.Scalar() == unset;
    *value = is_unset ? std::nullopt : std::optional<double>(toNumber(node_, std::string(" or ") + unset));
  }
  void operator()(std::string* value) const {
    if (node_.IsNull()) return value->clear();
    if (!node_.IsScalar()) reject("a text");
    *value = node_.Scalar();
  }
  void operator()(Eigen::Vector3d* value) const {
    if (!node_.IsSequence() || node_.size() != 3) reject("a list of 3 numbers");
    for (std::size_t i = 0; i < 3; ++i) (*value)[static_cast<long>(i)] = toNumber(node_[i]);
  }
  void operator()(std::vector<double>* value) const {
    if (!node_.IsSequence()) reject("a list of numbers");
    value->clear();
    for (const auto& item : node_) value->push_back(toNumber(item));
  }
  void operator()(std::vector<std::string>* value) const {
    if (!node_.IsSequence()) reject("a list of texts");
    value->clear();
    for (const auto& item : node_) {
      if (!item.IsScalar()) reject("a list of texts");
      value->push_back(item.Scalar());
    }
  }
  void operator()(std::vector<Eigen::Vector2d>* value) const {
    if (!node_.IsSequence()) reject("a list of [x, y]");
    value->clear();
    for (const auto& item : node_) {
      if (!item.IsSequence() || item.size() != 2) reject("a list of [x, y]");
      value->emplace_back(toNumber(item[0]), toNumber(item[1]));
    }
  }
  void operator()(const EnumReference& value) const {
    const auto& names = value.names;
    const auto found = std::find(names.begin(), names.end(), node_.IsScalar() ? node_.Scalar() : "");
    if (found == names.end()) {
      std::string choices;
      for (const auto& name : names) choices += (choices.empty() ? "" : ", ") + name;
      reject("one of " + choices);
    }
    value.set(static_cast<std::size_t>(found - names.begin()));
  }

private:
  double toNumber(const YAML::Node& node, const std::string& otherwise = "") const {
    double number = 0.0;
    if (!node.IsScalar() || !parseNumber(node.Scalar(), number)) {
      const std::string unit = *field_.field.unit != 0 ? std::string(" [") + field_.field.unit + "]" : "";
      reject("a number" + unit + otherwise);
    }
    return number;
  }
  [[noreturn]] void reject(const std::string& wanted) const {
    throw InputError(where_ + " is " + shown(node_) + ", must be " + wanted);
  }

  const FieldReference& field_;
  const YAML::Node& node_;
  std::string where_;
};

const FieldReference* find(const std::vector<FieldReference>& fields, const std::string& path) {
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const auto& field) { return field.path == path; });
  return found == fields.end() ? nullptr : &*found;
}

bool isSection(const std::vector<FieldReference>& fields, const std::string& path) {
  return std::any_of(fields.begin(), fields.end(),
                     [&](const auto& field) { return field.path.compare(0, path.size() + 1, path + ".") == 0; });
}

[[noreturn]] void unknownKey(const std::vector<FieldReference>& fields, const std::string& path,
                             const std::string& where) {
  std::set<std::string> known;
  for (const auto& field : fields) {
    known.insert(field.path);
    for (auto dot = field.path.find('.'); dot != std::string::npos; dot = field.path.find('.', dot + 1)) {
      known.insert(field.path.substr(0, dot));
    }
  }
  const std::vector<std::string> names(known.begin(), known.end());
  const std::string nearest = nearestWord(std::string_view(path).substr(0, longest_key), names);
  throw InputError(where + ": unknown key " + escaped(path, longest_key) + ", did you mean " + nearest + "?");
}

/// --set names a section: shows how its first value is named.
[[noreturn]] void isNoValue(const std::vector<FieldReference>& fields, const std::string& section) {
  const auto first =
      std::find_if(fields.begin(), fields.end(), [&](const auto& field) { return isSection({field}, section); });
  throw InputError("--set " + section + ": is a section; set one of its values, such as " + first->path);
}

void applyNode(const std::vector<FieldReference>& fields, const YAML::Node& node, const std::string& prefix,
               const Source& source, std::set<std::string>& set) {
  std::set<std::string> seen;
  for (const auto& entry : node) {
    if (!entry.first.IsScalar()) throw InputError(source.at(entry.first) + ": a key must be a text");
    const std::string path = prefix + entry.first.Scalar();
    const std::string where = source.at(entry.first);
    if (!seen.insert(path).second) throw InputError(where + ": key " + escaped(path, longest_key) + " stands twice");
    if (const FieldReference* field = find(fields, path)) {
      std::visit(Assign(*field, entry.second, source.at(entry.second) + ": " + path), field->value);
      set.insert(path);
    } else if (!isSection(fields, path)) {
      unknownKey(fields, path, where);
    } else if (entry.second.IsMap()) {
      applyNode(fields, entry.second, path + ".", source, set);
    } else if (!entry.second.IsNull()) {
      throw InputError(where, path, shown(entry.second), "a section");
    }
  }
}

/// Of several documents only the first would count, which their writer cannot have meant. (YAML::LoadAll does not end
/// on some broken texts.)
void checkThatDocumentIsOne(const std::string& text, const Source& source) {
  bool has_begun = false;
  int number = -1;
  for (const auto line : split(text, '\n')) {
    ++number;
    const bool begins = line.substr(0, 3) == "---" && trimmed(line.substr(0, 4)).size() == 3;
    if (begins && has_begun) {
      throw InputError(source.at(number) + ": begins another document, must be one");
    }
    const auto content = trimmed(line);
    has_begun = has_begun || begins || (!content.empty() && content.front() != '#' && content.front() != '%');
  }
}

YAML::Node parse(const std::string& text, const Source& source) {
  checkThatDocumentIsOne(text, source);
  try {
    return YAML::Load(text);
  } catch (const YAML::Exception& error) {
    throw InputError(source.at(error.mark.line) + ": not YAML: " + escaped(error.msg, longest_yaml_message));
  }
}

std::string formatNumber(double value) {
  char buffer[40];
  const auto result = std::to_chars(buffer, buffer + sizeof(buffer), value);
  return std::string(buffer, result.ptr);
}

/// Plain where YAML reads the text back as it is, else in double quotes.
std::string formatText(const std::string& text) {
  const bool plain = !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalnum(c) || c == '_' || c == '/' || c == '.' || c == '-';
  });
  if (plain) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "\"";
}

struct FormatValue {
  std::string operator()(const bool* value) const { return *value ? "true" : "false"; }
  std::string operator()(const int* value) const { return std::to_string(*value); }
  std::string operator()(const double* value) const { return formatNumber(*value); }
  std::string operator()(const std::optional<double>* value) const { return *value ? formatNumber(**value) : unset; }
  std::string operator()(const std::string* value) const { return formatText(*value); }
  std::string operator()(const Eigen::Vector3d* value) const {
    return "[" + formatNumber(value->x()) + ", " + formatNumber(value->y()) + ", " + formatNumber(value->z()) + "]";
  }
  std::string operator()(const std::vector<double>* value) const { return list(*value, formatNumber); }
  std::string operator()(const std::vector<std::string>* value) const { return list(*value, formatText); }
  std::string operator()(const std::vector<Eigen::Vector2d>* value) const {
    return list(*value,
                [](const Eigen::Vector2d& p) { return "[" + formatNumber(p.x()) + ", " + formatNumber(p.y()) + "]"; });
  }
  std::string operator()(const EnumReference& value) const { return value.names[value.get()]; }

private:
  template <class Values, class Format>
  static std::string list(const Values& values, Format format) {
    std::string text = "[";
    for (const auto& value : values) text += (text.size() > 1 ? ", " : "") + format(value);
    return text + "]";
  }
};

std::string comment(const FieldReference& reference) {
  const Field& field = reference.field;
  std::string text = *field.unit != 0 ? std::string("[") + field.unit + "] " : "";
  text += field.help;
  if (const auto* choice = std::get_if<EnumReference>(&reference.value)) {
    text += text.empty() ? "" : ": ";
    for (std::size_t i = 0; i < choice->names.size(); ++i) text += (i > 0 ? " | " : "") + choice->names[i];
  }
  return text;
}

}  // namespace

std::set<std::string> applyYaml(const std::vector<FieldReference>& fields, const std::string& text,
                                const std::string& source) {
  const YAML::Node root = parse(text, {source});
  std::set<std::string> set;
  if (root.IsNull()) return set;
  if (!root.IsMap()) throw InputError(source + ": a configuration is sections of keys, this is " + shown(root));
  applyNode(fields, root, "", {source}, set);
  return set;
}

std::set<std::string> applyConfiguration(const std::vector<FieldReference>& fields, const std::string& text,
                                         const std::string& source) {
  std::set<std::string> set = applyYaml(fields, text, source);
  if (set.empty()) {
    throw InputError(source +
                     ": sets nothing; a configuration is sections of keys (see --print-config), and "
                     "where the defaults are to hold there is none");
  }
  return set;
}

std::set<std::string> applyYamlFile(const std::vector<FieldReference>& fields, const std::filesystem::path& file) {
  return applyConfiguration(fields, readFile(file), file.string());
}

std::string applyAssignment(const std::vector<FieldReference>& fields, const std::string& assignment) {
  const auto equals = assignment.find('=');
  const std::string path(trimmed(std::string_view(assignment).substr(0, equals)));
  if (equals == std::string::npos || path.empty()) {
    throw InputError("--set " + inQuotes(assignment) + ": must be section.name=value");
  }
  const FieldReference* field = find(fields, path);
  if (field == nullptr && isSection(fields, path)) isNoValue(fields, path);
  if (field == nullptr) unknownKey(fields, path, "--set");
  const std::string where = "--set " + path;
  const std::string value(trimmed(std::string_view(assignment).substr(equals + 1)));
  const bool is_text = std::holds_alternative<std::string*>(field->value);
  const YAML::Node node = is_text ? YAML::Node(value) : parse(value, {where, false});
  std::visit(Assign(*field, node, where), field->value);
  return path;
}

std::string formatValue(const FieldReference& field) { return std::visit(FormatValue(), field.value); }

std::string formatYaml(const std::vector<FieldReference>& fields) {
  std::string text;
  std::vector<std::string_view> open;
  for (const auto& reference : fields) {
    const auto parts = split(reference.path, '.');
    std::size_t shared = 0;
    while (shared < open.size() && shared + 1 < parts.size() && open[shared] == parts[shared]) ++shared;
    open.resize(shared);
    for (; open.size() + 1 < parts.size(); open.push_back(parts[open.size()])) {
      text += std::string(2 * open.size(), ' ') + std::string(parts[open.size()]) + ":\n";
    }
    text += std::string(2 * open.size(), ' ') + std::string(parts.back()) + ": " + formatValue(reference);
    const std::string note = comment(reference);
    text += (note.empty() ? "" : "  # " + note) + "\n";
  }
  return text;
}

}  // namespace scan_to_path::pipeline
