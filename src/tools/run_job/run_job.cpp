// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <actionlib/client/simple_action_client.h>
#include <ros/master.h>
#include <ros/ros.h>
#include <scan_to_path/RunJobAction.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <functional>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"
#include "scan_to_path/pipeline/configuration.h"
#include "scan_to_path/pipeline/job_options.h"
#include "scan_to_path_ros/parameters.h"
#include "tools/progress_bar.h"
#include "tools/run_job/play_back.h"
#include "tools/run_job/review_question.h"

namespace {

using Client = actionlib::SimpleActionClient<scan_to_path::RunJobAction>;

volatile std::sig_atomic_t interrupted = 0;

struct Flags {
  std::string process = "cutting";
  std::string config;
  std::vector<std::string> lines;
  std::string out;
  std::string bag;
  std::string server = "cell/job_server";
  double wait = 30.0;
  bool play = false;
  bool review = false;
  bool quiet = false;
};

void addFlags(CLI::App& app, Flags& flags) {
  app.add_option("--process", flags.process, "what is done to the part")->capture_default_str();
  app.add_option("--config", flags.config, "configuration laid over the cell's for this job")->type_name("FILE");
  app.add_option("--out", flags.out, "directory of the result (default out/<process>)")->type_name("DIR");
  app.add_option("--bag", flags.bag, "replay this recording instead of scanning")->type_name("FILE");
  app.add_option("--server", flags.server, "name of the job server")->capture_default_str();
  app.add_option("--wait", flags.wait, "for the cell to come up [s]")->capture_default_str();
  app.add_flag("--play", flags.play, "play the result back, and compare it with the planned path");
  app.add_flag("--review", flags.review, "ask on the terminal before anything is written");
  app.add_flag("--quiet", flags.quiet, "no progress, no summary");
}

scan_to_path::RunJobGoal goalFrom(const Flags& flags) {
  scan_to_path::RunJobGoal goal;
  goal.process = flags.process;
  if (!flags.config.empty()) {
    goal.configuration = scan_to_path::readFile(flags.config);  // once: what is checked is what is sent
    scan_to_path::pipeline::JobOptions options;
    scan_to_path::pipeline::applyConfiguration(scan_to_path::pipeline::fieldReferences(options), goal.configuration,
                                               flags.config);
  }
  goal.out = std::filesystem::absolute(flags.out.empty() ? "out/" + flags.process : flags.out).string();
  goal.review = static_cast<std::uint8_t>(flags.review);
  if (!flags.bag.empty()) goal.bag = std::filesystem::absolute(flags.bag).string();
  return goal;
}

/// Waits until `is_there`, for `seconds` at most.
bool waitFor(double seconds, const std::function<bool()>& is_there) {
  const ros::WallTime limit = ros::WallTime::now() + ros::WallDuration(seconds);
  while (!is_there()) {
    if (ros::WallTime::now() > limit || interrupted != 0) return false;
    ros::WallDuration(0.02).sleep();
  }
  return true;
}

/// The namespace that the server is in, with its slash.
std::string cellOf(const std::string& server) {
  const auto slash = server.rfind('/');
  return slash == std::string::npos ? "" : server.substr(0, slash + 1);
}

int run(const Flags& flags) {
  const scan_to_path::RunJobGoal goal = goalFrom(flags);
  if (!waitFor(flags.wait, [] { return ros::master::check(); })) scan_to_path_ros::checkMaster();
  ros::NodeHandle nodes;
  Client client(nodes, flags.server + "/run", true);
  if (!waitFor(flags.wait, [&] { return client.isServerConnected(); })) {
    throw scan_to_path::InputError("no job server at " + nodes.resolveName(flags.server) + " within " +
                                   scan_to_path::fixed(flags.wait, 0) +
                                   " s; bring the cell up with: roslaunch scan_to_path cell.launch");
  }
  scan_to_path::tools::ProgressBar bar(flags.quiet);
  const auto progress = bar.progress();
  std::atomic<bool> is_in_review{false};
  client.sendGoal(goal, Client::SimpleDoneCallback(), Client::SimpleActiveCallback(),
                  [&](const scan_to_path::RunJobFeedbackConstPtr& at) {
                    if (at->stage == "review")
                      is_in_review = true;
                    else
                      progress.update(at->stage, at->fraction);
                  });
  scan_to_path::tools::ReviewQuestion question(nodes.resolveName(flags.server + "/accept"));
  while (!client.getState().isDone()) {
    if (interrupted != 0) client.cancelGoal();
    if (is_in_review && interrupted == 0) question.look();
    if (!client.isServerConnected()) {
      scan_to_path_ros::checkMaster();
      throw scan_to_path::InputError("the job server is gone");
    }
    ros::WallDuration(0.02).sleep();
  }
  const auto result = client.getResult();
  if (!result) throw scan_to_path::InputError("the job server gave no result");
  for (const auto& line : result->summary) {
    if (result->exit > 1)
      std::fprintf(stderr, "%s\n", line.c_str());
    else if (!flags.quiet)
      std::printf("%s\n", line.c_str());
  }
  if (flags.play && result->exit == 0) {
    const std::string line =
        scan_to_path::tools::playBack(nodes, cellOf(flags.server), [] { return interrupted != 0; });
    if (!flags.quiet) std::printf("%s\n", line.c_str());
  }
  return result->exit;
}

}  // namespace

/// Has a cell do a job, and ends with the job's exit status.
int main(int argc, char** argv) {
  ros::init(argc, argv, "run_job", ros::init_options::AnonymousName | ros::init_options::NoSigintHandler);
  std::signal(SIGINT, [](int) { interrupted = 1; });
  CLI::App app("Have the cell scan, plan and write a robot program");
  Flags flags;
  addFlags(app, flags);
  CLI11_PARSE(app, argc, argv);
  try {
    return run(flags);
  } catch (const scan_to_path::InputError& error) {
    std::fprintf(stderr, "run_job: %s\n", error.what());
    return 2;
  } catch (const scan_to_path::Interrupted&) {
    return 130;
  }
}
