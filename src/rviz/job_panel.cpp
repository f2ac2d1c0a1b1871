// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "rviz/job_panel.h"

#include <ros/names.h>
#include <std_msgs/Bool.h>
#include <QDir>
#include <QFontDatabase>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>
#include <pluginlib/class_list_macros.hpp>

namespace scan_to_path_rviz {
namespace {

constexpr int look_period = 200;  // [ms]
constexpr int full = 100;         // of the progress bar

/// A field of the panel that the rviz configuration keeps.
QLineEdit* lineEdit(QWidget* parent, const char* name, const QString& text, const char* tip) {
  auto* edit = new QLineEdit(text, parent);
  edit->setObjectName(name);
  edit->setToolTip(tip);
  return edit;
}

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
  server_ = lineEdit(this, "server", "job_server", "the cell's job server; relative to rviz's namespace");
  process_ = lineEdit(this, "process", "cutting", "what is done to the part");
  out_ =
      lineEdit(this, "out", QDir::home().filePath("out/cutting"), "directory of the result, where the job server runs");
  configuration_ = new QPlainTextEdit(this);
  configuration_->setObjectName("configuration");
  configuration_->setPlaceholderText("path: {pitch: 0.002}");
  configuration_->setToolTip("YAML laid over the cell's configuration for this job; empty: nothing");
  configuration_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  configuration_->setMaximumHeight(4 * fontMetrics().lineSpacing());
  auto* form = new QFormLayout;
  form->addRow("Server", server_);
  form->addRow("Process", process_);
  form->addRow("Out", out_);
  form->addRow("Options", configuration_);
  column_->addLayout(form);
  for (auto* edit : {server_, process_, out_}) {
    connect(edit, &QLineEdit::textEdited, this, [this] { Q_EMIT configChanged(); });
  }
  connect(server_, &QLineEdit::editingFinished, this, [this] { connectServer(); });
}

void JobPanel::addButtons() {
  run_ = button(this, "run", "Run", "scan the part, plan and write the program");
  play_ = button(this, "play", "Play", "play the planned trajectory back, and stop it again");
  cancel_ = button(this, "cancel", "Cancel", "end the job that runs; an older result stays");
  auto* buttons = new QHBoxLayout;
  for (auto* made : {run_, play_, cancel_}) buttons->addWidget(made);
  column_->addLayout(buttons);
  connect(run_, &QPushButton::clicked, this, [this] { run(); });
  connect(play_, &QPushButton::clicked, this, [this] { playOrStop(); });
  connect(cancel_, &QPushButton::clicked, this, [this] { cancel(); });
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
  const std::string name = server_->text().trimmed().toStdString();
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
  const auto played = player_.takeAnswer();
  if (played) showError(*played);
  refresh();
}

void JobPanel::refresh() {
  const bool connected = client_ && client_->connected();
  const bool is_idle = state_ == State::idle;
  run_->setEnabled(connected && is_idle && !playing_);  // the player and a scan would both say where the robot is
  play_->setEnabled(is_idle && playing_topic_.getNumPublishers() > 0 && !player_.running());
  play_->setText(playing_ ? "Stop" : "Play");
  cancel_->setEnabled(state_ == State::running);
  server_->setEnabled(is_idle);
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
  goal.process = process_->text().trimmed().toStdString();
  goal.configuration = configuration_->toPlainText().toStdString();
  goal.out = out_->text().trimmed().toStdString();
  if (!QDir::isAbsolutePath(QString::fromStdString(goal.out))) {
    showError("out: \"" + goal.out + "\" is no absolute path; the job server runs elsewhere");
    return;
  }
  showError("");
  summary_->clear();
  progress_->reset();
  state_ = State::running;
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

void JobPanel::showProgress(const std::string& stage, double fraction) {
  if (state_ != State::running) return;
  progress_->setMaximum(fraction > 0.0 ? full : 0);  // a stage that cannot tell how far it is: just busy
  progress_->setValue(qBound(0, qRound(full * fraction), full));
  state_text_->setText(QString::fromStdString(stage));
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
  for (auto* edit : {server_, process_, out_}) {
    QString text;
    if (config.mapGetString(edit->objectName(), &text)) edit->setText(text);
  }
  QString yaml;
  if (config.mapGetString(configuration_->objectName(), &yaml)) configuration_->setPlainText(yaml);
  connectServer();
}

void JobPanel::save(rviz::Config config) const {
  rviz::Panel::save(config);
  for (const auto* edit : {server_, process_, out_}) config.mapSetValue(edit->objectName(), edit->text());
  config.mapSetValue(configuration_->objectName(), configuration_->toPlainText());
}

}  // namespace scan_to_path_rviz

PLUGINLIB_EXPORT_CLASS(scan_to_path_rviz::JobPanel, rviz::Panel)
