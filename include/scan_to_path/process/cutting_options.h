// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "scan_to_path/common/options.h"
#include "scan_to_path/scan/normals.h"
#include "scan_to_path/toolpath/modifiers.h"

namespace scan_to_path::process {

/// Where a cutting path's rows come from: the scan's own lines (the seed's way), or plane sections of the surface.
enum class RowSource { scan_lines, surface };

/// How rows follow each other: all in one direction, or to and fro.
enum class RowOrder { one_way, zig_zag };

/// How a ball end mill goes over a scanned part. Spec cutting, steps 11 to 14.
struct CuttingOptions {
  RowSource row_source = RowSource::surface;
  scan::NormalMode normals = scan::NormalMode::weighted;
  double ball_radius = 0.02;
  double scallop_height = 1e-4;
  double pitch = 0.0;
  double direction = 0.0;
  double chord_tolerance = 5e-6;
  double max_spacing = 5e-3;
  double edge_margin = 5e-4;
  double lead = 0.0;
  double tilt = 0.0;
  RowOrder row_order = RowOrder::zig_zag;
  double stock = 0.0;
  double depth_of_cut = 1e-3;
  double feed = 0.02;
  double gouge_tolerance = 5e-5;
  std::vector<Eigen::Vector2d> region;
  std::string skip_rows;
  std::string reverse_rows;
  toolpath::LeadOptions leads;
  toolpath::LinkOptions links;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.row_source,
          Field{"row_source", "", "scan_lines: along the scan's own rows; surface: any pitch and direction"});
    visit(self.normals,
          Field{"normals", "",
                "of scan_lines: weighted, seed (its own rule) or surface; surface rows take the surface's"});
    visit(self.ball_radius, Field{"ball_radius", "m", "of the ball end mill", 1e-4, 1.0});
    visit(self.scallop_height, Field{"scallop_height", "m", "material that may be left between rows", 1e-7, 0.1});
    visit(self.pitch, Field{"pitch", "m", "distance of the rows' planes; 0: from scallop_height", 0.0, 1.0});
    visit(self.direction, Field{"direction", "rad", "of surface rows in the scan plane, from its x axis", -7.0, 7.0});
    visit(self.chord_tolerance,
          Field{"chord_tolerance", "m", "of straight moves off the row, at contact and ball centre", 1e-7, 1e-2});
    visit(self.max_spacing, Field{"max_spacing", "m", "of waypoints along a row", 1e-4, 1.0});
    visit(self.edge_margin, Field{"edge_margin", "m", "kept from the part's outline", 0.0, 1.0});
    visit(self.lead, Field{"lead", "rad", "leans the tool's shank towards the feed direction", -1.3, 1.3});
    visit(self.tilt, Field{"tilt", "rad", "leans the tool's shank to the right of the feed direction", -1.3, 1.3});
    visit(self.row_order, Field{"row_order", "", "one_way or zig_zag"});
    visit(self.stock, Field{"stock", "m", "allowance on the part, taken off in passes along the normal", 0.0, 1.0});
    visit(self.depth_of_cut, Field{"depth_of_cut", "m", "most that one pass takes off", 1e-6, 1.0});
    visit(self.feed, Field{"feed", "m/s", "while cutting", 1e-5, 10.0});
    visit(self.gouge_tolerance,
          Field{"gouge_tolerance", "m", "depth of the ball in the surface that is still no gouge", 0.0, 0.01});
    visit(self.region, Field{"region", "m",
                             "corners [x, y] in the work object frame of what is machined, seen along its z; none: all",
                             -100.0, 100.0});
    visit(self.skip_rows, Field{"skip_rows", "", "numbers of rows that are not driven, such as 3, 7-9"});
    visit(self.reverse_rows, Field{"reverse_rows", "", "numbers of rows that are driven the other way round"});
    visit(self.leads, Field{"leads", "", "runs onto and off a row"});
    visit(self.links, Field{"links", "", "moves between rows"});
  }
};

/// Throws InputError naming the first value outside its range, a scallop height that the ball cannot leave, a region
/// that bounds nothing, or rows that are no numbers.
void validateCutting(const CuttingOptions& options, const std::string& path);

}  // namespace scan_to_path::process

namespace scan_to_path {
template <>
struct EnumNames<process::RowSource> {
  static constexpr std::array<const char*, 2> names = {"scan_lines", "surface"};
};
template <>
struct EnumNames<process::RowOrder> {
  static constexpr std::array<const char*, 2> names = {"one_way", "zig_zag"};
};
}  // namespace scan_to_path
