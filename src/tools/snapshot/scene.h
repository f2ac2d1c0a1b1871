// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QSize>
#include <QString>
#include <QStringList>

namespace rviz {
class DisplayGroup;
class RenderPanel;
class VisualizationManager;
}  // namespace rviz

namespace scan_to_path::tools {

/// An rviz scene that is drawn into memory. Needs a QApplication on Qt's offscreen platform and a ROS master.
/// What OGRE made is not taken down again: a process has one scene, and ends with it.
class Scene {
public:
  /// Loads the displays and views of an .rviz file. Throws InputError when it cannot be read or shows nothing.
  Scene(const QString& config, QSize size);

  /// Throws InputError for a name that no enabled display has.
  void disable(const QString& display);

  /// Makes a saved view the current one. Throws InputError, naming those that are, when there is none of that name.
  void setView(const QString& name);

  /// Lets rviz run until every enabled display has what it shows and a few frames were drawn with it. Returns what is
  /// still missing after `timeout` seconds, a text for each display; empty: nothing.
  QStringList waitUntilShown(double timeout);

  /// The current view, as large as the scene.
  QImage draw();

private:
  void runFrames(int count);

  QSize size_;
  rviz::RenderPanel* panel_;
  rviz::VisualizationManager* manager_;
};

}  // namespace scan_to_path::tools
