// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmock/gmock.h>

#include <string>

#include "scan_to_path/common/error.h"

namespace scan_to_path::test {

/// Expects that `act` throws InputError with a one-line message that contains `part`.
template <class Act>
void expectInputError(Act&& act, const std::string& part) {
  try {
    act();
    ADD_FAILURE() << "no InputError; expected one saying: " << part;
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr(part));
    EXPECT_THAT(error.what(), ::testing::Not(::testing::HasSubstr("\n")));
  }
}

}  // namespace scan_to_path::test
