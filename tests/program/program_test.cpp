// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/program/program.h"

#include <gtest/gtest.h>

#include "program_cases.h"
#include "scan_to_path/program/rapid_writer.h"

namespace scan_to_path::program {
namespace {

TEST(WriteProgram, AbbIsRapid) {
  const auto input = test::seededInput(1, 1, 5);
  const auto files = writeProgram(Controller::abb, input);
  const auto rapid = writeRapid(input);
  ASSERT_EQ(files.size(), 2u);
  for (std::size_t i = 0; i < files.size(); ++i) {
    EXPECT_EQ(files[i].name, rapid[i].name);
    EXPECT_EQ(files[i].content, rapid[i].content);
  }
  EXPECT_STREQ(enumName(Controller::abb), "abb");
}

}  // namespace
}  // namespace scan_to_path::program
