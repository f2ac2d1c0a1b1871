// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/sensing/sensor_errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "support/expect_input_error.h"

namespace scan_to_path::sensing {
namespace {

constexpr int many = 200000;

std::vector<double> voltages(const ErrorOptions& errors, double distance, std::uint64_t seed = 1, int count = many) {
  RangeErrors sensor(errors, {}, seed);
  std::vector<double> result;
  for (int i = 0; i < count; ++i) result.push_back(sensor.voltageOf(distance));
  return result;
}

double distanceOf(double voltage) { return distanceFromVoltage({}, voltage).value(); }

TEST(ErrorPreset, NumbersAreTheSpecifications) {
  const ErrorOptions none = errorPreset(ErrorSet::none);
  EXPECT_EQ(none.noise_sigma + none.linearity_peak + none.drift_sigma + none.dropout_rate + none.spike_rate, 0.0);
  EXPECT_EQ(none.spot_diameter + none.clock_offset + none.converter_bits, 0.0);
  EXPECT_FALSE(none.quantise_encoders);

  const ErrorOptions white = errorPreset(ErrorSet::white);
  EXPECT_EQ(white.noise_sigma, 10e-6);
  EXPECT_EQ(white.linearity_peak + white.drift_sigma + white.dropout_rate + white.spike_rate, 0.0);
  EXPECT_EQ(white.spot_diameter + white.clock_offset + white.converter_bits, 0.0);
  EXPECT_FALSE(white.quantise_encoders);

  const ErrorOptions realistic = errorPreset(ErrorSet::realistic);
  EXPECT_EQ(realistic.noise_sigma, 2e-6);
  EXPECT_EQ(realistic.linearity_peak, 10e-6);
  EXPECT_EQ(realistic.linearity_periods, 3.0);
  EXPECT_EQ(realistic.converter_bits, 16);
  EXPECT_TRUE(realistic.quantise_encoders);
  EXPECT_DOUBLE_EQ(3.0 * realistic.drift_sigma, 20e-6);
  EXPECT_EQ(realistic.drift_correlation, 20.0);
  EXPECT_EQ(realistic.dropout_rate, 0.005);
  EXPECT_EQ(realistic.spike_rate, 0.002);
  EXPECT_EQ(realistic.spike_min, 0.2e-3);
  EXPECT_EQ(realistic.spike_max, 5e-3);
  EXPECT_EQ(realistic.spot_diameter, 50e-6);
  EXPECT_EQ(realistic.clock_offset, 0.0);
}

TEST(RangeErrors, WithoutErrorsTheVoltageIsExact) {
  RangeErrors sensor({}, {}, 1);
  for (double d = 0.055; d <= 0.105; d += 0.001) {
    EXPECT_DOUBLE_EQ(sensor.voltageOf(d), voltageFromDistance({}, d));
  }
}

/// Share of the spread that white noise of 10 um should have.
double relativeSigma(double sigma) {
  ErrorOptions errors = errorPreset(ErrorSet::white);
  errors.noise_sigma = sigma;
  double sum = 0.0, square = 0.0, product = 0.0, before = 0.0;
  for (const double voltage : voltages(errors, 0.08)) {
    const double error = distanceOf(voltage) - 0.08;
    sum += error;
    square += error * error;
    product += error * before;
    before = error;
  }
  EXPECT_LT(std::abs(sum / many), 3.0 * sigma / std::sqrt(many));
  EXPECT_LT(std::abs(product / square), 3.0 / std::sqrt(many));  // white: no correlation with the sample before
  return std::sqrt(square / many) / 10e-6;
}

TEST(RangeErrors, NoiseIsWhiteWithItsSigma) {
  const double bar = 3.0 / std::sqrt(2.0 * many);  // three standard errors of a standard deviation
  EXPECT_NEAR(relativeSigma(10e-6), 1.0, bar);
  EXPECT_GT(std::abs(relativeSigma(10.2e-6) - 1.0), bar);  // twin: 2 % more noise does not pass
}

TEST(RangeErrors, LinearityIsSmoothWithThreePeriods) {
  ErrorOptions errors;
  errors.linearity_peak = 10e-6;
  RangeErrors sensor(errors, {}, 1);
  double largest = 0.0, before = 0.0;
  int sign_changes = 0;
  for (int i = 1; i < 5000; ++i) {
    const double d = 0.055 + 0.05 * (i + 0.5) / 5000.0;
    const double voltage = sensor.voltageOf(d);
    const double error = 0.08 + voltage * 0.005 - d;  // 5 mm per volt; also where the error leaves the range
    if (voltage == sensor.farVoltage() || voltage == sensor.nearVoltage()) continue;
    largest = std::max(largest, std::abs(error));
    if (before != 0.0) {
      EXPECT_LT(std::abs(error - before), 10e-6 * 6.0 * M_PI / 5000.0 * 1.001);
    }
    if (error * before < 0.0) ++sign_changes;
    before = error;
  }
  EXPECT_NEAR(largest, 10e-6, 1e-9);
  EXPECT_EQ(sign_changes, 5);
}

TEST(RangeErrors, ConverterHasItsSteps) {
  ErrorOptions errors;
  errors.converter_bits = 16;
  RangeErrors sensor(errors, {}, 1);
  const double step = 10.0 / 65536.0;
  double largest = 0.0;
  for (double d = 0.0551; d < 0.1049; d += 3.7e-7) {
    const double voltage = sensor.voltageOf(d);
    const double steps = (voltage + 5.0) / step;
    EXPECT_NEAR(steps, std::round(steps), 1e-9);
    largest = std::max(largest, std::abs(voltage - voltageFromDistance({}, d)));
  }
  EXPECT_LE(largest, 0.5 * step + 1e-12);
  EXPECT_GT(largest, 0.49 * step);
}

TEST(RangeErrors, DropoutsAndSpikesHaveTheirShares) {
  ErrorOptions errors = errorPreset(ErrorSet::realistic);
  errors.noise_sigma = errors.linearity_peak = 0.0;
  errors.converter_bits = 0;
  int dropouts = 0, spikes = 0, positive = 0;
  double least = 1.0, most = 0.0;
  for (const double voltage : voltages(errors, 0.08)) {
    const auto distance = distanceFromVoltage({}, voltage);
    if (!distance) {
      ++dropouts;
    } else if (const double size = std::abs(*distance - 0.08); size > 1e-9) {
      ++spikes;
      if (*distance > 0.08) ++positive;
      least = std::min(least, size);
      most = std::max(most, size);
    }
  }
  const auto sigma = [](double n, double p) { return std::sqrt(n * p * (1.0 - p)); };  // binomial
  EXPECT_NEAR(dropouts, many * 0.005, 3.0 * sigma(many, 0.005));
  EXPECT_NEAR(spikes, many * 0.995 * 0.002, 3.0 * sigma(many, 0.002));
  EXPECT_NEAR(positive, 0.5 * spikes, 3.0 * sigma(spikes, 0.5));
  EXPECT_GE(least, 0.2e-3 - 1e-12);
  EXPECT_LE(most, 5e-3 + 1e-12);
  // Uniform sizes: of 400 the least lies within 3/400 of the range but with a chance of e^-3 … keep to 8/400.
  EXPECT_LT(least, 0.2e-3 + 4.8e-3 * 8.0 / 400.0);
  EXPECT_GT(most, 5e-3 - 4.8e-3 * 8.0 / 400.0);
}

TEST(RangeErrors, SwitchingOneErrorLeavesTheOthersAsTheyWere) {
  const ErrorOptions white = errorPreset(ErrorSet::white);
  ErrorOptions both = white;
  both.dropout_rate = 0.1;
  both.spike_rate = 0.1;
  const auto plain = voltages(white, 0.08, 3, 2000);
  const auto mixed = voltages(both, 0.08, 3, 2000);
  int same = 0;
  for (std::size_t i = 0; i < plain.size(); ++i) same += plain[i] == mixed[i] ? 1 : 0;
  EXPECT_NEAR(same, 2000 * 0.81, 3.0 * std::sqrt(2000 * 0.81 * 0.19));
}

TEST(RangeErrors, SeedsDecide) {
  const ErrorOptions errors = errorPreset(ErrorSet::realistic);
  EXPECT_EQ(voltages(errors, 0.08, 4, 1000), voltages(errors, 0.08, 4, 1000));
  EXPECT_NE(voltages(errors, 0.08, 4, 1000), voltages(errors, 0.08, 5, 1000));
}

TEST(RangeErrors, ReadingsBeyondTheRangeAreNoReturn) {
  RangeErrors sensor({}, {}, 1);
  EXPECT_EQ(sensor.voltageOf(std::nullopt), sensor.farVoltage());
  EXPECT_EQ(sensor.voltageOf(0.1051), sensor.farVoltage());
  EXPECT_EQ(sensor.voltageOf(0.0549), sensor.nearVoltage());
  EXPECT_FALSE(distanceFromVoltage({}, sensor.farVoltage()));
  EXPECT_FALSE(distanceFromVoltage({}, sensor.nearVoltage()));
}

std::vector<Drift> manyDrifts(const ErrorOptions& errors) {
  std::vector<Drift> drifts;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) drifts.emplace_back(errors, seed, 240.0);
  return drifts;
}

/// Mean over seeds, axes and times of `value(drift at t, drift at t + lag)`, over sigma^2.
double driftMoment(double lag, const std::function<double(double, double)>& value) {
  const ErrorOptions errors = errorPreset(ErrorSet::realistic);
  static const std::vector<Drift> drifts = manyDrifts(errors);
  double sum = 0.0;
  int count = 0;
  for (const auto& drift : drifts) {
    for (double t = 0.0; t < 200.0; t += 50.0) {
      const Vector3 here = drift.at(t), later = drift.at(t + lag);
      for (int axis = 0; axis < 3; ++axis, ++count) sum += value(here[axis], later[axis]);
    }
  }
  return sum / count / (errors.drift_sigma * errors.drift_sigma);
}

TEST(Drift, VarianceAndCorrelationAreThoseAskedFor) {
  // 900 independent histories of four instants 2.5 correlations apart: 3600 independent products of Gaussians, each
  // with a standard deviation below sqrt(2) sigma^2; three standard errors.
  const double bar = 3.0 * std::sqrt(2.0 / 3600.0);
  const auto product = [](double a, double b) { return a * b; };
  for (const double lag : {0.0, 5.0, 10.0, 20.0, 40.0, 80.0}) {
    EXPECT_NEAR(driftMoment(lag, product), std::exp(-std::pow(lag / 20.0, 2)), bar) << lag;
  }
  // Twin: half the correlation time would be e^-4 at 20 s.
  EXPECT_GT(std::abs(std::exp(-1.0) - std::exp(-4.0)), bar);
}

TEST(Drift, IsGaussianAndBandLimited) {
  // Fourth moment 3 sigma^4, spread of x^4 sqrt(96) sigma^4, over 3600 values.
  const double sigma = 20e-6 / 3.0;
  const auto fourth = [sigma](double a, double) { return a * a * a * a / (sigma * sigma); };
  EXPECT_NEAR(driftMoment(0.0, fourth), 3.0, 3.0 * std::sqrt(96.0 / 3600.0));
  // Speed: variance 2 sigma^2 / correlation^2, by a difference over 0.1 s.
  const auto speed = [](double a, double b) { return (b - a) * (b - a) / 0.01; };
  EXPECT_NEAR(driftMoment(0.1, speed) * 400.0 / 2.0, 1.0, 3.0 * std::sqrt(2.0 / 3600.0));
}

TEST(Drift, AxesAreIndependent) {
  const ErrorOptions errors = errorPreset(ErrorSet::realistic);
  Vector3 sum = Vector3::Zero();
  constexpr int seeds = 2000;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const Vector3 d = Drift(errors, seed, 1.0).at(0.5) / errors.drift_sigma;
    sum += Vector3(d.x() * d.y(), d.y() * d.z(), d.z() * d.x());
  }
  EXPECT_LT((sum / seeds).cwiseAbs().maxCoeff(), 3.0 / std::sqrt(seeds));
}

TEST(Drift, TheSameTimeDriftsTheSameWhateverElseIsAsked) {
  ErrorOptions errors = errorPreset(ErrorSet::realistic);
  const Drift brief(errors, 7, 30.0), lasting(errors, 7, 1000.0);
  for (double t = 0.0; t <= 30.0; t += 0.37) EXPECT_EQ(brief.at(t), lasting.at(t));
  EXPECT_NE(brief.at(10.0), Drift(errors, 8, 30.0).at(10.0));
  errors.drift_sigma = 0.0;
  EXPECT_EQ(Drift(errors, 7, 30.0).at(12.3), Vector3(Vector3::Zero()));
}

TEST(ErrorOptions, BadNumbersAreNamed) {
  ErrorOptions errors;
  errors.noise_sigma = -1e-6;
  test::expectInputError([&] { validateErrors(errors); }, "errors.noise_sigma is -1e-06 m, must be in [0, 0.01]");
  errors = {};
  errors.dropout_rate = 1.5;
  test::expectInputError([&] { validateErrors(errors); }, "errors.dropout_rate is 1.5, must be in [0, 1]");
  errors = {};
  errors.spike_max = 1e-4;
  test::expectInputError([&] { validateErrors(errors); }, "spike_max is 0.000100 m, must be at least spike_min");
}

}  // namespace
}  // namespace scan_to_path::sensing
