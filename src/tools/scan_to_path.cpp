// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>

#include "commands.h"
#include "progress_bar.h"
#include "scan_to_path/common/error.h"
#include "scan_to_path/common/version.h"

namespace {

enum ExitStatus { bad_input = 2, bug = 3, interrupted = 130 };

int fail(ExitStatus status, const std::string& message) {
  std::fprintf(stderr, "scan_to_path: %s\n", message.c_str());
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"From what a robot-carried sensor saw of a part to the robot program that machines it.", "scan_to_path"};
  app.set_version_flag("--version", std::string("scan_to_path ") + scan_to_path::version);
  app.require_subcommand(1);
  const auto plan = scan_to_path::tools::addPlanCommand(app);
  const auto emulate = scan_to_path::tools::addEmulateCommand(app);
  try {
    app.parse(argc, argv);
    scan_to_path::tools::installCancelSignals();
    return app.got_subcommand("plan") ? plan() : emulate();
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    return fail(bad_input, error.what());
  } catch (const scan_to_path::InputError& error) {
    return fail(bad_input, error.what());
  } catch (const scan_to_path::Interrupted&) {
    return fail(interrupted, "interrupted; nothing was written");
  } catch (const std::bad_alloc&) {
    return fail(bad_input, "out of memory");
  } catch (const std::exception& error) {
    return fail(bug, std::string("internal error: ") + error.what());
  }
}
