// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "scan_to_path/common/options.h"

namespace scan_to_path::pipeline {

/// An enum field by its names.
struct EnumReference {
  std::vector<std::string> names;
  std::function<std::size_t()> get;
  std::function<void(std::size_t)> set;
};

/// One leaf of a tree of option structs: where it stands ("path.lead"), what it is, and the variable itself.
struct FieldReference {
  std::string path;
  Field field;
  std::variant<bool*, int*, double*, std::optional<double>*, std::string*, Eigen::Vector3d*, std::vector<double>*,
               std::vector<std::string>*, std::vector<Eigen::Vector2d>*, EnumReference>
      value;
};

/// The leaves of a tree of option structs in the order in which they are declared. The references are valid as long
/// as `options` is.
template <class Options>
std::vector<FieldReference> fieldReferences(Options& options, const std::string& prefix = "") {
  std::vector<FieldReference> references;
  Options::fields(options, [&](auto& value, const Field& field) {
    using T = std::decay_t<decltype(value)>;
    const std::string path = prefix + field.name;
    if constexpr (IsOptions<T>::value) {
      for (auto& nested : fieldReferences(value, path + ".")) references.push_back(std::move(nested));
    } else if constexpr (std::is_enum_v<T>) {
      const auto& names = EnumNames<T>::names;
      references.push_back({path, field,
                            EnumReference{std::vector<std::string>(names.begin(), names.end()),
                                          [&value] { return static_cast<std::size_t>(value); },
                                          [&value](std::size_t index) { value = static_cast<T>(index); }}});
    } else {
      references.push_back({path, field, &value});
    }
  });
  return references;
}

/// Overwrites the fields that a YAML text names and returns their paths. `source` stands in messages. Throws InputError
/// with the line for text that is not YAML or of several documents, an unknown key (naming the nearest one), a value of
/// the wrong type, a key given twice.
std::set<std::string> applyYaml(const std::vector<FieldReference>& fields, const std::string& text,
                                const std::string& source);

/// The same with the text of a file that a user named. One that sets nothing is refused: it is a broken one, or not the
/// one that was meant.
std::set<std::string> applyConfiguration(const std::vector<FieldReference>& fields, const std::string& text,
                                         const std::string& source);

/// The same with the file itself, whose name stands in messages. Throws InputError when it cannot be read, too.
std::set<std::string> applyYamlFile(const std::vector<FieldReference>& fields, const std::filesystem::path& file);

/// Overwrites one field from "section.name=value" (the value as in YAML) and returns its path. Throws InputError as
/// applyYaml does.
std::string applyAssignment(const std::vector<FieldReference>& fields, const std::string& assignment);

/// The whole tree as YAML with unit and help beside each key; applyYaml of it changes nothing.
std::string formatYaml(const std::vector<FieldReference>& fields);

/// The value alone, as formatYaml writes it.
std::string formatValue(const FieldReference& field);

}  // namespace scan_to_path::pipeline
