// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "rviz/job_panel.h"

#include <actionlib/server/action_server.h>
#include <gmock/gmock.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <ros/spinner.h>
#include <std_msgs/Bool.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>
#include <yaml-cpp/yaml.h>

#include <QApplication>
#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <atomic>
#include <condition_variable>
#include <mutex>

namespace scan_to_path_rviz {
namespace {

constexpr double patience = 10.0;  // [s] for what takes milliseconds on a quiet machine

/// Turns the loops that rviz turns, until `reached` or patience is at its end.
template <class Condition>
bool until(const Condition& reached) {
  const ros::WallTime limit = ros::WallTime::now() + ros::WallDuration(patience);
  while (!reached()) {
    if (ros::WallTime::now() > limit) return false;
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.005));
    QApplication::processEvents();
  }
  return true;
}

/// A job server that does what the test says, beside the thread of the windows as a real one is.
class FakeServer {
  using Server = actionlib::ActionServer<scan_to_path::RunJobAction>;

public:
  explicit FakeServer(const std::string& name) : nodes_(name) {
    nodes_.setCallbackQueue(&queue_);
    server_ = std::make_unique<Server>(
        nodes_, "run", [this](Server::GoalHandle goal) { take(goal); },
        [this](Server::GoalHandle) { cancelled_ = true; }, false);
    server_->start();
    spinner_.start();
  }
  ~FakeServer() { spinner_.stop(); }

  bool hasGoal() const { return has_goal_; }
  bool cancelled() const { return cancelled_; }
  std::shared_ptr<const scan_to_path::RunJobGoal> goal() const {
    return std::make_shared<const scan_to_path::RunJobGoal>(*goal_.getGoal());
  }
  void tell(const std::string& stage, double fraction) {
    scan_to_path::RunJobFeedback feedback;
    feedback.stage = stage;
    feedback.fraction = fraction;
    goal_.publishFeedback(feedback);
  }
  void end(int exit, const std::vector<std::string>& summary) {
    has_goal_ = false;
    scan_to_path::RunJobResult result;
    result.exit = exit;
    result.summary = summary;
    result.out = goal_.getGoal()->out;
    if (exit == 130)
      goal_.setCanceled(result, summary.front());
    else if (exit > 1)
      goal_.setAborted(result, summary.front());
    else
      goal_.setSucceeded(result, summary.front());
  }

  bool reject = false;

private:
  void take(Server::GoalHandle goal) {
    if (reject) {
      scan_to_path::RunJobResult result;
      result.exit = 2;
      result.summary = {"a job is running; one at a time"};
      goal.setRejected(result, result.summary.front());
      return;
    }
    goal.setAccepted();
    goal_ = goal;
    has_goal_ = true;
  }

  ros::NodeHandle nodes_;
  ros::CallbackQueue queue_;
  ros::AsyncSpinner spinner_{1, &queue_};
  std::unique_ptr<Server> server_;
  Server::GoalHandle goal_;
  std::atomic<bool> has_goal_{false};
  std::atomic<bool> cancelled_{false};
};

class JobPanelTest : public testing::Test {
protected:
  void SetUp() override {
    server = std::make_unique<FakeServer>("job_server");
    ASSERT_TRUE(until([&] { return button("run")->isEnabled(); }));
    line("out")->setText("/tmp/out of a job");
  }

  QPushButton* button(const char* name) const { return panel.findChild<QPushButton*>(name); }
  QLineEdit* line(const char* name) const { return panel.findChild<QLineEdit*>(name); }
  QPlainTextEdit* text(const char* name) const { return panel.findChild<QPlainTextEdit*>(name); }
  std::string label(const char* name) const { return panel.findChild<QLabel*>(name)->text().toStdString(); }
  int progress() const { return panel.findChild<QProgressBar*>("progress")->value(); }
  std::string summary() const { return text("summary")->toPlainText().toStdString(); }

  void startJob() {
    button("run")->click();
    ASSERT_TRUE(until([&] { return server->hasGoal(); }));
  }
  bool idle() const { return button("run")->isEnabled(); }

  JobPanel panel;
  std::unique_ptr<FakeServer> server;
};

TEST_F(JobPanelTest, runsAJobAndShowsHowItGoes) {
  text("configuration")->setPlainText("path: {pitch: 0.002}");
  startJob();
  EXPECT_EQ(server->goal()->process, "cutting");
  EXPECT_EQ(server->goal()->out, "/tmp/out of a job");
  EXPECT_EQ(server->goal()->configuration, "path: {pitch: 0.002}");
  EXPECT_FALSE(button("run")->isEnabled());
  EXPECT_TRUE(button("cancel")->isEnabled());
  server->tell("fit", 0.37);
  EXPECT_TRUE(until([&] { return progress() == 37 && label("state") == "fit"; })) << progress() << label("state");
  server->end(0, {"41 rows", "program.mod"});
  ASSERT_TRUE(until([&] { return idle(); }));
  EXPECT_EQ(summary(), "41 rows\nprogram.mod\nresults in /tmp/out of a job");
  EXPECT_EQ(label("error"), "");
  EXPECT_EQ(progress(), 100);
  EXPECT_FALSE(button("cancel")->isEnabled());
}

TEST_F(JobPanelTest, cancelsAJob) {
  startJob();
  button("cancel")->click();
  EXPECT_FALSE(button("cancel")->isEnabled());
  EXPECT_EQ(label("state"), "cancelling");
  ASSERT_TRUE(until([&] { return server->cancelled(); }));
  server->end(130, {"cancelled"});
  ASSERT_TRUE(until([&] { return idle(); }));
  EXPECT_EQ(label("error"), "cancelled");
  EXPECT_EQ(summary(), "");
}

TEST_F(JobPanelTest, showsAnErrorAsOneLine) {
  startJob();
  server->end(2, {"scan: no sample came within 5 s\nand more", "even more"});
  ASSERT_TRUE(until([&] { return idle(); }));
  EXPECT_EQ(label("error"), "scan: no sample came within 5 s");
  EXPECT_EQ(progress(), -1);  // none
}

TEST_F(JobPanelTest, saysThatAResultDoesNotHold) {
  startJob();
  server->end(1, {"3 waypoints fail"});
  ASSERT_TRUE(until([&] { return idle(); }));
  EXPECT_EQ(label("error"), "planned, but not everything holds; see below");
  EXPECT_THAT(summary(), testing::StartsWith("3 waypoints fail"));
}

TEST_F(JobPanelTest, showsWhyAJobIsRejected) {
  server->reject = true;
  button("run")->click();
  ASSERT_TRUE(until([&] { return idle(); }));
  EXPECT_EQ(label("error"), "a job is running; one at a time");
}

TEST_F(JobPanelTest, losesTheServerAndFindsItAgain) {
  startJob();
  server.reset();
  ASSERT_TRUE(until([&] { return label("error") == "the job server is gone"; }));
  EXPECT_FALSE(button("run")->isEnabled());
  EXPECT_EQ(label("state"), "waiting for the job server");
  server = std::make_unique<FakeServer>("job_server");
  ASSERT_TRUE(until([&] { return idle(); }));
  startJob();
  server->end(0, {"41 rows"});
  EXPECT_TRUE(until([&] { return idle(); }));
  EXPECT_THAT(summary(), testing::StartsWith("41 rows"));
}

TEST_F(JobPanelTest, followsTheNameOfTheServer) {
  line("server")->setText("elsewhere/job_server");
  Q_EMIT line("server")->editingFinished();
  EXPECT_FALSE(button("run")->isEnabled());
  const FakeServer elsewhere("elsewhere/job_server");
  EXPECT_TRUE(until([&] { return idle(); }));
  line("server")->setText("no name");
  Q_EMIT line("server")->editingFinished();
  EXPECT_FALSE(button("run")->isEnabled());
  EXPECT_THAT(label("error"), testing::StartsWith("server: "));
}

TEST_F(JobPanelTest, wantsAnAbsolutePath) {
  line("out")->setText("out");
  button("run")->click();
  EXPECT_THAT(label("error"), testing::HasSubstr("no absolute path"));
  EXPECT_TRUE(idle());
}

TEST_F(JobPanelTest, laysRegionAndRowsOverTheOptions) {
  text("configuration")->setPlainText("path: {pitch: 0.002}");
  line("region")->setText("0.01 0.05 -0.02 0.03");
  line("skip_rows")->setText("3, 7-9");
  line("reverse_rows")->setText("2");
  startJob();
  const YAML::Node path = YAML::Load(server->goal()->configuration)["path"];
  EXPECT_EQ(path["pitch"].as<double>(), 0.002);
  ASSERT_EQ(path["region"].size(), 4U);
  EXPECT_EQ(path["region"][2].as<std::vector<double>>(), (std::vector<double>{0.05, 0.03}));
  EXPECT_EQ(path["skip_rows"].as<std::string>(), "3, 7-9");
  EXPECT_EQ(path["reverse_rows"].as<std::string>(), "2");
  EXPECT_EQ(server->goal()->review, 0);
}

TEST_F(JobPanelTest, saysWhatIsNoRegion) {
  line("region")->setText("0 1 2");
  button("run")->click();
  EXPECT_THAT(label("error"), testing::HasSubstr("x_min x_max y_min y_max"));
  EXPECT_TRUE(idle());
}

/// Takes the answer to a review.
class FakeReviewer {
  using Request = std_srvs::SetBool::Request;
  using Response = std_srvs::SetBool::Response;

public:
  FakeReviewer() {
    nodes_.setCallbackQueue(&queue_);
    service_ =
        nodes_.advertiseService<Request, Response>("job_server/accept", [this](Request& request, Response& response) {
          answer_ = request.data != 0 ? 1 : 0;
          response.success = 1;
          return true;
        });
    spinner_.start();
  }
  ~FakeReviewer() { spinner_.stop(); }

  /// 1: accepted; 0: rejected; -1: nobody answered.
  int answer() const { return answer_; }

private:
  std::atomic<int> answer_{-1};
  ros::NodeHandle nodes_;
  ros::CallbackQueue queue_;
  ros::AsyncSpinner spinner_{1, &queue_};
  ros::ServiceServer service_;
};

TEST_F(JobPanelTest, acceptsOrRejectsInReviewOnly) {
  for (const char* chosen : {"accept", "reject"}) {
    const FakeReviewer reviewer;
    panel.findChild<QCheckBox*>("review")->setChecked(true);
    EXPECT_FALSE(button("accept")->isEnabled());
    startJob();
    EXPECT_EQ(server->goal()->review, 1);
    server->tell("motion", 1.0);
    ASSERT_TRUE(until([&] { return label("state") == "motion"; }));
    EXPECT_FALSE(button("accept")->isEnabled());
    EXPECT_FALSE(button("reject")->isEnabled());
    server->tell("review", 0.0);
    ASSERT_TRUE(until([&] { return button("accept")->isEnabled() && button("reject")->isEnabled(); }));
    EXPECT_EQ(label("state"), "review: accept or reject");
    EXPECT_TRUE(button("cancel")->isEnabled());
    button(chosen)->click();
    EXPECT_FALSE(button("accept")->isEnabled());
    const bool is_accepted = chosen == std::string("accept");
    ASSERT_TRUE(until([&] { return reviewer.answer() == (is_accepted ? 1 : 0); }));
    server->end(is_accepted ? 0 : 130, {is_accepted ? "41 rows" : "rejected by the user"});
    ASSERT_TRUE(until([&] { return idle(); }));
    EXPECT_EQ(label("error"), is_accepted ? "" : "rejected by the user");
    EXPECT_FALSE(button("accept")->isEnabled());
  }
}

/// A player that takes its time, beside the thread of the windows.
class FakePlayer {
  using Request = std_srvs::Trigger::Request;
  using Response = std_srvs::Trigger::Response;

public:
  explicit FakePlayer(const std::string& why_not = "") : why_not_(why_not) {
    nodes_.setCallbackQueue(&queue_);
    active_ = nodes_.advertise<std_msgs::Bool>("playback_active", 1, true);
    tell(false);
    start_ =
        nodes_.advertiseService<Request, Response>("trajectory_player/start", [this](Request&, Response& response) {
          std::unique_lock<std::mutex> lock(mutex_);
          called_ = true;
          changed_.wait_for(lock, std::chrono::duration<double>(patience), [&] { return released_; });
          response.success = static_cast<std::uint8_t>(why_not_.empty());
          response.message = why_not_;
          if (why_not_.empty()) tell(true);
          return true;
        });
    stop_ = nodes_.advertiseService<Request, Response>("trajectory_player/stop", [this](Request&, Response& response) {
      response.success = 1;
      tell(false);
      return true;
    });
    spinner_.start();
  }
  ~FakePlayer() { spinner_.stop(); }

  bool called() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return called_;
  }
  void release() {
    const std::lock_guard<std::mutex> lock(mutex_);
    released_ = true;
    changed_.notify_all();
  }

private:
  void tell(bool active) {
    std_msgs::Bool msg;
    msg.data = static_cast<std::uint8_t>(active);
    active_.publish(msg);
  }

  std::string why_not_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool called_ = false;
  bool released_ = false;
  ros::NodeHandle nodes_;
  ros::CallbackQueue queue_;
  ros::AsyncSpinner spinner_{1, &queue_};
  ros::Publisher active_;
  ros::ServiceServer start_;
  ros::ServiceServer stop_;
};

TEST_F(JobPanelTest, playsWithoutWaitingAndStops) {
  EXPECT_FALSE(button("play")->isEnabled());  // nobody to play
  FakePlayer player;
  ASSERT_TRUE(until([&] { return button("play")->isEnabled(); }));
  button("play")->click();
  // The loop of the windows turns on while the player takes its time.
  ASSERT_TRUE(until([&] { return player.called(); }));
  EXPECT_FALSE(button("play")->isEnabled());
  player.release();
  ASSERT_TRUE(until([&] { return button("play")->isEnabled() && button("play")->text() == "Stop"; }));
  EXPECT_EQ(label("error"), "");
  EXPECT_EQ(label("state"), "playing");
  EXPECT_FALSE(button("run")->isEnabled());
  button("play")->click();
  EXPECT_TRUE(until([&] { return button("play")->isEnabled() && button("play")->text() == "Play"; }));
  EXPECT_TRUE(idle());
}

TEST_F(JobPanelTest, forgetsAPlayerThatIsGone) {
  auto player = std::make_unique<FakePlayer>();
  player->release();
  ASSERT_TRUE(until([&] { return button("play")->isEnabled(); }));
  button("play")->click();
  ASSERT_TRUE(until([&] { return button("play")->isEnabled() && button("play")->text() == "Stop"; }));
  player.reset();
  EXPECT_TRUE(until([&] { return !button("play")->isEnabled() && idle(); }));
}

TEST_F(JobPanelTest, saysWhyNothingIsPlayed) {
  FakePlayer player("no trajectory has come");
  ASSERT_TRUE(until([&] { return button("play")->isEnabled(); }));
  player.release();
  button("play")->click();
  ASSERT_TRUE(until([&] { return !label("error").empty(); }));
  EXPECT_THAT(label("error"), testing::EndsWith("trajectory_player/start: no trajectory has come"));
  EXPECT_EQ(button("play")->text(), "Play");
}

TEST_F(JobPanelTest, keepsItsFieldsInTheConfiguration) {
  text("configuration")->setPlainText("fit: {with_surface: false}");
  line("region")->setText("0 1, 2 3, 4 5");
  line("skip_rows")->setText("5");
  panel.findChild<QCheckBox*>("review")->setChecked(true);
  rviz::Config config;
  panel.save(config);
  JobPanel other;
  other.load(config);
  EXPECT_EQ(other.findChild<QLineEdit*>("out")->text(), "/tmp/out of a job");
  EXPECT_EQ(other.findChild<QLineEdit*>("server")->text(), "job_server");
  EXPECT_EQ(other.findChild<QLineEdit*>("region")->text(), "0 1, 2 3, 4 5");
  EXPECT_EQ(other.findChild<QLineEdit*>("skip_rows")->text(), "5");
  EXPECT_TRUE(other.findChild<QCheckBox*>("review")->isChecked());
  EXPECT_EQ(other.findChild<QPlainTextEdit*>("configuration")->toPlainText(), "fit: {with_surface: false}");
}

}  // namespace
}  // namespace scan_to_path_rviz
