// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scan_to_path/nurbs/curve_fit.h"

namespace scan_to_path::nurbs {

/// A line's samples in rising order of u: the caller's own arrays when they rise already, else sorted copies.
class SortedSamples {
public:
  /// Throws InputError when there are no samples or a parameter is not finite.
  explicit SortedSamples(const LineSamples& samples);

  const LineSamples& view() const { return view_; }

  /// Largest step of the parameter.
  double largestGap() const;

  /// Throws InputError naming the first number that is not finite.
  static void checkFinite(const LineSamples& samples);

private:
  void sort(const LineSamples& samples);

  LineSamples view_;
  std::vector<double> storage_;
};

}  // namespace scan_to_path::nurbs
