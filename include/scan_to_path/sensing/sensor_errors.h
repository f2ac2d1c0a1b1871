// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "scan_to_path/common/options.h"
#include "scan_to_path/common/random.h"
#include "scan_to_path/geometry/frames.h"
#include "scan_to_path/sensing/point_laser.h"

namespace scan_to_path::sensing {

using geometry::Vector3;

/// What an emulated scan gets wrong; without a preset, nothing.
struct ErrorOptions {
  double noise_sigma = 0.0;
  double linearity_peak = 0.0;
  double linearity_periods = 3.0;
  int converter_bits = 0;
  bool quantise_encoders = false;
  double drift_sigma = 0.0;
  double drift_correlation = 20.0;
  double dropout_rate = 0.0;
  double spike_rate = 0.0;
  double spike_min = 0.0002;
  double spike_max = 0.005;
  double spot_diameter = 0.0;
  double clock_offset = 0.0;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.noise_sigma, Field{"noise_sigma", "m", "white noise of the range", 0.0, 0.01});
    visit(self.linearity_peak, Field{"linearity_peak", "m", "peak of the range's smooth linearity error", 0.0, 0.01});
    visit(self.linearity_periods, Field{"linearity_periods", "", "of the linearity error over the range", 0.0, 100.0});
    visit(self.converter_bits,
          Field{"converter_bits", "bit", "of the converter over the voltage range; 0: exact", 0, 32});
    visit(self.quantise_encoders, Field{"quantise_encoders", "", "encoders count whole counts"});
    visit(self.drift_sigma,
          Field{"drift_sigma", "m", "repeatability: slow drift of the sensor along each axis", 0.0, 0.01});
    visit(self.drift_correlation,
          Field{"drift_correlation", "s", "time after which the drift's correlation is 1/e", 0.1, 1e5});
    visit(self.dropout_rate, Field{"dropout_rate", "", "share of samples without return", 0.0, 1.0});
    visit(self.spike_rate, Field{"spike_rate", "", "share of samples with a spike", 0.0, 1.0});
    visit(self.spike_min, Field{"spike_min", "m", "least size of a spike, of either sign", 0.0, 1.0});
    visit(self.spike_max, Field{"spike_max", "m", "largest size of a spike", 0.0, 1.0});
    visit(self.spot_diameter, Field{"spot_diameter", "m", "laser spot on the surface, 1/e^2", 0.0, 0.01});
    visit(self.clock_offset, Field{"clock_offset", "s", "encoders' clock ahead of the sensor's", -1.0, 1.0});
  }
};

enum class ErrorSet { none, white, realistic };

/// The error sets on which all figures of this package are measured (spec cutting, "The S part and the error sets").
ErrorOptions errorPreset(ErrorSet set);

/// Throws InputError for a number out of range or spike_max below spike_min.
void validateErrors(const ErrorOptions& errors);

/// Stationary Gaussian displacement of the sensor with the autocorrelation sigma^2 exp(-(tau / correlation)^2) along
/// each axis, independent of one another: random Fourier modes (Rahimi and Recht 2007), so it has no period.
class Drift {
public:
  /// For times in [0, duration] [s].
  Drift(const ErrorOptions& errors, std::uint64_t seed, double duration);

  /// [m], in base_link; the same for the same time whichever other times were asked for.
  Vector3 at(double time) const;

private:
  double step_ = 0.0;
  std::vector<Vector3> table_;  ///< at -1, 0, 1, … steps; empty without drift
};

/// The sensor's electronics: what voltage a distance becomes, sample by sample, in the order of the samples.
class RangeErrors {
public:
  RangeErrors(const ErrorOptions& errors, const PointLaserOptions& laser, std::uint64_t seed);

  /// `distance` [m] as the optics see it, nothing when no light returns. Every sample draws from every random stream,
  /// so that switching one error on or off leaves the others as they were.
  double voltageOf(std::optional<double> distance);

  /// Output while the sensor sees nothing, or something too far away, and something too near [V].
  double farVoltage() const { return far_voltage_; }
  double nearVoltage() const { return near_voltage_; }

private:
  double converted(double voltage) const;
  double drawSpike();

  ErrorOptions errors_;
  PointLaserOptions laser_;
  Random noise_;
  Random dropout_;
  Random spike_;
  double far_voltage_;
  double near_voltage_;
};

}  // namespace scan_to_path::sensing

namespace scan_to_path {
template <>
struct EnumNames<sensing::ErrorSet> {
  static constexpr std::array<const char*, 3> names = {"none", "white", "realistic"};
};
}  // namespace scan_to_path
