// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "../src/nurbs/spline_equations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../src/nurbs/span_layout.h"
#include "support/dense_spline_fit.h"
#include "support/spline_lines.h"

namespace scan_to_path::nurbs {
namespace {

using test::SampledLine;

/// Spans of one unit from 0 on; `empty` gets no samples.
struct Problem {
  std::vector<int> ends;
  SampledLine line;

  Problem(int spans, int empty, Random& random) {
    for (int i = 0; i <= spans; ++i) ends.push_back(i);
    for (int span = 0; span < spans; ++span) {
      for (int i = 0; i < 12 && span != empty; ++i) {
        const double u = span + (i + 0.8 * random.uniform()) / 12.0;
        line.add(u, 1.0 + u, std::cos(u), std::sin(u) + 1e-3 * random.gaussian());
      }
    }
  }

  int spans() const { return static_cast<int>(ends.size()) - 1; }
  std::vector<double> knots() const { return cubicKnots(ends, spans(), 0.0, spans()); }

  SplineEquations equations() const {
    SplineEquations equations(ends.size() + 2, Lanes(1.0, 0.5, 0.1, 0.0));
    for (int span = 0; span < spans(); ++span) {
      const auto begin = std::lower_bound(line.u.begin(), line.u.end(), span) - line.u.begin();
      const auto end = std::lower_bound(line.u.begin(), line.u.end(), span + 1) - line.u.begin();
      const CubicMoments moments =
          accumulate(line.view(), static_cast<std::size_t>(begin), static_cast<std::size_t>(end), span + 0.5, 2.0);
      equations.add(static_cast<std::size_t>(span), moments, spanMatrix(ends, span));
    }
    return equations;
  }
};

TEST(SplineEquations, SolutionAndResidualAreThoseOfTheCollocationMatrix) {
  Random random(1);
  for (int spans = 1; spans <= 20; ++spans) {
    const Problem problem(spans, -1, random);
    SplineEquations equations = problem.equations();
    ASSERT_TRUE(equations.solve()) << spans;
    const auto oracle = test::denseSplineFit(problem.line.view(), problem.knots());
    const auto points = equations.controlPoints();
    ASSERT_EQ(points.size(), static_cast<std::size_t>(spans + 3));
    // Coordinates of about 20 times 1e-16 times the condition of the normal equations, 1e4.
    for (int i = 0; i < spans + 3; ++i) {
      const geometry::Vector3 expected = oracle.control_points.row(i).transpose();
      EXPECT_LT((points[static_cast<std::size_t>(i)] - expected).norm(), 2e-11);
    }
    EXPECT_NEAR(equations.rss(), oracle.rss, 1e-7 * oracle.rss);
  }
}

TEST(SplineEquations, AGapAsWideAsABasisFunctionDeterminesNothing) {
  Random random(2);
  const Problem one_empty(8, 3, random);
  EXPECT_TRUE(one_empty.equations().solve()) << "every basis function still has samples";
  Problem wide(12, -1, random);
  SampledLine& line = wide.line;
  for (auto* values : {&line.x, &line.y, &line.z, &line.u}) {  // u last: it says which go
    std::vector<double> kept;
    for (std::size_t i = 0; i < line.u.size(); ++i) {
      if (line.u[i] < 4.0 || line.u[i] >= 8.0) kept.push_back((*values)[i]);
    }
    *values = std::move(kept);
  }
  EXPECT_FALSE(wide.equations().solve()) << "four empty spans leave one basis function without samples";
}

}  // namespace
}  // namespace scan_to_path::nurbs
