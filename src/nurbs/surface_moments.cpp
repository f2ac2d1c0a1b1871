// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "surface_moments.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "scan_to_path/common/error.h"

namespace scan_to_path::nurbs {
namespace {

/// Powers 0 … 6 of s' = alpha s + delta by powers of s.
struct PowerMap {
  double c[7][7] = {{1.0}};
  Lanes low[7];   // low[j]: coefficients of s^j in the powers 0 … 3
  Lanes high[7];  // and in the powers 4 … 6

  PowerMap(double alpha, double delta) {
    for (int k = 1; k < 7; ++k) {
      for (int j = 0; j <= k; ++j) c[k][j] = delta * c[k - 1][j] + (j > 0 ? alpha * c[k - 1][j - 1] : 0.0);
    }
    for (int j = 0; j < 7; ++j) {
      low[j] = Lanes(c[0][j], c[1][j], c[2][j], c[3][j]);
      high[j] = Lanes(c[4][j], c[5][j], c[6][j], 0.0);
    }
  }
};

/// From block `index` of `blocks` equal blocks to the whole.
PowerMap blockMap(int blocks, int index) { return {1.0 / blocks, (2.0 * index + 1.0 - blocks) / blocks}; }

void addMappedU(BicubicMoments& whole, const BicubicMoments& part, const PowerMap& map) {
  for (std::size_t l = 0; l < 7; ++l) {
    const Lanes a = part.low[l];
    const Lanes b = part.high[l];
    whole.low[l] += a[0] * map.low[0] + a[1] * map.low[1] + a[2] * map.low[2] + a[3] * map.low[3];
    whole.high[l] += a[0] * map.high[0] + a[1] * map.high[1] + a[2] * map.high[2] + a[3] * map.high[3] +
                     b[0] * map.high[4] + b[1] * map.high[5] + b[2] * map.high[6];
  }
  for (std::size_t l = 0; l < 4; ++l) {
    const Lanes w = part.heights[l];
    whole.heights[l] += w[0] * map.low[0] + w[1] * map.low[1] + w[2] * map.low[2] + w[3] * map.low[3];
  }
}

void addMappedV(BicubicMoments& whole, const BicubicMoments& part, const PowerMap& map) {
  for (std::size_t k = 0; k < 7; ++k) {
    for (std::size_t l = 0; l <= k; ++l) {
      whole.low[k] += map.c[k][l] * part.low[l];
      whole.high[k] += map.c[k][l] * part.high[l];
      if (k < 4) whole.heights[k] += map.c[k][l] * part.heights[l];
    }
  }
}

void checkFinite(const std::vector<HeightSamples>& lines) {
  const char* const names[] = {"u", "v", "w"};
  for (std::size_t l = 0; l < lines.size(); ++l) {
    const double* const arrays[] = {lines[l].u, lines[l].v, lines[l].w};
    for (std::size_t i = 0; i < lines[l].count; ++i) {
      for (std::size_t a = 0; a < 3; ++a) {
        if (std::isfinite(arrays[a][i])) continue;
        throw InputError("surface fit",
                         std::string(names[a]) + " of sample " + std::to_string(i) + " of line " + std::to_string(l),
                         std::to_string(arrays[a][i]), "finite");
      }
    }
  }
}

void findBounds(const std::vector<HeightSamples>& lines, HeightMoments& moments) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  moments.first_u = moments.first_v = infinity;
  moments.last_u = moments.last_v = -infinity;
  double sum = 0.0;
  for (const HeightSamples& line : lines) {
    for (std::size_t i = 0; i < line.count; ++i) {
      moments.first_u = std::min(moments.first_u, line.u[i]);
      moments.last_u = std::max(moments.last_u, line.u[i]);
      moments.first_v = std::min(moments.first_v, line.v[i]);
      moments.last_v = std::max(moments.last_v, line.v[i]);
      sum += line.u[i] + line.v[i] + line.w[i];  // minima and maxima pass over NaN, a sum does not
    }
    if (line.count > 0 && moments.samples == 0.0) moments.reference = line.w[0];
    moments.samples += static_cast<double>(line.count);
  }
  if (moments.samples == 0.0) throw InputError("surface fit", "number of samples", "0", "at least 1");
  if (!std::isfinite(sum)) checkFinite(lines);
  if (!(moments.first_u < moments.last_u)) throw InputError("surface fit", "range of u", "0", "above 0");
  if (!(moments.first_v < moments.last_v)) throw InputError("surface fit", "range of v", "0", "above 0");
}

/// One direction of the grid.
struct GridAxis {
  double first;
  double cells_per_unit;
  double largest;

  GridAxis(double first_parameter, double last_parameter, std::size_t cells)
      : first(first_parameter),
        cells_per_unit(static_cast<double>(cells) / (last_parameter - first_parameter)),
        largest(static_cast<double>(cells - 1)) {}

  /// Cell of the parameter; `local` becomes its place in [-1, 1].
  std::size_t find(double parameter, double& local) const {
    const double place = (parameter - first) * cells_per_unit;
    const auto cell = static_cast<std::size_t>(std::min(place, largest));
    local = 2.0 * (place - static_cast<double>(cell)) - 1.0;
    return cell;
  }
};

inline void addSample(BicubicMoments& cell, double s, double t, double w) {
  const double s2 = s * s;
  const Lanes a(1.0, s, s2, s2 * s);
  const Lanes b = (s2 * s2) * a;
  double power = 1.0;
  for (std::size_t l = 0; l < 7; ++l) {
    cell.low[l] += power * a;
    cell.high[l] += power * b;
    if (l < 4) cell.heights[l] += (w * power) * a;
    power *= t;
  }
}

template <class AddMapped, class Cell>
void mergeRow(const std::vector<int>& ends, std::size_t span, const AddMapped& add, const Cell& cell,
              std::size_t row_count) {
  const int begin = ends[span];
  const int blocks = ends[span + 1] - begin;
  for (int b = 0; b < blocks; ++b) {
    const PowerMap map = blockMap(blocks, b);
    for (std::size_t r = 0; r < row_count; ++r) add(r, cell(static_cast<std::size_t>(begin + b), r), map);
  }
}

/// basis^T H basis for the Hankel matrix H(k, l) = h[k + l].
void sandwich(const double* h, const CubicSpanMatrix& basis, Lanes result[4]) {
  Lanes product[4];
  for (std::size_t k = 0; k < 4; ++k) {
    product[k] = h[k] * Lanes::load(basis[0].data()) + h[k + 1] * Lanes::load(basis[1].data()) +
                 h[k + 2] * Lanes::load(basis[2].data()) + h[k + 3] * Lanes::load(basis[3].data());
  }
  for (std::size_t i = 0; i < 4; ++i) {
    result[i] =
        basis[0][i] * product[0] + basis[1][i] * product[1] + basis[2][i] * product[2] + basis[3][i] * product[3];
  }
}

void addRightHandSide(const BicubicMoments& patch, const CubicSpanMatrix& basis_u, const CubicSpanMatrix& basis_v,
                      std::size_t first, std::size_t stride_u, std::size_t stride_v, std::vector<double>& rhs) {
  for (std::size_t j = 0; j < 4; ++j) {
    const Lanes powers = basis_v[0][j] * patch.heights[0] + basis_v[1][j] * patch.heights[1] +
                         basis_v[2][j] * patch.heights[2] + basis_v[3][j] * patch.heights[3];
    for (std::size_t i = 0; i < 4; ++i) {
      const Lanes column(basis_u[0][i], basis_u[1][i], basis_u[2][i], basis_u[3][i]);
      rhs[first + i * stride_u + j * stride_v] += (column * powers).sum();
    }
  }
}

}  // namespace

HeightMoments accumulateHeights(const std::vector<HeightSamples>& lines, std::size_t cells_u, std::size_t cells_v) {
  HeightMoments moments;
  findBounds(lines, moments);
  moments.grid = {cells_u, cells_v, std::vector<BicubicMoments>(cells_u * cells_v)};
  const GridAxis axis_u(moments.first_u, moments.last_u, cells_u);
  const GridAxis axis_v(moments.first_v, moments.last_v, cells_v);
  for (const HeightSamples& line : lines) {
    double squares = 0.0;
    for (std::size_t i = 0; i < line.count; ++i) {
      double s = 0.0;
      double t = 0.0;
      const std::size_t cell_u = axis_u.find(line.u[i], s);
      const std::size_t cell_v = axis_v.find(line.v[i], t);
      const double w = line.w[i] - moments.reference;
      squares += w * w;
      addSample(moments.grid.at(cell_u, cell_v), s, t, w);
    }
    moments.squares += squares;
  }
  return moments;
}

MomentGrid mergeU(const MomentGrid& grid, const std::vector<int>& ends) {
  MomentGrid merged{ends.size() - 1, grid.cells_v, {}};
  merged.cells.resize(merged.cells_u * merged.cells_v);
  for (std::size_t i = 0; i < merged.cells_u; ++i) {
    mergeRow(
        ends, i,
        [&](std::size_t j, const BicubicMoments& part, const PowerMap& map) {
          if (part.count() > 0.0) addMappedU(merged.at(i, j), part, map);
        },
        [&](std::size_t block, std::size_t j) -> const BicubicMoments& { return grid.at(block, j); }, grid.cells_v);
  }
  return merged;
}

MomentGrid mergeV(const MomentGrid& grid, const std::vector<int>& ends) {
  MomentGrid merged{grid.cells_u, ends.size() - 1, {}};
  merged.cells.resize(merged.cells_u * merged.cells_v);
  for (std::size_t j = 0; j < merged.cells_v; ++j) {
    mergeRow(
        ends, j,
        [&](std::size_t i, const BicubicMoments& part, const PowerMap& map) {
          if (part.count() > 0.0) addMappedV(merged.at(i, j), part, map);
        },
        [&](std::size_t block, std::size_t i) -> const BicubicMoments& { return grid.at(i, block); }, grid.cells_u);
  }
  return merged;
}

void addPatch(const BicubicMoments& patch, const CubicSpanMatrix& basis_u, const CubicSpanMatrix& basis_v,
              std::size_t first, std::size_t stride_u, std::size_t stride_v, BandedMatrix& A,
              std::vector<double>& rhs) {
  Lanes in_u[7][4];  // [l][i]: sums of t^l times products of basis functions in u
  for (std::size_t l = 0; l < 7; ++l) {
    double powers[8];
    patch.low[l].store(powers);
    patch.high[l].store(powers + 4);
    sandwich(powers, basis_u, in_u[l]);
  }
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      double h[7];
      for (std::size_t l = 0; l < 7; ++l) h[l] = in_u[l][i][k];
      Lanes in_v[4];
      sandwich(h, basis_v, in_v);
      for (std::size_t j = 0; j < 4; ++j) {
        for (std::size_t l = 0; l < 4; ++l) {
          const std::size_t row = first + i * stride_u + j * stride_v;
          const std::size_t column = first + k * stride_u + l * stride_v;
          if (column <= row) A.at(row, column) += in_v[j][l];
        }
      }
    }
  }
  addRightHandSide(patch, basis_u, basis_v, first, stride_u, stride_v, rhs);
}

}  // namespace scan_to_path::nurbs
