// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/nurbs/curve_fit.h"

#include <cmath>
#include <string>

#include "cubic.h"
#include "scan_to_path/common/error.h"
#include "scan_to_path/nurbs/knot_vector.h"
#include "sorted_samples.h"
#include "spline_equations.h"

namespace scan_to_path::nurbs {
namespace {

void checkInside(const LineSamples& samples, const std::vector<double>& knots) {
  for (const double u : {samples.u[0], samples.u[samples.count - 1]}) {
    if (u < knots.front() || u > knots.back()) {
      throw InputError("curve fit", "parameter of a sample", std::to_string(u),
                       "in [" + std::to_string(knots.front()) + ", " + std::to_string(knots.back()) + "]");
    }
  }
}

/// Calls visit(span, begin, end) for every span that is not empty with its samples' range.
template <class Visitor>
void forEachSpan(const LineSamples& samples, const std::vector<double>& knots, Visitor&& visit) {
  std::size_t begin = 0;
  const std::size_t last_span = knots.size() - degree - 2;
  for (std::size_t span = degree; span <= last_span; ++span) {
    if (!(knots[span] < knots[span + 1])) continue;
    std::size_t end = span == last_span ? samples.count : begin;
    while (end < samples.count && samples.u[end] < knots[span + 1]) ++end;
    visit(span, begin, end);
    begin = end;
  }
}

}  // namespace

CurveFit leastSquaresCurve(const LineSamples& line, const std::vector<double>& knots) {
  validateKnots(knots, degree, knots.size() < degree + 1 ? 0 : knots.size() - degree - 1, "curve fit");
  const SortedSamples sorted(line);
  const LineSamples& samples = sorted.view();
  checkInside(samples, knots);
  const Lanes origin(samples.x[0], samples.y[0], samples.z[0], 0.0);
  const std::size_t count = knots.size() - degree - 1;
  SplineEquations equations(count, origin);
  forEachSpan(samples, knots, [&](std::size_t span, std::size_t begin, std::size_t end) {
    const double half = 0.5 * (knots[span + 1] - knots[span]);
    equations.add(span - degree, accumulate(samples, begin, end, knots[span] + half, 1.0 / half),
                  cubicSpanMatrix(&knots[span - 2]));
  });
  CurveFit fit;
  fit.samples = samples.count;
  fit.largest_gap = sorted.largestGap();
  if (samples.count < count || !equations.solve()) {
    SortedSamples::checkFinite(line);
    return fit;
  }
  const double rss = equations.rss();
  if (!std::isfinite(rss)) SortedSamples::checkFinite(line);
  fit.fitted = true;
  fit.curve.knots = knots;
  fit.curve.control_points = equations.controlPoints();
  fit.rms = std::sqrt(rss / static_cast<double>(samples.count));
  fit.sigma = samples.count > count ? std::sqrt(rss / static_cast<double>(samples.count - count)) : 0.0;
  return fit;
}

}  // namespace scan_to_path::nurbs
