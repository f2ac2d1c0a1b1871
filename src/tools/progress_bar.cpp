// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "progress_bar.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>

namespace scan_to_path::tools {
namespace {

std::atomic<bool> cancelled{false};
static_assert(std::atomic<bool>::is_always_lock_free, "set from a signal handler");

void onSignal(int signal) {
  if (cancelled.exchange(true)) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}

}  // namespace

void installCancelSignals() {
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
}

ProgressBar::ProgressBar(bool quiet) : active_(!quiet && isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar() {
  if (drawn_) std::fputs("\r\033[K", stderr);
}

Progress ProgressBar::progress() {
  return Progress([this](const std::string& stage, double fraction) { draw(stage, fraction); }, &cancelled);
}

void ProgressBar::draw(const std::string& stage, double fraction) {
  constexpr std::chrono::milliseconds redraw_period(100);
  constexpr int width = 40;
  const auto now = std::chrono::steady_clock::now();
  if (!active_ || (stage == stage_ && now - last_ < redraw_period)) return;
  last_ = now;
  stage_ = stage;
  drawn_ = true;
  const int filled = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * width);
  std::string bar(static_cast<std::size_t>(filled), '#');
  bar.resize(width, '.');
  std::fprintf(stderr, "\r\033[K%-10s [%s] %3.0f %%", stage.c_str(), bar.c_str(),
               100.0 * std::clamp(fraction, 0.0, 1.0));
  std::fflush(stderr);
}

}  // namespace scan_to_path::tools
