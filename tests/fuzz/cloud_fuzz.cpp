// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "fuzz.h"
#include "scan_to_path/common/error.h"
#include "scan_to_path/scan/cloud_io.h"

std::vector<std::string> scan_to_path::fuzz::seeds() {
  scan::ScanCloud cloud;
  for (int i = 0; i < 4; ++i) {
    scan::ScanPoint point;
    point.x = static_cast<float>(i);
    point.y = 0.5F;
    point.z = -1.0F;
    point.line = static_cast<std::uint32_t>(i / 2);
    point.time = 0.001 * i;
    cloud.push_back(point);
  }
  const std::string header =
      "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z ring t\nSIZE 4 4 4 2 4\nTYPE F F F U U\nCOUNT 1 1 1 1 1\n";
  return {scan::formatPcd(cloud),
          header + "WIDTH 2\nHEIGHT 1\nVIEWPOINT 0 0 1 1 0 0 0\nPOINTS 2\nDATA ascii\n1 2 3 4 5\nnan 0 0 1 2\n",
          "# .PCD v0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 4\nHEIGHT 1\nPOINTS 4\n"
          "DATA binary_compressed\n" +
              std::string("\x05\0\0\0\x30\0\0\0\0\0\xe0\x26\0", 13),
          "ply\nformat ascii 1.0\nelement vertex 2\nproperty double x\nproperty float y\nproperty float z\n"
          "property int line\nproperty double time\nend_header\n1 2 3 -1 0.25\n4 5 6 8 0.5\n"};
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace scan_to_path;
  try {
    const scan::CloudFile file = scan::parseCloud(fuzz::asText(data, size), "fuzz");
    fuzz::require(!file.cloud.empty(), "a cloud has points");
    for (const scan::ScanPoint& p : file.cloud) {
      fuzz::require(!std::isnan(p.x) && !std::isnan(p.y) && !std::isnan(p.z), "points have a place");
    }
  } catch (const InputError&) {
  }
  return 0;
}
