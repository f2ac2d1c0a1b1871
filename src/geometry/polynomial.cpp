// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "polynomial.h"

#include <cmath>
#include <cstddef>

namespace scan_to_path::geometry {
namespace {

double evaluate(const Polynomial& p, double x) {
  double value = 0.0;
  for (std::size_t i = p.size(); i-- > 0;) value = value * x + p[i];
  return value;
}

Polynomial derivative(const Polynomial& p) {
  Polynomial d;
  for (std::size_t i = 1; i < p.size(); ++i) d.push_back(static_cast<double>(i) * p[i]);
  return d;
}

/// The root in [low, high], where p changes sign once.
double bracketedRoot(const Polynomial& p, const Polynomial& slope, double low, double high) {
  const bool is_rising = evaluate(p, low) < 0.0;
  double x = 0.5 * (low + high);
  constexpr int most_iterations = 200;  // bisection alone needs about 60 to the last bit
  for (int i = 0; i < most_iterations; ++i) {
    const double value = evaluate(p, x);
    ((value < 0.0) == is_rising ? low : high) = x;
    const double newton = x - value / evaluate(slope, x);
    const double next = newton > low && newton < high ? newton : 0.5 * (low + high);
    if (next == x || !(high - low > 0.0)) return x;
    if (std::abs(next - x) <= 1e-16 * std::abs(x)) return next;
    x = next;
  }
  return x;
}

}  // namespace

std::vector<double> realRoots(const Polynomial& p, double low, double high) {
  if (!(low <= high) || p.size() < 2) return {};
  const Polynomial slope = derivative(p);
  std::vector<double> edges = realRoots(slope, low, high);
  edges.insert(edges.begin(), low);
  edges.push_back(high);
  std::vector<double> roots;
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    if ((evaluate(p, edges[i]) < 0.0) == (evaluate(p, edges[i + 1]) < 0.0)) continue;
    roots.push_back(bracketedRoot(p, slope, edges[i], edges[i + 1]));
  }
  return roots;
}

}  // namespace scan_to_path::geometry
