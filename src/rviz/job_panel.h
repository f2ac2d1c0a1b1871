// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ros/subscriber.h>
#include <rviz/panel.h>

#include <memory>

#include "rviz/job_client.h"
#include "rviz/service_call.h"

class QLabel;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;
class QTimer;
class QVBoxLayout;

namespace scan_to_path_rviz {

class JobFields;

/// Runs jobs of a cell from rviz: run, play, cancel, accept or reject, how far it is, and how it ended. Nothing in it
/// waits for anybody.
class JobPanel : public rviz::Panel {
public:
  explicit JobPanel(QWidget* parent = nullptr);
  ~JobPanel() override;

  void load(const rviz::Config& config) override;
  void save(rviz::Config config) const override;

private:
  enum class State { idle, running, cancelling };

  void addFields();
  void addButtons();
  void addResult();

  void connectServer();
  void look();
  void refresh();

  void run();
  void playOrStop();
  void cancel();
  void answer(bool is_wanted);
  void showProgress(const std::string& stage, double fraction);
  void showEnd(const JobEnd& end);
  void showError(const std::string& text);

  QVBoxLayout* column_ = nullptr;
  JobFields* fields_ = nullptr;
  QPushButton* run_ = nullptr;
  QPushButton* play_ = nullptr;
  QPushButton* cancel_ = nullptr;
  QPushButton* accept_ = nullptr;
  QPushButton* reject_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QLabel* state_text_ = nullptr;
  QLabel* error_ = nullptr;
  QPlainTextEdit* summary_ = nullptr;
  QTimer* timer_ = nullptr;

  State state_ = State::idle;
  std::unique_ptr<JobClient> client_;
  std::string cell_;  // namespace of the server, with a slash at its end
  ros::Subscriber playing_topic_;
  bool playing_ = false;
  ServiceCall player_;
  bool in_review_ = false;
  ServiceCall reviewer_;
};

}  // namespace scan_to_path_rviz
