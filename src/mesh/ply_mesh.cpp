// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>

#include "mesh_builder.h"
#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path::mesh {
namespace {

std::size_t scalarColumn(const PlyElement& element, const char* property, const std::string& name) {
  const auto column = element.find(property);
  if (!column || element.properties[*column].is_list) {
    throw InputError(name + ": element '" + element.name + "' has no number called " + property);
  }
  return *column;
}

void readVertices(PlyReader& reader, const PlyElement& element, const std::string& name, MeshBuilder& builder) {
  const std::size_t x = scalarColumn(element, "x", name);
  const std::size_t y = scalarColumn(element, "y", name);
  const std::size_t z = scalarColumn(element, "z", name);
  PlyRow row;
  for (std::uint64_t i = 0; i < element.count; ++i) {
    reader.readRow(row);
    builder.addVertex({row.values[x], row.values[y], row.values[z]}, [&] { return reader.where(); });
  }
}

std::size_t indexColumn(const PlyElement& element, const std::string& name) {
  for (const char* property : {"vertex_indices", "vertex_index"}) {
    const auto column = element.find(property);
    if (column && element.properties[*column].is_list) return *column;
  }
  throw InputError(name + ": element 'face' has no list called vertex_indices or vertex_index");
}

void readFaces(PlyReader& reader, const PlyElement& element, const std::string& name, MeshBuilder& builder) {
  const std::size_t column = indexColumn(element, name);
  PlyRow row;
  std::vector<std::int64_t> indices;
  for (std::uint64_t i = 0; i < element.count; ++i) {
    reader.readRow(row);
    indices.clear();
    for (const double index : row.lists[column]) {
      if (!(std::abs(index) < 1e15) || index != std::floor(index)) {
        throw InputError(reader.where(), "vertex index", std::to_string(index), "a whole number");
      }
      indices.push_back(static_cast<std::int64_t>(index));
    }
    builder.addPolygon(indices, [&] { return reader.where(); });
  }
}

template <class T>
void appendBinary(std::string& bytes, T value, bool swapped) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), &value, sizeof(T));
  if (swapped) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), raw.size());
}

/// The shortest text that reads back the same.
void appendShortest(std::string& text, double value) {
  std::array<char, 32> buffer;
  text.append(buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr);
}

void appendAscii(std::string& text, const TriangleMesh& mesh) {
  for (const auto& vertex : mesh.vertices) {
    for (int i = 0; i < 3; ++i) {
      appendShortest(text, vertex[i]);
      text += i < 2 ? ' ' : '\n';
    }
  }
  for (const auto& triangle : mesh.triangles) {
    text += '3';
    for (const auto index : triangle) {
      text += ' ';
      appendInteger(text, index);
    }
    text += '\n';
  }
}

void appendBinary(std::string& bytes, const TriangleMesh& mesh, bool swapped) {
  for (const auto& vertex : mesh.vertices) {
    for (int i = 0; i < 3; ++i) appendBinary(bytes, vertex[i], swapped);
  }
  for (const auto& triangle : mesh.triangles) {
    bytes += '\3';
    for (const auto index : triangle) appendBinary(bytes, index, swapped);
  }
}

}  // namespace

MeshFile parsePlyMesh(std::string_view content, const std::string& name) {
  PlyReader reader(content, name);
  MeshBuilder builder;
  while (const PlyElement* element = reader.nextElement()) {
    if (element->name == "vertex") readVertices(reader, *element, name, builder);
    if (element->name == "face") readFaces(reader, *element, name, builder);
  }
  return builder.finish(MeshFormat::ply, name);
}

std::string formatPly(const TriangleMesh& mesh, PlyFormat format) {
  const char* const formats[] = {"ascii", "binary_little_endian", "binary_big_endian"};
  std::string content = std::string("ply\nformat ") + formats[static_cast<int>(format)] + " 1.0\nelement vertex " +
                        std::to_string(mesh.vertices.size()) +
                        "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                        std::to_string(mesh.triangles.size()) +
                        "\nproperty list uchar uint vertex_indices\nend_header\n";
  if (format == PlyFormat::ascii) {
    appendAscii(content, mesh);
  } else {
    appendBinary(content, mesh, format == PlyFormat::binary_big_endian);
  }
  return content;
}

}  // namespace scan_to_path::mesh
