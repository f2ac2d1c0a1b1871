// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/scan/sample_log.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>

#include "decimal.h"
#include "scan_to_path/common/byte_order_mark.h"
#include "scan_to_path/common/error.h"
#include "scan_to_path/common/quote.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path::scan {
namespace {

constexpr std::string_view magic = "# scan_to_path samples 1";

/// Reads a log line by line; one pass over the text, no copies of it.
class LogParser {
public:
  LogParser(std::string_view text, const std::string& name) : rest_(withoutByteOrderMark(text)), name_(name) {}

  SampleLog parse() {
    if (trimmed(takeLine()) != magic) fail("first line", "not that of a sample log", "'" + std::string(magic) + "'");
    readHeader();
    const auto rows = static_cast<std::size_t>(std::count(rest_.begin(), rest_.end(), '\n')) + 1;
    log_.joint_time.reserve(rows);
    log_.counts.reserve(rows * joints_);
    log_.sensor_time.reserve(rows);
    log_.voltage.reserve(rows);
    while (!rest_.empty()) {
      const std::string_view line = takeLine();
      if (line.empty() || line.front() == '#') continue;
      readRow(line);
    }
    if (log_.sensor_time.empty()) throw InputError(name_, "number of sensor samples", "0", "at least 1");
    if (log_.joint_time.empty()) throw InputError(name_, "number of joint readings", "0", "at least 1");
    return std::move(log_);
  }

private:
  [[noreturn]] void fail(const std::string& quantity, const std::string& value, const std::string& limit) const {
    throw InputError(name_ + " line " + std::to_string(line_), quantity, value, limit);
  }

  std::string_view takeLine() {
    ++line_;
    const auto end = std::min(rest_.find('\n'), rest_.size());
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
  }

  void readHeader() {
    std::string_view line;
    do {
      if (rest_.empty()) fail("header", "missing", "'t,<joint names>,voltage'");
      line = takeLine();
    } while (line.empty() || line.front() == '#');
    const auto names = split(line, ',');
    if (names.size() < 3 || trimmed(names.front()) != "t" || trimmed(names.back()) != "voltage") {
      fail("header", inQuotes(line), "'t,<joint names>,voltage'");
    }
    std::set<std::string> seen;
    for (std::size_t i = 1; i + 1 < names.size(); ++i) {
      const std::string joint(trimmed(names[i]));
      if (joint.empty() || !seen.insert(joint).second) fail("joint name", inQuotes(joint), "unique and not empty");
      log_.joint_names.push_back(joint);
    }
    joints_ = log_.joint_names.size();
  }

  /// The next cell of a row; `at` moves past its comma. False when the cell is empty.
  bool takeCell(const char*& at, const char* end, std::size_t column, double& value) const {
    if (at == end || *at == ',') return false;
    const char* after = parseDecimal(at, end, value);
    if (after == end || (after != nullptr && *after == ',')) {
      at = after;
      return true;
    }
    const char* cell_end = std::find(at, end, ',');
    const std::string_view cell = trimmed({at, static_cast<std::size_t>(cell_end - at)});
    at = cell_end;
    if (cell.empty()) return false;
    if (!parseNumber(cell, value)) fail(columnName(column), inQuotes(cell), "a number");
    return true;
  }

  void endCell(const char*& at, const char* end, std::size_t column) const {
    const bool last = column == joints_ + 1;
    if (last ? at == end : at != end) {
      if (!last) ++at;
      return;
    }
    fail("number of cells", last ? "more than " + std::to_string(joints_ + 2) : std::to_string(column + 1),
         std::to_string(joints_ + 2));
  }

  void readRow(std::string_view line) {
    const char* at = line.data();
    const char* const end = at + line.size();
    double time = 0.0;
    if (!takeCell(at, end, 0, time)) fail("t", "empty", "a number");
    endCell(at, end, 0);
    if (!std::isfinite(time)) fail("t", fixed(time, 0), "finite");
    if (!(time > last_time_)) fail("t", fixed(time, 6), "after that of the row before, " + fixed(last_time_, 6));
    last_time_ = time;
    const bool has_joints = readJoints(at, end);
    if (has_joints) log_.joint_time.push_back(time);
    if (!readVoltage(at, end, time) && !has_joints)
      fail("row", "empty but for its time", "a reading of the joints or the sensor");
  }

  bool readJoints(const char*& at, const char* end) {
    std::size_t given = 0;
    for (std::size_t joint = 0; joint < joints_; ++joint) {
      double count = 0.0;
      if (takeCell(at, end, joint + 1, count)) {
        if (!std::isfinite(count)) fail(columnName(joint + 1), fixed(count, 0), "finite");
        log_.counts.push_back(count);
        ++given;
      }
      endCell(at, end, joint + 1);
    }
    if (given != 0 && given != joints_) {
      fail("number of joints with counts", std::to_string(given), "0 or " + std::to_string(joints_));
    }
    return given != 0;
  }

  bool readVoltage(const char*& at, const char* end, double time) {
    double voltage = 0.0;
    const bool given = takeCell(at, end, joints_ + 1, voltage);
    endCell(at, end, joints_ + 1);
    if (!given) return false;
    if (std::isinf(voltage)) fail("voltage", fixed(voltage, 0), "finite, or nan for a fault");
    log_.sensor_time.push_back(time);
    log_.voltage.push_back(voltage);
    return true;
  }

  std::string columnName(std::size_t column) const {
    if (column == 0) return "t";
    return column <= joints_ ? log_.joint_names[column - 1] : "voltage";
  }

  std::string_view rest_;
  const std::string& name_;
  std::size_t line_ = 0;
  std::size_t joints_ = 0;
  double last_time_ = -std::numeric_limits<double>::infinity();
  SampleLog log_;
};

void checkLog(const SampleLog& log) {
  const auto check = [](const char* what, std::size_t count, std::size_t wanted) {
    if (count != wanted) throw InputError("sample log", what, std::to_string(count), std::to_string(wanted));
  };
  check("number of counts", log.counts.size(), log.joint_time.size() * log.joint_names.size());
  check("number of voltages", log.voltage.size(), log.sensor_time.size());
  for (const double count : log.counts) {
    if (!std::isfinite(count)) throw InputError("sample log", "count", fixed(count, 0), "finite");
  }
  for (const double voltage : log.voltage) {
    if (std::isinf(voltage)) throw InputError("sample log", "voltage", fixed(voltage, 0), "finite, or nan for a fault");
  }
}

/// Times in microseconds. Throws InputError unless they rise by one at least.
std::vector<std::int64_t> microseconds(const std::vector<double>& times) {
  std::vector<std::int64_t> ticks(times.size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    constexpr double largest = 9e12;  // [s]
    if (!(std::abs(times[i]) < largest))
      throw InputError("sample log", "time", fixed(times[i], 0), "finite and below 9e12 s");
    ticks[i] = roundedTicks(times[i], 1e6);
    if (i > 0 && ticks[i] <= ticks[i - 1]) {
      throw InputError("sample log", "time " + std::to_string(i), fixed(times[i], 9),
                       "at least 1 us after " + fixed(times[i - 1], 9));
    }
  }
  return ticks;
}

/// Header lines.
std::string logHeader(const SampleLog& log) {
  std::string text(magic);
  text += "\nt,";
  for (const std::string& joint : log.joint_names) text += joint + ",";
  return text + "voltage\n";
}

}  // namespace

SampleLog parseSampleLog(std::string_view text, const std::string& name) { return LogParser(text, name).parse(); }

SampleLog readSampleLog(const std::filesystem::path& file) { return parseSampleLog(readFile(file), file.string()); }

std::string formatSampleLog(const SampleLog& log) {
  checkLog(log);
  const auto joint_ticks = microseconds(log.joint_time);
  const auto sensor_ticks = microseconds(log.sensor_time);
  const std::size_t joints = log.joint_names.size();
  std::string text = logHeader(log);
  text.reserve(text.size() + joint_ticks.size() * (16 + 12 * joints) + sensor_ticks.size() * 12);
  std::size_t j = 0;
  std::size_t s = 0;
  while (j < joint_ticks.size() || s < sensor_ticks.size()) {
    const bool has_joints = j < joint_ticks.size() && (s == sensor_ticks.size() || joint_ticks[j] <= sensor_ticks[s]);
    const bool has_sensor = s < sensor_ticks.size() && (!has_joints || sensor_ticks[s] == joint_ticks[j]);
    appendTicks(text, has_joints ? joint_ticks[j] : sensor_ticks[s], 6);
    text += ',';
    for (std::size_t k = 0; k < joints; ++k) {
      if (has_joints) appendShortest(text, log.counts[j * joints + k], 3);
      text += ',';
    }
    if (has_sensor) appendDecimal(text, log.voltage[s], 6);
    text += '\n';
    j += has_joints ? 1 : 0;
    s += has_sensor ? 1 : 0;
  }
  return text;
}

}  // namespace scan_to_path::scan
