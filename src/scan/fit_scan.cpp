// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/scan/fit_scan.h"

#include <algorithm>
#include <cmath>

#include "scan_to_path/scan/between_rows.h"
#include "scan_to_path/scan/outline.h"

namespace scan_to_path::scan {
namespace {

/// Noise along the beam, every line by its number of samples.
double pooledSigma(const std::vector<FittedLine>& lines) {
  double sum = 0.0;
  double samples = 0.0;
  for (const FittedLine& line : lines) {
    sum += line.sigma * line.sigma * static_cast<double>(line.samples);
    samples += static_cast<double>(line.samples);
  }
  return samples > 0.0 ? std::sqrt(sum / samples) : 0.0;
}

nurbs::SurfaceFit fitSurface(const SampleRows& rows, const nurbs::SurfaceFitOptions& options,
                             const Progress& progress) {
  std::vector<nurbs::HeightSamples> lines;
  for (const RowPiece& piece : rows.pieces) {
    lines.push_back({piece.x.data(), piece.y.data(), piece.z.data(), piece.size(), piece.row});
  }
  return nurbs::fitHeightSurface(lines, options, progress);
}

}  // namespace

SampleRows cleanRows(const ScanCloud& cloud, const Vector3& mean_beam, const ScanOptions& options, int threads,
                     const Progress& progress) {
  progress.update("rows", 0.0);
  SampleRows rows = findRows(cloud, mean_beam, options.rows);
  progress.update("filter", 0.4);
  rows = filterRows(std::move(rows), options.filter, threads);
  progress.update("background", 0.8);
  return removeBackground(std::move(rows), options.background);
}

FittedScan fitRows(const SampleRows& rows, const FitOptions& options, int threads, const Progress& progress) {
  progress.update("lines", 0.0);
  FittedLines fitted = fitLines(rows, options.lines, threads);
  FittedScan scan;
  scan.T_cloud_scan = rows.T_cloud_scan;
  scan.samples_in = rows.samples_in;
  scan.dropped = rows.dropped;
  scan.pitch = rows.pitch;
  scan.lines = std::move(fitted.lines);
  for (const Dropped& dropped : fitted.dropped) addDropped(scan.dropped, dropped.reason, dropped.count);
  for (const FittedLine& line : scan.lines) scan.samples_used += line.samples;
  scan.line_sigma = pooledSigma(scan.lines);
  const BetweenRows between = estimateBetweenRows(scan);
  scan.between_rows_rms = between.rms;
  scan.between_rows_largest = between.largest;
  scan.between_rows_share = between.share;
  progress.update("outline", 0.6);
  scan.outline = traceOutline(rows);
  Obstacles obstacles = rows.obstacles;
  obstacles.insert(obstacles.end(), fitted.too_short.begin(), fitted.too_short.end());
  scan.obstacles = highestPoints(obstacles, obstacle_spacing);
  if (options.with_surface) {
    progress.update("surface", 0.7);
    nurbs::SurfaceFit surface = fitSurface(rows, options.surface, progress);
    scan.surface = std::move(surface.surface);
    scan.surface_rms = surface.rms;
  }
  return scan;
}

FittedScan fitScan(const ScanCloud& cloud, const Vector3& mean_beam, const ScanOptions& scan_options,
                   const FitOptions& fit_options, int threads, const Progress& progress) {
  return fitRows(cleanRows(cloud, mean_beam, scan_options, threads, progress), fit_options, threads, progress);
}

}  // namespace scan_to_path::scan
