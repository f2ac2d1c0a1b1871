// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/unseen_share.h"

#include <algorithm>
#include <vector>

#include "scan_to_path/common/text.h"
#include "scan_to_path/pipeline/beyond_range.h"

namespace scan_to_path::pipeline {
namespace {

/// Lengths of rows [m].
struct Lengths {
  double seen_and_not = 0.0;
  double too_near = 0.0;
  double too_far = 0.0;
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
  const std::vector<double> places = scan::rowPlaces(rows);
  std::vector<Row> found;
  for (std::size_t begin = 0, end = 0; begin < rows.pieces.size(); begin = end) {
    Row row = {rows.pieces[begin].x.front(), rows.pieces[begin].x.front(), places[found.size()],
               rows.pieces[begin].index.front(), 0};
    std::uint32_t index_at_end = row.first_index;
    for (; end < rows.pieces.size() && rows.pieces[end].row == rows.pieces[begin].row; ++end) {
      const scan::RowPiece& piece = rows.pieces[end];
      const double gap = piece.x.front() - row.end;
      if (gap > shortest_gap) addUnseen(gap, index_at_end, piece.index.front(), rows.spacing, lengths);
      if (piece.x.back() >= row.end) index_at_end = piece.index.back();
      row.end = std::max(row.end, piece.x.back());
      row.first_index = std::min({row.first_index, piece.index.front(), piece.index.back()});
      row.last_index = std::max({row.last_index, piece.index.front(), piece.index.back()});
    }
    lengths.seen_and_not += row.end - row.begin;
    found.push_back(row);
  }
  return found;
}

/// Rows between two others that have nothing of the part where both of these have.
void addMissingRows(const std::vector<Row>& rows, double usual, double spacing, Lengths& lengths) {
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    const double distance = rows[i + 1].y - rows[i].y;
    const double overlap = std::min(rows[i].end, rows[i + 1].end) - std::max(rows[i].begin, rows[i + 1].begin);
    if (!(distance > scan::largest_usual_distance * usual) || overlap <= 0.0) continue;
    const double length = overlap * (distance / usual - 1.0);
    const bool rising = rows[i + 1].first_index > rows[i].last_index;
    addUnseen(length, rising ? rows[i].last_index : rows[i + 1].last_index,
              rising ? rows[i + 1].first_index : rows[i].first_index, spacing, lengths);
    lengths.seen_and_not += length;
  }
}

/// True on a row between its first and its last sample of the part, and between rows where both have the part.
bool isInside(const std::vector<Row>& rows, double usual, double x, double y) {
  const auto on = [x](const Row& row) { return x >= row.begin && x <= row.end; };
  const auto above =
      std::lower_bound(rows.begin(), rows.end(), y, [](const Row& row, double at) { return row.y < at; });
  const bool on_above = above != rows.end() && on(*above);
  const bool on_below = above != rows.begin() && on(*(above - 1));
  if (on_above && on_below) return true;
  return (on_above && above->y - y <= 0.5 * usual) || (on_below && y - (above - 1)->y <= 0.5 * usual);
}

/// Adds what lies beyond the range beside the rows, and names what does inside them.
void addBeyondRange(const BeyondRangeLengths& beyond, Lengths& lengths) {
  const double inside = beyond.inside.too_near + beyond.inside.too_far;
  // Gaps are measured from sample to sample, these lengths in cells: what is named cannot be more than the gaps.
  const double named = inside > 0.0 ? std::min(1.0, lengths.no_return / inside) : 0.0;
  lengths.no_return -= named * inside;
  lengths.too_near += named * beyond.inside.too_near + beyond.outside.too_near;
  lengths.too_far += named * beyond.inside.too_far + beyond.outside.too_far;
  lengths.seen_and_not += beyond.outside.too_near + beyond.outside.too_far;
}

std::string percent(double share) { return fixed(100.0 * share, 1) + " %"; }

}  // namespace

UnseenShare unseenShare(const scan::ScanCloud& cloud, const scan::SampleRows& rows, const scan::NoReturns& no_returns,
                        double shortest_gap) {
  Lengths lengths;
  const std::vector<Row> part = partRows(rows, shortest_gap, lengths);
  const double usual = scan::usualRowDistance(rows);
  addMissingRows(part, usual, rows.spacing, lengths);
  if (!no_returns.beams.empty() && usual > 0.0) {
    const auto is_inside = [&](double x, double y) { return isInside(part, usual, x, y); };
    addBeyondRange(lengthsBeyondRange(cloud, rows, no_returns, usual, is_inside), lengths);
  }
  const double whole = lengths.seen_and_not;
  if (!(whole > 0.0)) return {};
  return {lengths.too_near / whole, lengths.too_far / whole, std::max(0.0, lengths.no_return / whole),
          lengths.other / whole};
}

std::optional<std::string> unseenNote(const UnseenShare& share, double limit) {
  if (share.sum() <= limit) return std::nullopt;
  std::string sweep = "from another height or direction";
  if (share.too_near > 0.0 && share.too_far > 0.0) {
    sweep = "with the sensor higher for what is too near, and lower for what is too far";
  } else if (share.too_near > 0.0) {
    sweep = "with the sensor higher";
  } else if (share.too_far > 0.0) {
    sweep = "with the sensor lower";
  }
  return percent(share.sum()) + " of the part's rows was not seen as part (" + percent(share.too_near) +
         " too near for the sensor, " + percent(share.too_far) + " too far, " + percent(share.no_return) +
         " no return, " + percent(share.other) +
         " table or dropped): where that is no hole, sweep the part a second time " + sweep;
}

}  // namespace scan_to_path::pipeline
