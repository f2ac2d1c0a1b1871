// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include "support/sensing_cell.h"

namespace scan_to_path::sensing {
namespace {

/// The S part with all errors, about `samples` samples; joints at the sensor's rate, or at 250 Hz.
EmulationOptions optionsFor(std::int64_t samples, bool slow_joints) {
  EmulationOptions options;
  options.errors = errorPreset(ErrorSet::realistic);
  options.sample_rate = static_cast<double>(samples) / 207.07;
  options.joint_rate = slow_joints ? 250.0 : options.sample_rate;
  return options;
}

void countSamples(benchmark::State& state, std::size_t samples) {
  state.counters["samples"] = static_cast<double>(samples);
  state.SetItemsProcessed(static_cast<std::int64_t>(samples) * state.iterations());
}

void emulate(benchmark::State& state) {
  const test::SensingCell cell;
  const EmulationOptions options = optionsFor(state.range(0), false);
  std::size_t samples = 0;
  for (auto _ : state) samples = cell.emulate(options).log.voltage.size();
  countSamples(state, samples);
}
BENCHMARK(emulate)->Arg(1000000)->Unit(benchmark::kMillisecond);

void place(benchmark::State& state) {
  const test::SensingCell cell;
  const auto log = cell.emulate(optionsFor(state.range(0), state.range(1) != 0)).log;
  for (auto _ : state) benchmark::DoNotOptimize(cell.place(log));
  countSamples(state, log.voltage.size());
}
BENCHMARK(place)
    ->ArgNames({"samples", "slow_joints"})
    ->Args({1000000, 0})
    ->Args({1000000, 1})
    ->Args({4000000, 0})
    ->Unit(benchmark::kMillisecond);

void clockOffset(benchmark::State& state) {
  const test::SensingCell cell;
  const auto log = cell.emulate(optionsFor(state.range(0), false)).log;
  for (auto _ : state) benchmark::DoNotOptimize(cell.clockOffset(log));
  countSamples(state, log.voltage.size());
}
BENCHMARK(clockOffset)->Arg(200000)->Arg(1000000)->Arg(4000000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace scan_to_path::sensing
