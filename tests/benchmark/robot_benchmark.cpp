// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainiksolverpos_lma.hpp>
#include <kdl/chainiksolverpos_nr_jl.hpp>
#include <kdl/chainiksolvervel_pinv.hpp>

#include "scan_to_path/robot/inverse_kinematics.h"
#include "scan_to_path/robot/kdl_chain.h"
#include "support/irb2400.h"

namespace {

using namespace scan_to_path;
using geometry::Frame;
using robot::JointVector;
using robot::kdlChain;
using robot::toKdl;

/// Poses along an S-like raster row, 1 mm apart, tool down, and random poses within the joint limits.
struct Work {
  robot::Robot robot = test::irb2400();
  KDL::Chain chain = kdlChain(robot);
  JointVector start{6};
  std::vector<Frame> path, anywhere;

  Work() {
    start << 0.0, 0.3, 0.4, 0.1, 0.8, 0.2;
    const Frame T = robot::forwardKinematics(robot, start);
    for (int i = 0; i < 2000; ++i) {
      const double phase = 2.0 * M_PI * i / 500.0;  // a round of 500 mm, 20 mm deep, tilting as the surface does
      Frame pose = T;
      pose.translation() +=
          geometry::Vector3(0.08 * std::sin(phase), 0.08 * (1.0 - std::cos(phase)), 0.02 * std::sin(phase));
      pose.linear() = pose.linear() * geometry::makeFrame({0, 0, 0}, {0.2 * std::sin(phase), 0, 0}).linear();
      path.push_back(pose);
    }
    Random random(1);
    for (int i = 0; i < 2000; ++i) {
      anywhere.push_back(robot::forwardKinematics(robot, test::randomJoints(robot, random)));
    }
  }

  KDL::JntArray limits(bool upper) const {
    KDL::JntArray array(6);
    for (unsigned i = 0; i < 6; ++i) array(i) = upper ? robot.joints[i].upper : robot.joints[i].lower;
    return array;
  }
};

const Work& work() {
  static const Work instance;
  return instance;
}

/// Counts what was solved to 1 um and 0.001 degree, by the library's forward kinematics, and how far off it was.
struct Score {
  int solved = 0, within_limits = 0;
  double worst = 0.0;

  bool add(const Frame& T, const JointVector& q) {
    const Frame got = robot::forwardKinematics(work().robot, q);
    const double miss = (got.translation() - T.translation()).norm();
    if (!(miss <= 1e-6 && geometry::rotationAngle(got.linear(), T.linear()) <= 1.7e-5)) return false;
    worst = std::max(worst, miss);
    ++solved;
    if (robot::limitMargin(work().robot, q) >= 0.0) ++within_limits;
    return true;
  }

  void report(benchmark::State& state, std::size_t tried) const {
    state.counters["solved_percent"] = 100.0 * solved / static_cast<double>(tried);
    state.counters["within_limits_percent"] = 100.0 * within_limits / static_cast<double>(tried);
    state.counters["worst_um"] = 1e6 * worst;
  }
};

void forwardOurs(benchmark::State& state) {
  JointVector q = work().start;
  for (auto _ : state) {
    q[0] += 1e-9;
    benchmark::DoNotOptimize(robot::forwardKinematics(work().robot, q));
  }
}
BENCHMARK(forwardOurs);

void forwardKdl(benchmark::State& state) {
  KDL::ChainFkSolverPos_recursive solver(work().chain);
  KDL::JntArray q(6);
  q.data = work().start;
  KDL::Frame T;
  for (auto _ : state) {
    q(0) += 1e-9;
    solver.JntToCart(q, T);
    benchmark::DoNotOptimize(T);
  }
}
BENCHMARK(forwardKdl);

/// Solves pose after pose, each from the last good answer (warm) or from zero (cold); `solve` takes pose, seed, answer.
/// Every answer is judged by forward kinematics before the clock runs, whatever the solver's return code says.
template <class Solve>
void run(benchmark::State& state, const std::vector<Frame>& poses, bool warm, Solve&& solve) {
  const JointVector first = warm ? work().start : JointVector(JointVector::Zero(6));
  std::vector<JointVector> seeds;
  Score score;
  JointVector seed = first, q(6);
  for (const Frame& T : poses) {
    seeds.push_back(seed);
    const bool found = solve(T, seed, q) && score.add(T, q);
    if (found && warm) seed = q;
  }
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(solve(poses[i], seeds[i], q));
    i = (i + 1) % poses.size();
  }
  score.report(state, poses.size());
}

void inverseOurs(benchmark::State& state, const std::vector<Frame>& poses, bool warm) {
  const robot::InverseKinematics inverse(work().robot);
  run(state, poses, warm, [&inverse](const Frame& T, const JointVector& seed, JointVector& q) {
    const auto found = inverse.solve(T, seed);
    if (found) q = *found;
    return found.has_value();
  });
}

template <class Solver>
void inverseKdl(benchmark::State& state, const std::vector<Frame>& poses, bool warm, Solver& solver) {
  KDL::JntArray from(6), to(6);
  run(state, poses, warm, [&](const Frame& T, const JointVector& seed, JointVector& q) {
    from.data = seed;
    solver.CartToJnt(from, toKdl(T), to);
    q = to.data;
    return true;
  });
}

void inverseLma(benchmark::State& state, const std::vector<Frame>& poses, bool warm) {
  KDL::ChainIkSolverPos_LMA solver(work().chain, 1e-9, 500, 1e-15);  // its default eps is 7e-4 rad off
  inverseKdl(state, poses, warm, solver);
}

void inverseNewton(benchmark::State& state, const std::vector<Frame>& poses, bool warm) {
  KDL::ChainFkSolverPos_recursive forward(work().chain);
  KDL::ChainIkSolverVel_pinv velocity(work().chain);
  KDL::ChainIkSolverPos_NR_JL solver(work().chain, work().limits(false), work().limits(true), forward, velocity, 100,
                                     1e-9);
  inverseKdl(state, poses, warm, solver);
}

BENCHMARK_CAPTURE(inverseOurs, warm, work().path, true);
BENCHMARK_CAPTURE(inverseNewton, warm, work().path, true);
BENCHMARK_CAPTURE(inverseLma, warm, work().path, true);
BENCHMARK_CAPTURE(inverseOurs, cold, work().anywhere, false);
BENCHMARK_CAPTURE(inverseNewton, cold, work().anywhere, false);
BENCHMARK_CAPTURE(inverseLma, cold, work().anywhere, false);

void allConfigurations(benchmark::State& state) {
  const robot::InverseKinematics inverse(work().robot);
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(inverse.allConfigurations(work().anywhere[i++ % work().anywhere.size()]));
  }
}
BENCHMARK(allConfigurations);

}  // namespace
