// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ros/subscriber.h>
#include <rviz/display.h>
#include <scan_to_path/MotionPlan.h>
#include <scan_to_path/PlannedPath.h>
#include <scan_to_path/ToolPath.h>

#include <array>
#include <map>
#include <memory>
#include <vector>

#include "rviz/path_scene.h"

namespace rviz {
class BoolProperty;
class ColorProperty;
class EnumProperty;
class FloatProperty;
class RosTopicProperty;
class StringProperty;
}  // namespace rviz

namespace scan_to_path_rviz {

/// A tool path: where the tool is at work and where not, the direction of travel, contact frames, and the verdicts of
/// the path's or the motion's planner in colours. Only what came for the same job (header.stamp) is put together.
class ToolPathDisplay : public rviz::Display {
public:
  ToolPathDisplay();
  ~ToolPathDisplay() override;

  void setTopic(const QString& topic, const QString& datatype) override;
  void update(float wall_dt, float ros_dt) override;
  void reset() override;

protected:
  void onInitialize() override;
  void onEnable() override;
  void onDisable() override;

private:
  struct Verdicts {
    std_msgs::Header header;
    std::vector<scan_to_path::toolpath::WaypointVerdict> entries;
  };

  void addTopics();
  void addLook();
  void addColors();
  void redrawOnChange(rviz::Property& property);

  void subscribe();
  void unsubscribe();
  void take(const scan_to_path::ToolPathConstPtr& msg);
  void takeVerdicts(const std::string& from, const std_msgs::Header& header,
                    const std::vector<scan_to_path::WaypointVerdict>& msgs);

  void draw();
  bool byVerdict() const;
  scan_to_path_ros::PathDrawingOptions drawingOptions() const;
  PathLook look() const;
  /// The motion's verdicts on this path or, before there are any, the planner's findings; null: neither.
  const Verdicts* verdictsOfPath() const;
  void showFigures(const scan_to_path_ros::PathDrawing& drawing, const Verdicts* verdicts);
  void place();

  rviz::RosTopicProperty* topic_ = nullptr;
  rviz::RosTopicProperty* motion_topic_ = nullptr;
  rviz::RosTopicProperty* findings_topic_ = nullptr;
  rviz::EnumProperty* color_by_ = nullptr;
  rviz::StringProperty* rows_ = nullptr;
  rviz::BoolProperty* links_ = nullptr;
  rviz::FloatProperty* line_width_ = nullptr;
  rviz::FloatProperty* arrow_interval_ = nullptr;
  rviz::FloatProperty* arrow_size_ = nullptr;
  rviz::FloatProperty* frame_interval_ = nullptr;
  rviz::FloatProperty* frame_size_ = nullptr;
  rviz::FloatProperty* mark_size_ = nullptr;
  rviz::ColorProperty* on_color_ = nullptr;
  rviz::ColorProperty* off_color_ = nullptr;
  rviz::ColorProperty* arrow_color_ = nullptr;
  std::array<rviz::ColorProperty*, 8> verdict_colors_ = {};

  std::vector<ros::Subscriber> subscribers_;
  std_msgs::Header header_;
  std::unique_ptr<scan_to_path::toolpath::ToolPath> path_;
  std::map<std::string, Verdicts> verdicts_;  // by where they come from
  std::unique_ptr<PathScene> scene_;
  bool stale_ = false;
};

}  // namespace scan_to_path_rviz
