// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstring>

namespace scan_to_path::nurbs {

/// Four numbers worked on side by side. The order of operations is written out by the program, not left to the
/// compiler's vectoriser, so results are the same bits whatever vector width the processor has.
struct Lanes {
  typedef double Pair __attribute__((vector_size(16)));
  Pair low;
  Pair high;

  Lanes() : low{0.0, 0.0}, high{0.0, 0.0} {}
  explicit Lanes(double value) : low{value, value}, high{value, value} {}
  Lanes(double a, double b, double c, double d) : low{a, b}, high{c, d} {}
  Lanes(Pair first, Pair second) : low(first), high(second) {}

  static Lanes load(const double* p) {
    Lanes lanes;
    std::memcpy(&lanes.low, p, sizeof(Pair));
    std::memcpy(&lanes.high, p + 2, sizeof(Pair));
    return lanes;
  }
  void store(double* p) const {
    std::memcpy(p, &low, sizeof(Pair));
    std::memcpy(p + 2, &high, sizeof(Pair));
  }
  double operator[](std::size_t i) const { return i < 2 ? low[i] : high[i - 2]; }
  double sum() const { return (low[0] + low[1]) + (high[0] + high[1]); }

  Lanes& operator+=(const Lanes& o) {
    low += o.low;
    high += o.high;
    return *this;
  }
};

inline Lanes operator+(const Lanes& a, const Lanes& b) { return {a.low + b.low, a.high + b.high}; }
inline Lanes operator-(const Lanes& a, const Lanes& b) { return {a.low - b.low, a.high - b.high}; }
inline Lanes operator*(const Lanes& a, const Lanes& b) { return {a.low * b.low, a.high * b.high}; }
inline Lanes operator*(double a, const Lanes& b) { return Lanes(a) * b; }

}  // namespace scan_to_path::nurbs
