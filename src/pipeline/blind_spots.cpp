// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/blind_spots.h"

#include <algorithm>
#include <cstdlib>

#include "scan_to_path/common/text.h"

namespace scan_to_path::pipeline {
namespace {

using geometry::Vector3;

/// A stretch of a row without any sample, in the scan frame.
struct Gap {
  std::size_t row = 0;
  double begin = 0.0;  ///< x [m]
  double end = 0.0;
  Vector3 middle = Vector3::Zero();
  std::size_t spot = 0;
};

struct RowSample {
  Vector3 at;
  std::uint32_t index;
};

RowSample sampleAt(const scan::RowPiece& piece, std::size_t i) {
  return {Vector3(piece.x[i], piece.y[i], piece.z[i]), piece.index[i]};
}

std::vector<Gap> gapsOf(const scan::SampleRows& rows, double shortest_gap) {
  std::vector<Gap> gaps;
  std::size_t row = 0;
  for (std::size_t begin = 0, end = 0; begin < rows.pieces.size(); begin = end, ++row) {
    RowSample last = sampleAt(rows.pieces[begin], 0);
    for (; end < rows.pieces.size() && rows.pieces[end].row == rows.pieces[begin].row; ++end) {
      const scan::RowPiece& piece = rows.pieces[end];
      const RowSample first = sampleAt(piece, 0);
      const double between = std::abs(static_cast<double>(first.index) - static_cast<double>(last.index)) - 1.0;
      const double length = first.at.x() - last.at.x();
      if (length - rows.spacing * std::max(0.0, between) > shortest_gap) {
        gaps.push_back({row, last.at.x(), first.at.x(), 0.5 * (first.at + last.at), gaps.size()});
      }
      if (piece.x.back() >= last.at.x()) last = sampleAt(piece, piece.size() - 1);
    }
  }
  return gaps;
}

/// Gives gaps that lie beside each other on neighbouring rows the number of the first of them.
void joinNeighbours(std::vector<Gap>& gaps) {
  std::size_t before = 0;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    while (gaps[before].row + 1 < gaps[i].row) ++before;
    for (std::size_t j = before; gaps[j].row < gaps[i].row; ++j) {
      if (gaps[j].end < gaps[i].begin || gaps[j].begin > gaps[i].end) continue;
      const std::size_t kept = std::min(gaps[i].spot, gaps[j].spot), gone = std::max(gaps[i].spot, gaps[j].spot);
      for (std::size_t k = kept; k <= i; ++k) {
        if (gaps[k].spot == gone) gaps[k].spot = kept;
      }
    }
  }
}

}  // namespace

std::vector<BlindSpot> blindSpots(const scan::SampleRows& rows, double shortest_gap) {
  std::vector<Gap> gaps = gapsOf(rows, shortest_gap);
  joinNeighbours(gaps);
  const double usual = scan::usualRowDistance(rows);
  std::vector<BlindSpot> spots;
  for (std::size_t spot = 0; spot < gaps.size(); ++spot) {
    if (gaps[spot].spot != spot) continue;
    double begin = gaps[spot].begin, end = gaps[spot].end;
    std::size_t count = 0, last_row = gaps[spot].row;
    Vector3 sum = Vector3::Zero();
    for (std::size_t k = spot; k < gaps.size(); ++k) {
      if (gaps[k].spot != spot) continue;
      begin = std::min(begin, gaps[k].begin);
      end = std::max(end, gaps[k].end);
      last_row = gaps[k].row;
      sum += gaps[k].middle;
      ++count;
    }
    spots.push_back({end - begin, usual * static_cast<double>(last_row - gaps[spot].row + 1),
                     rows.T_cloud_scan * Vector3(sum / static_cast<double>(count))});
  }
  std::stable_sort(spots.begin(), spots.end(),
                   [](const BlindSpot& a, const BlindSpot& b) { return a.length * a.width > b.length * b.width; });
  return spots;
}

std::optional<std::string> blindSpotNote(const std::vector<BlindSpot>& spots) {
  if (spots.empty()) return std::nullopt;
  const BlindSpot& largest = spots.front();
  const Vector3& p = largest.middle;
  return "nothing was measured in " + std::to_string(spots.size()) + (spots.size() == 1 ? " place" : " places") +
         " inside the part's rows, the largest " + fixed(1e3 * largest.length, 1) + " x " +
         fixed(1e3 * largest.width, 1) + " mm at (" + fixed(p.x(), 3) + ", " + fixed(p.y(), 3) + ", " +
         fixed(p.z(), 3) + ") m of the scan's frame: where that is no hole, the tool runs into what stands there";
}

}  // namespace scan_to_path::pipeline
