// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/scan/outline.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace scan_to_path::scan {
namespace {

using Vector2 = Eigen::Vector2d;

/// A corner of the outline: the row it lies on and its x. Equal corners are equal numbers.
using Corner = std::pair<int, double>;
using Edge = std::pair<Corner, Corner>;

/// x range of a piece with the y of its ends.
struct Span {
  double begin = 0.0;
  double end = 0.0;
  double y_begin = 0.0;
  double y_end = 0.0;
};

/// Spans of every row, left to right; pieces that a short cut separates are one span.
std::vector<std::vector<Span>> rowSpans(const SampleRows& rows) {
  std::vector<std::vector<Span>> spans;
  for (const RowPiece& piece : rows.pieces) {
    const auto row = static_cast<std::size_t>(piece.row);
    if (spans.size() <= row) spans.resize(row + 1);
    if (!spans[row].empty() && piece.x.front() <= spans[row].back().end) {
      Span& last = spans[row].back();
      if (piece.x.back() > last.end) {
        last.end = piece.x.back();
        last.y_end = piece.y.back();
      }
      continue;
    }
    spans[row].push_back({piece.x.front(), piece.x.back(), piece.y.front(), piece.y.back()});
  }
  return spans;
}

/// True when the spans overlap and no row is missing between them.
bool overlap(const Span& a, const Span& b, double largest_distance) {
  const double distance = std::abs(0.5 * (b.y_begin + b.y_end) - 0.5 * (a.y_begin + a.y_end));
  return std::min(a.end, b.end) > std::max(a.begin, b.begin) && distance <= largest_distance;
}

/// Whether a straight edge between the rows may join two ends: one that runs nearly along the rows would take in a
/// long stretch that only one of the rows has seen.
bool joinsStraight(double x_lower, double y_lower, double x_upper, double y_upper) {
  constexpr double most_per_distance = 2.0;
  return std::abs(x_upper - x_lower) <= most_per_distance * std::abs(y_upper - y_lower);
}

/// Two overlapping spans of neighbouring rows as the quadrilateral between them, counter-clockwise. An end that both
/// have to themselves joins straight; where one span meets several, or ends far beyond the other, it is cut down to
/// the overlap.
std::vector<Edge> quadrilateral(int row, const std::vector<Span>& lower, std::size_t a, const std::vector<Span>& upper,
                                std::size_t b, double largest_distance) {
  const auto touch = [largest_distance](const Span& lower, const Span& upper) {
    return overlap(lower, upper, largest_distance);
  };
  const bool left_far = !joinsStraight(lower[a].begin, lower[a].y_begin, upper[b].begin, upper[b].y_begin);
  const bool right_far = !joinsStraight(lower[a].end, lower[a].y_end, upper[b].end, upper[b].y_end);
  const bool left_shared =
      left_far || (b > 0 && touch(lower[a], upper[b - 1])) || (a > 0 && touch(lower[a - 1], upper[b]));
  const bool right_shared = right_far || (b + 1 < upper.size() && touch(lower[a], upper[b + 1])) ||
                            (a + 1 < lower.size() && touch(lower[a + 1], upper[b]));
  const double left = std::max(lower[a].begin, upper[b].begin);
  const double right = std::min(lower[a].end, upper[b].end);
  const Corner lower_left(row, left_shared ? left : lower[a].begin);
  const Corner lower_right(row, right_shared ? right : lower[a].end);
  const Corner upper_left(row + 1, left_shared ? left : upper[b].begin);
  const Corner upper_right(row + 1, right_shared ? right : upper[b].end);
  return {{lower_left, lower_right}, {lower_right, upper_right}, {upper_right, upper_left}, {upper_left, lower_left}};
}

/// Edges along one row, of the strip above it (towards +x) and of the strip below it (towards -x), less the parts
/// that both have: there the outline does not run.
std::vector<Edge> cancelAlongRow(int row, const std::vector<Edge>& edges) {
  std::map<double, int> change;  // net number of edges towards +x from this x on
  for (const Edge& edge : edges) {
    const double low = std::min(edge.first.second, edge.second.second);
    const double high = std::max(edge.first.second, edge.second.second);
    const int sense = edge.second.second > edge.first.second ? 1 : -1;
    change[low] += sense;
    change[high] -= sense;
  }
  std::vector<Edge> kept;
  int sense = 0;
  double from = 0.0;
  for (const auto& [x, step] : change) {
    if (sense > 0) kept.push_back({{row, from}, {row, x}});
    if (sense < 0) kept.push_back({{row, x}, {row, from}});
    sense += step;
    from = x;
  }
  return kept;
}

/// Closes edges to loops. Where loops touch, each takes the edge that comes first.
std::vector<std::vector<Corner>> closeLoops(const std::vector<Edge>& edges) {
  std::multimap<Corner, Corner> next(edges.begin(), edges.end());
  std::vector<std::vector<Corner>> loops;
  while (!next.empty()) {
    std::vector<Corner> loop;
    auto edge = next.begin();
    while (edge != next.end()) {
      loop.push_back(edge->first);
      const Corner to = edge->second;
      next.erase(edge);
      edge = next.find(to);
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

/// y on a row at x: on the line between the ends of the span that x lies on.
double rowHeight(const std::vector<Span>& spans, double x) {
  auto span = spans.begin();
  while (span + 1 != spans.end() && x > span->end) ++span;
  const double width = span->end - span->begin;
  const double share = width > 0.0 ? std::clamp((x - span->begin) / width, 0.0, 1.0) : 0.0;
  return span->y_begin + share * (span->y_end - span->y_begin);
}

bool isStraight(const Vector2& a, const Vector2& b, const Vector2& c) {
  const Vector2 ab = b - a;
  const Vector2 bc = c - b;
  return std::abs(ab.x() * bc.y() - ab.y() * bc.x()) <= 1e-12 * ab.norm() * bc.norm() && ab.dot(bc) > 0.0;
}

std::vector<Vector2> polygonOf(const std::vector<Corner>& loop, const std::vector<std::vector<Span>>& spans) {
  std::vector<Vector2> polygon;
  for (const auto& [row, x] : loop) {
    const Vector2 p(x, rowHeight(spans[static_cast<std::size_t>(row)], x));
    const std::size_t n = polygon.size();
    if (n >= 2 && isStraight(polygon[n - 2], polygon[n - 1], p)) polygon.pop_back();
    polygon.push_back(p);
  }
  return polygon;
}

}  // namespace

Outline traceOutline(const SampleRows& rows) {
  const auto spans = rowSpans(rows);
  // What nobody has seen is not the part: where rows are missing it ends.
  const double largest_distance = largest_usual_distance * usualRowDistance(rows);
  std::vector<std::vector<Edge>> along(spans.size());
  std::vector<Edge> edges;
  for (std::size_t r = 0; r + 1 < spans.size(); ++r) {
    for (std::size_t a = 0; a < spans[r].size(); ++a) {
      for (std::size_t b = 0; b < spans[r + 1].size(); ++b) {
        if (!overlap(spans[r][a], spans[r + 1][b], largest_distance)) continue;
        const auto quad = quadrilateral(static_cast<int>(r), spans[r], a, spans[r + 1], b, largest_distance);
        along[r].push_back(quad[0]);
        edges.push_back(quad[1]);
        along[r + 1].push_back(quad[2]);
        edges.push_back(quad[3]);
      }
    }
  }
  for (std::size_t r = 0; r < spans.size(); ++r) {
    const auto kept = cancelAlongRow(static_cast<int>(r), along[r]);
    edges.insert(edges.end(), kept.begin(), kept.end());
  }
  Outline outline;
  for (const auto& loop : closeLoops(edges)) {
    auto polygon = polygonOf(loop, spans);
    if (polygon.size() >= 3) outline.polygons.push_back(std::move(polygon));
  }
  return outline;
}

OutlineTest::OutlineTest(const Outline& outline) {
  std::vector<Edge> all;
  double y_max = -1e300;
  y_min_ = 1e300;
  for (const auto& polygon : outline.polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vector2& p = polygon[i];
      const Vector2& q = polygon[(i + 1) % polygon.size()];
      y_min_ = std::min(y_min_, p.y());
      y_max = std::max(y_max, p.y());
      if (p.y() == q.y()) continue;
      const Vector2& low = p.y() < q.y() ? p : q;
      const Vector2& high = p.y() < q.y() ? q : p;
      all.push_back({low.y(), high.y(), low.x(), (high.x() - low.x()) / (high.y() - low.y())});
    }
  }
  const std::size_t bins = std::max<std::size_t>(1, all.size());
  bins_per_metre_ = y_max > y_min_ ? static_cast<double>(bins) / (y_max - y_min_) : 0.0;
  const auto bin = [&](double y) {
    return std::min(bins - 1, static_cast<std::size_t>((y - y_min_) * bins_per_metre_));
  };
  first_.assign(bins + 1, 0);
  for (const Edge& edge : all) {
    for (std::size_t b = bin(edge.y_low); b <= bin(edge.y_high); ++b) ++first_[b + 1];
  }
  for (std::size_t b = 0; b < bins; ++b) first_[b + 1] += first_[b];
  edges_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (const Edge& edge : all) {
    for (std::size_t b = bin(edge.y_low); b <= bin(edge.y_high); ++b) edges_[next[b]++] = edge;
  }
}

bool OutlineTest::inside(double x, double y) const {
  const double position = (y - y_min_) * bins_per_metre_;
  const std::size_t bins = first_.size() - 1;
  if (!(position >= 0.0) || position >= static_cast<double>(bins)) return false;
  const auto b = static_cast<std::size_t>(position);
  bool inside = false;
  for (std::size_t i = first_[b]; i < first_[b + 1]; ++i) {
    const Edge& edge = edges_[i];
    if (y < edge.y_low || y >= edge.y_high) continue;
    if (edge.x_at_low + (y - edge.y_low) * edge.dx_dy <= x) inside = !inside;
  }
  return inside;
}

}  // namespace scan_to_path::scan
