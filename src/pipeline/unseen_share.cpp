// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/unseen_share.h"

#include <algorithm>
#include <vector>

#include "scan_to_path/common/text.h"

namespace scan_to_path::pipeline {
namespace {

/// Lengths of rows [m].
struct Lengths {
  double seen_and_not = 0.0;
  double no_return = 0.0;
  double other = 0.0;
};

/// The part on one row, from its first to its last sample.
struct Row {
  double begin = 0.0;             ///< x [m]
  double end = 0.0;               ///< x [m]
  double y = 0.0;                 ///< mean over its pieces' middles [m]
  std::uint32_t first_index = 0;  ///< of its samples, the least
  std::uint32_t last_index = 0;
};

/// Adds a stretch without samples of the part; those of the cloud between two of its indices tell what is there.
void addUnseen(double length, std::uint32_t index_a, std::uint32_t index_b, double spacing, Lengths& lengths) {
  const std::uint32_t apart = std::max(index_a, index_b) - std::min(index_a, index_b);
  const double sampled = apart > 0 ? spacing * (apart - 1) : 0.0;
  const double other = std::min(sampled, length);
  lengths.other += other;
  lengths.no_return += length - other;
}

/// The rows of the part; gaps inside them go to `lengths`.
std::vector<Row> partRows(const scan::SampleRows& rows, double shortest_gap, Lengths& lengths) {
  std::vector<Row> found;
  for (std::size_t begin = 0, end = 0; begin < rows.pieces.size(); begin = end) {
    Row row = {rows.pieces[begin].x.front(), rows.pieces[begin].x.front(), 0.0, rows.pieces[begin].index.front(), 0};
    std::uint32_t index_at_end = row.first_index;
    for (; end < rows.pieces.size() && rows.pieces[end].row == rows.pieces[begin].row; ++end) {
      const scan::RowPiece& piece = rows.pieces[end];
      const double gap = piece.x.front() - row.end;
      if (gap > shortest_gap) addUnseen(gap, index_at_end, piece.index.front(), rows.spacing, lengths);
      if (piece.x.back() >= row.end) index_at_end = piece.index.back();
      row.end = std::max(row.end, piece.x.back());
      row.y += piece.y[piece.size() / 2];
      row.first_index = std::min({row.first_index, piece.index.front(), piece.index.back()});
      row.last_index = std::max({row.last_index, piece.index.front(), piece.index.back()});
    }
    row.y /= static_cast<double>(end - begin);
    lengths.seen_and_not += row.end - row.begin;
    found.push_back(row);
  }
  return found;
}

/// Rows between two others that have nothing of the part where both of these have.
void addMissingRows(const std::vector<Row>& rows, double spacing, Lengths& lengths) {
  std::vector<double> distances;
  for (std::size_t i = 1; i < rows.size(); ++i) distances.push_back(rows[i].y - rows[i - 1].y);
  if (distances.empty()) return;
  // Rasters may alternate between two pitches: the larger one counts.
  std::vector<double> sorted = distances;
  std::sort(sorted.begin(), sorted.end());
  const double usual = sorted[3 * (sorted.size() - 1) / 4];
  constexpr double largest_usual = 2.5;
  for (std::size_t i = 0; i < distances.size(); ++i) {
    const double overlap = std::min(rows[i].end, rows[i + 1].end) - std::max(rows[i].begin, rows[i + 1].begin);
    if (!(distances[i] > largest_usual * usual) || overlap <= 0.0) continue;
    const double length = overlap * (distances[i] / usual - 1.0);
    const bool rising = rows[i + 1].first_index > rows[i].last_index;
    addUnseen(length, rising ? rows[i].last_index : rows[i + 1].last_index,
              rising ? rows[i + 1].first_index : rows[i].first_index, spacing, lengths);
    lengths.seen_and_not += length;
  }
}

std::string percent(double share) { return fixed(100.0 * share, 1) + " %"; }

}  // namespace

UnseenShare unseenShare(const scan::SampleRows& rows, double shortest_gap) {
  Lengths lengths;
  const std::vector<Row> part = partRows(rows, shortest_gap, lengths);
  addMissingRows(part, rows.spacing, lengths);
  if (!(lengths.seen_and_not > 0.0)) return {};
  return {lengths.no_return / lengths.seen_and_not, lengths.other / lengths.seen_and_not};
}

std::optional<std::string> unseenNote(const UnseenShare& share, double limit) {
  if (share.sum() <= limit) return std::nullopt;
  return percent(share.sum()) + " of the rows inside the part's outline was not seen as part (" +
         percent(share.no_return) + " no return, " + percent(share.other) +
         " table or dropped): where that is no hole, sweep the part a second time from another height or direction";
}

}  // namespace scan_to_path::pipeline
