// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <ros/console.h>
#include <ros/init.h>
#include <ros/master.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <QApplication>
#include <QPainter>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "scan_to_path/common/error.h"
#include "scene.h"

namespace scan_to_path::tools {
namespace {

enum Exit { done = 0, not_shown = 1, bad_input = 2 };

struct Flags {
  std::string config;
  std::string out;
  std::string size = "640x480";
  std::vector<std::string> disabled;
  std::vector<std::string> views;
  int columns = 0;
  double timeout = 10.0;
};

void addFlags(CLI::App& app, Flags& flags) {
  app.add_option("--config", flags.config, "what rviz shows, and how")->type_name("FILE.rviz")->required();
  app.add_option("--out", flags.out, "picture to write")->type_name("FILE.png")->required();
  app.add_option("--size", flags.size, "of the picture [pixel]")->type_name("WxH")->capture_default_str();
  app.add_option("--disable", flags.disabled, "switch this display off (repeatable)")
      ->type_name("NAME")
      ->allow_extra_args(false);
  app.add_option("--view", flags.views, "saved view; several share the picture, row by row (repeatable)")
      ->type_name("NAME")
      ->allow_extra_args(false);
  app.add_option("--columns", flags.columns, "of views in the picture (default: as many as rows, or one more)");
  app.add_option("--timeout", flags.timeout, "how long displays may take to show something [s]")->capture_default_str();
}

QSize parseSize(const std::string& text) {
  int width = 0;
  int height = 0;
  char rest = 0;
  const bool is_size = std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) == 2;
  if (!is_size || width < 1 || height < 1 || width > 8192 || height > 8192) {
    throw InputError("--size " + text + ": must be WIDTHxHEIGHT, 1 to 8192 pixels each");
  }
  return {width, height};
}

/// How views share a picture.
struct Grid {
  int columns = 1;
  int rows = 1;
  QSize cell;
};

Grid gridOf(const Flags& flags) {
  const QSize size = parseSize(flags.size);
  const int count = std::max(1, static_cast<int>(flags.views.size()));
  Grid grid;
  grid.columns = flags.columns > 0 ? flags.columns : static_cast<int>(std::ceil(std::sqrt(count)));
  grid.rows = (count + grid.columns - 1) / grid.columns;
  grid.cell = QSize(size.width() / grid.columns, size.height() / grid.rows);
  if (grid.cell.isEmpty())
    throw InputError("--size " + flags.size + ": too small for " + std::to_string(count) + " views");
  return grid;
}

QImage drawViews(Scene& scene, const std::vector<std::string>& views, const Grid& grid) {
  if (views.empty()) return scene.draw();
  QImage picture(grid.cell.width() * grid.columns, grid.cell.height() * grid.rows, QImage::Format_RGB32);
  picture.fill(Qt::white);
  QPainter painter(&picture);
  for (int i = 0; i < static_cast<int>(views.size()); ++i) {
    scene.setView(QString::fromStdString(views[static_cast<std::size_t>(i)]));
    const QRect cell(QPoint(i % grid.columns * grid.cell.width(), i / grid.columns * grid.cell.height()), grid.cell);
    painter.drawImage(cell.topLeft(), scene.draw());
    painter.setPen(Qt::lightGray);
    if (i % grid.columns > 0) painter.drawLine(cell.topLeft(), cell.bottomLeft());
    if (i / grid.columns > 0) painter.drawLine(cell.topLeft(), cell.topRight());
  }
  return picture;
}

/// Nothing on standard error while it lives: rviz's start looks for a package that Debian does not have, Qt for a
/// user's session, and both say so. What matters is thrown, and said in one line at the end.
class QuietStart {
public:
  QuietStart() : kept_(dup(STDERR_FILENO)), nowhere_(open("/dev/null", O_WRONLY | O_CLOEXEC)) {
    std::fflush(stderr);
    if (kept_ >= 0 && nowhere_ >= 0) dup2(nowhere_, STDERR_FILENO);
  }
  ~QuietStart() {
    std::fflush(stderr);
    if (kept_ >= 0 && nowhere_ >= 0) dup2(kept_, STDERR_FILENO);
    for (const int file : {kept_, nowhere_}) {
      if (file >= 0) close(file);
    }
  }
  QuietStart(const QuietStart&) = delete;
  QuietStart& operator=(const QuietStart&) = delete;

private:
  int kept_;
  int nowhere_;
};

Scene startScene(const std::string& config, QSize size, char* program) {
  const QuietStart quiet;
  static int no_arguments = 1;
  static std::vector<char*> arguments = {program, nullptr};
  new QApplication(no_arguments, arguments.data());  // lives as long as the process, as the scene does
  return Scene(QString::fromStdString(config), size);
}

Exit run(const Flags& flags, char* program) {
  const Grid grid = gridOf(flags);
  // A node handle without a master waits for ever.
  if (!ros::master::check()) throw InputError("no ROS master at " + ros::master::getURI());
  Scene scene = startScene(flags.config, grid.cell, program);
  for (const std::string& name : flags.disabled) scene.disable(QString::fromStdString(name));
  const QStringList left = scene.waitUntilShown(flags.timeout);
  if (!left.empty()) {
    std::fprintf(stderr, "snapshot: after %g s: %s\n", flags.timeout, qPrintable(left.join("; ").simplified()));
    return not_shown;
  }
  const QImage picture = drawViews(scene, flags.views, grid);
  if (!picture.save(QString::fromStdString(flags.out), "PNG")) throw InputError(flags.out + ": cannot be written");
  return done;
}

}  // namespace
}  // namespace scan_to_path::tools

/// Draws what rviz would show, without a screen. Exit status: 0 drawn; 1 a display has nothing to show, or not Ok,
/// within the timeout; 2 bad input or no master. Nothing is written unless it is 0.
int main(int argc, char** argv) {
  using namespace scan_to_path::tools;
  qputenv("QT_QPA_PLATFORM", "offscreen");
  qputenv("QT_QPA_OFFSCREEN_NO_GLX", "1");
  ros::init(argc, argv, "snapshot", ros::init_options::AnonymousName | ros::init_options::NoSigintHandler);
  // What matters is said in the one line at the end.
  if (ros::console::set_logger_level("ros", ros::console::levels::Fatal)) ros::console::notifyLoggerLevelsChanged();
  CLI::App cli("Draw what rviz shows into a picture, without a screen");
  Flags flags;
  addFlags(cli, flags);
  int status = bad_input;
  try {
    cli.parse(argc, argv);
    status = run(flags, argv[0]);
  } catch (const CLI::Success& help) {
    status = cli.exit(help);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "snapshot: %s\n", error.what());
  }
  // OGRE and rviz are not made to be taken down without a window system around them.
  std::fflush(nullptr);
  _exit(status);
}
