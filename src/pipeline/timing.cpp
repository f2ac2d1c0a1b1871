// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/timing.h"

#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <ctime>
#include <nlohmann/json.hpp>

namespace scan_to_path::pipeline {
namespace {

std::string hostName() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

std::string utcNow() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text.data();
}

double peakMemory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

}  // namespace

void Timing::mark(const std::string& stage) {
  const auto now = Clock::now();
  stages_.emplace_back(stage, std::chrono::duration<double>(now - last_).count());
  last_ = now;
}

double Timing::total() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

std::string Timing::format(int threads, const std::filesystem::path& input, const std::filesystem::path& out) const {
  nlohmann::ordered_json stages = nlohmann::ordered_json::object();
  for (const auto& [name, seconds] : stages_) stages[name] = seconds;
  const nlohmann::ordered_json root = {{"stages_s", stages},
                                       {"total_s", total()},
                                       {"peak_memory_bytes", peakMemory()},
                                       {"threads", threads},
                                       {"host", hostName()},
                                       {"date", utcNow()},
                                       {"input", std::filesystem::absolute(input).string()},
                                       {"out", std::filesystem::absolute(out).string()}};
  return root.dump(1, ' ', true, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace scan_to_path::pipeline
