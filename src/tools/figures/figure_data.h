// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "scan_to_path/pipeline/stages.h"
#include "scan_to_path/scan/sample_rows.h"

/// What the figures of the method show: the intermediate values of one job on an emulated scan of the S part.
namespace scan_to_path::tools {

using geometry::Frame;
using geometry::Vector3;

/// A short stretch of one row where the fitted curve is nearly straight: the samples and the curve, in a frame of its
/// own: x along the curve, z off the surface, origin on the curve.
struct FitDetail {
  std::vector<Vector3> samples;  ///< as they were measured [m]
  std::vector<Vector3> curve;    ///< points of the fitted curve, dense enough to draw [m]
};

/// Points on the fitted lines, and what two methods say the normals there are.
struct NormalComparison {
  std::vector<Vector3> points;       ///< every point on the lines, in base_link [m]
  std::vector<Vector3> normals;      ///< by the structure of the scan lines, one a point
  std::vector<std::size_t> chosen;   ///< the points at which arrows are to be drawn
  std::vector<Vector3> pca_normals;  ///< by principal components of the 20 nearest points, one a chosen point
};

/// A row of the path as planned and as the robot drives it, in base_link.
struct RowPlayback {
  std::vector<Frame> planned;        ///< poses of the tool centre point at the waypoints
  std::vector<Vector3> played_back;  ///< tool centre point by KDL's forward kinematics of the joint motion [m]
  robot::JointVector joints;         ///< in the middle of the row [rad]
};

struct FigureData {
  FigureData(pipeline::JobOptions job_options, pipeline::Cell job_cell)
      : options(std::move(job_options)), cell(std::move(job_cell)) {}

  pipeline::JobOptions options;
  pipeline::Cell cell;
  scan::ScanCloud raw;                        ///< in base_link
  scan::ScanCloud filtered;                   ///< the samples left after filtering, in base_link
  std::vector<std::vector<Vector3>> outline;  ///< closed polygons on the surface, in base_link [m]
  FitDetail detail;
  NormalComparison normals;
  pipeline::PathStage path;
  pipeline::MotionStage motion;
  RowPlayback row;
};

/// Emulates the scan with the realistic errors drawn from `seed` and runs the job's stages on it. The same values for
/// any number of threads.
FigureData makeFigureData(pipeline::JobOptions options, const std::vector<std::filesystem::path>& package_path,
                          int seed, int threads);

}  // namespace scan_to_path::tools
