// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <future>
#include <optional>
#include <string>

namespace scan_to_path_rviz {

/// A std_srvs/Trigger or SetBool called beside the thread of the windows, one at a time.
class ServiceCall {
public:
  /// `name` is resolved already. Does nothing while a call is under way.
  void start(const std::string& name);
  void start(const std::string& name, bool data);
  bool running() const { return answer_.valid(); }

  /// Once after each call: empty when it was done, or one line on why not. Never waits.
  std::optional<std::string> takeAnswer();

private:
  template <class Service>
  void start(const std::string& name, const Service& service);

  std::future<std::string> answer_;
};

}  // namespace scan_to_path_rviz
