// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "picture_comparison.h"

namespace scan_to_path {
namespace {

using test_support::DisplayColour;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

const QColor blue(0, 90, 160);          // clouds and curves, flat
const QColor marker_blue(0, 115, 178);  // spheres, shaded from it to black
const QColor marker_green(0, 158, 115);
const QColor marker_vermilion(214, 94, 0);
const QColor vermilion(213, 94, 0);
const QColor amber(230, 159, 0);
const QColor path_blue(30, 120, 255);
const QColor scan_grey(190, 190, 190);

struct Figure {
  std::string name;                     ///< of rviz/<name>.rviz and of <name>.png beside this file
  std::string options;                  ///< snapshot's --view, --columns and --disable
  std::vector<DisplayColour> displays;  ///< the main display first
};

void PrintTo(const Figure& figure, std::ostream* out) { *out << figure.name; }

const std::vector<Figure> figures = {
    {"fig_07_raw_cloud", "", {{"Raw cloud", blue, blue}}},
    {"fig_08_filtered_cloud", "", {{"Filtered cloud", blue, blue}, {"Outline", vermilion, vermilion}}},
    {"fig_09_fit",
     "--view 3D --view XY --view XZ --view YZ",
     {{"Samples", vermilion, vermilion.darker(200)}, {"Fitted curve", blue, blue}}},
    {"fig_10_normals", "--view side --view top --columns 1", {{"Normals", marker_green, marker_green.darker(300)}}},
    {"fig_11_pca_normals",
     "--view side --view top --columns 1",
     {{"PCA normals", marker_vermilion, marker_vermilion.darker(300)}}},
    {"fig_12_played_back_row",
     "--view cell --view row",
     {{"Planned row", amber, amber},
      {"Robot", QColor(255, 107, 27), QColor(120, 45, 10)},
      {"Played back", marker_blue, marker_blue.darker(300)}}},
    // What comes while a scan runs, and what only a job with a region has, is not shown.
    {"cell",
     "--view cell --view part --disable 'Scan, live' --disable Region",
     {{"Tool path", path_blue, path_blue.darker(120)},
      {"Robot", QColor(255, 107, 27), QColor(120, 45, 10)},
      {"Scan", scan_grey, scan_grey.darker(150)}}},
};

const std::filesystem::path source = SCAN_TO_PATH_SOURCE_DIR;

std::filesystem::path pictureFile(const Figure& figure, const std::string& kind) {
  return std::filesystem::temp_directory_path() /
         ("snapshots_test_" + std::to_string(getpid()) + "_" + figure.name + kind + ".png");
}

/// Exit status of snapshot, which stands beside this test; what it says on standard error goes to the file `errors`, if
/// given.
int snapshot(const std::string& arguments, const std::string& errors = "") {
  const auto program = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "snapshot";
  const int status =
      std::system((program.string() + " " + arguments + (errors.empty() ? "" : " 2> " + errors)).c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::string configOf(const Figure& figure) { return (source / "rviz" / (figure.name + ".rviz")).string(); }

/// For a picture [s]; of a processor's time, as others may be busy with theirs.
constexpr double longest = 2.0;

/// Of all programs that this one has waited for [s].
double processorTime() {
  rusage usage = {};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// The figure as it is drawn now; null when it is not. Says how long it took.
QImage draw(const Figure& figure, const std::string& options = "") {
  const auto file = pictureFile(figure, "");
  const auto begin = std::chrono::steady_clock::now();
  const double processor_begin = processorTime();
  std::filesystem::remove(file);
  // On a machine that builds at the same time the scene may take its time to come up; drawing itself takes no second.
  const int status = snapshot("--config " + configOf(figure) + " --out " + file.string() + " --timeout 60 " +
                              figure.options + " " + options);
  EXPECT_EQ(status, 0);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const double processor_seconds = processorTime() - processor_begin;
  std::printf("%s: %.2f s, %.2f s of a processor's\n", figure.name.c_str(), seconds, processor_seconds);
  EXPECT_LT(processor_seconds, longest);
  const QImage picture(QString::fromStdString(file.string()));
  std::filesystem::remove(file);
  return picture;
}

QImage golden(const Figure& figure) {
  return QImage(QString::fromStdString((source / "tests/snapshots" / (figure.name + ".png")).string()));
}

class Snapshots : public testing::TestWithParam<Figure> {};

TEST_P(Snapshots, AreThePicturesOfThisFolder) {
  const Figure& figure = GetParam();
  const QImage picture = draw(figure);
  ASSERT_FALSE(picture.isNull());
  EXPECT_EQ(picture.size(), QSize(640, 480));
  if (const char* folder = std::getenv("SCAN_TO_PATH_UPDATE_SNAPSHOTS")) {  // set by scripts/update_snapshots only
    ASSERT_TRUE(picture.save(QString::fromUtf8(folder) + "/" + QString::fromStdString(figure.name) + ".png"));
    return;
  }
  const auto wrong = test_support::compare(golden(figure), picture, figure.displays);
  EXPECT_THAT(wrong, IsEmpty());
  if (!wrong.empty()) {
    const auto kept = pictureFile(figure, "_now");
    picture.save(QString::fromStdString(kept.string()));
    ADD_FAILURE() << "what it looks like now: " << kept;
  }
}

TEST_P(Snapshots, MissTheirMainDisplay) {
  if (std::getenv("SCAN_TO_PATH_UPDATE_SNAPSHOTS")) GTEST_SKIP() << "pictures are being written";
  const Figure& figure = GetParam();
  const std::string& display = figure.displays.front().display;
  const QImage picture = draw(figure, "--disable '" + display + "'");
  ASSERT_FALSE(picture.isNull());
  EXPECT_THAT(test_support::compare(golden(figure), picture, figure.displays),
              Contains(HasSubstr(display + " covers")));
}

INSTANTIATE_TEST_SUITE_P(Figures, Snapshots, testing::ValuesIn(figures),
                         [](const auto& info) { return info.param.name; });

struct BadCall {
  std::string name;
  std::string arguments;
  int status;
  std::string message;
};

void PrintTo(const BadCall& call, std::ostream* out) { *out << call.name; }

class SnapshotCalls : public testing::TestWithParam<BadCall> {};

TEST_P(SnapshotCalls, FailWithOneLineAndNoPicture) {
  const BadCall& call = GetParam();
  const auto folder = std::filesystem::temp_directory_path() / ("snapshots_test_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  const auto picture = folder / "picture.png";
  const auto errors = folder / "errors";
  EXPECT_EQ(snapshot("--out " + picture.string() + " " + call.arguments, errors.string()), call.status);
  EXPECT_FALSE(std::filesystem::exists(picture));
  const std::string text = [&] {
    std::ifstream file(errors);
    return std::string(std::istreambuf_iterator<char>(file), {});
  }();
  EXPECT_THAT(text, HasSubstr(call.message));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
  std::filesystem::remove_all(folder);
}

const std::string fig_07 = "--config " + configOf(figures.front());

INSTANTIATE_TEST_SUITE_P(
    Calls, SnapshotCalls,
    testing::Values(BadCall{"no_config", "--config /nowhere.rviz", 2, "no such file"},
                    BadCall{"no_configuration", "--config " + (source / "config/part_scan.yaml").string(), 2,
                            "no rviz configuration"},
                    BadCall{"no_display", fig_07 + " --disable Cloud", 2, "--disable Cloud"},
                    BadCall{"no_view", fig_07 + " --view top", 2, "--view top"},
                    BadCall{"no_size", fig_07 + " --size 640", 2, "--size 640"},
                    BadCall{"no_flag", fig_07 + " --picture x", 2, "--picture"},
                    // In another namespace nobody publishes the cloud.
                    BadCall{"no_cloud", fig_07 + " --timeout 1 __ns:=/elsewhere", 1, "display 'Raw cloud'"}),
    [](const auto& info) { return info.param.name; });

TEST(SnapshotMaster, IsMissed) {
  const std::string uri = std::getenv("ROS_MASTER_URI");
  setenv("ROS_MASTER_URI", "http://127.0.0.1:1", 1);  // nothing listens on port 1
  EXPECT_EQ(snapshot(fig_07 + " --out /nowhere.png", "/dev/null"), 2);
  setenv("ROS_MASTER_URI", uri.c_str(), 1);
}

}  // namespace
}  // namespace scan_to_path
