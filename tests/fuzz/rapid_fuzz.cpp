// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "fuzz.h"
#include "program/program_cases.h"
#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"
#include "scan_to_path/program/rapid_reader.h"

using namespace scan_to_path;

std::vector<std::string> fuzz::seeds() {
  const auto hand_written = std::string(SCAN_TO_PATH_SOURCE_DIR) + "/tests/program/fixtures/hand_written.mod";
  const auto written = program::writeProgram(program::Controller::abb, test::seededInput(1, 1, 5));
  return {readFile(hand_written), written.at(1).content};
}

/// Any bytes are an InputError of one line, or a program whose targets, speeds and zones are finite.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  program::RapidReadOptions options;
  options.process_signal = "doSpindle";
  options.max_steps = 100000;
  try {
    const auto read = program::readRapid({{"fuzz.mod", std::string(fuzz::asText(data, size))}}, options);
    for (const auto& move : read.moves) {
      fuzz::require(move.T_base_tcp.matrix().allFinite(), "targets are finite");
      fuzz::require(std::isfinite(move.speed) && std::isfinite(move.zone), "speeds and zones are finite");
      fuzz::require(move.tool >= 0 && move.tool < static_cast<int>(read.tools.size()), "a move has a tool");
    }
  } catch (const InputError& error) {
    fuzz::require(std::string_view(error.what()).find('\n') == std::string_view::npos, "a message is one line");
  }
  return 0;
}
