// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "pcd_header.h"

#include <algorithm>
#include <cmath>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path::scan {
namespace {

std::vector<std::string_view> words(std::string_view line) {
  std::vector<std::string_view> result;
  for (const std::string_view word : split(line, ' ')) {
    const std::string_view clean = trimmed(word);
    if (!clean.empty()) result.push_back(clean);
  }
  return result;
}

class HeaderParser {
public:
  HeaderParser(std::string_view content, const std::string& name) : content_(content), name_(name) {}

  PcdHeader parse() {
    while (!done_) {
      if (header_.bytes >= content_.size()) fail("header", "cut off", "complete, down to its DATA line");
      const auto end = std::min(content_.find('\n', header_.bytes), content_.size());
      const std::string_view line = trimmed(content_.substr(header_.bytes, end - header_.bytes));
      header_.bytes = std::min(end + 1, content_.size());
      ++header_.lines;
      if (!line.empty() && line.front() != '#') readEntry(words(line));
    }
    finish();
    return std::move(header_);
  }

private:
  [[noreturn]] void fail(const std::string& quantity, const std::string& value, const std::string& limit) const {
    throw InputError(name_ + " line " + std::to_string(header_.lines), quantity, value, limit);
  }

  void readEntry(const std::vector<std::string_view>& entry) {
    const std::string_view key = entry.front();
    if (key == "FIELDS" || key == "COLUMNS") {
      for (std::size_t i = 1; i < entry.size(); ++i) {
        header_.fields.emplace_back();
        header_.fields.back().name = std::string(entry[i]);
      }
    } else if (key == "SIZE" || key == "COUNT") {
      readSizes(entry);
    } else if (key == "TYPE") {
      readTypes(entry);
    } else if (key == "WIDTH" || key == "HEIGHT" || key == "POINTS") {
      if (entry.size() != 2) fail(std::string(key), "not one number", "one number");
      const std::uint64_t value = integer(entry[1], std::string(key), 1ULL << 32);
      (key == "WIDTH" ? width_ : key == "HEIGHT" ? height_ : header_.points) = value;
      has_points_ = has_points_ || key == "POINTS";
    } else if (key == "VIEWPOINT") {
      readViewpoint(entry);
    } else if (key == "DATA") {
      readData(entry);
    } else if (key != "VERSION") {
      fail("header entry", "unknown", "one of PCD 0.7's");
    }
  }

  std::uint64_t integer(std::string_view word, const std::string& quantity, std::uint64_t largest) const {
    double value = -1.0;
    if (!parseNumber(word, value) || !(value >= 0.0 && value <= static_cast<double>(largest)) ||
        value != std::floor(value)) {
      fail(quantity, "not such a number", "a whole number up to " + std::to_string(largest));
    }
    return static_cast<std::uint64_t>(value);
  }

  void checkCount(const std::vector<std::string_view>& entry) const {
    if (entry.size() != header_.fields.size() + 1) {
      fail("number of entries after " + std::string(entry.front()), std::to_string(entry.size() - 1),
           std::to_string(header_.fields.size()) + ", one per field");
    }
  }

  void readSizes(const std::vector<std::string_view>& entry) {
    checkCount(entry);
    const bool is_size = entry.front() == "SIZE";
    for (std::size_t i = 0; i < header_.fields.size(); ++i) {
      const std::uint64_t value = integer(entry[i + 1], std::string(entry.front()), is_size ? 8 : 100000);
      if (is_size && value != 1 && value != 2 && value != 4 && value != 8) {
        fail("SIZE", std::to_string(value), "1, 2, 4 or 8");
      }
      (is_size ? header_.fields[i].size : header_.fields[i].count) = static_cast<std::size_t>(value);
    }
  }

  void readTypes(const std::vector<std::string_view>& entry) {
    checkCount(entry);
    for (std::size_t i = 0; i < header_.fields.size(); ++i) {
      const std::string_view type = entry[i + 1];
      if (type != "F" && type != "U" && type != "I") fail("TYPE", "unknown", "F, U or I");
      header_.fields[i].type = type.front();
    }
  }

  void readViewpoint(const std::vector<std::string_view>& entry) {
    if (entry.size() != header_.viewpoint.size() + 1) fail("VIEWPOINT", "not 7 numbers", "7 numbers");
    for (std::size_t i = 0; i < header_.viewpoint.size(); ++i) {
      if (!parseNumber(entry[i + 1], header_.viewpoint[i]) || !std::isfinite(header_.viewpoint[i])) {
        fail("VIEWPOINT", "not 7 numbers", "7 finite numbers");
      }
    }
  }

  void readData(const std::vector<std::string_view>& entry) {
    const std::string_view kind = entry.size() == 2 ? entry[1] : std::string_view();
    if (kind == "ascii") {
      header_.data = PcdData::ascii;
    } else if (kind == "binary") {
      header_.data = PcdData::binary;
    } else if (kind == "binary_compressed") {
      header_.data = PcdData::binary_compressed;
    } else {
      fail("DATA", "unknown", "ascii, binary or binary_compressed");
    }
    done_ = true;
  }

  void finish() {
    if (!has_points_) header_.points = width_ * height_;
    for (PcdField& field : header_.fields) {
      if (field.type == 'F' && field.size < 4) fail("SIZE of float field", std::to_string(field.size), "4 or 8");
      field.offset = header_.point_size;
      header_.point_size += field.size * field.count;
    }
  }

  std::string_view content_;
  const std::string& name_;
  PcdHeader header_;
  std::uint64_t width_ = 0;
  std::uint64_t height_ = 1;
  bool has_points_ = false;
  bool done_ = false;
};

}  // namespace

const PcdField* PcdHeader::find(const std::vector<std::string>& names) const {
  for (const std::string& name : names) {
    for (const PcdField& field : fields) {
      if (field.name == name && field.count > 0) return &field;
    }
  }
  return nullptr;
}

PcdHeader parsePcdHeader(std::string_view content, const std::string& name) {
  return HeaderParser(content, name).parse();
}

}  // namespace scan_to_path::scan
