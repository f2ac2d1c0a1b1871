// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "scan_to_path/common/options.h"
#include "scan_to_path/scan/sample_rows.h"

namespace scan_to_path::scan {

enum class BackgroundMode { automatic, none, height };

/// How the table behind the part is told from it.
struct BackgroundOptions {
  BackgroundMode mode = BackgroundMode::automatic;
  double height = 0.0;
  double tolerance = 0.001;
  int min_samples = 50;
  double border_share = 0.7;
  double min_length = 0.002;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.mode,
          Field{"mode", "",
                "automatic: look for a table plane; none: all is part; height: all up to `height` is background"});
    visit(self.height,
          Field{"height", "m",
                "coordinate of the table along the beam, in the cloud's frame, against the beam (mode height)"});
    visit(self.tolerance,
          Field{"tolerance", "m", "samples this near to the table's plane, or beyond it, are background", 1e-6, 1.0});
    visit(self.min_samples, Field{"min_samples", "", "fewer samples do not make a table", 3, 1e9});
    visit(
        self.border_share,
        Field{"border_share", "", "share of the rows that must end on the table, at both ends of x or of y", 0.0, 1.0});
    visit(self.min_length,
          Field{"min_length", "m", "shorter pieces of the part are dropped with the table", 0.0, 10.0});
  }
};

/// z = a + b x + c y in the scan frame.
struct BackgroundPlane {
  double a = 0.0;
  double b = 0.0;
  double c = 0.0;

  double heightAbove(double x, double y, double z) const { return z - (a + b * x + c * y); }
};

/// The plane on which the far sides of depth jumps lie, if there is one that
/// - at least min_samples samples of two rows or more support within the tolerance,
/// - has nothing beyond it (but one sample in a thousand), and
/// - surrounds the part: the scan ends on it on both sides along x, or on both sides across. A part's step or pocket
///   floor does not.
/// A scan without depth jumps has no background. Deterministic (seeded sampling of triples, then least squares).
std::optional<BackgroundPlane> findBackground(const SampleRows& rows, const BackgroundOptions& options);

/// A plane that a scan ends on without a step from it to the rest: a table with a part lying flush on it, or the part's
/// own flange. Samples do not tell which.
struct FlushPlane {
  double share = 0.0;   ///< of the samples
  double height = 0.0;  ///< what BackgroundOptions::height would be for it, in the middle of its samples [m]
};

/// Such a plane in rows that are rid of their background, if there is one: as in findBackground at least min_samples
/// samples support it, nothing is beyond it and it surrounds the rest, all within a tenth of the tolerance, as what is
/// curved comes near to a plane at its lowest. Nothing in another mode than automatic: then the user has said it.
std::optional<FlushPlane> findFlushPlane(const SampleRows& rows, BackgroundOptions options);

/// Drops the samples on the background ("background") and what is left of pieces shorter than min_length
/// ("short piece"). Throws InputError when nothing is left.
SampleRows removeBackground(SampleRows rows, const BackgroundOptions& options);

}  // namespace scan_to_path::scan

namespace scan_to_path {
template <>
struct EnumNames<scan::BackgroundMode> {
  static constexpr std::array<const char*, 3> names = {"automatic", "none", "height"};
};
}  // namespace scan_to_path
