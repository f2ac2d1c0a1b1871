// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "rviz/tool_path_display.h"

#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <rviz/display_context.h>
#include <rviz/frame_manager.h>
#include <rviz/properties/bool_property.h>
#include <rviz/properties/color_property.h>
#include <rviz/properties/enum_property.h>
#include <rviz/properties/float_property.h>
#include <rviz/properties/ros_topic_property.h>
#include <rviz/properties/string_property.h>
#include <pluginlib/class_list_macros.hpp>

#include "scan_to_path/common/error.h"
#include "scan_to_path_ros/conversions.h"

namespace scan_to_path_rviz {
namespace {

using rviz::StatusProperty;
using scan_to_path::toolpath::Verdict;
using scan_to_path_ros::PathDrawing;
using scan_to_path_ros::PathStrip;

enum ColorBy { by_process, by_verdict };

constexpr const char* motion = "motion";
constexpr const char* findings = "findings";

/// Of the verdicts, in their order: apart from each other and from the two colours of the process.
const std::array<QColor, 8> verdict_palette = {QColor(40, 180, 60), QColor(220, 30, 30), QColor(150, 60, 200),
                                               QColor(255, 150, 0), QColor(240, 220, 0), QColor(120, 30, 30),
                                               QColor(0, 170, 220), QColor(240, 90, 180)};

template <class Message>
QString typeName() {
  return QString::fromStdString(ros::message_traits::datatype<Message>());
}

rviz::FloatProperty* length(const char* name, double value, const char* what, rviz::Property* parent) {
  auto* property = new rviz::FloatProperty(name, static_cast<float>(value), what, parent);
  property->setMin(0.0F);
  return property;
}

}  // namespace

ToolPathDisplay::ToolPathDisplay() {
  addTopics();
  const int topics = numChildren();
  addLook();
  addColors();
  for (int i = topics; i < numChildren(); ++i) redrawOnChange(*childAt(i));
}

ToolPathDisplay::~ToolPathDisplay() { unsubscribe(); }

void ToolPathDisplay::addTopics() {
  topic_ = new rviz::RosTopicProperty("Topic", "tool_path", typeName<scan_to_path::ToolPath>(), "the tool path", this);
  motion_topic_ = new rviz::RosTopicProperty("Motion Topic", "motion_plan", typeName<scan_to_path::MotionPlan>(),
                                             "verdicts of the motion on the path's waypoints; empty: none", this);
  findings_topic_ = new rviz::RosTopicProperty("Findings Topic", "planned_path", typeName<scan_to_path::PlannedPath>(),
                                               "what the path planner found; shown until the motion's verdicts come; "
                                               "empty: none",
                                               this);
  for (auto* topic : {topic_, motion_topic_, findings_topic_}) {
    connect(topic, &rviz::Property::changed, this, [this] { reset(); });
  }
}

void ToolPathDisplay::addLook() {
  const scan_to_path_ros::PathDrawingOptions drawing;
  const PathLook look;
  color_by_ =
      new rviz::EnumProperty("Color By", "process", "process: tool at work or not; verdict: of each waypoint", this);
  color_by_->addOption("process", by_process);
  color_by_->addOption("verdict", by_verdict);
  rows_ = new rviz::StringProperty("Rows", "all", "rows to show, such as \"3, 7-9\"", this);
  links_ = new rviz::BoolProperty("Links", drawing.links, "show approaches, links and retracts", this);
  line_width_ = length("Line Width", look.line_width, "[m]", this);
  arrow_interval_ =
      length("Arrow Interval", drawing.arrow_interval, "between arrows in the direction of travel [m]; 0: none", this);
  arrow_size_ = length("Arrow Size", drawing.arrow_size, "[m]", this);
  frame_interval_ = length("Frame Interval", drawing.frame_interval, "between contact frames [m]; 0: none", this);
  frame_size_ = length("Frame Size", look.frame_size, "[m]", this);
  mark_size_ = length("Mark Size", look.mark_size, "of the dots on waypoints that are not ok [m]", this);
}

void ToolPathDisplay::addColors() {
  on_color_ = new rviz::ColorProperty("Process On Color", QColor(30, 120, 255), "the tool is at work", this);
  off_color_ = new rviz::ColorProperty("Process Off Color", QColor(160, 160, 160), "the tool is not at work", this);
  arrow_color_ = new rviz::ColorProperty("Arrow Color", QColor(255, 255, 255), "direction of travel", this);
  auto* group = new rviz::Property("Verdict Colors", QVariant(), "of waypoints, and of moves to or from them", this);
  for (std::size_t i = 0; i < verdict_colors_.size(); ++i) {
    const char* name = scan_to_path::EnumNames<Verdict>::names[i];
    verdict_colors_[i] = new rviz::ColorProperty(name, verdict_palette[i], "", group);
  }
}

void ToolPathDisplay::redrawOnChange(rviz::Property& property) {
  connect(&property, &rviz::Property::changed, this, [this] { stale_ = true; });
  for (int i = 0; i < property.numChildren(); ++i) redrawOnChange(*property.childAt(i));
}

void ToolPathDisplay::onInitialize() { setStatus(StatusProperty::Warn, "Path", "no path yet"); }

void ToolPathDisplay::onEnable() { subscribe(); }

void ToolPathDisplay::onDisable() {
  unsubscribe();
  scene_.reset();
}

void ToolPathDisplay::setTopic(const QString& topic, const QString&) { topic_->setString(topic); }

void ToolPathDisplay::reset() {
  rviz::Display::reset();
  if (!initialized()) return;
  unsubscribe();
  scene_.reset();
  setStatus(StatusProperty::Warn, "Path", "no path yet");
  if (isEnabled()) subscribe();
}

void ToolPathDisplay::subscribe() {
  try {
    if (!topic_->getTopicStd().empty()) {
      subscribers_.push_back(update_nh_.subscribe<scan_to_path::ToolPath>(
          topic_->getTopicStd(), 1, [this](const scan_to_path::ToolPathConstPtr& msg) { take(msg); }));
    }
    if (!motion_topic_->getTopicStd().empty()) {
      subscribers_.push_back(update_nh_.subscribe<scan_to_path::MotionPlan>(
          motion_topic_->getTopicStd(), 1,
          [this](const scan_to_path::MotionPlanConstPtr& msg) { takeVerdicts(motion, msg->header, msg->verdicts); }));
    }
    if (!findings_topic_->getTopicStd().empty()) {
      subscribers_.push_back(update_nh_.subscribe<scan_to_path::PlannedPath>(
          findings_topic_->getTopicStd(), 1, [this](const scan_to_path::PlannedPathConstPtr& msg) {
            takeVerdicts(findings, msg->header, msg->findings);
          }));
    }
    setStatus(StatusProperty::Ok, "Topic", "OK");
  } catch (const ros::Exception& error) {
    setStatus(StatusProperty::Error, "Topic", error.what());
  }
}

void ToolPathDisplay::unsubscribe() {
  subscribers_.clear();
  path_.reset();
  verdicts_.clear();
}

void ToolPathDisplay::take(const scan_to_path::ToolPathConstPtr& msg) {
  path_.reset();
  scene_.reset();
  try {
    path_ = std::make_unique<scan_to_path::toolpath::ToolPath>(scan_to_path_ros::fromMsg(*msg));
    header_ = msg->header;
    stale_ = true;
    setStatus(StatusProperty::Ok, "Topic", "path received");  // as rviz's own: "OK" while nothing has come
  } catch (const scan_to_path::InputError& error) {
    setStatus(StatusProperty::Error, "Path", error.what());
  }
}

void ToolPathDisplay::takeVerdicts(const std::string& from, const std_msgs::Header& header,
                                   const std::vector<scan_to_path::WaypointVerdict>& msgs) {
  Verdicts verdicts = {header, {}};
  try {
    for (const auto& msg : msgs) verdicts.entries.push_back(scan_to_path_ros::fromMsg(msg));
    verdicts_[from] = std::move(verdicts);
  } catch (const scan_to_path::InputError& error) {
    verdicts_.erase(from);
    setStatus(StatusProperty::Error, "Verdicts", error.what());
  }
  stale_ = true;
}

void ToolPathDisplay::update(float, float) {
  if (!path_) return;
  if (stale_) draw();
  place();
}

void ToolPathDisplay::draw() {
  stale_ = false;
  scene_.reset();
  try {
    const Verdicts* verdicts = verdictsOfPath();
    const auto drawing = scan_to_path_ros::drawPath(
        *path_,
        byVerdict() && verdicts != nullptr ? verdicts->entries : std::vector<scan_to_path::toolpath::WaypointVerdict>(),
        drawingOptions());
    scene_ = std::make_unique<PathScene>(scene_manager_, scene_node_, drawing, look());
    showFigures(drawing, verdicts);
  } catch (const scan_to_path::InputError& error) {
    setStatus(StatusProperty::Error, "Path", error.what());
  }
  context_->queueRender();
}

bool ToolPathDisplay::byVerdict() const { return color_by_->getOptionInt() == by_verdict; }

scan_to_path_ros::PathDrawingOptions ToolPathDisplay::drawingOptions() const {
  scan_to_path_ros::PathDrawingOptions options;
  const std::string rows = rows_->getStdString();
  if (!scan_to_path::trimmed(rows).empty()) options.rows = scan_to_path::toolpath::RowSelection::parse(rows, "rows");
  options.links = links_->getBool();
  options.arrow_interval = arrow_interval_->getFloat();
  options.arrow_size = arrow_size_->getFloat();
  options.frame_interval = frame_interval_->getFloat();
  return options;
}

PathLook ToolPathDisplay::look() const {
  PathLook look;
  look.strip_color = [this](const PathStrip& strip) {
    if (byVerdict()) return verdict_colors_[static_cast<std::size_t>(strip.verdict)]->getOgreColor();
    return (strip.process_on ? on_color_ : off_color_)->getOgreColor();
  };
  look.mark_color = [this](Verdict verdict) {
    return verdict_colors_[static_cast<std::size_t>(verdict)]->getOgreColor();
  };
  look.arrow_color = arrow_color_->getOgreColor();
  look.line_width = line_width_->getFloat();
  look.mark_size = mark_size_->getFloat();
  look.frame_size = frame_size_->getFloat();
  return look;
}

const ToolPathDisplay::Verdicts* ToolPathDisplay::verdictsOfPath() const {
  for (const char* from : {motion, findings}) {
    const auto found = verdicts_.find(from);
    if (found != verdicts_.end() && found->second.header.stamp == header_.stamp) return &found->second;
  }
  return nullptr;
}

void ToolPathDisplay::showFigures(const PathDrawing& drawing, const Verdicts* verdicts) {
  setStatusStd(StatusProperty::Ok, "Path", scan_to_path_ros::describePath(drawing));
  setStatusStd(StatusProperty::Ok, "Rows",
               std::to_string(drawing.rows_shown) + " of " + std::to_string(drawing.rows) + " shown");
  if (!byVerdict()) {
    deleteStatus("Verdicts");
  } else if (verdicts == nullptr) {
    setStatus(StatusProperty::Warn, "Verdicts", "none for this path yet");
  } else {
    setStatusStd(StatusProperty::Ok, "Verdicts", scan_to_path_ros::describeVerdicts(drawing));
  }
}

/// The path stays where its frame is now: an old path does not fall out of tf2's memory.
void ToolPathDisplay::place() {
  Ogre::Vector3 position;
  Ogre::Quaternion orientation;
  const bool known = context_->getFrameManager()->getTransform(header_.frame_id, ros::Time(), position, orientation);
  scene_node_->setVisible(known);
  if (known) {
    scene_node_->setPosition(position);
    scene_node_->setOrientation(orientation);
    deleteStatus("Frame");
  } else {
    setStatusStd(StatusProperty::Error, "Frame", "no transform from " + header_.frame_id + " to the fixed frame");
  }
}

}  // namespace scan_to_path_rviz

PLUGINLIB_EXPORT_CLASS(scan_to_path_rviz::ToolPathDisplay, rviz::Display)
