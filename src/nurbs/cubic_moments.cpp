// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "cubic_moments.h"

#include <vector>

namespace scan_to_path::nurbs {

LocalMap::LocalMap(double alpha, double delta) : c{} {
  c[0][0] = 1.0;
  for (int k = 1; k < 7; ++k) {
    for (int j = 0; j <= k; ++j) c[k][j] = delta * c[k - 1][j] + (j > 0 ? alpha * c[k - 1][j - 1] : 0.0);
  }
}

const LocalMap& blockMap(int blocks, int index) {
  static const std::vector<LocalMap> maps = [] {
    std::vector<LocalMap> table;
    for (int m = 1; m <= max_blocks; ++m) {
      for (int b = 0; b < max_blocks; ++b) table.emplace_back(1.0 / m, (2.0 * b + 1.0 - m) / m);
    }
    return table;
  }();
  return maps[static_cast<std::size_t>((blocks - 1) * max_blocks + index)];
}

CubicMoments accumulate(const LineSamples& samples, std::size_t begin, std::size_t end, double centre,
                        double inverse_half) {
  CubicMoments moments;
  if (begin == end) return moments;
  const Lanes reference(samples.x[begin], samples.y[begin], samples.z[begin], 0.0);
  Lanes y0;
  Lanes y1;
  Lanes y2;
  Lanes y3;
  Lanes squares;
  Lanes high;
  for (std::size_t i = begin; i < end; ++i) {
    const double s = (samples.u[i] - centre) * inverse_half;
    const double s2 = s * s;
    const double s3 = s2 * s;
    const Lanes q = Lanes(samples.x[i], samples.y[i], samples.z[i], 1.0) - reference;
    y0 += q;
    y1 += s * q;
    y2 += s2 * q;
    y3 += s3 * q;
    squares += q * q;
    high += s3 * Lanes(1.0, s, s2, s3);
  }
  moments.y[0] = y0;
  moments.y[1] = y1;
  moments.y[2] = y2;
  moments.y[3] = y3;
  moments.squares = squares;
  moments.high = high;
  moments.reference = reference;
  return moments;
}

void addMapped(CubicMoments& whole, const CubicMoments& part, const LocalMap& map) {
  if (part.count() == 0.0) return;
  const auto& c = map.c;
  const Lanes shift = part.reference - whole.reference;
  const Lanes m0 = part.y[0];
  const Lanes m1 = c[1][0] * part.y[0] + c[1][1] * part.y[1];
  const Lanes m2 = c[2][0] * part.y[0] + c[2][1] * part.y[1] + c[2][2] * part.y[2];
  const Lanes m3 = c[3][0] * part.y[0] + c[3][1] * part.y[1] + c[3][2] * part.y[2] + c[3][3] * part.y[3];
  const double powers[7] = {part.y[0][3], part.y[1][3], part.y[2][3], part.high[0],
                            part.high[1], part.high[2], part.high[3]};
  double high[4] = {m3[3], 0.0, 0.0, 0.0};
  for (int k = 4; k < 7; ++k) {
    for (int j = 0; j <= k; ++j) high[k - 3] += c[k][j] * powers[j];
  }
  whole.squares += part.squares + shift * (2.0 * part.y[0] + shift * Lanes(part.count()));
  whole.y[0] += m0 + m0[3] * shift;
  whole.y[1] += m1 + m1[3] * shift;
  whole.y[2] += m2 + m2[3] * shift;
  whole.y[3] += m3 + m3[3] * shift;
  whole.high += Lanes::load(high);
}

CubicResidual::CubicResidual(const CubicMoments& moments) : reference(moments.reference) {
  // A pivot this far below its diagonal element is rounding: the samples do not determine that coefficient.
  constexpr double tolerance = 1e-12;
  const double S[7] = {moments.y[0][3], moments.y[1][3], moments.y[2][3], moments.high[0],
                       moments.high[1], moments.high[2], moments.high[3]};
  const auto kept = [](double pivot, double diagonal) { return pivot > tolerance * diagonal ? pivot : 0.0; };
  const auto inverse = [](double pivot) { return pivot > 0.0 ? 1.0 / pivot : 0.0; };
  d[0] = S[0];
  const double i0 = inverse(d[0]);
  l10 = S[1] * i0;
  l20 = S[2] * i0;
  l30 = S[3] * i0;
  d[1] = kept(S[2] - l10 * S[1], S[2]);
  const double i1 = inverse(d[1]);
  const double w21 = S[3] - l10 * S[2];
  const double w31 = S[4] - l10 * S[3];
  l21 = w21 * i1;
  l31 = w31 * i1;
  d[2] = kept(S[4] - l20 * S[2] - l21 * w21, S[4]);
  const double i2 = inverse(d[2]);
  const double w32 = S[5] - l20 * S[3] - l21 * w31;
  l32 = w32 * i2;
  d[3] = kept(S[6] - l30 * S[3] - l31 * w31 - l32 * w32, S[6]);
  const double i3 = inverse(d[3]);
  const Lanes y0 = moments.y[0];
  const Lanes y1 = moments.y[1] - l10 * y0;
  const Lanes y2 = moments.y[2] - l20 * y0 - l21 * y1;
  const Lanes y3 = moments.y[3] - l30 * y0 - l31 * y1 - l32 * y2;
  z[0] = i0 * y0;
  z[1] = i1 * y1;
  z[2] = i2 * y2;
  z[3] = i3 * y3;
  rest = moments.squares - y0 * z[0] - y1 * z[1] - y2 * z[2] - y3 * z[3];
  // A sum of squares that rounding has taken below zero.
  rest.low = rest.low > Lanes::Pair{} ? rest.low : Lanes::Pair{};
  rest.high = rest.high > Lanes::Pair{} ? rest.high : Lanes::Pair{};
}

Lanes CubicResidual::of(const Lanes a[4], const Lanes& origin) const {
  const Lanes r3 = a[3] - z[3];
  const Lanes r2 = a[2] + l32 * a[3] - z[2];
  const Lanes r1 = a[1] + l21 * a[2] + l31 * a[3] - z[1];
  const Lanes r0 = (a[0] + (origin - reference)) + l10 * a[1] + l20 * a[2] + l30 * a[3] - z[0];
  return rest + d[0] * (r0 * r0) + d[1] * (r1 * r1) + d[2] * (r2 * r2) + d[3] * (r3 * r3);
}

void addNormalEquations(const CubicMoments& span, const CubicSpanMatrix& basis, double* band, double* rhs) {
  const double S[7] = {span.y[0][3], span.y[1][3], span.y[2][3], span.high[0], span.high[1], span.high[2], span.high[3]};
  const Lanes M[4] = {Lanes::load(basis[0].data()), Lanes::load(basis[1].data()), Lanes::load(basis[2].data()),
                      Lanes::load(basis[3].data())};
  Lanes GM[4];  // Gram matrix of the monomials times M
  for (std::size_t k = 0; k < 4; ++k) {
    GM[k] = S[k] * M[0] + S[k + 1] * M[1] + S[k + 2] * M[2] + S[k + 3] * M[3];
  }
  for (std::size_t r = 0; r < 4; ++r) {
    double row[4];
    (basis[0][r] * GM[0] + basis[1][r] * GM[1] + basis[2][r] * GM[2] + basis[3][r] * GM[3]).store(row);
    for (std::size_t c = 0; c <= r; ++c) band[r * 4 + c + 3 - r] += row[c];
    const Lanes right =
        basis[0][r] * span.y[0] + basis[1][r] * span.y[1] + basis[2][r] * span.y[2] + basis[3][r] * span.y[3];
    (Lanes::load(rhs + 4 * r) + right).store(rhs + 4 * r);
  }
}

}  // namespace scan_to_path::nurbs
