// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "scan_to_path/scan/fitted_scan.h"
#include "scan_to_path/scan/obstacles.h"

namespace scan_to_path::scan {

/// Why a piece of a row ends where it does.
enum class PieceEnd {
  border,     ///< the row itself ends, or the sensor saw nothing more
  step_down,  ///< beyond it the surface lies lower: an edge of this piece
  step_up,    ///< beyond it the surface lies higher: this piece is the far side of a depth jump
  gap,        ///< samples are missing for longer than max_gap
};

/// Consecutive samples of one scan row in scan-frame coordinates, ordered towards +x. All arrays have one length.
struct RowPiece {
  int row = 0;          ///< 0 … in the order across
  bool forward = true;  ///< measured towards +x
  PieceEnd begins = PieceEnd::border;
  PieceEnd ends = PieceEnd::border;
  std::vector<double> x;             ///< along the row [m]
  std::vector<double> y;             ///< across the rows [m]
  std::vector<double> z;             ///< towards the sensor [m]
  std::vector<std::uint32_t> index;  ///< of the sample in the cloud

  std::size_t size() const { return x.size(); }
};

/// A scan cloud told apart into rows: what every step from the raw cloud to the fit takes and returns.
struct SampleRows {
  Frame T_cloud_scan = Frame::Identity();  ///< see FittedScan
  std::vector<RowPiece> pieces;            ///< sorted by row, then along x
  double pitch = 0.0;                      ///< median distance of neighbouring rows [m]
  double spacing = 0.0;                    ///< median distance of neighbouring samples [m]
  std::size_t samples_in = 0;
  std::vector<Dropped> dropped;
  Obstacles obstacles;  ///< measured, and no part of the pieces: the background, and pieces too short to fit
};

/// Where each row lies across: the mean of its pieces' middles [m], in the rows' order.
std::vector<double> rowPlaces(const SampleRows& rows);

/// What neighbouring rows are apart where none is missing: three quarters of all distances are no larger, as a raster
/// may alternate between two pitches [m]. 0 for fewer than two rows.
double usualRowDistance(const SampleRows& rows);

/// Rows farther apart than this many usual distances have others missing between them.
inline constexpr double largest_usual_distance = 2.5;

std::size_t sampleCount(const SampleRows& rows);

/// Adds to the entry of that reason; nothing when count is 0.
void addDropped(std::vector<Dropped>& dropped, const std::string& reason, std::size_t count);

/// Adds samples [begin, end) of a piece to the obstacles.
void addObstacles(const RowPiece& piece, std::size_t begin, std::size_t end, Obstacles& obstacles);

/// Samples [begin, end) of a piece, with the piece's own ends where they coincide and `gap` elsewhere.
RowPiece subPiece(const RowPiece& piece, std::size_t begin, std::size_t end);

}  // namespace scan_to_path::scan
