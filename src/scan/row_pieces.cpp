// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "row_pieces.h"

#include <algorithm>
#include <numeric>

namespace scan_to_path::scan {
namespace {

void appendSamples(const Track& track, const Run& run, const Vector3& origin, RowPiece& piece) {
  const std::size_t count = run.end - run.begin;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = run.forward ? run.begin + k : run.end - 1 - k;
    piece.x.push_back(track.x[i] - origin.x());
    piece.y.push_back(track.y[i] - origin.y());
    piece.z.push_back(track.z[i] - origin.z());
    piece.index.push_back(track.index[i]);
  }
}

/// Orders a piece by x. Rows rise but for the shaking of a robot that starts or stops, so only the short windows out
/// of order are sorted.
void orderAlongX(RowPiece& piece) {
  const std::size_t n = piece.size();
  std::vector<double> least_after(n);
  double least = 1e300;
  bool ordered = true;
  for (std::size_t i = n; i-- > 0;) {
    ordered = ordered && piece.x[i] <= least;
    least = std::min(least, piece.x[i]);
    least_after[i] = least;
  }
  if (ordered) return;
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  double most = -1e300;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < n; ++i) {
    most = std::max(most, piece.x[i]);
    if (i + 1 < n && most > least_after[i + 1]) continue;
    std::stable_sort(order.begin() + static_cast<std::ptrdiff_t>(begin),
                     order.begin() + static_cast<std::ptrdiff_t>(i + 1),
                     [&](std::size_t a, std::size_t b) { return piece.x[a] < piece.x[b]; });
    begin = i + 1;
  }
  const auto permute = [&order](auto& values) {
    const auto old = values;
    for (std::size_t i = 0; i < order.size(); ++i) values[i] = old[order[i]];
  };
  permute(piece.y);
  permute(piece.z);
  permute(piece.index);
  permute(piece.x);
}

}  // namespace

std::vector<RowPiece> makePieces(const Track& track, std::vector<Run>& runs, const Vector3& origin) {
  std::sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) {
    return a.row != b.row ? a.row < b.row : a.low != b.low ? a.low < b.low : a.begin < b.begin;
  });
  std::vector<RowPiece> pieces;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const bool goes_on = i > 0 && runs[i].row == runs[i - 1].row && runs[i].forward == runs[i - 1].forward;
    if (!goes_on) {
      pieces.emplace_back();
      pieces.back().row = runs[i].row;
      pieces.back().forward = runs[i].forward;
    }
    RowPiece& piece = pieces.back();
    piece.x.reserve(piece.size() + runs[i].end - runs[i].begin);
    appendSamples(track, runs[i], origin, piece);
  }
  for (RowPiece& piece : pieces) orderAlongX(piece);
  return pieces;
}

}  // namespace scan_to_path::scan
