// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "rviz/job_panel.h"

#include <ros/names.h>
#include <std_msgs/Bool.h>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>
#include <pluginlib/class_list_macros.hpp>

#include <vector>

#include "rviz/job_fields.h"
#include "scan_to_path/common/error.h"

namespace scan_to_path_rviz {
namespace {

constexpr int look_period = 200;  // [ms]
constexpr int full = 100;         // of the progress bar

QPushButton* button(QWidget* parent, const char* name, const char* text, const char* tip) {
  auto* made = new QPushButton(text, parent);
  made->setObjectName(name);
  made->setToolTip(tip);
  return made;
}

}  // namespace

JobPanel::JobPanel(QWidget* parent) : rviz::Panel(parent) {
  column_ = new QVBoxLayout(this);
  addFields();
  addButtons();
  addResult();
  timer_ = new QTimer(this);
  connect(timer_, &QTimer::timeout, this, [this] { look(); });
  timer_->start(look_period);
  connectServer();
}

JobPanel::~JobPanel() = default;

void JobPanel::addFields() {
  fields_ = new JobFields(this, [this] { Q_EMIT configChanged(); });
  column_->addWidget(fields_);
  connect(fields_->server(), &QLineEdit::editingFinished, this, [this] { connectServer(); });
}

void JobPanel::addButtons() {
  run_ = button(this, "run", "Run", "scan the part, plan and write the program");
  play_ = button(this, "play", "Play", "play the planned trajectory back, and stop it again");
  cancel_ = button(this, "cancel", "Cancel", "end the job that runs; an older result stays");
  accept_ = button(this, "accept", "Accept", "write what was planned");
  reject_ = button(this, "reject", "Reject", "write nothing; an older result stays");
  for (const auto& row : {std::vector<QPushButton*>{run_, play_, cancel_}, {accept_, reject_}}) {
    auto* buttons = new QHBoxLayout;
    for (auto* made : row) buttons->addWidget(made);
    column_->addLayout(buttons);
  }
  connect(run_, &QPushButton::clicked, this, [this] { run(); });
  connect(play_, &QPushButton::clicked, this, [this] { playOrStop(); });
  connect(cancel_, &QPushButton::clicked, this, [this] { cancel(); });
  connect(accept_, &QPushButton::clicked, this, [this] { answer(true); });
  connect(reject_, &QPushButton::clicked, this, [this] { answer(false); });
}

void JobPanel::addResult() {
  progress_ = new QProgressBar(this);
  progress_->setObjectName("progress");
  progress_->setRange(0, full);
  state_text_ = new QLabel(this);
  state_text_->setObjectName("state");
  error_ = new QLabel(this);
  error_->setObjectName("error");
  error_->setStyleSheet("color: #c02020");
  error_->setWordWrap(true);
  error_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  summary_ = new QPlainTextEdit(this);
  summary_->setObjectName("summary");
  summary_->setReadOnly(true);
  summary_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  summary_->setLineWrapMode(QPlainTextEdit::NoWrap);
  for (QWidget* widget : {static_cast<QWidget*>(progress_), static_cast<QWidget*>(state_text_),
                          static_cast<QWidget*>(error_), static_cast<QWidget*>(summary_)}) {
    column_->addWidget(widget);
  }
}

void JobPanel::connectServer() {
  if (state_ != State::idle) return;
  client_.reset();
  playing_topic_.shutdown();
  showError("");
  std::string why;
  const std::string name = fields_->server()->text().trimmed().toStdString();
  if (name.empty() || !ros::names::validate(name, why)) {
    showError("server: " + (name.empty() ? std::string("no name") : why));
  } else {
    ros::NodeHandle nodes;
    cell_ = name.substr(0, name.rfind('/') + 1);
    playing_ = false;
    playing_topic_ =
        nodes.subscribe<std_msgs::Bool>(cell_ + "playback_active", 1, [this](const std_msgs::BoolConstPtr& msg) {
          playing_ = msg->data != 0;
          refresh();
        });
    client_ = std::make_unique<JobClient>(
        nodes, name,
        JobClient::Listener{[this](const std::string& stage, double fraction) { showProgress(stage, fraction); },
                            [this](const JobEnd& end) { showEnd(end); }});
  }
  refresh();
}

void JobPanel::look() {
  if (client_) client_->look();
  if (playing_topic_.getNumPublishers() == 0) playing_ = false;
  for (ServiceCall* call : {&player_, &reviewer_}) {
    const auto answered = call->takeAnswer();
    if (answered) showError(*answered);
  }
  refresh();
}

void JobPanel::refresh() {
  const bool connected = client_ && client_->connected();
  const bool is_idle = state_ == State::idle;
  run_->setEnabled(connected && is_idle && !playing_);  // the player and a scan would both say where the robot is
  const bool in_review = state_ == State::running && in_review_;
  play_->setEnabled((is_idle || in_review) && playing_topic_.getNumPublishers() > 0 && !player_.running());
  play_->setText(playing_ ? "Stop" : "Play");
  cancel_->setEnabled(state_ == State::running);
  accept_->setEnabled(in_review && !reviewer_.running());
  reject_->setEnabled(in_review && !reviewer_.running());
  fields_->server()->setEnabled(is_idle);
  if (state_ == State::running) return;  // the progress tells
  if (!is_idle) {
    state_text_->setText("cancelling");
  } else if (!connected) {
    state_text_->setText("waiting for the job server");
  } else {
    state_text_->setText(playing_ ? "playing" : "ready");
  }
}

void JobPanel::run() {
  if (!client_ || state_ != State::idle || playing_) return;
  scan_to_path::RunJobGoal goal;
  try {
    goal = fields_->goal();
  } catch (const scan_to_path::InputError& error) {
    showError(error.what());
    return;
  }
  showError("");
  summary_->clear();
  progress_->reset();
  state_ = State::running;
  in_review_ = false;
  state_text_->setText("waiting for the job to begin");
  client_->run(goal);
  refresh();
}

void JobPanel::playOrStop() {
  showError("");
  player_.start(ros::names::resolve(cell_ + "trajectory_player/" + (playing_ ? "stop" : "start")));
  refresh();
}

void JobPanel::cancel() {
  if (state_ != State::running) return;
  state_ = State::cancelling;
  client_->cancel();
  refresh();
}

void JobPanel::answer(bool is_wanted) {
  showError("");
  reviewer_.start(ros::names::resolve(fields_->server()->text().trimmed().toStdString() + "/accept"), is_wanted);
  refresh();
}

void JobPanel::showProgress(const std::string& stage, double fraction) {
  if (state_ != State::running) return;
  progress_->setMaximum(fraction > 0.0 ? full : 0);  // a stage that cannot tell how far it is: just busy
  progress_->setValue(qBound(0, qRound(full * fraction), full));
  in_review_ = stage == "review";
  state_text_->setText(in_review_ ? "review: accept or reject" : QString::fromStdString(stage));
  refresh();
}

void JobPanel::showEnd(const JobEnd& end) {
  state_ = State::idle;
  progress_->setMaximum(full);
  if (end.exit > 1) {
    progress_->reset();
    showError(end.summary.empty() ? "the job failed" : end.summary.front());
  } else {
    progress_->setValue(full);
    QStringList lines;
    for (const auto& line : end.summary) lines << QString::fromStdString(line);
    lines << QString::fromStdString("results in " + end.out);
    summary_->setPlainText(lines.join('\n'));
    if (end.exit == 1) showError("planned, but not everything holds; see below");
  }
  refresh();
}

/// One line; empty: none.
void JobPanel::showError(const std::string& text) { error_->setText(QString::fromStdString(text).section('\n', 0, 0)); }

void JobPanel::load(const rviz::Config& config) {
  rviz::Panel::load(config);
  fields_->load(config);
  connectServer();
}

void JobPanel::save(rviz::Config config) const {
  rviz::Panel::save(config);
  fields_->save(config);
}

}  // namespace scan_to_path_rviz

PLUGINLIB_EXPORT_CLASS(scan_to_path_rviz::JobPanel, rviz::Panel)
