// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "rviz/path_scene.h"

#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <rviz/ogre_helpers/billboard_line.h>
#include <rviz/ogre_helpers/point_cloud.h>

#include <algorithm>

namespace scan_to_path_rviz {
namespace {

using scan_to_path::geometry::Vector3;
using scan_to_path_ros::PathDrawing;

Ogre::Vector3 toOgre(const Vector3& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

constexpr std::size_t chain_points = 65536 / 4;  // of one of OGRE's chains in rviz's lines

/// Draws lines of at most `most_points`, in as many of rviz's objects as it takes for each to be one chain. An object
/// of more counts points to choose the chain and lines to choose the place in it, and so mixes up lines of unequal
/// length.
class Pen {
public:
  Pen(Ogre::SceneManager* scene, Ogre::SceneNode* node, std::size_t lines, std::size_t most_points, float width,
      std::vector<std::unique_ptr<rviz::BillboardLine>>& drawn)
      : scene_(scene), node_(node), lines_left_(lines), most_points_(most_points), width_(width), drawn_(drawn) {}

  /// A line begins before its first point.
  void begin() {
    if (lines_here_ == 0)
      add();
    else
      drawn_.back()->newLine();
    --lines_here_;
  }
  void to(const Vector3& point, const Ogre::ColourValue& color) { drawn_.back()->addPoint(toOgre(point), color); }

private:
  void add() {
    lines_here_ = std::min(lines_left_, chain_points / most_points_);
    lines_left_ -= lines_here_;
    auto& made = drawn_.emplace_back(std::make_unique<rviz::BillboardLine>(scene_, node_));
    made->setMaxPointsPerLine(static_cast<std::uint32_t>(most_points_));
    made->setNumLines(static_cast<std::uint32_t>(lines_here_));
    made->setLineWidth(width_);
  }

  Ogre::SceneManager* scene_;
  Ogre::SceneNode* node_;
  std::size_t lines_left_;
  std::size_t most_points_;
  float width_;
  std::vector<std::unique_ptr<rviz::BillboardLine>>& drawn_;
  std::size_t lines_here_ = 0;
};

}  // namespace

PathScene::PathScene(Ogre::SceneManager* scene, Ogre::SceneNode* node, const PathDrawing& drawing, const PathLook& look)
    : scene_(scene), node_(node) {
  if (!drawing.strips.empty()) addStrips(drawing, look);
  if (!drawing.arrows.empty()) addArrows(drawing, look);
  if (!drawing.frames.empty()) addFrames(drawing, look);
  if (!drawing.marks.empty()) addMarks(drawing, look);
}

PathScene::~PathScene() {
  if (marks_) node_->detachObject(marks_.get());
}

void PathScene::addStrips(const PathDrawing& drawing, const PathLook& look) {
  std::size_t most = 0;
  for (const auto& strip : drawing.strips) most = std::max(most, strip.points.size());
  Pen pen(scene_, node_, drawing.strips.size(), most, look.line_width, lines_);
  for (const auto& strip : drawing.strips) {
    const Ogre::ColourValue color = look.strip_color(strip);
    pen.begin();
    for (const auto& point : strip.points) pen.to(point, color);
  }
}

void PathScene::addArrows(const PathDrawing& drawing, const PathLook& look) {
  Pen pen(scene_, node_, drawing.arrows.size(), drawing.arrows.front().size(), look.line_width, lines_);
  for (const auto& arrow : drawing.arrows) {
    pen.begin();
    for (const auto& point : arrow) pen.to(point, look.arrow_color);
  }
}

void PathScene::addFrames(const PathDrawing& drawing, const PathLook& look) {
  // Red, green and blue for x, y and z, as rviz shows frames.
  const std::array<Ogre::ColourValue, 3> colors = {Ogre::ColourValue::Red, Ogre::ColourValue::Green,
                                                   Ogre::ColourValue::Blue};
  Pen pen(scene_, node_, 3 * drawing.frames.size(), 2, look.line_width, lines_);
  for (const auto& frame : drawing.frames) {
    for (int axis = 0; axis < 3; ++axis) {
      const Ogre::ColourValue& color = colors[static_cast<std::size_t>(axis)];
      pen.begin();
      pen.to(frame.translation(), color);
      pen.to(frame.translation() + static_cast<double>(look.frame_size) * frame.linear().col(axis), color);
    }
  }
}

void PathScene::addMarks(const PathDrawing& drawing, const PathLook& look) {
  std::vector<rviz::PointCloud::Point> points;
  for (const auto& mark : drawing.marks) points.push_back({toOgre(mark.point), look.mark_color(mark.verdict)});
  marks_ = std::make_unique<rviz::PointCloud>();
  marks_->setRenderMode(rviz::PointCloud::RM_SPHERES);
  marks_->setDimensions(look.mark_size, look.mark_size, look.mark_size);
  marks_->addPoints(points.data(), static_cast<std::uint32_t>(points.size()));
  node_->attachObject(marks_.get());
}

}  // namespace scan_to_path_rviz
