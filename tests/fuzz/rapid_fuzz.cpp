// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <string>

#include "scan_to_path/common/error.h"
#include "scan_to_path/program/rapid_reader.h"

/// Any bytes are a program or an InputError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  scan_to_path::program::RapidReadOptions options;
  options.process_signal = "doSpindle";
  options.max_steps = 100000;
  try {
    scan_to_path::program::readRapid({{"fuzz.mod", std::string(reinterpret_cast<const char*>(data), size)}}, options);
  } catch (const scan_to_path::InputError&) {
  }
  return 0;
}
