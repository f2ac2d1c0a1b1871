// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "scan_to_path/pipeline/left_out.h"

namespace scan_to_path::pipeline {

/// The contacts of a whole path that are left out so far, and how far each row end that fails goes back next.
class RowCuts {
public:
  /// A row's end whose lead or link fails goes back by `first_retreat` [m] first, then by twice as much each time.
  explicit RowCuts(double first_retreat) : first_retreat_(first_retreat) {}

  /// Leaves out the contacts of a path made of the whole one that fail; returns how many there are.
  std::size_t cutContacts(const process::PlannedPath& planned, const std::vector<toolpath::WaypointVerdict>& verdicts);

  /// Shortens the rows to or from which the way fails, each at that end; false when there is nothing to shorten.
  bool cutRowEnds(const process::PlannedPath& planned, const std::vector<toolpath::WaypointVerdict>& verdicts);

  const Causes& causes() const { return causes_; }
  std::set<toolpath::WaypointIndex> places() const;

private:
  /// A row's end: its last contact, in the whole path, and whether it is the row's start.
  using RowEnd = std::pair<toolpath::WaypointIndex, bool>;

  /// The row's contacts in `planned`, by their places in the whole path, from the end on.
  void shorten(const process::PlannedPath& planned, int segment, bool is_start, toolpath::WaypointVerdict verdict);

  double first_retreat_;
  std::map<RowEnd, double> retreats_;  ///< [m], of ends that went back before
  Causes causes_;
};

}  // namespace scan_to_path::pipeline
