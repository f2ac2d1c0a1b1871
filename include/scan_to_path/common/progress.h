// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <utility>

#include "scan_to_path/common/error.h"

namespace scan_to_path {

/// How long work tells how far it is and learns that it should stop. Copyable; the default one is silent.
class Progress {
public:
  /// Called from the working thread with the stage's name and the finished fraction in [0, 1].
  using Report = std::function<void(const std::string& stage, double fraction)>;

  Progress() = default;
  explicit Progress(Report report, const std::atomic<bool>* cancelled = nullptr)
      : report_(std::move(report)), cancelled_(cancelled) {}

  /// Throws Interrupted when somebody asked to stop.
  void update(const std::string& stage, double fraction) const {
    checkCancelled();
    if (report_) report_(stage, fraction);
  }

  /// The cheap half of update(), for inner loops. Throws Interrupted.
  void checkCancelled() const {
    if (cancelled_ != nullptr && cancelled_->load(std::memory_order_relaxed)) throw Interrupted();
  }

private:
  Report report_;
  const std::atomic<bool>* cancelled_ = nullptr;
};

}  // namespace scan_to_path
