// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/scan/find_rows.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/median.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path::scan {
namespace {

using Vector2 = Eigen::Vector2d;

/// All finite samples in measured order, in a frame whose z is against the beam.
struct Track {
  std::vector<double> x, y, z;
  std::vector<std::uint32_t> index;

  Vector2 at(std::size_t i) const { return {x[i], y[i]}; }
  std::size_t size() const { return x.size(); }
};

/// Samples begin … end of the track between two cuts.
struct Stretch {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// A stretch's samples at least a window apart; its last sample closes the list.
using Anchors = std::vector<std::size_t>;

/// Samples [begin, end) that travel one way along the rows.
struct Run {
  std::size_t begin = 0;
  std::size_t end = 0;
  bool forward = true;
  double low = 0.0;   ///< range along x
  double high = 0.0;
  double y = 0.0;     ///< mean
  int row = -1;
};

Track project(const ScanCloud& cloud, const Frame& T_scan_cloud) {
  Track track;
  track.x.reserve(cloud.size());
  track.y.reserve(cloud.size());
  track.z.reserve(cloud.size());
  track.index.reserve(cloud.size());
  const Eigen::Matrix3d R = T_scan_cloud.linear();
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const ScanPoint& p = cloud[i];
    const Vector3 q = R * Vector3(p.x, p.y, p.z);
    if (!std::isfinite(q.sum())) continue;
    track.x.push_back(q.x());
    track.y.push_back(q.y());
    track.z.push_back(q.z());
    track.index.push_back(static_cast<std::uint32_t>(i));
  }
  return track;
}

/// Median distance between successive samples that do move.
double medianSpacing(const Track& track) {
  constexpr std::size_t wanted = 20000;
  const std::size_t stride = std::max<std::size_t>(1, track.size() / wanted);
  std::vector<double> steps;
  for (std::size_t i = 1; i < track.size(); i += stride) {
    const double step = (track.at(i) - track.at(i - 1)).norm();
    if (step > 0.0) steps.push_back(step);
  }
  return median(std::move(steps));
}

bool hasLines(const ScanCloud& cloud) {
  return std::any_of(cloud.begin(), cloud.end(), [](const ScanPoint& p) { return p.line != no_line; });
}

/// Removes the points that belong to no line of a cloud that knows its lines.
std::size_t dropWithoutLine(const ScanCloud& cloud, Track& track) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < track.size(); ++i) {
    if (cloud[track.index[i]].line == no_line) continue;
    track.x[kept] = track.x[i];
    track.y[kept] = track.y[i];
    track.z[kept] = track.z[i];
    track.index[kept++] = track.index[i];
  }
  const std::size_t lost = track.size() - kept;
  track.x.resize(kept);
  track.y.resize(kept);
  track.z.resize(kept);
  track.index.resize(kept);
  return lost;
}

std::vector<Stretch> cutTrack(const ScanCloud& cloud, const Track& track, double longest_step, double longest_silence) {
  std::vector<Stretch> stretches;
  std::size_t begin = 0;
  for (std::size_t i = 1; i <= track.size(); ++i) {
    bool cut = i == track.size();
    if (!cut) {
      const ScanPoint& p = cloud[track.index[i - 1]];
      const ScanPoint& q = cloud[track.index[i]];
      cut = (track.at(i) - track.at(i - 1)).squaredNorm() > longest_step * longest_step ||
            std::abs(q.time - p.time) > longest_silence || q.line != p.line;
    }
    if (!cut) continue;
    stretches.push_back({begin, i});
    begin = i;
  }
  return stretches;
}

Anchors findAnchors(const Track& track, const Stretch& stretch, double window) {
  Anchors anchors{stretch.begin};
  for (std::size_t i = stretch.begin + 1; i < stretch.end; ++i) {
    if ((track.at(i) - track.at(anchors.back())).squaredNorm() >= window * window) anchors.push_back(i);
  }
  if (anchors.back() != stretch.end - 1) anchors.push_back(stretch.end - 1);
  return anchors;
}

/// Double-angle mean of the travel directions, which does not mind the sense of travel: its length is the share of
/// them that agree. With a hint only directions nearer to it than acos(least_cosine) count.
Vector2 meanDoubleAngle(const Track& track, const std::vector<Anchors>& all, const Vector2* hint = nullptr,
                        double least_cosine = 0.0) {
  Vector2 sum = Vector2::Zero();
  double weight = 0.0;
  for (const Anchors& anchors : all) {
    for (std::size_t k = 1; k < anchors.size(); ++k) {
      const Vector2 step = track.at(anchors[k]) - track.at(anchors[k - 1]);
      const double length = step.norm();
      if (length == 0.0) continue;
      if (hint != nullptr && std::abs(step.dot(*hint)) < least_cosine * length) continue;
      sum += Vector2(step.x() * step.x() - step.y() * step.y(), 2.0 * step.x() * step.y()) / length;
      weight += length;
    }
  }
  return weight > 0.0 ? Vector2(sum / weight) : Vector2(0.0, 0.0);
}

Vector2 halfAngle(const Vector2& doubled) {
  const double angle = 0.5 * std::atan2(doubled.y(), doubled.x());
  return {std::cos(angle), std::sin(angle)};
}

Vector2 rowDirection(const Track& track, const std::vector<Anchors>& all) {
  const Vector2 doubled = meanDoubleAngle(track, all);
  constexpr double least_agreement = 0.2;
  if (!(doubled.norm() >= least_agreement)) {
    throw InputError("scan cloud", "share of samples travelling along one direction", fixed(doubled.norm(), 2),
                     "at least 0.20: no scan rows found; are the points in the order in which they were measured?");
  }
  Vector2 axis = halfAngle(doubled);
  for (const double least_cosine : {0.866, 0.9986}) {  // 30, 3 degrees: without the way from row to row
    const Vector2 nearer = meanDoubleAngle(track, all, &axis, least_cosine);
    if (nearer.norm() > 0.0) axis = halfAngle(nearer);
  }
  return axis;
}

void rotate(Track& track, const Vector2& axis) {
  for (std::size_t i = 0; i < track.size(); ++i) {
    const Vector2 p = track.at(i);
    track.x[i] = axis.x() * p.x() + axis.y() * p.y();
    track.y[i] = axis.x() * p.y() - axis.y() * p.x();
  }
}

/// +1 or -1 along the rows, 0 when more than 45 degrees off.
int travelClass(const Track& track, std::size_t from, std::size_t to) {
  const Vector2 step = track.at(to) - track.at(from);
  if (std::abs(step.y()) >= std::abs(step.x())) return 0;
  return step.x() > 0.0 ? 1 : -1;
}

/// The sample of [from, to] from which on (or up to which) travel is within 45 degrees of the row: it goes farthest
/// along `sense` less its distance across from sample `on_row`.
std::size_t rowEnd(const Track& track, std::size_t from, std::size_t to, std::size_t on_row, double sense) {
  std::size_t best = from;
  double farthest = -1e300;
  for (std::size_t i = from; i <= to; ++i) {
    const double reach = sense * track.x[i] - std::abs(track.y[i] - track.y[on_row]);
    if (reach <= farthest) continue;
    farthest = reach;
    best = i;
  }
  return best;
}

Run makeRun(const Track& track, std::size_t begin, std::size_t end, bool forward) {
  Run run;
  run.begin = begin;
  run.end = end;
  run.forward = forward;
  const auto first = static_cast<std::ptrdiff_t>(begin);
  const auto last = static_cast<std::ptrdiff_t>(end);
  const auto [low, high] = std::minmax_element(track.x.begin() + first, track.x.begin() + last);
  run.low = *low;
  run.high = *high;
  run.y = std::accumulate(track.y.begin() + first, track.y.begin() + last, 0.0) / static_cast<double>(end - begin);
  return run;
}

/// The runs of one stretch: maximal sequences of anchor intervals of one travel class, with exact ends.
void collectRuns(const Track& track, const Anchors& anchors, std::vector<Run>& runs) {
  const std::size_t intervals = anchors.size() - 1;
  std::size_t k = 0;
  while (k < intervals) {
    const int travel = travelClass(track, anchors[k], anchors[k + 1]);
    std::size_t last = k + 1;
    while (last < intervals && travelClass(track, anchors[last], anchors[last + 1]) == travel) ++last;
    if (travel != 0) {
      const double sense = travel;
      const std::size_t before = anchors[k > 0 ? k - 1 : 0];
      const std::size_t after = anchors[std::min(last + 1, intervals)];
      const std::size_t begin = rowEnd(track, before, anchors[k + 1], anchors[k + 1], -sense);
      const std::size_t end = rowEnd(track, anchors[last - 1], after, anchors[last - 1], sense);
      if (end > begin) runs.push_back(makeRun(track, begin, end + 1, travel > 0));
    }
    k = last;
  }
}

std::vector<Run> findRuns(const Track& track, const std::vector<Anchors>& all, bool lines_given) {
  std::vector<Run> runs;
  for (const Anchors& anchors : all) {
    if (anchors.size() < 2) continue;
    if (lines_given) {
      const bool forward = track.x[anchors.back()] >= track.x[anchors.front()];
      runs.push_back(makeRun(track, anchors.front(), anchors.back() + 1, forward));
    } else {
      collectRuns(track, anchors, runs);
    }
  }
  // Two runs that meet in one turning point share its sample: the earlier one keeps it.
  for (std::size_t i = 1; i < runs.size(); ++i) runs[i].begin = std::max(runs[i].begin, runs[i - 1].end);
  return runs;
}

void keepLongRuns(std::vector<Run>& runs, const RowOptions& options) {
  std::size_t longest = 0;
  for (const Run& run : runs) longest = std::max(longest, run.end - std::min(run.begin, run.end));
  const auto least = static_cast<std::size_t>(options.min_samples);
  if (longest < least) {
    throw InputError("scan cloud", "number of samples on the longest scan row", std::to_string(longest),
                     "at least " + std::to_string(least));
  }
  runs.erase(std::remove_if(runs.begin(), runs.end(),
                            [&](const Run& run) {
                              return run.end < run.begin + least || run.high - run.low < options.min_length;
                            }),
             runs.end());
}

bool overlap(const Run& a, const Run& b, double margin) {
  return std::min(a.high, b.high) - std::max(a.low, b.low) > margin;
}

/// Median distance across of runs that lie beside each other. Precondition: sorted by y.
double medianPitch(const std::vector<Run>& runs, double margin) {
  std::vector<double> distances;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    for (std::size_t j = i + 1; j < runs.size(); ++j) {
      if (!overlap(runs[i], runs[j], margin)) continue;
      distances.push_back(runs[j].y - runs[i].y);
      break;
    }
  }
  if (distances.empty()) {
    throw InputError("scan cloud", "number of scan rows", "1", "at least 2 that lie beside each other");
  }
  return median(std::move(distances));
}

/// Numbers the rows across. Precondition: sorted by y. Runs at one y that do not overlap share a row.
int numberRows(std::vector<Run>& runs, double pitch, double margin) {
  int row = -1;
  std::size_t first = 0;
  double y = 0.0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    constexpr double same_row = 0.25;  // of the pitch: half of that of a row at half pitch
    bool joins = row >= 0 && runs[i].y - y < same_row * pitch;
    for (std::size_t j = first; joins && j < i; ++j) joins = !overlap(runs[i], runs[j], margin);
    if (!joins) {
      ++row;
      first = i;
      y = runs[i].y;
    }
    runs[i].row = row;
  }
  return row + 1;
}

double yAt(const Track& track, const Run& run, double x) {
  std::size_t low = run.begin;
  std::size_t high = run.end - 1;
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    if ((track.x[middle] <= x) == run.forward) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return track.y[low];
}

void checkPairOrder(const Track& track, const Run& a, const Run& b, double margin) {
  if (!overlap(a, b, margin)) return;
  const double low = std::max(a.low, b.low);
  const double high = std::min(a.high, b.high);
  constexpr int stations = 8;
  for (int k = 0; k <= stations; ++k) {
    const double x = low + (high - low) * k / stations;
    if (yAt(track, b, x) > yAt(track, a, x)) continue;
    throw InputError("scan cloud: rows " + std::to_string(a.row) + " and " + std::to_string(b.row) +
                     " cross (or one was scanned twice) " + fixed((x - low) * 1e3, 1) +
                     " mm along them; rows must lie side by side");
  }
}

/// Rows whose order changes along them cross each other. Precondition: sorted by row.
void checkOrder(const Track& track, const std::vector<Run>& runs, double margin) {
  for (std::size_t i = 0; i < runs.size(); ++i) {
    for (std::size_t j = i + 1; j < runs.size() && runs[j].row <= runs[i].row + 1; ++j) {
      if (runs[j].row == runs[i].row + 1) checkPairOrder(track, runs[i], runs[j], margin);
    }
  }
}

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
    std::stable_sort(order.begin() + static_cast<std::ptrdiff_t>(begin), order.begin() + static_cast<std::ptrdiff_t>(i + 1),
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

/// One piece per row and travel direction; what interrupts it is decided later, by the gap's length.
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

/// Middle of the bounding box.
Vector3 middle(const Track& track) {
  const auto centre = [](const std::vector<double>& values) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return 0.5 * (*low + *high);
  };
  return {centre(track.x), centre(track.y), centre(track.z)};
}

Frame beamFrame(const Vector3& mean_beam) {
  if (!(mean_beam.norm() > 0.0) || !std::isfinite(mean_beam.norm())) {
    throw InputError("scan cloud", "mean beam direction", "zero or not finite", "a direction");
  }
  const Vector3 z = -mean_beam.normalized();
  return geometry::frameFromAxes(Vector3::Zero(), z, geometry::anyOrthogonal(z));
}

Track finiteTrack(const ScanCloud& cloud, const Frame& T_cloud_beam, bool lines_given, std::vector<Dropped>& dropped) {
  Track track = project(cloud, T_cloud_beam.inverse());
  addDropped(dropped, "not finite", cloud.size() - track.size());
  if (lines_given) addDropped(dropped, "no line", dropWithoutLine(cloud, track));
  if (track.size() < 4) {
    throw InputError("scan cloud", "number of finite points on lines", std::to_string(track.size()), "at least 4");
  }
  return track;
}

}  // namespace

SampleRows findRows(const ScanCloud& cloud, const Vector3& mean_beam, const RowOptions& options) {
  validate(options, "rows");
  SampleRows rows;
  rows.samples_in = cloud.size();
  const Frame T_cloud_beam = beamFrame(mean_beam);
  const bool lines_given = hasLines(cloud);
  Track track = finiteTrack(cloud, T_cloud_beam, lines_given, rows.dropped);

  rows.spacing = medianSpacing(track);
  const double window = std::max(options.window, 3.0 * rows.spacing);
  const double longest_step = lines_given ? 1e300 : std::max(window, 5.0 * rows.spacing);
  std::vector<Anchors> anchors;
  for (const Stretch& stretch : cutTrack(cloud, track, longest_step, lines_given ? 1e300 : options.max_time_gap)) {
    anchors.push_back(findAnchors(track, stretch, window));
  }
  Vector2 axis = rowDirection(track, anchors);
  rotate(track, axis);

  std::vector<Run> runs = findRuns(track, anchors, lines_given);
  keepLongRuns(runs, options);
  if (!runs.empty() && !runs.front().forward) {  // x runs as the first row does
    axis = -axis;
    rotate(track, Vector2(-1.0, 0.0));
    for (Run& run : runs) run = makeRun(track, run.begin, run.end, !run.forward);
  }
  std::sort(runs.begin(), runs.end(),
            [](const Run& a, const Run& b) { return a.y != b.y ? a.y < b.y : a.begin < b.begin; });
  rows.pitch = medianPitch(runs, window);
  if (numberRows(runs, rows.pitch, window) < 2) {
    throw InputError("scan cloud", "number of scan rows", "1", "at least 2");
  }
  checkOrder(track, runs, window);

  const Vector3 origin = middle(track);
  Frame T_beam_scan = Frame::Identity();
  T_beam_scan.linear() << axis.x(), -axis.y(), 0.0, axis.y(), axis.x(), 0.0, 0.0, 0.0, 1.0;
  T_beam_scan.translation() = T_beam_scan.linear() * origin;
  rows.T_cloud_scan = T_cloud_beam * T_beam_scan;
  rows.pieces = makePieces(track, runs, origin);
  addDropped(rows.dropped, "turn", track.size() - sampleCount(rows));
  return rows;
}

}  // namespace scan_to_path::scan
