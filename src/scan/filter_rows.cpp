// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/scan/filter_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "keep_samples.h"
#include "scan_to_path/common/parallel.h"
#include "spikes.h"

namespace scan_to_path::scan {
namespace {

struct Range {
  std::size_t begin = 0;
  std::size_t end = 0;

  std::size_t size() const { return end - begin; }
};

/// Runs of one piece that belong together, and how they end.
struct Part {
  std::vector<Range> runs;
  PieceEnd begins = PieceEnd::border;
  PieceEnd ends = PieceEnd::border;
};

/// What one row became.
struct Filtered {
  std::vector<RowPiece> pieces;
  std::size_t spikes = 0;
  std::size_t edges = 0;
  std::size_t shorts = 0;
  Obstacles obstacles;
};

bool isJump(const RowPiece& piece, std::size_t a, std::size_t b, const FilterOptions& options, double steepness) {
  const double rise = std::abs(piece.z[b] - piece.z[a]);
  return rise > options.jump_height && rise > steepness * std::abs(piece.x[b] - piece.x[a]);
}

std::vector<Range> runsBetweenJumps(const RowPiece& piece, const FilterOptions& options, double steepness) {
  std::vector<Range> runs;
  std::size_t begin = 0;
  for (std::size_t i = 1; i <= piece.size(); ++i) {
    if (i < piece.size() && !isJump(piece, i - 1, i, options, steepness)) continue;
    runs.push_back({begin, i});
    begin = i;
  }
  return runs;
}

double medianOf(std::array<double, 5> values) {
  std::nth_element(values.begin(), values.begin() + 2, values.end());
  return values[2];
}

/// Height at x of the line through the five samples at an end of a run: medians, so that a spike there does no harm.
double heightNear(const RowPiece& piece, std::size_t first, double x) {
  std::array<double, 5> heights;
  std::array<double, 5> slopes;
  for (std::size_t k = 0; k < 5; ++k) {
    const std::size_t i = first + k;
    const std::size_t next = first + (k + 2) % 5;
    const double dx = piece.x[next] - piece.x[i];
    heights[k] = piece.z[i];
    slopes[k] = dx != 0.0 ? (piece.z[next] - piece.z[i]) / dx : 0.0;
  }
  return medianOf(heights) + medianOf(slopes) * (x - piece.x[first + 2]);
}

/// True when the surface before sample a, the last of its run, and from b on, the first of its own, do not meet.
/// `rise` is what lies between them.
bool isStep(const RowPiece& piece, const Range& before, const Range& after, const FilterOptions& options,
            double steepness, double& rise) {
  const std::size_t a = before.end - 1;
  const std::size_t b = after.begin;
  rise = piece.z[b] - piece.z[a];
  if (before.size() >= 5 && after.size() >= 5) {
    const double x = 0.5 * (piece.x[a] + piece.x[b]);
    rise = heightNear(piece, b, x) - heightNear(piece, a - 4, x);
  }
  return std::abs(rise) > options.jump_height && std::abs(rise) > steepness * std::abs(piece.x[b] - piece.x[a]);
}

/// Drops short runs and puts together again what a spike had split.
std::vector<Part> joinRuns(const RowPiece& piece, const std::vector<Range>& runs, const FilterOptions& options,
                           double steepness) {
  std::vector<Part> parts;
  for (const Range& run : runs) {
    if (run.size() < static_cast<std::size_t>(options.min_run)) continue;
    double rise = 0.0;
    const bool jumps = !parts.empty() && isStep(piece, parts.back().runs.back(), run, options, steepness, rise);
    if (parts.empty() || jumps) {
      Part part;
      if (jumps) {
        parts.back().ends = rise > 0.0 ? PieceEnd::step_up : PieceEnd::step_down;
        part.begins = rise > 0.0 ? PieceEnd::step_down : PieceEnd::step_up;
      }
      parts.push_back(part);
    }
    parts.back().runs.push_back(run);
  }
  return parts;
}

RowPiece gather(const RowPiece& piece, const Part& part) {
  RowPiece joined;
  joined.row = piece.row;
  joined.forward = piece.forward;
  joined.begins = part.begins;
  joined.ends = part.ends;
  const auto append = [&part](const auto& from, auto& to) {
    std::size_t count = 0;
    for (const Range& run : part.runs) count += run.size();
    to.reserve(count);
    for (const Range& run : part.runs) {
      to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(run.begin),
                from.begin() + static_cast<std::ptrdiff_t>(run.end));
    }
  };
  append(piece.x, joined.x);
  append(piece.y, joined.y);
  append(piece.z, joined.z);
  append(piece.index, joined.index);
  return joined;
}

Filtered cutAtJumps(RowPiece piece, const FilterOptions& options) {
  const double steepness = std::tan(options.jump_angle);
  Filtered filtered;
  const auto runs = runsBetweenJumps(piece, options, steepness);
  if (runs.size() == 1) {
    filtered.pieces.push_back(std::move(piece));
    return filtered;
  }
  std::size_t kept = 0;
  for (const Part& part : joinRuns(piece, runs, options, steepness)) {
    filtered.pieces.push_back(gather(piece, part));
    kept += filtered.pieces.back().size();
  }
  filtered.edges = piece.size() - kept;
  return filtered;
}

/// Where samples are missing the gap counts in space: a wall under a grazing beam goes on for millimetres meanwhile.
bool isGap(const RowPiece& piece, std::size_t a, std::size_t b, double max_gap, double spacing) {
  constexpr double missing = 3.0;  // spacings
  const double over_plane = std::hypot(piece.x[b] - piece.x[a], piece.y[b] - piece.y[a]);
  if (over_plane <= missing * spacing) return false;
  return std::hypot(over_plane, piece.z[b] - piece.z[a]) > max_gap;
}

void cutAtGaps(RowPiece&& piece, double max_gap, double spacing, std::vector<RowPiece>& pieces) {
  std::size_t begin = 0;
  for (std::size_t i = 1; i < piece.size(); ++i) {
    if (!isGap(piece, i - 1, i, max_gap, spacing)) continue;
    pieces.push_back(subPiece(piece, begin, i));
    begin = i;
  }
  if (begin == 0) {
    pieces.push_back(std::move(piece));
  } else {
    pieces.push_back(subPiece(piece, begin, piece.size()));
  }
}

/// Spikes out, gaps cut, short pieces out. `residuals` has one row per piece.
void finishRow(Filtered& row, const PieceResiduals& residuals, double limit, double spacing,
               const FilterOptions& options) {
  const double max_gap = std::max(options.max_gap, 5.0 * spacing);
  std::vector<RowPiece> cut;
  for (std::size_t k = 0; k < row.pieces.size(); ++k) {
    const std::vector<char> spikes = findSpikes(row.pieces[k], residuals[k], limit);
    row.spikes += keepSamples(row.pieces[k], [&](std::size_t i) { return spikes[i] == 0; });
    if (row.pieces[k].size() > 0) cutAtGaps(std::move(row.pieces[k]), max_gap, spacing, cut);
  }
  row.pieces.clear();
  for (RowPiece& piece : cut) {
    const bool is_short = piece.size() < static_cast<std::size_t>(options.min_run) ||
                          piece.x.back() - piece.x.front() < options.min_length;
    if (is_short) {
      row.shorts += piece.size();
      addObstacles(piece, 0, piece.size(), row.obstacles);
    } else {
      row.pieces.push_back(std::move(piece));
    }
  }
}

/// Calls work(i) for every i below count.
template <class Work>
void forEach(std::size_t count, int threads, Work&& work) {
  parallelFor(count, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) work(i);
  });
}

}  // namespace

SampleRows filterRows(SampleRows rows, const FilterOptions& options, int threads) {
  validate(options, "filter");
  const std::size_t count = rows.pieces.size();
  std::vector<Filtered> filtered(count);
  std::vector<PieceResiduals> residuals(count);
  forEach(count, threads, [&](std::size_t i) {
    filtered[i] = cutAtJumps(std::move(rows.pieces[i]), options);
    for (const RowPiece& piece : filtered[i].pieces) residuals[i].push_back(neighbourResiduals(piece));
  });
  const double scale = 1.4826 * medianAbsoluteResidual(residuals);  // of a normal distribution: its sigma
  const double limit = std::max(options.spike_floor, options.spike_threshold * scale);
  forEach(count, threads, [&](std::size_t i) { finishRow(filtered[i], residuals[i], limit, rows.spacing, options); });

  rows.pieces.clear();
  for (Filtered& row : filtered) {
    addDropped(rows.dropped, "spike", row.spikes);
    addDropped(rows.dropped, "spike or edge", row.edges);
    addDropped(rows.dropped, "short piece", row.shorts);
    rows.obstacles.insert(rows.obstacles.end(), row.obstacles.begin(), row.obstacles.end());
    for (RowPiece& piece : row.pieces) rows.pieces.push_back(std::move(piece));
  }
  return rows;
}

}  // namespace scan_to_path::scan
