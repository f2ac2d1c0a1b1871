// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/scan/cloud_io.h"

#include <gmock/gmock.h>

#include <cstring>

#include "scan_to_path/common/random.h"
#include "support/expect_input_error.h"

namespace scan_to_path::scan {
namespace {

using test::expectInputError;

ScanCloud randomCloud(std::size_t count) {
  Random random(1);
  ScanCloud cloud;
  for (std::size_t i = 0; i < count; ++i) {
    ScanPoint point;
    point.x = static_cast<float>(random.uniform());
    point.y = static_cast<float>(random.uniform());
    point.z = static_cast<float>(random.uniform());
    point.line = i % 3 == 0 ? no_line : static_cast<std::uint32_t>(i);
    point.time = random.uniform();
    cloud.push_back(point);
  }
  return cloud;
}

void expectSame(const ScanCloud& a, const ScanCloud& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].x, b[i].x);
    EXPECT_EQ(a[i].y, b[i].y);
    EXPECT_EQ(a[i].z, b[i].z);
    EXPECT_EQ(a[i].line, b[i].line);
    EXPECT_EQ(a[i].time, b[i].time);
  }
}

/// LZF without any compression: literal runs only.
std::string literalLzf(const std::string& data) {
  std::string packed;
  for (std::size_t at = 0; at < data.size(); at += 32) {
    const std::size_t length = std::min<std::size_t>(32, data.size() - at);
    packed += static_cast<char>(length - 1);
    packed += data.substr(at, length);
  }
  return packed;
}

std::string bytesOf(std::uint32_t value) {
  std::string bytes(4, '\0');
  std::memcpy(bytes.data(), &value, 4);
  return bytes;
}

const std::string ascii_header =
    "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z ring t\nSIZE 4 4 8 2 4\nTYPE F F F U U\nCOUNT 1 1 1 1 1\n"
    "WIDTH 3\nHEIGHT 1\nVIEWPOINT 0 0 2 1 0 0 0\nPOINTS 3\nDATA ascii\n";

TEST(CloudIo, BinaryRoundTrip) {
  const ScanCloud cloud = randomCloud(1000);
  const std::string text = formatPcd(cloud);
  EXPECT_TRUE(isPcd(text));
  const CloudFile file = parseCloud(text, "cloud.pcd");
  expectSame(file.cloud, cloud);
  EXPECT_EQ(file.no_return, 0u);
  EXPECT_FALSE(file.viewing_direction);
}

TEST(CloudIo, ViewpointTellsTheViewingDirection) {
  geometry::Frame T = geometry::makeFrame({0.0, 0.0, 0.0}, {3.14159265358979, 0.0, 0.0});
  const CloudFile turned = parseCloud(formatPcd(randomCloud(10), T), "f");
  ASSERT_TRUE(turned.viewing_direction);
  EXPECT_LT((*turned.viewing_direction + geometry::Vector3::UnitZ()).norm(), 1e-8);
  T.translation() = geometry::Vector3(0.5, 0.5, 100.0);
  const CloudFile placed = parseCloud(formatPcd(randomCloud(1000), T), "f");
  EXPECT_LT((*placed.viewing_direction + geometry::Vector3::UnitZ()).norm(), 0.01);
}

TEST(CloudIo, AsciiWithRingNanosecondsAndNoReturns) {
  const CloudFile file = parseCloud(ascii_header + "1 2 3 4 500000000\nnan 0 0 0 0\r\n\n 7  8 9.5 65535 0", "f");
  ASSERT_EQ(file.cloud.size(), 2u);
  EXPECT_EQ(file.no_return, 1u);
  EXPECT_EQ(file.cloud[0].line, 4u);
  EXPECT_DOUBLE_EQ(file.cloud[0].time, 0.5);
  EXPECT_EQ(file.cloud[1].z, 9.5f);
  ASSERT_TRUE(file.viewing_direction);
}

TEST(CloudIo, CompressedFieldsLieOneAfterTheOther) {
  const ScanCloud cloud = randomCloud(100);
  std::string columns;
  for (const auto member : {&ScanPoint::x, &ScanPoint::y, &ScanPoint::z}) {
    for (const ScanPoint& p : cloud) {
      const float value = p.*member;
      columns.append(reinterpret_cast<const char*>(&value), 4);
    }
  }
  const std::string packed = literalLzf(columns);
  const std::string text =
      "# .PCD v0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 100\nHEIGHT 1\nPOINTS 100\n"
      "DATA binary_compressed\n" +
      bytesOf(static_cast<std::uint32_t>(packed.size())) + bytesOf(static_cast<std::uint32_t>(columns.size())) + packed;
  const CloudFile file = parseCloud(text, "f");
  ASSERT_EQ(file.cloud.size(), 100u);
  for (std::size_t i = 0; i < 100; ++i) EXPECT_EQ(file.cloud[i].z, cloud[i].z);
  expectInputError([&] { parseCloud(text.substr(0, text.size() - 1), "f"); }, "f: compressed data is cut off");
}

TEST(CloudIo, PlyWithoutFaces) {
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 2\nproperty double x\nproperty float y\nproperty float z\n"
      "property int line\nproperty double time\nend_header\n";
  const CloudFile file = parseCloud(header + "1 2 3 -1 0.25\n4 5 6 8 0.5\n", "f.ply");
  ASSERT_EQ(file.cloud.size(), 2u);
  EXPECT_EQ(file.cloud[0].line, no_line);
  EXPECT_EQ(file.cloud[1].line, 8u);
  EXPECT_DOUBLE_EQ(file.cloud[1].time, 0.5);
  expectInputError([&] { parseCloud(header + "nan 2 3 -1 0\nnan 5 6 8 0\n", "f.ply"); },
                   "finite coordinates is 0 of 2");
}

TEST(CloudIo, RefusesWhatIsNoCloud) {
  const auto fails = [](const std::string& text, const std::string& message) {
    expectInputError([&] { parseCloud(text, "f"); }, message);
  };
  fails("", "f: content is neither PCD nor PLY");
  fails("# .PCD v0.7\nFIELDS x y z\n", "f line 2: header is cut off");
  fails("# .PCD v0.7\nFIELDS x y\nPOINTS 1\nDATA ascii\n1 2\n", "f: field z is missing");
  fails("# .PCD v0.7\nFIELDS x y z\nSIZE 4 4\nDATA ascii\n", "f line 3: number of entries after SIZE is 2, must be 3");
  fails("# .PCD v0.7\nFIELDS x y z\nPOINTS 1\nDATA zip\n", "f line 4: DATA is unknown");
  fails("# .PCD v0.7\nFIELDS x y z\nPOINTS 4000000000\nDATA binary\nabcdefghijklm",
        "number of points is 4000000000, must be at most the 1");
  fails("# .PCD v0.7\nFIELDS x y z\nPOINTS 2\nDATA ascii\n1 2 3\n", "number of points is 2, must be at most the 1");
  fails("# .PCD v0.7\nFIELDS x y z\nPOINTS 1\nDATA ascii\n1 2\n", "f line 5: number of values is 2, must be 3");
  fails("# .PCD v0.7\nFIELDS x y z\nPOINTS 1\nDATA ascii\n1 2 q\n", "f line 5: z is not a number");
  fails("# .PCD v0.7\nFIELDS x y z\nPOINTS 1\nDATA ascii\nnan nan nan\n", "finite coordinates is 0 of 1");
  expectInputError([] { readCloud("/nonexistent.pcd"); }, "/nonexistent.pcd");
}

TEST(CloudIo, DamagedFilesAreReadOrRefused) {
  const std::string text = formatPcd(randomCloud(50));
  Random random(2);
  for (int round = 0; round < 2000; ++round) {
    std::string damaged = text.substr(0, static_cast<std::size_t>(random.uniform() * static_cast<double>(text.size())));
    for (int k = 0; k < 3 && !damaged.empty(); ++k)
      damaged[random.bits() % std::min<std::size_t>(damaged.size(), 250)] = static_cast<char>(random.bits());
    try {
      EXPECT_LE(parseCloud(damaged, "damaged").cloud.size(), damaged.size());
    } catch (const InputError&) {
    }
  }
}

}  // namespace
}  // namespace scan_to_path::scan
