// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scan_to_path/program/program.h"

namespace scan_to_path::program {

/// ABB RAPID: program.pgf (the list of modules), program.mod (header, data, main), program_2.mod, … for further moves.
/// docs/programs.md says what is in them. Same input, same bytes. Throws InputError as writeProgram does.
std::vector<ProgramFile> writeRapid(const ProgramInput& input);

}  // namespace scan_to_path::program
