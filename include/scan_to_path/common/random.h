// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace scan_to_path {

/// Seeded generator whose numbers are the same on every machine and library (xoshiro256++ seeded by SplitMix64;
/// Blackman and Vigna 2019). Streams of one seed are independent: give each error source its own.
class Random {
public:
  explicit Random(std::uint64_t seed, std::uint64_t stream = 0);

  std::uint64_t bits();
  /// Uniform in [0, 1).
  double uniform();
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Standard normal (Marsaglia's polar method).
  double gaussian();

private:
  std::uint64_t state_[4];
  double spare_ = 0.0;
  bool has_spare_ = false;
};

}  // namespace scan_to_path
