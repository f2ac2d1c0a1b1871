// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scan_to_path/common/progress.h"
#include "scan_to_path/scan/fitted_scan.h"
#include "scan_to_path/toolpath/scan_surface.h"
#include "scan_to_path/toolpath/tool_path.h"
#include "scan_to_path/toolpath/verdict.h"

namespace scan_to_path::toolpath {

class SolidPoints;

/// What of the part a ball must not enter. The scan's obstacles it must not in any case.
enum class GougeTarget {
  surface,            ///< the surface fitted across the scan's lines: all there is between them
  surface_and_lines,  ///< the lines too, where they leave the surface, as at folds
};

/// Finds where a ball would cut into a scanned part. Spec cutting, step 11: a gouge is where the smallest signed
/// principal curvature at the contact is at most -1/r, or where a distant piece of surface enters the ball.
/// Keeps a reference: the scan must outlive it.
class GougeCheck {
public:
  /// Samples the surface inside the outline on a square grid of a sixteenth of the radius.
  /// Throws InputError for a radius that is not positive, a negative tolerance, or a scan without surface or outline.
  GougeCheck(const scan::FittedScan& scan, double ball_radius, double tolerance,
             GougeTarget target = GougeTarget::surface);
  ~GougeCheck();

  /// The waypoints of a path (in the scan's cloud frame) that gouge, themselves or on the move that leads to them, in
  /// path order. All moves are swept; between two contacts the ball may go deeper by `chord_tolerance` [m], by which
  /// the straight move may leave the surface. `allowance` is the stock that each segment leaves on the surface [m];
  /// empty means none. The margin is the hollow's radius less the ball's, or the ball's depth in the surface as a
  /// negative number [m]. Throws Interrupted.
  std::vector<WaypointVerdict> check(const ToolPath& path, const std::vector<double>& allowance = {},
                                     double chord_tolerance = 0.0, const Progress& progress = {}) const;

private:
  struct Nearest {
    double distance = 0.0;
    Vector3 point = Vector3::Zero();
  };

  void sampleHeights();
  void findTops();
  std::optional<Nearest> nearestNode(const Vector3& centre, double reach, const Vector3* contact) const;
  void searchBlock(std::size_t block_x, std::size_t block_y, const Vector3& centre, double reach,
                   const Vector3* contact, std::optional<Nearest>& nearest) const;
  Nearest refined(const Vector3& centre, const Nearest& start) const;
  struct Deepest {
    Vector3 point = Vector3::Zero();
    bool is_part = true;
  };
  std::optional<Deepest> deepest(const Vector3& centre, double radius, const Vector3* contact) const;
  bool entersAt(const Vector3& centre, double radius, double tolerance, const Vector3* contact,
                WaypointVerdict& verdict) const;
  bool judgeWaypoint(const Segment& segment, std::size_t index, double allowance, WaypointVerdict& verdict) const;
  bool judgeMove(const Waypoint& from, const Waypoint& to, double allowance, double tolerance, bool on_surface,
                 WaypointVerdict& verdict) const;

  const scan::FittedScan& scan_;
  std::unique_ptr<const SolidPoints> lines_;  ///< null when the lines do not count
  std::unique_ptr<const SolidPoints> obstacles_;
  geometry::Frame T_scan_cloud_;
  ScanSurface surface_;
  double radius_;
  double tolerance_;
  double spacing_;
  Eigen::Vector2d origin_;
  std::size_t count_x_ = 0;
  std::size_t count_y_ = 0;
  std::size_t blocks_x_ = 0;
  std::size_t blocks_y_ = 0;
  std::vector<double> heights_;  ///< count_y_ rows of count_x_; far below where there is no part
  std::vector<double> tops_;     ///< highest node of each block, blocks_y_ rows of blocks_x_
};

}  // namespace scan_to_path::toolpath
