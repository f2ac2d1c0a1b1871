// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scan_to_path/scan/sample_log.h"
#include "scan_to_path/sensing/point_laser.h"

namespace scan_to_path::sensing {

/// Throws InputError, naming sample, time, voltage and length, for a voltage that repeats exactly for more than
/// laser.max_repeats times the log's usual run of equal voltages, where the log shows noise of at least one of its
/// steps and 1e-5 of the output's range: a converter that saturates, or a sensor that holds its last value, within the
/// measuring range. Gaussian noise of one step's standard deviation leaves a voltage at its likeliest value with
/// p = 0.38, fifty times on end with 0.38^49 = 3e-21; of half a step, as on a quieter surface, with 0.68^49 = 6e-9.
/// Without such noise a flat part repeats its voltage rightly, and nothing is refused, unless 1000 samples or more all
/// measure one and the same voltage: that a plate is level to a step of the converter, without noise and with nothing
/// around it, is less likely than a sensor that is off.
void checkRestingSensor(const scan::SampleLog& log, const PointLaserOptions& laser);

}  // namespace scan_to_path::sensing
