// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <console_bridge/console.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <mutex>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"
#include "scan_to_path/robot/robot.h"

namespace scan_to_path::robot {

namespace {

constexpr int max_depth = 100;  // urdfdom's XML reader recurses per element and would run out of stack

/// Collects what urdfdom would print.
class MessageCollector : public console_bridge::OutputHandler {
public:
  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    // The first says what is wrong, the next ones in which joint or link.
    if (level == console_bridge::CONSOLE_BRIDGE_LOG_ERROR && errors_.size() < max_message) {
      errors_ += (errors_.empty() ? "" : "; ") + text;
    }
  }
  std::string errors() const { return errors_.empty() ? "it is not a robot description" : errors_; }

private:
  static constexpr std::size_t max_message = 200;
  std::mutex mutex_;
  std::string errors_;
};

/// One line of printable characters, as an error message has to be.
std::string printable(std::string text) {
  for (char& c : text) {
    if (std::iscntrl(static_cast<unsigned char>(c)) != 0) c = ' ';
  }
  return std::string(trimmed(text));
}

/// End of the markup that begins at `begin` ('<'), quoted attribute values skipped.
std::size_t tagEnd(const std::string& text, std::size_t begin) {
  char quote = 0;
  for (std::size_t i = begin; i < text.size(); ++i) {
    if (quote != 0) {
      if (text[i] == quote) quote = 0;
    } else if (text[i] == '"' || text[i] == '\'') {
      quote = text[i];
    } else if (text[i] == '>') {
      return i;
    }
  }
  return text.size();
}

std::size_t skipTo(const std::string& text, std::size_t begin, const char* mark) {
  return std::min(text.find(mark, begin), text.size());
}

/// Refuses xacro and nesting deeper than max_depth; anything else is left to the XML reader.
void checkMarkup(const std::string& text) {
  int depth = 0;
  for (std::size_t i = text.find('<'); i < text.size(); i = text.find('<', i + 1)) {
    if (text.compare(i, 4, "<!--") == 0) {
      i = skipTo(text, i, "-->");
    } else if (text.compare(i, 9, "<![CDATA[") == 0) {
      i = skipTo(text, i, "]]>");
    } else if (text.compare(i, 7, "<xacro:") == 0) {
      throw InputError("robot description is a xacro file, must be plain URDF: run xacro on it first");
    } else if (text.compare(i, 2, "</") == 0) {
      --depth;
    } else if (i + 1 < text.size() && (std::isalpha(static_cast<unsigned char>(text[i + 1])) != 0 ||
                                       text[i + 1] == '_' || static_cast<unsigned char>(text[i + 1]) > 127)) {
      i = tagEnd(text, i);
      if (i == text.size() || text[i - 1] != '/') ++depth;
    }
    if (depth > max_depth) {
      throw InputError("robot description", "depth of nested elements", "> " + std::to_string(max_depth),
                       "<= " + std::to_string(max_depth));
    }
    if (i >= text.size()) break;
  }
}

/// urdfdom's links own their children, so a loop of joints would never be freed.
struct ModelDeleter {
  std::shared_ptr<urdf::ModelInterface> model;
  void operator()(urdf::ModelInterface*) {
    for (auto& link : model->links_) {
      link.second->child_links.clear();
      link.second->child_joints.clear();
    }
    model.reset();
  }
};

/// Runs urdfdom with its messages collected instead of printed.
std::shared_ptr<urdf::ModelInterface> parseSilently(const std::string& text, std::string& message) {
  static std::mutex handler_mutex;  // console_bridge has one handler for the whole process
  const std::lock_guard<std::mutex> lock(handler_mutex);
  MessageCollector messages;
  console_bridge::OutputHandler* previous = console_bridge::getOutputHandler();
  console_bridge::useOutputHandler(&messages);
  std::shared_ptr<urdf::ModelInterface> model;
  try {
    model = urdf::parseURDF(text);
    message = messages.errors();
  } catch (const std::exception& error) {
    message = error.what();
  }
  console_bridge::useOutputHandler(previous);
  return model;
}

std::shared_ptr<const urdf::ModelInterface> parseModel(const std::string& text) {
  checkMarkup(text);
  std::string message;
  const auto model = parseSilently(text, message);
  if (model == nullptr) throw InputError("robot description cannot be read: " + printable(message));
  return {model.get(), ModelDeleter{model}};
}

std::vector<std::string> linkNames(const urdf::ModelInterface& model) {
  std::vector<std::string> names;
  for (const auto& link : model.links_) names.push_back(link.first);
  return names;
}

const urdf::Link& findLink(const urdf::ModelInterface& model, const std::string& name) {
  const auto found = model.links_.find(name);
  if (found != model.links_.end()) return *found->second;
  throw InputError("robot " + printable(model.getName()) + " has no link " + name + ", did you mean " +
                   printable(nearestWord(name, linkNames(model))) + "?");
}

/// The URDF's joints from the base to the tip, fixed ones included.
std::vector<const urdf::Joint*> jointsBetween(const urdf::ModelInterface& model, const std::string& base_link,
                                              const std::string& tip_link) {
  findLink(model, base_link);
  std::vector<const urdf::Joint*> joints;
  const urdf::Link* link = &findLink(model, tip_link);
  while (link->name != base_link) {
    if (link->parent_joint == nullptr || joints.size() > model.joints_.size()) {
      throw InputError("robot " + printable(model.getName()) + " has no chain of joints from " + base_link + " to " +
                       tip_link);
    }
    joints.push_back(link->parent_joint.get());
    link = &findLink(model, link->parent_joint->parent_link_name);
  }
  std::reverse(joints.begin(), joints.end());
  return joints;
}

std::string jointLabel(const urdf::Joint& joint) { return "joint " + printable(joint.name); }

Frame jointOrigin(const urdf::Joint& joint) {
  const urdf::Pose& pose = joint.parent_to_joint_origin_transform;
  Eigen::Quaterniond rotation;
  pose.rotation.getQuaternion(rotation.x(), rotation.y(), rotation.z(), rotation.w());
  Frame T = Frame::Identity();
  T.linear() = rotation.normalized().toRotationMatrix();
  T.translation() << pose.position.x, pose.position.y, pose.position.z;
  if (!T.matrix().allFinite()) throw InputError(jointLabel(joint) + ": origin is not finite");
  return T;
}

[[noreturn]] void refuseDegrees(const urdf::Joint& source, const char* quantity, const std::string& value,
                                const char* limit) {
  throw InputError(jointLabel(source) + ": " + quantity + " is " + value + ", must be " + limit +
                   "; it looks like degrees, URDF takes radians (an axis without an end is continuous)");
}

void readLimits(const urdf::Joint& source, Joint& joint) {
  if (source.limits == nullptr)
    throw InputError(jointLabel(source) + ": limit is absent, must have lower, upper, velocity");
  joint.max_velocity = source.limits->velocity;
  if (!(joint.max_velocity > 0.0) || !std::isfinite(joint.max_velocity)) {
    throw InputError(jointLabel(source), "limit velocity", fixed(joint.max_velocity, 6) + " rad/s", "> 0 and finite");
  }
  // Two thirds more than the fastest wrists of six-axis arms, 1100 degrees per second, drive.
  constexpr double fastest = 30.0;
  if (joint.max_velocity > fastest) refuseDegrees(source, "velocity", fixed(joint.max_velocity, 6) + " rad/s", "<= 30");
  if (source.type == urdf::Joint::CONTINUOUS) {
    joint.lower = -std::numeric_limits<double>::infinity();
    joint.upper = std::numeric_limits<double>::infinity();
    return;
  }
  joint.lower = source.limits->lower;
  joint.upper = source.limits->upper;
  const std::string range = fixed(joint.lower, 6) + " to " + fixed(joint.upper, 6) + " rad";
  if (!(joint.lower < joint.upper && std::isfinite(joint.upper - joint.lower))) {
    throw InputError(jointLabel(source), "limit", range, "rising and finite");
  }
  // Eight turns either way, where wrists turn by one or two; in degrees any arm has a joint that turns by more than 50.
  constexpr double largest = 50.0;
  if (joint.lower < -largest || joint.upper > largest) refuseDegrees(source, "limit", range, "within 50 rad");
}

Joint movableJoint(const urdf::Joint& source, const Frame& T_parent_joint) {
  if (source.type != urdf::Joint::REVOLUTE && source.type != urdf::Joint::CONTINUOUS) {
    throw InputError(jointLabel(source) + ": type must be revolute, continuous or fixed");
  }
  if (source.mimic != nullptr) throw InputError(jointLabel(source) + ": mimic joints are not supported in the chain");
  Joint joint;
  joint.name = source.name;
  joint.T_parent_joint = T_parent_joint;
  joint.axis << source.axis.x, source.axis.y, source.axis.z;
  const double length = joint.axis.norm();
  if (!(length > 1e-6 && std::isfinite(length))) {
    throw InputError(jointLabel(source), "length of the axis", fixed(length, 6), "> 0 and finite");
  }
  joint.axis /= length;
  readLimits(source, joint);
  return joint;
}

Robot robotOf(const urdf::ModelInterface& model, const std::string& base_link, const std::string& tip_link) {
  Robot robot;
  robot.name = model.getName();
  robot.base_link = base_link;
  robot.tip_link = tip_link;
  robot.link_names = linkNames(model);
  for (const urdf::Joint* joint : jointsBetween(model, base_link, tip_link)) {
    robot.T_last_tip = robot.T_last_tip * jointOrigin(*joint);
    if (joint->type == urdf::Joint::FIXED) continue;
    robot.joints.push_back(movableJoint(*joint, robot.T_last_tip));
    robot.T_last_tip.setIdentity();
  }
  if (robot.joints.empty() || robot.joints.size() > static_cast<std::size_t>(max_joints)) {
    throw InputError("robot " + printable(robot.name), "number of movable joints from " + base_link + " to " + tip_link,
                     std::to_string(robot.joints.size()), "in [1, " + std::to_string(max_joints) + "]");
  }
  return robot;
}

}  // namespace

Robot parseRobot(const std::string& urdf, const std::string& base_link, const std::string& tip_link) {
  return robotOf(*parseModel(urdf), base_link, tip_link);
}

}  // namespace scan_to_path::robot
