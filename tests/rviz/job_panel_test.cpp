// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "rviz/job_panel.h"

#include <gmock/gmock.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <yaml-cpp/yaml.h>

#include <QApplication>
#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>

#include "fake_cell.h"

namespace scan_to_path_rviz {
namespace {

using test::FakePlayer;
using test::FakeReviewer;
using test::FakeServer;
using test::patience;

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
