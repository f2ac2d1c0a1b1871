// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "row_order.h"

#include <algorithm>
#include <string>
#include <utility>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/median.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path::scan {
namespace {

bool overlap(const Run& a, const Run& b, double margin) {
  return std::min(a.high, b.high) - std::max(a.low, b.low) > margin;
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
                     " mm along them; rows must lie side by side, seen along the beam: where they do, the viewing "
                     "direction is wrong (a cloud's viewpoint or scan.beam, a sample log's cell.sensor)");
  }
}

}  // namespace

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

void checkOrder(const Track& track, const std::vector<Run>& runs, double margin) {
  for (std::size_t i = 0; i < runs.size(); ++i) {
    for (std::size_t j = i + 1; j < runs.size() && runs[j].row <= runs[i].row + 1; ++j) {
      if (runs[j].row == runs[i].row + 1) checkPairOrder(track, runs[i], runs[j], margin);
    }
  }
}

}  // namespace scan_to_path::scan
