// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "rapid_values.h"

#include <cmath>

#include "scan_to_path/common/error.h"

namespace scan_to_path::program {
namespace {

using Kind = Expression::Kind;

constexpr double radians_per_degree = 0.017453292519943295;

/// What RobotWare takes as a unit quaternion: the sum of squares within this of 1.
constexpr double quaternion_tolerance = 1e-5;

[[noreturn]] void fail(const RapidValues::Scope& scope, int line, const std::string& what) {
  throw InputError(scope.module->file + " line " + std::to_string(line) + ": " + what);
}

/// Reads the parts of a value by their place, with the place in messages.
struct Reading {
  const RapidValues::Scope& scope;
  int line;
  const char* type;

  [[noreturn]] void wrong(const std::string& what) const { fail(scope, line, std::string(type) + ": " + what); }

  const std::vector<RapidValue>& list(const RapidValue& value, std::size_t size) const {
    if (value.kind != RapidValue::Kind::list || value.parts.size() != size) {
      wrong("expected " + std::to_string(size) + " components in [ ]");
    }
    return value.parts;
  }
  double number(const RapidValue& value) const {
    if (value.kind != RapidValue::Kind::number) wrong("expected a number");
    return value.number;
  }
  bool truth(const RapidValue& value) const {
    if (value.kind != RapidValue::Kind::truth) wrong("expected TRUE or FALSE");
    return value.number != 0.0;
  }
  int integer(const RapidValue& value) const {
    const double n = number(value);
    if (!(std::abs(n) <= 1000.0) || n != std::floor(n)) wrong("expected a small whole number");
    return static_cast<int>(n);
  }
  template <std::size_t N>
  std::array<double, N> numbers(const RapidValue& value, double scale) const {
    const auto& parts = list(value, N);
    std::array<double, N> result{};
    for (std::size_t i = 0; i < N; ++i) result[i] = scale * number(parts[i]);
    return result;
  }
  /// [[x,y,z],[q1,q2,q3,q4]], mm.
  RapidPose pose(const RapidValue& position, const RapidValue& orientation) const {
    auto q = numbers<4>(orientation, 1.0);
    const double square = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    if (!(std::abs(square - 1.0) <= quaternion_tolerance)) wrong("the quaternion is not of length 1");
    for (auto& component : q) component /= std::sqrt(square);
    return RapidPose::fromQuaternion(q, numbers<3>(position, 1e-3));
  }
  RapidPose pose(const RapidValue& value) const {
    const auto& parts = list(value, 2);
    return pose(parts[0], parts[1]);
  }
};

bool isName(const Expression& expression, const char* name) {
  return expression.kind == Kind::name && expression.text == name;
}

/// Number in a predefined name: 100 of "v100", 10 of "z10"; -1 when it is none of the series.
double predefined(const Expression& expression, char letter, std::initializer_list<int> series) {
  if (expression.kind != Kind::name) return -1.0;
  for (const int member : series) {
    if (expression.text == letter + std::to_string(member)) return member;
  }
  return -1.0;
}

}  // namespace

/// Data may refer to data: bounds the work and the depth that a few lines can ask for.
struct RapidValues::Budget {
  int nodes = 2000;
  int depth = 0;
};

RapidValues::RapidValues(const std::vector<RapidModule>& modules) {
  for (const auto& module : modules) {
    for (const auto& [name, declaration] : module.data) {
      if (!global_.emplace(name, std::pair{&module, &declaration}).second) {
        fail({&module, nullptr}, declaration.line, "'" + name + "' is declared in another module too");
      }
    }
  }
}

const Declaration& RapidValues::find(const Expression& name, const Scope& scope) const {
  const Declaration* found = nullptr;
  if (scope.routine != nullptr) {
    const auto own = scope.routine->data.find(name.text);
    if (own != scope.routine->data.end()) found = &own->second;
  }
  if (found == nullptr) {
    const auto global = global_.find(name.text);
    if (global != global_.end()) found = global->second.second;
  }
  if (found == nullptr) fail(scope, name.line, "'" + name.text.substr(0, 40) + "' is not declared");
  if (!found->has_value) fail(scope, name.line, "'" + name.text.substr(0, 40) + "' has no value");
  if (unknown_.count(name.text) > 0) {
    fail(scope, name.line, "'" + name.text.substr(0, 40) + "' gets its value at run time");
  }
  return *found;
}

RapidValue RapidValues::evaluate(const Expression& expression, const Scope& scope) const {
  Budget budget;
  return evaluate(expression, scope, budget);
}

RapidValue RapidValues::evaluate(const Expression& expression, const Scope& scope, Budget& budget) const {
  if (--budget.nodes < 0 || budget.depth > 200) fail(scope, expression.line, "value is too large or refers to itself");
  RapidValue value;
  switch (expression.kind) {
    case Kind::number:
      value.number = expression.number;
      return value;
    case Kind::truth:
      value.kind = RapidValue::Kind::truth;
      value.number = expression.number;
      return value;
    case Kind::text:
      value.kind = RapidValue::Kind::text;
      value.text = expression.text;
      return value;
    case Kind::aggregate:
      value.kind = RapidValue::Kind::list;
      for (const auto& part : expression.parts) value.parts.push_back(evaluate(part, scope, budget));
      return value;
    case Kind::name: {
      const auto& declaration = find(expression, scope);
      ++budget.depth;
      value = evaluate(declaration.value, scope, budget);
      --budget.depth;
      return value;
    }
    case Kind::call:
      fail(scope, expression.line, "function '" + expression.text.substr(0, 40) + "' is not read here");
    default:
      return arithmetic(expression, scope, budget);
  }
}

RapidValue RapidValues::arithmetic(const Expression& expression, const Scope& scope, Budget& budget) const {
  double operands[2] = {0.0, 0.0};
  for (std::size_t i = 0; i < expression.parts.size(); ++i) {
    ++budget.depth;
    const RapidValue operand = evaluate(expression.parts[i], scope, budget);
    --budget.depth;
    if (operand.kind != RapidValue::Kind::number) fail(scope, expression.line, "arithmetic with what is no number");
    operands[i] = operand.number;
  }
  RapidValue value;
  switch (expression.kind) {
    case Kind::negative:
      value.number = -operands[0];
      break;
    case Kind::add:
      value.number = operands[0] + operands[1];
      break;
    case Kind::subtract:
      value.number = operands[0] - operands[1];
      break;
    case Kind::multiply:
      value.number = operands[0] * operands[1];
      break;
    default:
      value.number = operands[0] / operands[1];
      break;
  }
  if (!std::isfinite(value.number)) fail(scope, expression.line, "result is not finite");
  return value;
}

double RapidValues::number(const Expression& expression, const Scope& scope) const {
  return Reading{scope, expression.line, "num"}.number(evaluate(expression, scope));
}

RapidTarget RapidValues::target(const Expression& expression, const Scope& scope) const {
  if (expression.kind == Kind::call) return shifted(expression, scope);
  const Reading read{scope, expression.line, "robtarget"};
  const RapidValue value = evaluate(expression, scope);
  const auto& parts = read.list(value, 4);
  RapidTarget target;
  target.pose = read.pose(parts[0], parts[1]);
  const auto& configuration = read.list(parts[2], 4);
  for (std::size_t i = 0; i < 4; ++i) target.configuration[i] = read.integer(configuration[i]);
  read.numbers<6>(parts[3], 1.0);
  return target;
}

RapidTarget RapidValues::shifted(const Expression& call, const Scope& scope) const {
  const bool in_object = call.text == "offs";
  if ((!in_object && call.text != "reltool") || call.parts.size() != 4) {
    fail(scope, call.line, "'" + call.text.substr(0, 40) + "' is no target that is read");
  }
  if (call.parts[0].kind == Kind::call) fail(scope, call.line, "a shift of a shifted target is not read");
  RapidTarget target = this->target(call.parts[0], scope);
  RapidPose shift;
  for (std::size_t i = 0; i < 3; ++i) shift.t[i] = 1e-3 * number(call.parts[i + 1], scope);
  target.pose = in_object ? shift * target.pose : target.pose * shift;
  return target;
}

std::array<double, 6> RapidValues::axes(const Expression& expression, const Scope& scope) const {
  const Reading read{scope, expression.line, "jointtarget"};
  const RapidValue value = evaluate(expression, scope);
  const auto& parts = read.list(value, 2);
  read.numbers<6>(parts[1], 1.0);
  return read.numbers<6>(parts[0], radians_per_degree);
}

RapidSpeed RapidValues::speed(const Expression& expression, const Scope& scope) const {
  const double known =
      predefined(expression, 'v', {5,   10,  20,  30,   40,   50,   60,   80,   100,  150,  200,  300, 400,
                                   500, 600, 800, 1000, 1500, 2000, 2500, 3000, 4000, 5000, 6000, 7000});
  if (known > 0.0) return {1e-3 * known, 500.0 * radians_per_degree};
  const Reading read{scope, expression.line, "speeddata"};
  const auto numbers = read.numbers<4>(evaluate(expression, scope), 1.0);
  return {1e-3 * numbers[0], radians_per_degree * numbers[1]};
}

double RapidValues::zone(const Expression& expression, const Scope& scope) const {
  if (isName(expression, "fine")) return 0.0;
  const double known = predefined(expression, 'z', {0, 1, 5, 10, 15, 20, 30, 40, 50, 60, 80, 100, 150, 200});
  if (known >= 0.0) return known > 0.0 ? 1e-3 * known : 0.3e-3;
  const Reading read{scope, expression.line, "zonedata"};
  const RapidValue value = evaluate(expression, scope);
  const auto& parts = read.list(value, 7);
  for (std::size_t i = 1; i < 7; ++i) {
    if (read.number(parts[i]) < 0.0) read.wrong("a zone is negative");
  }
  return read.truth(parts[0]) ? 0.0 : 1e-3 * parts[1].number;
}

RapidTool RapidValues::tool(const Expression& expression, const Scope& scope) const {
  RapidTool tool;
  if (expression.kind == Kind::name) tool.name = expression.text;
  if (isName(expression, "tool0")) return tool;
  const Reading read{scope, expression.line, "tooldata"};
  const RapidValue value = evaluate(expression, scope);
  const auto& parts = read.list(value, 3);
  if (!read.truth(parts[0])) read.wrong("a tool that the robot does not hold is not read");
  tool.T_tip_tcp = read.pose(parts[1]).frame();
  const auto& load = read.list(parts[2], 6);
  tool.mass = read.number(load[0]);
  const auto centre = read.numbers<3>(load[1], 1e-3);
  tool.centre_of_gravity = {centre[0], centre[1], centre[2]};
  read.pose(load[1], load[2]);
  tool.inertia = {read.number(load[3]), read.number(load[4]), read.number(load[5])};
  return tool;
}

RapidPose RapidValues::workobject(const Expression& expression, const Scope& scope) const {
  if (isName(expression, "wobj0")) return {};
  const Reading read{scope, expression.line, "wobjdata"};
  const RapidValue value = evaluate(expression, scope);
  const auto& parts = read.list(value, 5);
  if (read.truth(parts[0])) read.wrong("a work object that the robot holds is not read");
  if (!read.truth(parts[1])) read.wrong("a work object on a moving unit is not read");
  return read.pose(parts[3]) * read.pose(parts[4]);
}

}  // namespace scan_to_path::program
