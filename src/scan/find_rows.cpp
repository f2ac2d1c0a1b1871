// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/scan/find_rows.h"

#include <algorithm>
#include <cmath>

#include "row_order.h"
#include "row_pieces.h"
#include "runs.h"
#include "scan_to_path/common/error.h"
#include "track.h"
#include "travel_direction.h"

namespace scan_to_path::scan {
namespace {

bool hasLines(const ScanCloud& cloud) {
  return std::any_of(cloud.begin(), cloud.end(), [](const ScanPoint& p) { return p.line != no_line; });
}

Frame beamFrame(const Vector3& mean_beam) {
  if (!(mean_beam.norm() > 0.0) || !std::isfinite(mean_beam.norm())) {
    throw InputError("scan cloud", "mean beam direction", "zero or not finite", "a direction");
  }
  const Vector3 z = -mean_beam.normalized();
  return geometry::frameFromAxes(Vector3::Zero(), z, geometry::anyOrthogonal(z));
}

/// x shall run as the first row does.
void turnAlongFirstRow(Track& track, Vector2& axis, std::vector<Run>& runs) {
  if (runs.empty() || runs.front().forward) return;
  axis = -axis;
  rotate(track, Vector2(-1.0, 0.0));
  for (Run& run : runs) run = makeRun(track, run.begin, run.end, !run.forward);
}

/// Sorts the runs by y and numbers the rows; returns their pitch. `window`: runs overlap when by more than that.
double orderRows(const Track& track, std::vector<Run>& runs, double window) {
  std::sort(runs.begin(), runs.end(),
            [](const Run& a, const Run& b) { return a.y != b.y ? a.y < b.y : a.begin < b.begin; });
  const double pitch = medianPitch(runs, window);
  if (numberRows(runs, pitch, window) < 2) {
    throw InputError("scan cloud", "number of scan rows", "1", "at least 2");
  }
  checkOrder(track, runs, window);
  return pitch;
}

/// What lies between runs, which are in measured order.
std::vector<Stretch> stretchesBetween(const std::vector<Run>& runs, std::size_t samples) {
  std::vector<Stretch> between;
  std::size_t from = 0;
  for (const Run& run : runs) {
    if (run.begin > from) between.push_back({from, run.begin});
    from = std::max(from, run.end);
  }
  if (samples > from) between.push_back({from, samples});
  return between;
}

/// Samples of stretches that are no turns from row to row: at least half as many as on a row, over several rows.
std::size_t crossingSamples(const Track& track, const std::vector<Stretch>& between, double samples_on_row,
                            double pitch) {
  constexpr double several = 5.0;
  std::size_t crossing = 0;
  for (const Stretch& stretch : between) {
    const auto first = track.y.begin() + static_cast<std::ptrdiff_t>(stretch.begin);
    const auto last = track.y.begin() + static_cast<std::ptrdiff_t>(stretch.end);
    const auto [low, high] = std::minmax_element(first, last);
    const std::size_t samples = stretch.end - stretch.begin;
    if (*high - *low > several * pitch && static_cast<double>(samples) > 0.5 * samples_on_row) crossing += samples;
  }
  return crossing;
}

/// The beam frame turned about z so that `axis` becomes x, and moved to `origin`, given in the turned axes.
Frame scanFrame(const Frame& T_cloud_beam, const Vector2& axis, const Vector3& origin) {
  Frame T_beam_scan = Frame::Identity();
  T_beam_scan.linear() << axis.x(), -axis.y(), 0.0, axis.y(), axis.x(), 0.0, 0.0, 0.0, 1.0;
  T_beam_scan.translation() = T_beam_scan.linear() * origin;
  return T_cloud_beam * T_beam_scan;
}

}  // namespace

SampleRows findRows(const ScanCloud& cloud, const Vector3& mean_beam, const RowOptions& options) {
  validate(options, "rows");
  SampleRows rows;
  rows.samples_in = cloud.size();
  const Frame T_cloud_beam = beamFrame(mean_beam);
  const bool lines_given = hasLines(cloud);
  Track track = makeTrack(cloud, T_cloud_beam.inverse(), lines_given, rows.dropped);

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
  turnAlongFirstRow(track, axis, runs);
  const std::vector<Stretch> between = stretchesBetween(runs, track.size());
  rows.pitch = orderRows(track, runs, window);

  const Vector3 origin = middle(track);
  rows.T_cloud_scan = geometry::snapped(scanFrame(T_cloud_beam, axis, origin));
  rows.pieces = makePieces(track, runs, origin);
  const std::size_t on_rows = sampleCount(rows);
  const double samples_on_row = static_cast<double>(on_rows) / static_cast<double>(runs.size());
  const std::size_t crossing = crossingSamples(track, between, samples_on_row, rows.pitch);
  addDropped(rows.dropped, "turn", track.size() - on_rows - crossing);
  addDropped(rows.dropped, "across the rows", crossing);
  return rows;
}

}  // namespace scan_to_path::scan
