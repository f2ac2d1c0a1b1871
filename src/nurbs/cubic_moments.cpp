// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "cubic_moments.h"

#include <algorithm>

namespace scan_to_path::nurbs {

LocalMap::LocalMap(double alpha, double delta) : c{} {
  double all[7][7] = {{1.0}};
  for (int k = 1; k < 7; ++k) {
    for (int j = 0; j <= k; ++j) all[k][j] = delta * all[k - 1][j] + (j > 0 ? alpha * all[k - 1][j - 1] : 0.0);
  }
  for (int j = 0; j < 7; ++j) high[j] = Lanes(all[3][j], all[4][j], all[5][j], all[6][j]);
  for (int k = 0; k < 4; ++k) std::copy(all[k], all[k] + 4, c[k]);
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
  whole.squares += part.squares + shift * (2.0 * part.y[0] + shift * Lanes(part.count()));
  whole.y[0] += m0 + m0[3] * shift;
  whole.y[1] += m1 + m1[3] * shift;
  whole.y[2] += m2 + m2[3] * shift;
  whole.y[3] += m3 + m3[3] * shift;
  whole.high += part.y[0][3] * map.high[0] + part.y[1][3] * map.high[1] + part.y[2][3] * map.high[2] +
                part.high[0] * map.high[3] + part.high[1] * map.high[4] + part.high[2] * map.high[5] +
                part.high[3] * map.high[6];
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

}  // namespace scan_to_path::nurbs
