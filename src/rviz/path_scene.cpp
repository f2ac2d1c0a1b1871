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

/// One line after another: a line begins before its first point.
class Pen {
public:
  explicit Pen(rviz::BillboardLine& lines) : lines_(lines) {}

  void begin() {
    if (!first_) lines_.newLine();
    first_ = false;
  }
  void to(const Vector3& point, const Ogre::ColourValue& color) { lines_.addPoint(toOgre(point), color); }

private:
  rviz::BillboardLine& lines_;
  bool first_ = true;
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

std::unique_ptr<rviz::BillboardLine> PathScene::makeLines(std::size_t lines, std::size_t most_points, float width) {
  auto made = std::make_unique<rviz::BillboardLine>(scene_, node_);
  made->setMaxPointsPerLine(static_cast<std::uint32_t>(most_points));
  made->setNumLines(static_cast<std::uint32_t>(lines));
  made->setLineWidth(width);
  return made;
}

void PathScene::addStrips(const PathDrawing& drawing, const PathLook& look) {
  std::size_t most = 0;
  for (const auto& strip : drawing.strips) most = std::max(most, strip.points.size());
  strips_ = makeLines(drawing.strips.size(), most, look.line_width);
  Pen pen(*strips_);
  for (const auto& strip : drawing.strips) {
    const Ogre::ColourValue color = look.strip_color(strip);
    pen.begin();
    for (const auto& point : strip.points) pen.to(point, color);
  }
}

void PathScene::addArrows(const PathDrawing& drawing, const PathLook& look) {
  arrows_ = makeLines(drawing.arrows.size(), drawing.arrows.front().size(), look.line_width);
  Pen pen(*arrows_);
  for (const auto& arrow : drawing.arrows) {
    pen.begin();
    for (const auto& point : arrow) pen.to(point, look.arrow_color);
  }
}

void PathScene::addFrames(const PathDrawing& drawing, const PathLook& look) {
  // Red, green and blue for x, y and z, as rviz shows frames.
  const std::array<Ogre::ColourValue, 3> colors = {Ogre::ColourValue::Red, Ogre::ColourValue::Green,
                                                   Ogre::ColourValue::Blue};
  frames_ = makeLines(3 * drawing.frames.size(), 2, look.line_width);
  Pen pen(*frames_);
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
