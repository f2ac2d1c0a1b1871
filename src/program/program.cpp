// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/program/program.h"

#include "scan_to_path/program/rapid_writer.h"

namespace scan_to_path::program {

std::vector<ProgramFile> writeProgram(Controller controller, const ProgramInput& input) {
  switch (controller) {
    case Controller::abb:
      return writeRapid(input);
  }
  throw InputError("no program writer for this controller");
}

}  // namespace scan_to_path::program
