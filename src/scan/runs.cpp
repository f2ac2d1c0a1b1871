// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "runs.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "scan_to_path/common/error.h"

namespace scan_to_path::scan {
namespace {

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

}  // namespace

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

}  // namespace scan_to_path::scan
