// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/toolpath/scallop.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scan_to_path/common/random.h"
#include "scan_to_path/geometry/frames.h"
#include "support/expect_input_error.h"

namespace scan_to_path::toolpath {
namespace {

using test::expectInputError;

/// Step 11's equation as it is printed, in long double: it cancels for flat surfaces.
double printedRowDistance(double h, double r, double kappa) {
  const long double rho = 1.0L / kappa;
  const long double c = ((rho + r) * (rho + r) + (rho + h) * (rho + h) - static_cast<long double>(r) * r) /
                        (2.0L * (rho + r) * (rho + h));
  return static_cast<double>(std::abs(rho) * 2.0L * std::acos(c));
}

/// Height of the point where two circles of radius r meet that touch a circle of radius |rho| at angles +-phi/2.
double circleGeometryHeight(double row_distance, double r, double rho) {
  const double half = 0.5 * row_distance / rho;
  const double across = (rho + r) * std::sin(half);
  const double out = (rho + r) * std::cos(half);
  const double drop = std::sqrt(r * r - across * across);
  // The cusp is the lower meeting point: towards the surface, that is, inwards on both convex and hollow circles.
  return out - drop - rho;
}

TEST(Scallop, GivesFourMillimetresOnAPlaneForTheSeedsBall) {
  EXPECT_NEAR(rowDistance(1e-4, 0.02, 0.0), 3.995e-3, 1e-6);
  EXPECT_DOUBLE_EQ(rowDistance(1e-4, 0.02, 0.0), 2.0 * std::sqrt(2.0 * 0.02 * 1e-4 - 1e-8));
  EXPECT_NEAR(scallopHeight(4e-3, 0.02, 0.0), 0.02 - std::sqrt(0.02 * 0.02 - 0.002 * 0.002), 1e-17);
}

TEST(Scallop, AgreesWithThePrintedEquation) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const double r = random.uniform(1e-3, 0.05);
    const double kappa = (random.bits() % 2 == 0 ? 1.0 : -0.95) * random.uniform(0.01, 1.0) / r;
    const double h = random.uniform(1e-4, 0.9) * std::min(r, largestScallop(r, kappa));
    const double printed = printedRowDistance(h, r, kappa);
    // acos loses half of long double's 19 digits near 1.
    EXPECT_NEAR(rowDistance(h, r, kappa) / printed, 1.0, 1e-8) << h << " " << r << " " << kappa;
  }
}

TEST(Scallop, AgreesWithCirclesOnConvexAndHollowCylinders) {
  for (const double rho : {0.01, 0.05, 0.1, 1.0, -0.05, -0.1, -1.0}) {
    const double L = rowDistance(1e-4, 0.02, 1.0 / rho);
    // Differences of lengths up to |rho| + r rounded at 1e-16.
    EXPECT_NEAR(circleGeometryHeight(L, 0.02, rho), 1e-4, 1e-15) << rho;
  }
}

TEST(Scallop, TheApproximationFromTextbooksOvershoots) {
  // What the exact rule is for: sqrt(8 h r / (1 + kappa r)) leaves up to 7.5 % more than h.
  double worst = 0.0;
  for (double kappa = -40.0; kappa <= 100.0; kappa += 1.0) {
    const double approximate = std::sqrt(8.0 * 1e-4 * 0.02 / (1.0 + kappa * 0.02));
    worst = std::max(worst, scallopHeight(approximate, 0.02, kappa) / 1e-4 - 1.0);
  }
  EXPECT_GT(worst, 0.002);
  EXPECT_LT(worst, 0.075);
}

TEST(Scallop, HeightIsTheInverseOfDistance) {
  Random random(2);
  for (int i = 0; i < 5000; ++i) {
    const double r = std::exp(random.uniform(std::log(1e-3), std::log(0.1)));
    const double kappa = random.uniform(-0.98, 3.0) / r * (random.bits() % 3 == 0 ? 1e-9 : 1.0);
    const double h = random.uniform(1e-6, 0.95) * std::min(r, largestScallop(r, kappa));
    // sqrt(half^2 - b) amplifies rounding where the cusp nears the largest scallop: by 1 / (1 - 0.95).
    EXPECT_NEAR(scallopHeight(rowDistance(h, r, kappa), r, kappa) / h, 1.0, 1e-12) << r << " " << kappa << " " << h;
  }
}

TEST(Scallop, GoesOverIntoThePlaneWithoutAJump) {
  for (double kappa = 1e-2; kappa > 1e-14; kappa *= 0.1) {
    // dL/dkappa is about -L r / 2.
    EXPECT_NEAR(rowDistance(1e-4, 0.02, kappa), rowDistance(1e-4, 0.02, 0.0), 1.1 * kappa * 0.004 * 0.01 + 1e-17);
    EXPECT_NEAR(rowDistance(1e-4, 0.02, -kappa), rowDistance(1e-4, 0.02, 0.0), 1.1 * kappa * 0.004 * 0.01 + 1e-17);
  }
}

TEST(Scallop, GrowsWithDistanceAndCurvature) {
  EXPECT_EQ(scallopHeight(0.0, 0.02, 5.0), 0.0);
  EXPECT_LT(rowDistance(1e-4, 0.02, 10.0), rowDistance(1e-4, 0.02, 0.0));
  EXPECT_GT(rowDistance(1e-4, 0.02, -10.0), rowDistance(1e-4, 0.02, 0.0));
  EXPECT_LT(scallopHeight(0.003, 0.02, 0.0), scallopHeight(0.004, 0.02, 0.0));
}

TEST(Scallop, WithTheSignOfCurvatureTurnedRoundTheCircleCheckFails) {
  for (const double rho : {0.05, 0.1, -0.05, -0.1}) {
    const double L = rowDistance(1e-4, 0.02, -1.0 / rho);
    EXPECT_GT(std::abs(circleGeometryHeight(L, 0.02, rho) - 1e-4), 1e-5) << rho;
  }
}

TEST(Scallop, LargestScallopIsWhereTheBallsPart) {
  EXPECT_DOUBLE_EQ(largestScallop(0.02, 0.0), 0.02);
  const double kappa = 30.0;
  const double h = largestScallop(0.02, kappa);
  EXPECT_NEAR(h, (std::sqrt(1.0 + 2.0 * kappa * 0.02) - 1.0) / kappa, 1e-16);
  const double L = rowDistance(h * (1.0 - 1e-9), 0.02, kappa);
  // At that distance the balls' centres are 2 r apart.
  EXPECT_NEAR(2.0 * (1.0 / kappa + 0.02) * std::sin(0.5 * kappa * L), 0.04, 1e-8);
  expectInputError([&] { scallopHeight(1.001 * L, 0.02, kappa); }, "meet");
}

TEST(Scallop, RejectsWhatHasNoAnswer) {
  expectInputError([] { rowDistance(0.0, 0.02, 0.0); }, "scallop height is 0 m");
  expectInputError([] { rowDistance(0.02, 0.02, 0.0); }, "must be positive and below 0.02 m");
  expectInputError([] { rowDistance(1e-4, -0.02, 0.0); }, "ball radius is -0.02 m");
  expectInputError([] { rowDistance(1e-4, 0.02, -50.0); }, "must be above -50 1/m (gouge)");
  expectInputError([] { rowDistance(1e-4, 0.02, std::nan("")); }, "curvature");
  expectInputError([] { rowDistance(std::nan(""), 0.02, 0.0); }, "scallop height");
  expectInputError([] { scallopHeight(-1.0, 0.02, 0.0); }, "row distance is -1 m");
  expectInputError([] { scallopHeight(0.041, 0.02, 0.0); }, "meet");
  expectInputError([] { scallopHeight(10.0, 0.02, 10.0); }, "one turn");
}

}  // namespace
}  // namespace scan_to_path::toolpath
