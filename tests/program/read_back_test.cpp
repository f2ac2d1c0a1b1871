// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <regex>

#include "program_cases.h"
#include "scan_to_path/program/program.h"

namespace scan_to_path::program {
namespace {

using test::seededInput;
using ::testing::HasSubstr;

std::vector<ProgramFile> written(const ProgramInput& input) { return writeProgram(Controller::abb, input); }

std::string allTexts(const std::vector<Discrepancy>& found) {
  std::string text;
  for (const auto& discrepancy : found) text += discrepancy.text + "\n";
  return text;
}

TEST(ReadBack, SeededProgramsSayWhatWasPlanned) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto input = seededInput(seed);
    EXPECT_EQ(allTexts(readBack(Controller::abb, input, written(input))), "") << "seed " << seed;
  }
}

}  // namespace
}  // namespace scan_to_path::program
