// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/scan/sample_rows.h"

#include <algorithm>

namespace scan_to_path::scan {

std::size_t sampleCount(const SampleRows& rows) {
  std::size_t count = 0;
  for (const RowPiece& piece : rows.pieces) count += piece.size();
  return count;
}

void addDropped(std::vector<Dropped>& dropped, const std::string& reason, std::size_t count) {
  if (count == 0) return;
  const auto entry = std::find_if(dropped.begin(), dropped.end(), [&](const Dropped& d) { return d.reason == reason; });
  if (entry != dropped.end()) {
    entry->count += count;
  } else {
    dropped.push_back({reason, count});
  }
}

std::vector<double> rowPlaces(const SampleRows& rows) {
  std::vector<double> places;
  for (std::size_t begin = 0, end = 0; begin < rows.pieces.size(); begin = end) {
    double sum = 0.0;
    for (; end < rows.pieces.size() && rows.pieces[end].row == rows.pieces[begin].row; ++end) {
      sum += rows.pieces[end].y[rows.pieces[end].size() / 2];
    }
    places.push_back(sum / static_cast<double>(end - begin));
  }
  return places;
}

double usualRowDistance(const SampleRows& rows) {
  const std::vector<double> places = rowPlaces(rows);
  std::vector<double> distances;
  for (std::size_t i = 1; i < places.size(); ++i) distances.push_back(places[i] - places[i - 1]);
  if (distances.empty()) return 0.0;
  std::sort(distances.begin(), distances.end());
  return distances[3 * (distances.size() - 1) / 4];
}

void addObstacles(const RowPiece& piece, std::size_t begin, std::size_t end, Obstacles& obstacles) {
  for (std::size_t i = begin; i < end; ++i) {
    obstacles.emplace_back(static_cast<float>(piece.x[i]), static_cast<float>(piece.y[i]),
                           static_cast<float>(piece.z[i]));
  }
}

RowPiece subPiece(const RowPiece& piece, std::size_t begin, std::size_t end) {
  RowPiece part;
  part.row = piece.row;
  part.forward = piece.forward;
  part.begins = begin == 0 ? piece.begins : PieceEnd::gap;
  part.ends = end == piece.size() ? piece.ends : PieceEnd::gap;
  const auto copy = [begin, end](const auto& from, auto& to) {
    to.assign(from.begin() + static_cast<std::ptrdiff_t>(begin), from.begin() + static_cast<std::ptrdiff_t>(end));
  };
  copy(piece.x, part.x);
  copy(piece.y, part.y);
  copy(piece.z, part.z);
  copy(piece.index, part.index);
  return part;
}

}  // namespace scan_to_path::scan
