// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "rapid_pose.h"
#include "rapid_syntax.h"
#include "scan_to_path/program/rapid_reader.h"

namespace scan_to_path::program {

/// What an expression comes to.
struct RapidValue {
  enum class Kind { number, truth, text, list };
  Kind kind = Kind::number;
  double number = 0.0;
  std::string text;
  std::vector<RapidValue> parts;
};

/// A robtarget in its work object.
struct RapidTarget {
  RapidPose pose;
  std::array<int, 4> configuration{};
};

struct RapidSpeed {
  double linear = 0.0;   ///< [m/s]
  double angular = 0.0;  ///< [rad/s]
};

/// The data of a program and what its expressions come to. Errors are InputErrors with file and line.
class RapidValues {
public:
  explicit RapidValues(const std::vector<RapidModule>& modules);

  /// Where names are looked up: a routine's own data, its module's, then all modules'.
  struct Scope {
    const RapidModule* module = nullptr;
    const RapidRoutine* routine = nullptr;
  };

  double number(const Expression& expression, const Scope& scope) const;
  RapidTarget target(const Expression& expression, const Scope& scope) const;  ///< with Offs and RelTool
  std::array<double, 6> axes(const Expression& expression, const Scope& scope) const;
  RapidSpeed speed(const Expression& expression, const Scope& scope) const;
  double zone(const Expression& expression, const Scope& scope) const;  ///< radius [m]; 0 for fine
  RapidTool tool(const Expression& expression, const Scope& scope) const;
  RapidPose workobject(const Expression& expression, const Scope& scope) const;  ///< T_base_object

  /// From here on the name's value is known to the controller only: its use is an error.
  void forget(const std::string& name) { unknown_.insert(name); }

private:
  struct Budget;
  RapidValue evaluate(const Expression& expression, const Scope& scope) const;
  RapidValue evaluate(const Expression& expression, const Scope& scope, Budget& budget) const;
  RapidValue arithmetic(const Expression& expression, const Scope& scope, Budget& budget) const;
  const Declaration& find(const Expression& name, const Scope& scope) const;
  RapidTarget shifted(const Expression& call, const Scope& scope) const;

  std::map<std::string, std::pair<const RapidModule*, const Declaration*>> global_;
  std::set<std::string> unknown_;
};

}  // namespace scan_to_path::program
