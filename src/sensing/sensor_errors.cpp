// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/sensing/sensor_errors.h"

#include <cmath>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"

namespace scan_to_path::sensing {
namespace {

// Random streams of one seed, one per error source.
enum Stream : std::uint64_t { noise_stream = 1, dropout_stream, spike_stream, drift_stream };

constexpr int drift_modes = 64;
constexpr double steps_per_correlation = 20.0;  // of the table: cubic interpolation then errs by under 1e-4 sigma

/// A drift's Fourier modes along one axis.
struct Modes {
  double frequency[drift_modes];  // [rad/s]
  double cosine[drift_modes];     // [m]
  double sine[drift_modes];       // [m]
};

Modes drawModes(const ErrorOptions& errors, std::uint64_t seed, std::uint64_t axis) {
  Random random(seed, drift_stream + axis);
  // The spectrum of exp(-(tau / c)^2) is Gaussian with standard deviation sqrt(2) / c.
  const double bandwidth = std::sqrt(2.0) / errors.drift_correlation;
  const double amplitude = errors.drift_sigma / std::sqrt(static_cast<double>(drift_modes));
  Modes modes;
  for (int m = 0; m < drift_modes; ++m) {
    modes.frequency[m] = bandwidth * random.gaussian();
    modes.cosine[m] = amplitude * random.gaussian();
    modes.sine[m] = amplitude * random.gaussian();
  }
  return modes;
}

double sumOfModes(const Modes& modes, double time) {
  double sum = 0.0;
  for (int m = 0; m < drift_modes; ++m) {
    const double phase = modes.frequency[m] * time;
    sum += modes.cosine[m] * std::cos(phase) + modes.sine[m] * std::sin(phase);
  }
  return sum;
}

}  // namespace

ErrorOptions errorPreset(ErrorSet set) {
  ErrorOptions errors;
  if (set == ErrorSet::white) errors.noise_sigma = 10e-6;
  if (set == ErrorSet::realistic) {
    errors.noise_sigma = 2e-6;
    errors.linearity_peak = 10e-6;
    errors.linearity_periods = 3.0;
    errors.converter_bits = 16;
    errors.quantise_encoders = true;
    errors.drift_sigma = 20e-6 / 3.0;
    errors.drift_correlation = 20.0;
    errors.dropout_rate = 0.005;
    errors.spike_rate = 0.002;
    errors.spike_min = 0.0002;
    errors.spike_max = 0.005;
    errors.spot_diameter = 50e-6;
  }
  return errors;
}

void validateErrors(const ErrorOptions& errors) {
  validate(errors, "errors");
  if (errors.spike_max < errors.spike_min) {
    throw InputError("errors", "spike_max", fixed(errors.spike_max, 6) + " m",
                     "at least spike_min, " + fixed(errors.spike_min, 6) + " m");
  }
}

Drift::Drift(const ErrorOptions& errors, std::uint64_t seed, double duration) {
  if (errors.drift_sigma == 0.0) return;
  step_ = errors.drift_correlation / steps_per_correlation;
  const auto steps = static_cast<std::size_t>(std::ceil(duration / step_)) + 4;
  table_.resize(steps);
  for (int axis = 0; axis < 3; ++axis) {
    const Modes modes = drawModes(errors, seed, static_cast<std::uint64_t>(axis));
    for (std::size_t i = 0; i < steps; ++i) table_[i][axis] = sumOfModes(modes, (static_cast<double>(i) - 1.0) * step_);
  }
}

Vector3 Drift::at(double time) const {
  if (table_.empty()) return Vector3::Zero();
  const double x = time / step_;
  const auto i = static_cast<std::size_t>(x);
  const double u = x - static_cast<double>(i);
  // Lagrange's cubic through the steps before, at and after.
  return (-u * (u - 1.0) * (u - 2.0) / 6.0) * table_[i] + ((u + 1.0) * (u - 1.0) * (u - 2.0) / 2.0) * table_[i + 1] +
         (-u * (u + 1.0) * (u - 2.0) / 2.0) * table_[i + 2] + (u * (u + 1.0) * (u - 1.0) / 6.0) * table_[i + 3];
}

RangeErrors::RangeErrors(const ErrorOptions& errors, const PointLaserOptions& laser, std::uint64_t seed)
    : errors_(errors),
      laser_(laser),
      noise_(seed, noise_stream),
      dropout_(seed, dropout_stream),
      spike_(seed, spike_stream) {
  const double beyond = 0.05 * (laser.distance_max - laser.distance_min);
  far_voltage_ = converted(voltageFromDistance(laser, laser.distance_max + beyond));
  near_voltage_ = converted(voltageFromDistance(laser, laser.distance_min - beyond));
}

double RangeErrors::voltageOf(std::optional<double> distance) {
  const double noise = errors_.noise_sigma * noise_.gaussian();
  const bool is_dropout = dropout_.uniform() < errors_.dropout_rate;
  const double spike = drawSpike();
  if (!distance || is_dropout) return far_voltage_;
  const double share = (*distance - laser_.distance_min) / (laser_.distance_max - laser_.distance_min);
  const double linearity = errors_.linearity_peak * std::sin(2.0 * M_PI * errors_.linearity_periods * share);
  const double reading = *distance + linearity + noise + spike;
  if (reading < laser_.distance_min) return near_voltage_;
  if (reading > laser_.distance_max) return far_voltage_;
  return converted(voltageFromDistance(laser_, reading));
}

double RangeErrors::drawSpike() {
  const bool is_spike = spike_.uniform() < errors_.spike_rate;
  const double size = spike_.uniform(errors_.spike_min, errors_.spike_max);
  const bool is_negative = spike_.uniform() < 0.5;
  if (!is_spike) return 0.0;
  return is_negative ? -size : size;
}

double RangeErrors::converted(double voltage) const {
  if (errors_.converter_bits == 0) return voltage;
  const double step = std::ldexp(laser_.voltage_max - laser_.voltage_min, -errors_.converter_bits);
  return laser_.voltage_min + step * std::round((voltage - laser_.voltage_min) / step);
}

}  // namespace scan_to_path::sensing
