// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "../src/process/row_maker.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/expect_input_error.h"
#include "support/fitted_scans.h"

namespace scan_to_path::process {
namespace {

constexpr double few_bits = 1e-12;  // [m] and of unit vectors: a few hundred last bits of what is 0.1
const geometry::Rectangle maker_area = {0.0, 0.1, 0.0, 0.06};

/// Polynomials up to the third degree in x and in y are what a bicubic surface is.
scan::FittedScan scanOfPolynomial(const test::Height& polynomial) {
  return test::fittedScan(polynomial, maker_area, 0.004, 8, 8);
}

scan::FittedScan flatMakerScan() {
  return scanOfPolynomial([](double, double) { return 0.01; });
}

scan::FittedScan scanWithHole(double x_min, double x_max) {
  scan::FittedScan scan = flatMakerScan();
  scan.outline.polygons.push_back({{x_min, 0.02}, {x_min, 0.04}, {x_max, 0.04}, {x_max, 0.02}});
  return scan;
}

void expectEqualSteps(const Row& row, double begin, double end, std::size_t moves) {
  ASSERT_EQ(row.points.size(), moves + 1);
  for (std::size_t k = 0; k <= moves; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(moves);
    EXPECT_NEAR(row.points[k].t, begin + share * (end - begin), few_bits) << k;
  }
}

// The line at s = 10 mm in the direction of 30 degrees comes in over the left edge, x = t cos 30 - s sin 30 = 0.5 mm,
// and goes out over the upper one, y = t sin 30 + s cos 30 = 59.5 mm. 95.3 mm of t, 1.0127 times that on the plane, are
// 20 moves of at most 5 mm.
TEST(RowMaker, ARowOfAPlaneIsTheSectionInEqualSteps) {
  const scan::FittedScan scan = scanOfPolynomial([](double x, double y) { return 0.01 + 0.3 * x - 0.2 * y; });
  CuttingOptions options;
  options.direction = M_PI / 6.0;
  const RowMaker maker(scan, options);
  const double c = std::sqrt(0.75), s = 0.01;
  EXPECT_LT((maker.across() - Eigen::Vector2d(-0.5, c)).norm(), few_bits);
  const auto rows = maker.rowsAt(s, 7);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].row, 7);
  EXPECT_EQ(rows[0].piece, 0);
  EXPECT_EQ(rows[0].pieces, 1);
  expectEqualSteps(rows[0], (0.0005 + 0.5 * s) / c, (0.0595 - c * s) / 0.5, 20);
  const Vector3 normal = Vector3(-0.3, 0.2, 1.0).normalized();
  const Vector3 tangent = Vector3(c, 0.5, 0.3 * c - 0.2 * 0.5).normalized();
  for (const RowPoint& p : rows[0].points) {
    const double x = c * p.t - 0.5 * s, y = 0.5 * p.t + c * s;
    EXPECT_LT((p.point - Vector3(x, y, 0.01 + 0.3 * x - 0.2 * y)).norm(), few_bits);
    EXPECT_LT((p.normal - normal).norm(), few_bits);
    EXPECT_LT((p.tangent - tangent).norm(), few_bits);
  }
}

/// Along z = a (x - 50 mm)^2, whose slope goes from -1 to 1: what a row is to keep to.
struct Parabola {
  double a = 0.0;  ///< [1/m]
  double radius = 0.0;

  double height(double x) const { return a * (x - 0.05) * (x - 0.05); }
  double slope(double x) const { return 2.0 * a * (x - 0.05); }
  double stretch(double x) const { return std::hypot(1.0, slope(x)); }

  /// Moves a metre of x [1/m] at which the chord of the contacts and that of the ball's centre, which on a hill goes
  /// round 1 + kappa r times as far, sag by no more than the tolerance: kappa l^2 / 8.
  double density(double x, double tolerance) const {
    const double kappa = -2.0 * a / std::pow(stretch(x), 3);  // convex positive
    return stretch(x) * std::sqrt(std::abs(kappa) * std::max(1.0, 1.0 + kappa * radius) / (8.0 * tolerance));
  }

  /// Its integral, by Simpson's rule.
  double moves(double from, double to, double tolerance) const {
    constexpr int steps = 200;
    const double step = (to - from) / steps;
    double sum = 0.0;
    for (int i = 0; i <= steps; ++i) {
      sum += (i == 0 || i == steps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) * density(from + i * step, tolerance);
    }
    return sum * step / 3.0;
  }

  Vector3 centre(double x) const {
    return Vector3(x, 0.0, height(x)) + radius / stretch(x) * Vector3(-slope(x), 0.0, 1.0);
  }

  /// How far the curve of the contacts, or of the ball's centre, leaves the chord between two places [m].
  double sag(double from, double to, bool of_centre) const {
    const auto at = [&](double x) { return of_centre ? centre(x) : Vector3(x, 0.0, height(x)); };
    const Vector3 chord = (at(to) - at(from)).normalized();
    double largest = 0.0;
    for (int i = 1; i < 40; ++i) {
      const Vector3 off = at(from + (to - from) * i / 40.0) - at(from);
      largest = std::max(largest, (off - chord * chord.dot(off)).norm());
    }
    return largest;
  }
};

// Moves in equal steps of x would have shares 9 % above and below the mean in the hollow, and more on the hill.
TEST(RowMaker, MovesAreAsLongAsTheChordsAllow) {
  const CuttingOptions options;
  const double tolerance = options.chord_tolerance, begin = options.edge_margin, end = 0.1 - options.edge_margin;
  for (const double a : {10.0, -10.0}) {
    const Parabola along{a, options.ball_radius};
    const scan::FittedScan scan = scanOfPolynomial([&](double x, double) { return along.height(x); });
    const auto rows = RowMaker(scan, options).rowsAt(0.03, 0);
    ASSERT_EQ(rows.size(), 1U);
    const auto& points = rows[0].points;
    EXPECT_NEAR(points.front().t, begin, few_bits);
    EXPECT_NEAR(points.back().t, end, few_bits);
    const double needed = along.moves(begin, end, tolerance);
    const auto moves = static_cast<double>(points.size() - 1);
    // Each of 80 cells counts with its larger end: half a percent more at most.
    EXPECT_GE(moves, needed);
    EXPECT_LE(moves, std::ceil(1.005 * needed));
    double widest = 0.0;
    for (std::size_t k = 1; k < points.size(); ++k) {
      const double from = points[k - 1].t, to = points[k].t;
      ASSERT_NEAR(along.moves(from, to, tolerance), needed / moves, 0.01 * needed / moves) << a << " " << k;
      ASSERT_LE(along.sag(from, to, false), tolerance) << a << " " << k;
      ASSERT_LE(along.sag(from, to, true), tolerance) << a << " " << k;
      widest = std::max(widest, along.sag(from, to, a < 0.0));
    }
    EXPECT_GE(widest, 0.9 * tolerance) << a;
  }
}

TEST(RowMaker, AHoleMakesPiecesInRisingT) {
  const scan::FittedScan scan = scanWithHole(0.03, 0.05);
  CuttingOptions options;
  auto rows = RowMaker(scan, options).rowsAt(0.03, 3);
  ASSERT_EQ(rows.size(), 2U);
  for (int piece = 0; piece < 2; ++piece) {
    const Row& row = rows[static_cast<std::size_t>(piece)];
    EXPECT_EQ(row.row, 3);
    EXPECT_EQ(row.piece, piece);
    EXPECT_EQ(row.pieces, 2);
  }
  expectEqualSteps(rows[0], 0.0005, 0.0295, 6);   // 29 mm
  expectEqualSteps(rows[1], 0.0505, 0.0995, 10);  // 49 mm
  options.direction = M_PI;                       // t is -x, s is -y
  rows = RowMaker(scan, options).rowsAt(-0.03, 3);
  ASSERT_EQ(rows.size(), 2U);
  expectEqualSteps(rows[0], -0.0995, -0.0505, 10);
  expectEqualSteps(rows[1], -0.0295, -0.0005, 6);
  EXPECT_NEAR(rows[0].points[0].point.x(), 0.0995, few_bits);
  EXPECT_NEAR(rows[0].points[0].tangent.x(), -1.0, few_bits);
}

TEST(RowMaker, StretchesThatHoldNoLinkAreLeftOut) {
  const CuttingOptions options;
  const auto rowsBeside = [&](double x_max) { return RowMaker(scanWithHole(0.03, x_max), options).rowsAt(0.03, 0); };
  EXPECT_EQ(rowsBeside(0.09889).size(), 2U);  // 0.11 mm between the margins
  const auto rows = rowsBeside(0.09891);      // 0.09 mm
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].pieces, 1);
  EXPECT_TRUE(RowMaker(flatMakerScan(), options).rowsAt(0.0004, 0).empty()) << "within the margin of the edge";
}

TEST(RowMaker, EdgesAreTheMarginFromTheOutlines) {
  const scan::FittedScan scan = flatMakerScan();
  CuttingOptions options;
  options.edge_margin = 0.002;
  // Found to 0.1 um; the margin's own place need not have a row.
  EXPECT_NEAR(RowMaker(scan, options).edge(+1), 0.002, 2e-7);
  EXPECT_NEAR(RowMaker(scan, options).edge(-1), 0.058, 2e-7);
  options.direction = 0.5 * M_PI;  // s is -x
  EXPECT_NEAR(RowMaker(scan, options).edge(+1), -0.098, 2e-7);
  EXPECT_NEAR(RowMaker(scan, options).edge(-1), -0.002, 2e-7);
  options.edge_margin = 0.031;
  test::expectInputError([&] { RowMaker(scan, options).edge(+1); }, "no row fits into the part's outline");
}

TEST(RowMaker, ARegionCutsARowAtItsBorder) {
  const scan::FittedScan scan = flatMakerScan();
  const CuttingOptions options;
  const RowMaker maker(scan, options);
  const Row row = maker.rowsAt(0.03, 5).front();
  const auto within = [&](double x_min, double x_max) {
    const toolpath::Region region({{x_min, 0.0}, {x_max, 0.0}, {x_max, 0.06}, {x_min, 0.06}},
                                  geometry::Frame::Identity());
    return maker.inRegion(row, region);
  };
  const auto part = within(0.021, 0.069);
  ASSERT_EQ(part.size(), 1U);
  EXPECT_EQ(part[0].row, 5);
  ASSERT_EQ(part[0].points.size(), 11U);  // 48 mm
  EXPECT_NEAR(part[0].points.front().t, 0.021, 1e-8);
  EXPECT_NEAR(part[0].points.back().t, 0.069, 1e-8);
  EXPECT_NEAR(part[0].points[5].t, 0.045, 1e-8);
  const auto whole = within(-0.1, 0.2);
  ASSERT_EQ(whole.size(), 1U);
  ASSERT_EQ(whole[0].points.size(), row.points.size());
  for (std::size_t k = 0; k < row.points.size(); ++k) EXPECT_EQ(whole[0].points[k].t, row.points[k].t);
  EXPECT_TRUE(within(0.2, 0.3).empty());
}

/// Spec cutting, step 11, as it stands there.
double distanceByRule(double h, double r, double kappa) {
  const double rho = 1.0 / kappa;
  const double cosine = ((rho + r) * (rho + r) + (rho + h) * (rho + h) - r * r) / (2.0 * (rho + r) * (rho + h));
  return 2.0 * std::abs(rho) * std::acos(cosine);
}

TEST(RowMaker, TheRuleTakesTheSlopeAndTheSharpestBendAcross) {
  const CuttingOptions options;
  const double h = options.scallop_height, r = options.ball_radius;
  const auto distanceOver = [&](const test::Height& f) {
    const scan::FittedScan scan = scanOfPolynomial(f);
    const RowMaker maker(scan, options);
    return maker.ruleDistance(maker.rowsAt(0.03, 0));
  };
  const double on_plane = 2.0 * std::sqrt(2.0 * r * h - h * h);
  EXPECT_NEAR(RowMaker(flatMakerScan(), options).planeDistance(), on_plane, few_bits);
  EXPECT_NEAR(RowMaker(flatMakerScan(), options).ruleDistance({}), on_plane, few_bits);
  const double slope = 0.5;
  EXPECT_NEAR(distanceOver([&](double, double y) { return slope * y; }), on_plane / std::hypot(1.0, slope), 1e-9);
  const auto bend = [](double y, double kappa) { return -0.5 * kappa * (y - 0.03) * (y - 0.03); };
  for (const double kappa : {20.0, -20.0}) {
    EXPECT_NEAR(distanceOver([&](double, double y) { return bend(y, kappa); }), distanceByRule(h, r, kappa), 1e-9);
  }
  // Convex more and more along the row: its end decides.
  EXPECT_NEAR(distanceOver([&](double x, double y) { return bend(y, 200.0 * x); }),
              distanceByRule(h, r, 200.0 * 0.0995), 1e-9);
}

}  // namespace
}  // namespace scan_to_path::process
