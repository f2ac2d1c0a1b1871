// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <OgreColourValue.h>

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "scan_to_path_ros/path_drawing.h"

namespace Ogre {
class SceneManager;
class SceneNode;
}  // namespace Ogre

namespace rviz {
class BillboardLine;
class PointCloud;
}  // namespace rviz

namespace scan_to_path_rviz {

/// How a drawing looks; lengths in metres.
struct PathLook {
  std::function<Ogre::ColourValue(const scan_to_path_ros::PathStrip&)> strip_color;
  std::function<Ogre::ColourValue(scan_to_path::toolpath::Verdict)> mark_color;
  Ogre::ColourValue arrow_color;
  float line_width = 0.001F;
  float mark_size = 0.002F;
  float frame_size = 0.01F;
};

/// A drawing as objects of the scene graph, below one node, for as long as this lives.
class PathScene {
public:
  PathScene(Ogre::SceneManager* scene, Ogre::SceneNode* node, const scan_to_path_ros::PathDrawing& drawing,
            const PathLook& look);
  ~PathScene();

private:
  void addStrips(const scan_to_path_ros::PathDrawing& drawing, const PathLook& look);
  void addArrows(const scan_to_path_ros::PathDrawing& drawing, const PathLook& look);
  void addFrames(const scan_to_path_ros::PathDrawing& drawing, const PathLook& look);
  void addMarks(const scan_to_path_ros::PathDrawing& drawing, const PathLook& look);

  Ogre::SceneManager* scene_;
  Ogre::SceneNode* node_;
  std::vector<std::unique_ptr<rviz::BillboardLine>> lines_;
  std::unique_ptr<rviz::PointCloud> marks_;
};

}  // namespace scan_to_path_rviz
