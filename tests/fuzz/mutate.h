// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scan_to_path/common/random.h"

namespace scan_to_path::fuzz {

/// One of the corpus' inputs with one to eight random changes: bits, bytes, numbers, words, pieces cut, doubled or
/// taken from another input.
std::string mutated(const std::vector<std::string>& corpus, Random& random);

}  // namespace scan_to_path::fuzz
