// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "sorted_samples.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "scan_to_path/common/error.h"

namespace scan_to_path::nurbs {

SortedSamples::SortedSamples(const LineSamples& samples) : view_(samples) {
  if (samples.count == 0) throw InputError("curve fit", "number of samples", "0", "at least 1");
  std::size_t i = 1;
  while (i < samples.count && samples.u[i] >= samples.u[i - 1]) ++i;
  if (i < samples.count) sort(samples);
  if (!std::isfinite(view_.u[0]) || !std::isfinite(view_.u[view_.count - 1])) checkFinite(samples);
}

double SortedSamples::largestGap() const {
  double gap = 0.0;
  for (std::size_t i = 1; i < view_.count; ++i) gap = std::max(gap, view_.u[i] - view_.u[i - 1]);
  return gap;
}

void SortedSamples::checkFinite(const LineSamples& samples) {
  const char* const names[] = {"u", "x", "y", "z"};
  const double* const arrays[] = {samples.u, samples.x, samples.y, samples.z};
  for (std::size_t i = 0; i < samples.count; ++i) {
    for (std::size_t a = 0; a < 4; ++a) {
      if (!std::isfinite(arrays[a][i])) {
        throw InputError("curve fit", std::string(names[a]) + " of sample " + std::to_string(i),
                         std::to_string(arrays[a][i]), "finite");
      }
    }
  }
}

void SortedSamples::sort(const LineSamples& samples) {
  checkFinite(samples);
  std::vector<std::size_t> order(samples.count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return samples.u[a] < samples.u[b]; });
  storage_.reserve(4 * samples.count);
  for (const double* array : {samples.u, samples.x, samples.y, samples.z}) {
    for (const std::size_t i : order) storage_.push_back(array[i]);
  }
  const double* start = storage_.data();
  const std::size_t n = samples.count;
  view_ = {start, start + n, start + 2 * n, start + 3 * n, n};
}

}  // namespace scan_to_path::nurbs
