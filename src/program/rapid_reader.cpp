// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/program/rapid_reader.h"

#include <algorithm>
#include <map>
#include <set>

#include "rapid_syntax.h"
#include "rapid_values.h"
#include "scan_to_path/common/error.h"

namespace scan_to_path::program {
namespace {

/// Instructions that leave the path alone.
const std::set<std::string> harmless = {"confl",  "confj",     "singarea", "tpwrite", "tperase", "waittime",
                                        "setdo",  "set",       "reset",    "stop",    "exit",    "return",
                                        "waitdi", "waituntil", "waitrob",  "pulsedo", "accset"};

/// Every routine call is nested in its caller's.
constexpr int deepest_call = 64;

std::string lowerCase(std::string text) {
  for (auto& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
  }
  return text;
}

class Interpreter {
public:
  Interpreter(const std::vector<RapidModule>& modules, const RapidReadOptions& options)
      : values_(modules),
        process_on_(lowerCase(options.process_on)),
        process_off_(lowerCase(options.process_off)),
        signal_(lowerCase(options.process_signal)),
        steps_left_(options.max_steps) {
    for (const auto& module : modules) {
      for (const auto& [name, routine] : module.routines) {
        if (!routines_.emplace(name, RapidValues::Scope{&module, &routine}).second) {
          throw InputError(module.file + " line " + std::to_string(routine.line) + ": routine '" + name +
                           "' is in another module too");
        }
      }
    }
  }

  RapidProgram run() {
    const auto main = routines_.find("main");
    if (main == routines_.end()) throw InputError("robot program: no routine main");
    call(main->second, 0);
    return std::move(program_);
  }

private:
  using Scope = RapidValues::Scope;

  [[noreturn]] static void fail(const Scope& scope, int line, const std::string& what) {
    throw InputError(scope.module->file + " line " + std::to_string(line) + ": " + what);
  }

  /// Runs a routine; `ended_` is set by EXIT.
  void call(const Scope& scope, int depth) {
    if (depth > deepest_call) fail(scope, scope.routine->line, "routines call each other too deeply");
    if (scope.routine->has_parameters) fail(scope, scope.routine->line, "routines with parameters are not read");
    for (const auto& statement : scope.routine->statements) {
      if (ended_) return;
      if (steps_left_ == 0) fail(scope, statement.line, "the program is too long");
      --steps_left_;
      if (statement.name == "return") return;
      execute(statement, scope, depth);
    }
  }

  void execute(const Statement& statement, const Scope& scope, int depth) {
    if (statement.kind == Statement::Kind::assignment) {
      values_.forget(statement.name);
    } else if (statement.kind == Statement::Kind::conditional) {
      checkConditional(statement, scope);
    } else if (isMove(statement.name)) {
      move(statement, scope);
    } else if (statement.name == process_on_ || statement.name == process_off_) {
      switchProcess(statement.name == process_on_);
      if (process_on_now_) waitsOf(statement.name);
    } else if (const auto routine = routines_.find(statement.name); routine != routines_.end()) {
      if (!statement.arguments.empty()) fail(scope, statement.line, "calls with arguments are not read");
      call(routine->second, depth + 1);
    } else {
      instruction(statement, scope);
    }
  }

  void switchProcess(bool on) {
    process_on_now_ = on;
    process_wait_ = 0.0;
  }

  /// The waits in the routine that starts the process, after the signal is set; nothing else of it is followed.
  void waitsOf(const std::string& name) {
    const auto found = routines_.find(name);
    if (found == routines_.end()) return;
    const Scope& scope = found->second;
    for (const auto& statement : scope.routine->statements) {
      if (statement.name == "return" || statement.name == "exit") return;
      if (setsSignal(statement)) process_wait_ = 0.0;
      if (statement.kind == Statement::Kind::instruction && statement.name == "waittime") wait(statement, scope);
    }
  }

  bool setsSignal(const Statement& statement) const {
    if (signal_.empty()) return false;
    const auto& inside = statement.names_inside;
    return std::find(inside.begin(), inside.end(), signal_) != inside.end() ||
           (!statement.arguments.empty() && statement.arguments[0].value.text == signal_);
  }

  /// WaitTime [\InPos] Time.
  void wait(const Statement& statement, const Scope& scope) {
    if (!process_on_now_) return;
    for (const auto& argument : statement.arguments) {
      if (!argument.option.empty()) continue;
      const double time = values_.number(argument.value, scope);
      if (!(time >= 0.0)) fail(scope, statement.line, "a wait must not be negative");
      process_wait_ += time;
    }
  }

  static bool isMove(const std::string& name) { return name == "movel" || name == "movej" || name == "moveabsj"; }

  /// What depends on a condition must be harmless: no motion, no routine, no process.
  void checkConditional(const Statement& statement, const Scope& scope) {
    for (const auto& name : statement.names_inside) {
      const bool moves = name.rfind("move", 0) == 0 || name.rfind("trigg", 0) == 0 || name.rfind("search", 0) == 0;
      if (moves || routines_.count(name) > 0 || name == process_on_ || name == process_off_ ||
          (!signal_.empty() && name == signal_)) {
        fail(scope, statement.line, "'" + name + "' under a condition is not read");
      }
    }
  }

  void instruction(const Statement& statement, const Scope& scope) {
    if (harmless.count(statement.name) == 0) {
      fail(scope, statement.line, "instruction '" + statement.name.substr(0, 40) + "' is not read");
    }
    if (statement.name == "exit") ended_ = true;
    if (statement.name == "stop") stopped_ = true;
    if (statement.name == "waittime") wait(statement, scope);
    if (signal_.empty() || statement.arguments.empty() || statement.arguments[0].value.text != signal_) return;
    if (statement.name == "set" || statement.name == "reset") {
      switchProcess(statement.name == "set");
    } else if (statement.name == "setdo" && statement.arguments.size() == 2) {
      switchProcess(values_.number(statement.arguments[1].value, scope) != 0.0);
    } else {
      fail(scope, statement.line, "the process signal is used in a way that is not read");
    }
  }

  /// Move [\Conc] ToPoint Speed [\V] Zone [\Z] Tool [\WObj].
  void move(const Statement& statement, const Scope& scope) {
    std::vector<const Expression*> positional;
    const Expression* workobject = nullptr;
    const Expression* speed = nullptr;
    for (const auto& argument : statement.arguments) {
      if (argument.option.empty()) {
        positional.push_back(&argument.value);
      } else if (argument.option == "wobj" && argument.has_value) {
        workobject = &argument.value;
      } else if (argument.option == "v" && argument.has_value) {
        speed = &argument.value;
      } else if (argument.option != "conc" && argument.option != "noeoffs") {
        fail(scope, statement.line, "\\" + argument.option.substr(0, 40) + " is not read");
      }
    }
    if (positional.size() != 4) fail(scope, statement.line, "a move needs point, speed, zone and tool");
    RapidMove made;
    made.file = scope.module->file;
    made.line = statement.line;
    setTarget(made, statement, *positional[0], workobject, scope);
    const RapidSpeed limits = values_.speed(*positional[1], scope);
    made.speed = speed != nullptr ? 1e-3 * values_.number(*speed, scope) : limits.linear;
    made.orientation_speed = limits.angular;
    made.zone = values_.zone(*positional[2], scope);
    made.stop = made.zone == 0.0;
    made.tool = toolIndex(*positional[3], scope);
    made.process_on = process_on_now_;
    made.process_wait = process_wait_;
    process_wait_ = 0.0;
    made.after_stop = stopped_;
    stopped_ = false;
    program_.moves.push_back(std::move(made));
  }

  void setTarget(RapidMove& made, const Statement& statement, const Expression& point, const Expression* workobject,
                 const Scope& scope) {
    if (statement.name == "moveabsj") {
      made.type = RapidMoveType::absolute_joint;
      made.axes = values_.axes(point, scope);
      return;
    }
    made.type = statement.name == "movel" ? RapidMoveType::linear : RapidMoveType::joint;
    const RapidTarget target = values_.target(point, scope);
    const RapidPose object = workobject != nullptr ? values_.workobject(*workobject, scope) : RapidPose{};
    made.T_base_tcp = (object * target.pose).frame();
    made.configuration = target.configuration;
    if (!made.T_base_tcp.matrix().allFinite()) fail(scope, statement.line, "the target is not finite");
  }

  int toolIndex(const Expression& expression, const Scope& scope) {
    RapidTool tool = values_.tool(expression, scope);
    for (std::size_t i = 0; i < program_.tools.size(); ++i) {
      const auto& known = program_.tools[i];
      if (known.name == tool.name && known.T_tip_tcp.matrix() == tool.T_tip_tcp.matrix() && known.mass == tool.mass) {
        return static_cast<int>(i);
      }
    }
    program_.tools.push_back(std::move(tool));
    return static_cast<int>(program_.tools.size()) - 1;
  }

  RapidValues values_;
  std::map<std::string, Scope> routines_;
  std::string process_on_;
  std::string process_off_;
  std::string signal_;
  std::size_t steps_left_;
  RapidProgram program_;
  bool process_on_now_ = false;
  double process_wait_ = 0.0;
  bool stopped_ = false;
  bool ended_ = false;
};

}  // namespace

RapidProgram readRapid(const std::vector<ProgramFile>& files, const RapidReadOptions& options) {
  std::vector<RapidModule> modules;
  for (const auto& file : files) {
    const std::size_t length = file.name.size();
    if (length >= 4 && lowerCase(file.name.substr(length - 4)) == ".mod") modules.push_back(parseRapidModule(file));
  }
  return Interpreter(modules, options).run();
}

}  // namespace scan_to_path::program
