// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "fuzz.h"
#include "scan_to_path/common/error.h"
#include "scan_to_path/scan/sample_log.h"

std::vector<std::string> scan_to_path::fuzz::seeds() {
  return {
      "# scan_to_path samples "
      "1\nt,joint_1,joint_2,voltage\n0.000000,100,-200,1.25\n0.001000,,,nan\n0.002000,101,-201.5,\n",
      "# scan_to_path samples 1\r\n# made by hand\r\nt,a,voltage\r\n-1e-3,2147483647,-5\r\n0,-2147483648,5\r\n"};
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace scan_to_path;
  try {
    const scan::SampleLog log = scan::parseSampleLog(fuzz::asText(data, size), "fuzz");
    fuzz::require(log.counts.size() == log.joint_time.size() * log.joint_names.size(), "counts for every joint");
    fuzz::require(log.voltage.size() == log.sensor_time.size() && !log.voltage.empty(), "a voltage for every time");
    for (std::size_t i = 1; i < log.sensor_time.size(); ++i) {
      fuzz::require(log.sensor_time[i] > log.sensor_time[i - 1], "time rises");
    }
    for (const double count : log.counts) fuzz::require(std::isfinite(count), "counts are finite");
  } catch (const InputError&) {
  }
  return 0;
}
