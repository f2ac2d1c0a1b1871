// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scan_to_path/common/options.h"
#include "scan_to_path/toolpath/tool_path.h"

namespace scan_to_path::toolpath {

using geometry::Vector3;

/// How the tool runs onto a row and off it.
struct LeadOptions {
  double length = 0.005;
  double angle = 0.17;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.length,
          Field{"length", "m", "straight run before the first and after the last contact; 0: none", 0.0, 1.0});
    visit(self.angle, Field{"angle", "rad", "of that run over the surface's tangent; 0: tangential", 0.0, 1.5});
  }
};

/// How the tool gets to the first row, from row to row, and away.
struct LinkOptions {
  double approach = 0.005;
  double clearance = 0.02;
  double plunge_feed = 0.01;
  double rapid_feed = 0.25;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(self.approach, Field{"approach", "m", "driven along the surface normal before and after a row", 1e-4, 1.0});
    visit(self.clearance, Field{"clearance", "m", "of links over the highest contact below them", 1e-3, 10.0});
    visit(self.plunge_feed, Field{"plunge_feed", "m/s", "of the approach along the normal", 1e-5, 10.0});
    visit(self.rapid_feed, Field{"rapid_feed", "m/s", "of moves in the air", 1e-5, 10.0});
  }
};

/// Rows with a straight, climbing run before their first contact and after their last one, at the row's feed and with
/// the process off. Replaces runs that are there already: applied twice equals once. Other segments stay.
ToolPath withLeads(ToolPath path, const LeadOptions& options);

/// The rows joined in their order by an approach, links and a retract with the process off: along the normal off the
/// row, along `up` to the clearance over every contact within `corridor` [m] of the link, across, and down again. The
/// tool turns in steps of at most 45 degrees; a turn of more than 90 goes round by the direction of travel, so that
/// zig-zag rows turn it to and fro, and back where that would wind it up from pass to pass. Links keep the same
/// clearance over the points of `also_below`, in groups of what lies together. Replaces links that are there already:
/// applied twice equals once. `up` is a unit vector in the path's frame. Throws InputError when the path has no rows.
ToolPath withLinks(ToolPath path, const Vector3& up, double corridor, const LinkOptions& options,
                   std::vector<std::vector<Vector3>> also_below = {});

}  // namespace scan_to_path::toolpath
