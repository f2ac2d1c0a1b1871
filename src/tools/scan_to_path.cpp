// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>

int main(int argc, char** argv) {
  CLI::App app{"From a scan of a part to the robot program that machines it", "scan_to_path"};
  app.set_version_flag("--version", "scan_to_path 0.1.0");
  CLI11_PARSE(app, argc, argv);
  return 0;
}
