// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/toolpath/scallop.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "scan_to_path/common/error.h"

namespace scan_to_path::toolpath {
namespace {

[[noreturn]] void reject(const char* quantity, double value, const char* unit, const std::string& limit) {
  std::ostringstream text;
  text << value << " " << unit;
  throw InputError("scallop rule", quantity, text.str(), limit);
}

std::string limitText(const char* before, double value, const char* unit) {
  std::ostringstream text;
  text << before << " " << value << " " << unit;
  return text.str();
}

void checkBall(double ball_radius, double curvature) {
  if (!(ball_radius > 0.0) || !std::isfinite(ball_radius)) reject("ball radius", ball_radius, "m", "positive");
  if (!(curvature * ball_radius > -1.0) || !std::isfinite(curvature)) {
    reject("curvature across the rows", curvature, "1/m", limitText("above", -1.0 / ball_radius, "1/m (gouge)"));
  }
}

/// asin(x) / x
double arcSinc(double x) { return std::abs(x) < 1e-5 ? 1.0 + x * x / 6.0 : std::asin(x) / x; }

/// sin(x) / x
double sinc(double x) { return std::abs(x) < 1e-5 ? 1.0 - x * x / 6.0 : std::sin(x) / x; }

}  // namespace

double largestScallop(double ball_radius, double curvature) {
  checkBall(ball_radius, curvature);
  const double kr = curvature * ball_radius;
  if (kr < -0.5) return -2.0 * (1.0 + kr) / curvature;  // the ball reaches over the hollow's centre
  return 2.0 * ball_radius / (std::sqrt(1.0 + 2.0 * kr) + 1.0);
}

double rowDistance(double scallop_height, double ball_radius, double curvature) {
  checkBall(ball_radius, curvature);
  const double h = scallop_height;
  const double r = ball_radius;
  const double limit = std::min(r, largestScallop(r, curvature));
  if (!(h > 0.0 && h < r && h <= limit)) reject("scallop height", h, "m", limitText("positive and below", limit, "m"));
  // 1 - cos(phi/2) = 2 sin^2(phi/4) turns step 11's equation into sin(phi/4) = kappa a, L = phi / kappa = 4 a asinc.
  const double a = std::sqrt(h * (2.0 * r - h) / (4.0 * (1.0 + curvature * r) * (1.0 + curvature * h)));
  return 4.0 * a * arcSinc(curvature * a);
}

double scallopHeight(double row_distance, double ball_radius, double curvature) {
  checkBall(ball_radius, curvature);
  if (!(row_distance >= 0.0)) reject("row distance", row_distance, "m", "0 or more");
  const double quarter_angle = curvature * row_distance / 4.0;
  if (!(std::abs(quarter_angle) <= std::asin(1.0))) {
    reject("row distance", row_distance, "m", "at most one turn around the surface");
  }
  // Step 11's equation squared out: h^2 - (2 r - kappa b) h + b = 0 with b = (1 + kappa r)(2 sin(phi/4) / kappa)^2.
  const double s = 0.5 * row_distance * sinc(quarter_angle);
  const double b = (1.0 + curvature * ball_radius) * s * s;
  const double half = ball_radius - 0.5 * curvature * b;
  const double discriminant = half * half - b;
  if (!(discriminant >= 0.0 && half > 0.0)) {
    reject("row distance", row_distance, "m", "small enough for the balls of the two rows to meet");
  }
  return b / (half + std::sqrt(discriminant));
}

}  // namespace scan_to_path::toolpath
