// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include <functional>

namespace scan_to_path::tools {

/// Adds a subcommand to the application. The returned action runs it once its options are parsed and gives the exit
/// status.
std::function<int()> addPlanCommand(CLI::App& app);
std::function<int()> addEmulateCommand(CLI::App& app);

}  // namespace scan_to_path::tools
