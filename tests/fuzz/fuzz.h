// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

/// One file `<reader>_fuzz.cpp` per reader defines these two. driver.cpp runs them under any compiler with mutations
/// of the seeds; with clang, -fsanitize=fuzzer replaces the driver and seeds() is not used.

/// libFuzzer's entry: reads the bytes, swallows InputError and nothing else, aborts when a result is not valid.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace scan_to_path::fuzz {

/// Good inputs to start from, made in code.
std::vector<std::string> seeds();

inline std::string_view asText(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Ends the process with a message when a reader gave a result that breaks its promise.
inline void require(bool holds, const char* promise) {
  if (holds) return;
  std::fprintf(stderr, "broken promise: %s\n", promise);
  std::abort();
}

}  // namespace scan_to_path::fuzz
