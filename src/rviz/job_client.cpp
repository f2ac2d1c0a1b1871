// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "rviz/job_client.h"

namespace scan_to_path_rviz {
namespace {

constexpr int gone = 3;  // exit status of a job that nobody can tell the end of

}  // namespace

JobClient::JobClient(const ros::NodeHandle& nodes, const std::string& server, Listener listener)
    : nodes_(nodes), listener_(std::move(listener)) {
  constexpr bool own_thread = false;
  client_ = std::make_unique<Client>(nodes_, server + "/run", own_thread);
}

void JobClient::run(const scan_to_path::RunJobGoal& goal) {
  running_ = true;
  client_->sendGoal(
      goal,
      [this](const actionlib::SimpleClientGoalState& state, const scan_to_path::RunJobResultConstPtr& result) {
        finish(result, state.getText());
      },
      Client::SimpleActiveCallback(),
      [this](const scan_to_path::RunJobFeedbackConstPtr& at) { listener_.progress(at->stage, at->fraction); });
}

void JobClient::cancel() {
  if (running_) client_->cancelGoal();
}

void JobClient::look() {
  if (!running_ || connected()) return;
  client_->stopTrackingGoal();
  finish(nullptr, "the job server is gone");
}

void JobClient::finish(const scan_to_path::RunJobResultConstPtr& result, const std::string& text) {
  running_ = false;
  JobEnd end;
  if (result && (result->exit != 0 || !result->summary.empty() || !result->out.empty())) {
    end = {result->exit, result->summary, result->out};
  } else {  // an action's own ends bring no result: goal lost, server gone
    end.exit = gone;
    end.summary = {text.empty() ? "the job server lost the job" : text};
  }
  listener_.ended(end);
}

}  // namespace scan_to_path_rviz
