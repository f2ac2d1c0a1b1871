// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/common/output_directory.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "scan_to_path/common/text.h"
#include "support/expect_input_error.h"

namespace scan_to_path {
namespace {

namespace fs = std::filesystem;
using test::expectInputError;

bool anyFile(const std::string&) { return true; }

/// A directory of its own for every test, removed afterwards.
class OutputDirectoryTest : public ::testing::Test {
protected:
  OutputDirectoryTest()
      : root_(fs::path(::testing::TempDir()) / ("output_directory_test_" + std::to_string(::getpid()))),
        out_(root_ / "deep" / "cutting") {
    fs::remove_all(root_);
    fs::create_directories(root_);
  }
  ~OutputDirectoryTest() override { fs::remove_all(root_); }

  void writeOlderResult() const {
    OutputDirectory older(out_, anyFile);
    older.write("path.csv", "old path");
    older.write("program.mod", "old program");
    older.commit();
  }

  std::size_t entriesBeside() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(out_.parent_path()), {}));
  }

  fs::path root_;
  fs::path out_;
};

TEST_F(OutputDirectoryTest, AppearsOnlyWithCommit) {
  OutputDirectory directory(out_, anyFile);
  directory.write("path.csv", "a path");
  EXPECT_FALSE(fs::exists(out_));
  directory.commit();
  EXPECT_EQ(readFile(out_ / "path.csv"), "a path");
  EXPECT_EQ(entriesBeside(), 1U);
}

TEST_F(OutputDirectoryTest, WithoutCommitTheOlderResultStays) {
  writeOlderResult();
  {
    OutputDirectory directory(out_, anyFile);
    directory.write("path.csv", "new path");
  }
  EXPECT_EQ(readFile(out_ / "path.csv"), "old path");
  EXPECT_EQ(readFile(out_ / "program.mod"), "old program");
  EXPECT_EQ(entriesBeside(), 1U);
}

TEST_F(OutputDirectoryTest, CommitRemovesFilesOfTheOlderResult) {
  writeOlderResult();
  OutputDirectory directory(out_, anyFile);
  directory.write("path.csv", "new path");
  directory.commit();
  EXPECT_EQ(readFile(out_ / "path.csv"), "new path");
  EXPECT_FALSE(fs::exists(out_ / "program.mod"));
  EXPECT_EQ(entriesBeside(), 1U);
}

TEST_F(OutputDirectoryTest, LeftOversOfAKilledRunAreReplaced) {
  fs::create_directories(out_.string() + ".part");
  fs::create_directories(out_.string() + ".old");
  writeFileAtomically(out_.string() + ".part/stale", "x");
  OutputDirectory directory(out_.string() + "/", anyFile);
  directory.write("path.csv", "a path");
  directory.commit();
  EXPECT_FALSE(fs::exists(out_ / "stale"));
  EXPECT_EQ(entriesBeside(), 1U);
}

TEST_F(OutputDirectoryTest, RefusesToReplaceWhatIsNotAResult) {
  const auto is_ours = [](const std::string& name) { return name == "path.csv"; };
  for (const char* suffix : {"", ".part", ".old"}) {
    const fs::path directory = out_.string() + suffix;
    fs::create_directories(directory);
    writeFileAtomically(directory / "path.csv", "ours");
    { OutputDirectory replaced(out_, is_ours); }
    fs::create_directories(directory);
    writeFileAtomically(directory / "thesis.txt", "three years");
    expectInputError([&] { OutputDirectory refused(out_, is_ours); }, "holds thesis.txt");
    EXPECT_EQ(readFile(directory / "thesis.txt"), "three years");
    fs::remove_all(directory);
  }
}

TEST_F(OutputDirectoryTest, RefusesWhatIsNotADirectory) {
  writeFileAtomically(root_ / "file", "x");
  expectInputError([&] { OutputDirectory directory(root_ / "file", anyFile); }, "exists and is not a directory");
  // A file on the way: also true for root, whom no permission stops.
  expectInputError([&] { OutputDirectory directory(root_ / "file" / "out", anyFile); }, "cannot ");
  expectInputError([] { OutputDirectory directory("/proc/scan_to_path", anyFile); },
                   "cannot create /proc/scan_to_path.part");
  EXPECT_EQ(readFile(root_ / "file"), "x");
}

TEST_F(OutputDirectoryTest, FailedWriteIsToldAndLeavesTheOlderResult) {
  writeOlderResult();
  {
    OutputDirectory directory(out_, anyFile);
    expectInputError([&] { directory.write("no/such/directory", "x"); }, "cannot write ");
    fs::create_symlink("/dev/full", out_.string() + ".part/full");
    expectInputError([&] { directory.write("full", "x"); }, "No space left on device");
  }
  EXPECT_EQ(readFile(out_ / "path.csv"), "old path");
}

TEST_F(OutputDirectoryTest, CommitThatCannotRenameLeavesTheOlderResult) {
  writeOlderResult();
  OutputDirectory directory(out_, anyFile);
  fs::remove_all(out_.string() + ".part");
  expectInputError([&] { directory.commit(); }, "cannot create " + out_.string());
  EXPECT_EQ(readFile(out_ / "path.csv"), "old path");
}

TEST_F(OutputDirectoryTest, FileIsWrittenWholeOrNotAtAll) {
  const fs::path file = root_ / "samples.csv";
  writeFileAtomically(file, "first");
  writeFileAtomically(file, "second");
  EXPECT_EQ(readFile(file), "second");
  EXPECT_FALSE(fs::exists(file.string() + ".part"));
  fs::create_directories(root_ / "directory" / "inner");
  expectInputError([&] { writeFileAtomically(root_ / "directory", "x"); }, "cannot write ");
  EXPECT_FALSE(fs::exists(root_ / "directory.part"));
  expectInputError([&] { writeFileAtomically(root_ / "none" / "f", "x"); }, "No such file or directory");
}

TEST_F(OutputDirectoryTest, FullDiskLeavesTheOlderFile) {
  const fs::path file = root_ / "samples.csv";
  writeFileAtomically(file, "first");
  fs::create_symlink("/dev/full", file.string() + ".part");
  expectInputError([&] { writeFileAtomically(file, "second"); }, "No space left on device");
  EXPECT_EQ(readFile(file), "first");
  EXPECT_FALSE(fs::exists(fs::symlink_status(file.string() + ".part")));
}

TEST_F(OutputDirectoryTest, DevicesAreWrittenToNotReplaced) {
  // Through a link, so that a failure of this test replaces the link and not the device.
  const fs::path link = root_ / "device";
  fs::create_symlink("/dev/full", link);
  expectInputError([&] { writeFileAtomically(link, "x"); }, "No space left on device");
  EXPECT_TRUE(fs::is_symlink(link));
  fs::remove(link);
  fs::create_symlink("/dev/null", link);
  writeFileAtomically(link, "x");
  EXPECT_TRUE(fs::is_character_file(link));
}

}  // namespace
}  // namespace scan_to_path
