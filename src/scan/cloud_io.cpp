// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/scan/cloud_io.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "lzf.h"
#include "pcd_header.h"
#include "scan_to_path/common/byte_order_mark.h"
#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"
#include "scan_to_path/mesh/ply.h"

namespace scan_to_path::scan {
namespace {

using geometry::Vector3;

constexpr double nanosecond = 1e-9;

/// The quantities of a point that are read, in this order.
enum Quantity : std::size_t { x_value, y_value, z_value, line_value, time_value, quantities };

const std::array<std::vector<std::string>, quantities> field_names = {
    {{"x"}, {"y"}, {"z"}, {"line", "ring"}, {"time", "t"}}};

using Values = std::array<double, quantities>;
constexpr Values absent = {0.0, 0.0, 0.0, -1.0, 0.0};

/// Collects points and leaves out those without a place.
class CloudBuilder {
public:
  void reserve(std::size_t count) { file_.cloud.reserve(count); }

  void add(const Values& values) {
    if (!std::isfinite(values[x_value] + values[y_value] + values[z_value])) {
      ++file_.no_return;
      return;
    }
    ScanPoint point;
    point.x = static_cast<float>(values[x_value]);
    point.y = static_cast<float>(values[y_value]);
    point.z = static_cast<float>(values[z_value]);
    const double line = values[line_value];
    point.line = line >= 0.0 && line < static_cast<double>(no_line) ? static_cast<std::uint32_t>(line) : no_line;
    point.time = std::isfinite(values[time_value]) ? values[time_value] : 0.0;
    sum_ += Vector3(point.x, point.y, point.z);
    file_.cloud.push_back(point);
  }

  CloudFile finish(const std::string& name, const std::array<double, 7>* viewpoint) {
    if (file_.cloud.empty()) {
      throw InputError(name, "number of points with finite coordinates", "0 of " + std::to_string(file_.no_return),
                       "at least 1");
    }
    if (viewpoint != nullptr) setViewingDirection(*viewpoint);
    return std::move(file_);
  }

private:
  void setViewingDirection(const std::array<double, 7>& v) {
    const Vector3 origin(v[0], v[1], v[2]);
    const Eigen::Quaterniond turn(v[3], v[4], v[5], v[6]);
    const Vector3 to_points = sum_ / static_cast<double>(file_.cloud.size()) - origin;
    if (origin.norm() > 0.0 && to_points.norm() > 0.0) {
      file_.viewing_direction = to_points.normalized();
    } else if (turn.norm() > 0.0 && turn.vec().norm() > 0.0) {
      file_.viewing_direction = turn.normalized() * Vector3::UnitZ();
    }
  }

  CloudFile file_;
  Vector3 sum_ = Vector3::Zero();
};

template <class T>
double load(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return static_cast<double>(value);
}

double loadField(const PcdField& field, const char* bytes) {
  if (field.type == 'F') return field.size == 4 ? load<float>(bytes) : load<double>(bytes);
  const bool is_signed = field.type == 'I';
  switch (field.size) {
    case 1:
      return is_signed ? load<std::int8_t>(bytes) : load<std::uint8_t>(bytes);
    case 2:
      return is_signed ? load<std::int16_t>(bytes) : load<std::uint16_t>(bytes);
    case 4:
      return is_signed ? load<std::int32_t>(bytes) : load<std::uint32_t>(bytes);
    default:
      return is_signed ? load<std::int64_t>(bytes) : load<std::uint64_t>(bytes);
  }
}

class PcdReader {
public:
  PcdReader(std::string_view content, const std::string& name)
      : name_(name), header_(parsePcdHeader(content, name)), data_(content.substr(header_.bytes)) {
    for (std::size_t q = 0; q < quantities; ++q) fields_[q] = header_.find(field_names[q]);
    for (const Quantity q : {x_value, y_value, z_value}) {
      if (fields_[q] == nullptr) throw InputError(name, "field " + field_names[q][0], "missing", "there");
      if (fields_[q]->type != 'F')
        throw InputError(name, "type of field " + field_names[q][0], std::string(1, fields_[q]->type), "F");
    }
  }

  CloudFile read() {
    switch (header_.data) {
      case PcdData::ascii:
        readAscii();
        break;
      case PcdData::binary:
        readBinary();
        break;
      case PcdData::binary_compressed:
        readCompressed();
        break;
    }
    return builder_.finish(name_, &header_.viewpoint);
  }

private:
  double scale(std::size_t q) const { return q == time_value && fields_[q]->type != 'F' ? nanosecond : 1.0; }

  void checkRoom(std::size_t bytes) const {
    if (bytes / header_.point_size >= header_.points) return;
    throw InputError(name_, "number of points", std::to_string(header_.points),
                     "at most the " + std::to_string(bytes / header_.point_size) + " that the file holds");
  }

  /// Adds all points; `place(field, i)` says where field `field` of point i starts.
  template <class Place>
  void addAll(const Place& place) {
    builder_.reserve(static_cast<std::size_t>(header_.points));
    for (std::uint64_t i = 0; i < header_.points; ++i) {
      Values values = absent;
      for (std::size_t q = 0; q < quantities; ++q) {
        if (fields_[q] != nullptr)
          values[q] = scale(q) * loadField(*fields_[q], place(*fields_[q], static_cast<std::size_t>(i)));
      }
      builder_.add(values);
    }
  }

  void readBinary() {
    checkRoom(data_.size());
    addAll([&](const PcdField& field, std::size_t i) { return data_.data() + i * header_.point_size + field.offset; });
  }

  /// Compressed data keeps all points' first field, then all second fields, and so on.
  void readCompressed() {
    if (data_.size() < 8) throw InputError(name_, "compressed data", "cut off", "complete");
    const auto packed = static_cast<std::size_t>(load<std::uint32_t>(data_.data()));
    const auto size = static_cast<std::size_t>(load<std::uint32_t>(data_.data() + 4));
    if (packed > data_.size() - 8)
      throw InputError(name_, "compressed data", "cut off", std::to_string(packed) + " bytes");
    const auto expanded = expandLzf(data_.substr(8, packed), size);
    if (!expanded)
      throw InputError(name_, "compressed data", "damaged", "LZF data of " + std::to_string(size) + " bytes");
    checkRoom(expanded->size());
    const auto points = static_cast<std::size_t>(header_.points);
    addAll([&](const PcdField& field, std::size_t i) {
      return expanded->data() + points * field.offset + i * field.size * field.count;
    });
  }

  void readAscii() {
    std::vector<std::size_t> column(quantities, 0);  // 0: not there, else number of the word from 1
    std::size_t columns = 0;
    for (const PcdField& field : header_.fields) {
      for (std::size_t q = 0; q < quantities; ++q) {
        if (fields_[q] == &field) column[q] = columns + 1;
      }
      columns += field.count;
    }
    std::size_t at = 0;
    std::size_t line_number = header_.lines;
    for (std::uint64_t i = 0; i < header_.points; ++i) {
      std::string_view line;
      do {
        if (at >= data_.size()) {
          throw InputError(name_, "number of points", std::to_string(header_.points),
                           "at most the " + std::to_string(i) + " that the file holds");
        }
        const auto end = std::min(data_.find('\n', at), data_.size());
        line = trimmed(data_.substr(at, end - at));
        at = end + 1;
        ++line_number;
      } while (line.empty());
      addAsciiPoint(line, column, columns, name_ + " line " + std::to_string(line_number));
    }
  }

  void addAsciiPoint(std::string_view line, const std::vector<std::size_t>& column, std::size_t columns,
                     const std::string& where) {
    Values values = absent;
    std::size_t word_number = 0;
    while (!line.empty()) {
      const auto length = std::min(line.find_first_of(" \t"), line.size());
      const std::string_view word = line.substr(0, length);
      line.remove_prefix(std::min(length + 1, line.size()));
      if (word.empty()) continue;
      ++word_number;
      for (std::size_t q = 0; q < quantities; ++q) {
        if (column[q] != word_number) continue;
        if (!parseNumber(word, values[q])) throw InputError(where, field_names[q][0], "not a number", "a number");
        values[q] *= scale(q);
      }
    }
    if (word_number != columns)
      throw InputError(where, "number of values", std::to_string(word_number), std::to_string(columns));
    builder_.add(values);
  }

  const std::string& name_;
  PcdHeader header_;
  std::string_view data_;
  std::array<const PcdField*, quantities> fields_{};
  CloudBuilder builder_;
};

CloudFile readPly(std::string_view content, const std::string& name) {
  mesh::PlyReader reader(content, name);
  if (reader.header().hasFaces()) throw InputError(name, "PLY file", "a mesh with faces", "a cloud without faces");
  CloudBuilder builder;
  mesh::PlyRow row;
  while (const mesh::PlyElement* element = reader.nextElement()) {
    if (element->name != "vertex") continue;
    std::array<std::optional<std::size_t>, quantities> column;
    for (std::size_t q = 0; q < quantities; ++q) {
      for (const std::string& field : field_names[q]) {
        if (!column[q]) column[q] = element->find(field);
      }
      if (q <= z_value && !column[q])
        throw InputError(name, "vertex property " + field_names[q][0], "missing", "there");
    }
    const auto is_integer = [&](std::size_t c) { return element->properties[c].type < mesh::PlyType::float32; };
    const double time_scale = column[time_value] && is_integer(*column[time_value]) ? nanosecond : 1.0;
    builder.reserve(static_cast<std::size_t>(element->count));
    for (std::uint64_t i = 0; i < element->count; ++i) {
      reader.readRow(row);
      Values values = absent;
      for (std::size_t q = 0; q < quantities; ++q) {
        if (column[q]) values[q] = row.values[*column[q]];
      }
      values[time_value] *= time_scale;
      builder.add(values);
    }
  }
  return builder.finish(name, nullptr);
}

template <class T>
void appendBytes(std::string& text, T value) {
  std::array<char, sizeof value> bytes;
  std::memcpy(bytes.data(), &value, sizeof value);
  text.append(bytes.data(), bytes.size());
}

}  // namespace

bool isPcd(std::string_view content) {
  const std::string_view start = trimmed(content.substr(0, 200));
  return start.substr(0, 7) == "# .PCD " || start.substr(0, 8) == "VERSION " || start.substr(0, 7) == "FIELDS ";
}

CloudFile parseCloud(std::string_view content, const std::string& name) {
  content = withoutByteOrderMark(content);
  if (mesh::isPly(content)) return readPly(content, name);
  if (isPcd(content)) return PcdReader(content, name).read();
  throw InputError(name, "content", "neither PCD nor PLY", "one of them");
}

CloudFile readCloud(const std::filesystem::path& file) { return parseCloud(readFile(file), file.string()); }

std::string formatPcd(const ScanCloud& cloud, const geometry::Frame& T_cloud_sensor) {
  const std::string count = std::to_string(cloud.size());
  std::string text =
      "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z line time\nSIZE 4 4 4 4 8\n"
      "TYPE F F F U F\nCOUNT 1 1 1 1 1\nWIDTH " +
      count + "\nHEIGHT 1\nVIEWPOINT";
  const Vector3 origin = T_cloud_sensor.translation();
  const Eigen::Quaterniond turn = geometry::canonicalQuaternion(T_cloud_sensor.linear());
  for (const double value : {origin.x(), origin.y(), origin.z(), turn.w(), turn.x(), turn.y(), turn.z()}) {
    text += " " + fixed(value, 15);
  }
  text += "\nPOINTS " + count + "\nDATA binary\n";
  text.reserve(text.size() + 24 * cloud.size());
  for (const ScanPoint& p : cloud) {
    for (const float value : {p.x, p.y, p.z}) appendBytes(text, value);
    appendBytes(text, p.line);
    appendBytes(text, p.time);
  }
  return text;
}

}  // namespace scan_to_path::scan
