// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/scan/line_fit.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "corners.h"
#include "line_table.h"
#include "scan_to_path/common/error.h"
#include "scan_to_path/common/parallel.h"

namespace scan_to_path::scan {
namespace {

constexpr std::size_t least_samples = 8;  // twice the control points of the smallest cubic B-spline

/// Samples [begin, end) of a piece that become one line.
struct Segment {
  const RowPiece* piece = nullptr;
  std::size_t begin = 0;
  std::size_t end = 0;
  bool goes_on = false;   ///< the one before it ends at a gap that may still turn out to be bridged
  std::vector<double> u;  ///< parameters; empty when they are the piece's x
  std::optional<nurbs::LineMoments> moments;

  std::size_t size() const { return end - begin; }
  const double* parameters() const { return u.empty() ? piece->x.data() + begin : u.data(); }
  bool beginsAtEdge() const { return begin == 0 && piece->begins != PieceEnd::gap; }
  bool endsAtEdge() const { return end == piece->size() && piece->ends != PieceEnd::gap; }

  nurbs::LineSamples view() const {
    return {parameters(), piece->x.data() + begin, piece->y.data() + begin, piece->z.data() + begin, size()};
  }
};

/// Cumulated chord lengths (exponent 1) or their square roots (1/2; centripetal, eq 3), scaled to the line's length.
std::vector<double> chordParameters(const Segment& segment, double exponent) {
  const nurbs::LineSamples p = segment.view();
  std::vector<double> u(p.count, 0.0);
  double length = 0.0;
  for (std::size_t i = 1; i < p.count; ++i) {
    const double chord =
        std::sqrt((p.x[i] - p.x[i - 1]) * (p.x[i] - p.x[i - 1]) + (p.y[i] - p.y[i - 1]) * (p.y[i] - p.y[i - 1]) +
                  (p.z[i] - p.z[i - 1]) * (p.z[i] - p.z[i - 1]));
    length += chord;
    u[i] = u[i - 1] + (exponent == 1.0 ? chord : std::sqrt(chord));
  }
  const double scale = u.back() > 0.0 ? length / u.back() : 1.0;
  for (double& value : u) value *= scale;
  return u;
}

void prepare(Segment& segment, Parameterization parameterization) {
  if (parameterization == Parameterization::chord_length) segment.u = chordParameters(segment, 1.0);
  if (parameterization == Parameterization::centripetal) segment.u = chordParameters(segment, 0.5);
  segment.moments.emplace(segment.view());
}

/// Adds a segment long enough to fit; another one's samples stand in the way of whoever follows the others.
void addSegment(const RowPiece& piece, std::size_t begin, std::size_t end, std::vector<Segment>& segments,
                Obstacles& too_short, bool goes_on = false) {
  if (end < begin + least_samples || !(piece.x[end - 1] > piece.x[begin])) {
    addObstacles(piece, begin, end, too_short);
    return;
  }
  segments.emplace_back();
  segments.back().piece = &piece;
  segments.back().begin = begin;
  segments.back().end = end;
  segments.back().goes_on = goes_on;
}

std::vector<Segment> splitAtCorners(const SampleRows& rows, const LineFitOptions& options, int threads,
                                    Obstacles& too_short) {
  std::vector<std::vector<Corner>> corners(rows.pieces.size());
  parallelFor(corners.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) corners[i] = findCorners(rows.pieces[i], options);
  });
  std::vector<Segment> segments;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    std::size_t begin = 0;
    for (const Corner& corner : corners[i]) {
      addSegment(rows.pieces[i], begin, corner.index, segments, too_short);
      begin = corner.index;
    }
    addSegment(rows.pieces[i], begin, rows.pieces[i].size(), segments, too_short);
  }
  return segments;
}

double distance(const RowPiece& piece, std::size_t a, std::size_t b) {
  return std::hypot(piece.x[b] - piece.x[a], piece.y[b] - piece.y[a], piece.z[b] - piece.z[a]);
}

/// Splits at every gap that a fine knot span might not bridge: with the gap inside, spans could not get shorter.
std::vector<Segment> splitAtWideGaps(const std::vector<Segment>& segments, double wide, Obstacles& too_short) {
  std::vector<Segment> result;
  for (const Segment& segment : segments) {
    std::size_t begin = segment.begin;
    for (std::size_t i = begin + least_samples; i + least_samples <= segment.end; ++i) {
      if (i < begin + least_samples || segment.piece->x[i] - segment.piece->x[i - 1] <= wide) continue;
      addSegment(*segment.piece, begin, i, result, too_short, begin != segment.begin);
      begin = i;
    }
    addSegment(*segment.piece, begin, segment.end, result, too_short, begin != segment.begin);
  }
  return result;
}

void prepareAll(std::vector<Segment>& segments, Parameterization parameterization, int threads) {
  parallelFor(segments.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (!segments[i].moments) prepare(segments[i], parameterization);
    }
  });
}

std::vector<int> chooseCounts(const std::vector<Segment>& segments, const nurbs::CurveFitOptions& options,
                              int threads) {
  std::vector<nurbs::LineMoments> moments;
  moments.reserve(segments.size());
  for (const Segment& segment : segments) moments.push_back(*segment.moments);
  return nurbs::chooseControlPoints(moments, options, threads);
}

double knotSpan(const Segment& segment, int control_points) {
  return (segment.moments->last() - segment.moments->first()) / (control_points - 3);
}

/// Joins segments again where the gap between them is not longer than their knot spans. Returns whether any were.
bool joinAcrossGaps(std::vector<Segment>& segments, const std::vector<int>& counts) {
  std::vector<Segment> result;
  double span_before = 0.0;
  for (std::size_t k = 0; k < segments.size(); ++k) {
    Segment& segment = segments[k];
    const double span = counts[k] > 0 ? knotSpan(segment, counts[k]) : 1e300;
    const bool adjoins = segment.goes_on && !result.empty() && result.back().piece == segment.piece &&
                         result.back().end == segment.begin;
    if (adjoins && distance(*segment.piece, segment.begin - 1, segment.begin) <= std::min(span, span_before)) {
      Segment joined;
      joined.piece = segment.piece;
      joined.begin = result.back().begin;
      joined.end = segment.end;
      joined.goes_on = result.back().goes_on;
      result.back() = std::move(joined);
    } else {
      result.push_back(std::move(segment));
    }
    span_before = span;
  }
  const bool changed = result.size() != counts.size();
  segments = std::move(result);
  return changed;
}

/// Splits the segments with a gap longer than a knot span, and drops those that allow no fit at all.
/// Returns whether there were any.
bool splitAtGaps(std::vector<Segment>& segments, const std::vector<int>& counts, Obstacles& too_short) {
  bool changed = false;
  std::vector<Segment> result;
  for (std::size_t k = 0; k < segments.size(); ++k) {
    Segment& segment = segments[k];
    if (counts[k] == 0) {
      addObstacles(*segment.piece, segment.begin, segment.end, too_short);
      changed = true;
      continue;
    }
    const double span = knotSpan(segment, counts[k]);
    if (segment.moments->largestGap() <= span) {
      result.push_back(std::move(segment));
      continue;
    }
    changed = true;
    const double* u = segment.parameters();
    std::size_t begin = 0;
    for (std::size_t i = 1; i <= segment.size(); ++i) {
      if (i < segment.size() && u[i] - u[i - 1] <= span) continue;
      addSegment(*segment.piece, segment.begin + begin, segment.begin + i, result, too_short);
      begin = i;
    }
  }
  segments = std::move(result);
  return changed;
}

/// Sum of squared residuals along the beam.
double beamResidual(const Segment& segment, const LineTable& table) {
  const double* u = segment.parameters();
  const double* z = segment.piece->z.data() + segment.begin;
  double sum = 0.0;
  std::size_t hint = 0;
  for (std::size_t i = 0; i < segment.size(); ++i) {
    const double residual = z[i] - table.point(u[i], hint).z();
    sum += residual * residual;
  }
  return sum;
}

FittedLine fitSegment(const Segment& segment, int control_points, const Frame& T_cloud_scan) {
  nurbs::CurveFit fit = segment.moments->fit(control_points);
  FittedLine line;
  line.row = segment.piece->row;
  line.forward = segment.piece->forward;
  line.curve = std::move(fit.curve);
  line.begin = line.curve.first();
  line.end = line.curve.last();
  line.begins_at_edge = segment.beginsAtEdge();
  line.ends_at_edge = segment.endsAtEdge();
  line.samples = segment.size();
  const double sum = beamResidual(segment, LineTable(line, Frame::Identity()));
  const double n = static_cast<double>(segment.size());
  line.residual_rms = std::sqrt(sum / n);
  line.sigma = std::sqrt(sum / (n - control_points));
  for (Vector3& p : line.curve.control_points) p = T_cloud_scan * p;
  return line;
}

}  // namespace

FittedLines fitLines(const SampleRows& rows, const LineFitOptions& options, int threads) {
  validate(options, "fit");
  FittedLines fitted;
  Obstacles& too_short = fitted.too_short;
  constexpr double wide_gap = 5.0;  // spacings
  std::vector<Segment> segments =
      splitAtWideGaps(splitAtCorners(rows, options, threads, too_short), wide_gap * rows.spacing, too_short);
  std::vector<int> counts;
  do {  // ends: what is joined was split before, what splits in the end stays so
    prepareAll(segments, options.parameterization, threads);
    counts = chooseCounts(segments, options.control_points, threads);
  } while (joinAcrossGaps(segments, counts) || splitAtGaps(segments, counts, too_short));
  if (segments.empty()) {
    throw InputError("scan rows", "number of samples on the longest smooth stretch", "too small",
                     "at least " + std::to_string(least_samples));
  }
  fitted.lines.resize(segments.size());
  parallelFor(segments.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) fitted.lines[i] = fitSegment(segments[i], counts[i], rows.T_cloud_scan);
  });
  addDropped(fitted.dropped, "too short to fit", too_short.size());
  return fitted;
}

}  // namespace scan_to_path::scan
