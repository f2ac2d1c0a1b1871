// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/process/cutting.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "scan_to_path/common/error.h"
#include "scan_to_path/process/row_directions.h"
#include "scan_to_path/process/row_plan.h"
#include "scan_to_path/process/scan_line_rows.h"
#include "scan_to_path/process/surface_rows.h"
#include "scan_to_path/process/uncovered_area.h"
#include "scan_to_path/toolpath/ball_tool.h"
#include "scan_to_path/toolpath/contact_frame.h"
#include "scan_to_path/toolpath/gouge.h"
#include "scan_to_path/toolpath/region.h"
#include "scan_to_path/toolpath/row_selection.h"
#include "scan_to_path/toolpath/scallop.h"

namespace scan_to_path::process {
namespace {

using toolpath::Segment;
using toolpath::ToolPath;
using toolpath::Waypoint;
using toolpath::WaypointIndex;

int passCount(const CuttingOptions& options) {
  // The small part keeps a stock of exactly n cuts from making n + 1 passes.
  return std::max(1, static_cast<int>(std::ceil(options.stock / options.depth_of_cut - 1e-9)));
}

/// Stock that pass number `pass` leaves on the surface [m]: constant steps, none after the last.
double allowanceOf(const CuttingOptions& options, int pass) {
  const int passes = passCount(options);
  return options.stock * static_cast<double>(passes - 1 - pass) / static_cast<double>(passes);
}

std::string rowName(const CuttingOptions& options, int pass, const Row& row) {
  std::string name = passCount(options) > 1 ? "pass_" + std::to_string(pass) + "_" : std::string();
  name += "row_" + std::to_string(row.row);
  if (row.pieces > 1) name += "_" + std::to_string(row.piece);
  return name;
}

Segment rowSegment(const Row& row, const scan::Frame& T_cloud_scan, double allowance, bool forward, double feed) {
  Segment segment;
  for (const RowPoint& p : row.points) {
    Waypoint waypoint;
    const Vector3 feed_direction = forward ? p.tangent : Vector3(-p.tangent);
    waypoint.pose = T_cloud_scan * toolpath::contactFrame(p.point + allowance * p.normal, p.normal, feed_direction);
    waypoint.feed = feed;
    waypoint.process_on = true;
    segment.waypoints.push_back(waypoint);
  }
  if (!forward) std::reverse(segment.waypoints.begin(), segment.waypoints.end());
  segment.waypoints.front().process_on = false;  // the move to it is not a cut yet
  return segment;
}

void addRows(ToolPath& path, std::vector<double>& allowances, const RowPlan& plan, const scan::Frame& T_cloud_scan,
             const CuttingOptions& options) {
  const RowDirections directions(options.row_order, options.reverse_rows);
  const auto rows = directions.driven(plan.rows);
  for (int pass = 0; pass < passCount(options); ++pass) {
    const double allowance = allowanceOf(options, pass);
    for (const Row& row : rows) {
      path.segments.push_back(rowSegment(row, T_cloud_scan, allowance, directions.isForward(row.row), options.feed));
      path.segments.back().name = rowName(options, pass, row);
      allowances.push_back(allowance);
    }
  }
}

/// One value a segment from one value a row; `none` where there is no row.
template <class Value>
std::vector<Value> withLinksBetween(const ToolPath& path, const std::vector<Value>& of_rows, const Value& none) {
  std::vector<Value> values;
  auto next = of_rows.begin();
  for (const Segment& segment : path.segments) values.push_back(toolpath::isRow(segment) ? *next++ : none);
  return values;
}

/// Points by groups of what lies together.
using PointGroups = std::vector<std::vector<Vector3>>;

/// The scan's obstacles, which links keep their clearance over; some at a time, so that most are passed over at once.
void addObstaclesBelow(const scan::FittedScan& scan, PointGroups& below) {
  constexpr std::size_t at_a_time = 500;
  for (std::size_t i = 0; i < scan.obstacles.size(); ++i) {
    if (i % at_a_time == 0) below.emplace_back();
    below.back().push_back(scan.T_cloud_scan * scan.obstacles[i].cast<double>());
  }
}

PointGroups rowPoints(const ToolPath& path) {
  PointGroups rows;
  for (const Segment& segment : path.segments) {
    if (toolpath::isRow(segment)) rows.push_back(toolpath::positionsOf(segment));
  }
  return rows;
}

void addDistances(std::vector<Figure>& figures, std::vector<double> distances) {
  std::sort(distances.begin(), distances.end());
  figures.push_back({"row_distance_min", distances.front(), "m"});
  figures.push_back({"row_distance_median", distances[distances.size() / 2], "m"});
  figures.push_back({"row_distance_max", distances.back(), "m"});
}

std::vector<Figure> rowFigures(const RowPlan& plan) {
  std::vector<Figure> figures = {{"rows", static_cast<double>(rowCount(plan.rows)), ""}};
  if (plan.distances.empty()) return figures;
  addDistances(figures, plan.distances);
  figures.push_back({"scallop", plan.widest_scallop, "m"});
  return figures;
}

void setFigure(std::vector<Figure>& figures, const Figure& figure) {
  const auto found =
      std::find_if(figures.begin(), figures.end(), [&](const Figure& f) { return f.name == figure.name; });
  if (found == figures.end()) {
    figures.push_back(figure);
  } else {
    *found = figure;
  }
}

void setTravelFigures(PlannedPath& planned) {
  const toolpath::Travel travel = toolpath::travelOf(planned.path);
  for (const Figure& figure :
       {Figure{"waypoints", static_cast<double>(toolpath::waypointCount(planned.path)), ""},
        Figure{"cutting_length", travel.worked, "m"}, Figure{"path_length", travel.length, "m"},
        Figure{"time", travel.time, "s"}, Figure{"gouges", static_cast<double>(planned.findings.size()), ""}}) {
    setFigure(planned.figures, figure);
  }
}

class CuttingPlanner : public Planner {
public:
  explicit CuttingPlanner(const CuttingOptions& options) : options_(options) { validateCutting(options_, "path"); }

  PlannedPath plan(const PlannerInput& input, const Progress& progress) const override {
    const scan::FittedScan& scan = scanOf(input);
    const toolpath::Region region(options_.region, input.T_input_workobject.inverse() * scan.T_cloud_scan);
    const RowPlan rows = options_.row_source == RowSource::surface ? surfaceRows(scan, options_, progress, region)
                                                                   : scanLineRows(scan, options_, region);
    checkThatRowsAreThere(options_.skip_rows, "path.skip_rows", rows.last_row);
    checkThatRowsAreThere(options_.reverse_rows, "path.reverse_rows", rows.last_row);
    PlannedPath planned;
    planned.path.process = "cutting";
    planned.path.frame = input.frame;
    planned.path.T_contact_tcp = toolpath::ballToolFrame({options_.ball_radius, options_.lead, options_.tilt});
    planned.passes = passCount(options_);
    planned.figures = rowFigures(rows);
    addRows(planned.path, planned.allowances, rows, scan.T_cloud_scan, options_);
    join(planned, scan, {}, rowFigures(rows), progress);
    for (std::size_t s = 0; s < planned.path.segments.size(); ++s) {
      const Segment& segment = planned.path.segments[s];
      const RowPart row = {static_cast<int>(s), static_cast<int>(firstContact(segment))};
      planned.parts.push_back(toolpath::isRow(segment) ? row : RowPart{});
    }
    progress.update("path", 1.0);
    return planned;
  }

  PlannedPath without(const PlannedPath& whole, const std::set<WaypointIndex>& left_out, const PlannerInput& input,
                      const Progress& progress) const override {
    const CutRows cut = cutPasses(whole.path, left_out, passCount(options_), shortestPiece());
    PlannedPath planned;
    planned.path.process = whole.path.process;
    planned.path.frame = whole.path.frame;
    planned.path.T_contact_tcp = whole.path.T_contact_tcp;
    planned.path.segments = cut.rows;
    planned.passes = whole.passes;
    if (!cut.rows.empty()) {
      for (const RowPart& part : cut.parts) {
        planned.allowances.push_back(whole.allowances[static_cast<std::size_t>(part.source)]);
      }
      join(planned, scanOf(input), rowPoints(whole.path), whole.figures, progress);
      planned.parts = withLinksBetween(planned.path, cut.parts, RowPart{});
    }
    progress.update("path", 1.0);
    return planned;
  }

  double shortestPiece() const override { return options_.ball_radius; }

private:
  static const scan::FittedScan& scanOf(const PlannerInput& input) {
    if (input.scan == nullptr) throw InputError("cutting: needs a fitted scan, got none");
    return *input.scan;
  }

  /// Stock may still stand on every contact, cut in an earlier pass or not: nothing is driven through it at rapid feed.
  toolpath::LinkOptions linksOverStock() const {
    toolpath::LinkOptions links = options_.links;
    links.approach += options_.stock;
    links.clearance += options_.stock;
    return links;
  }

  /// What a place may keep and still be covered: what rows are meant to leave, with some of it for what lies between
  /// the places where that was looked for. Rows of a given distance leave what it makes of them, twice that of a plane
  /// on a slope of 45 degrees; what they leave at folds would hide what they do not reach.
  double heightLeft(const std::vector<Figure>& figures) const {
    const double meant = 1.05 * options_.scallop_height;
    if (options_.row_source == RowSource::surface && options_.pitch == 0.0) return meant;
    const double r = options_.ball_radius;
    double given = 0.0;
    for (const Figure& figure : figures) {
      if (figure.name != "row_distance_median") continue;
      const double half = std::min(0.5 * figure.value, r);
      given = 2.0 * (r - std::sqrt(r * r - half * half));
    }
    return std::max(meant, given);
  }

  /// Leads, links, findings and figures of a path that has its rows and what each leaves on the surface.
  /// `whole_figures` are those of the path as first planned.
  void join(PlannedPath& planned, const scan::FittedScan& scan, PointGroups also_below,
            const std::vector<Figure>& whole_figures, const Progress& progress) const {
    addObstaclesBelow(scan, also_below);
    planned.path = toolpath::withLeads(std::move(planned.path), options_.leads);
    const Vector3 up = scan.T_cloud_scan.linear().col(2);
    planned.path =
        toolpath::withLinks(std::move(planned.path), up, options_.ball_radius, linksOverStock(), std::move(also_below));
    planned.path = toolpath::snapped(std::move(planned.path));
    planned.allowances = withLinksBetween(planned.path, planned.allowances, 0.0);
    const auto target = options_.row_source == RowSource::scan_lines ? toolpath::GougeTarget::surface_and_lines
                                                                     : toolpath::GougeTarget::surface;
    progress.checkCancelled();
    const UncoveredArea uncovered =
        uncoveredArea(planned.path, planned.allowances, scan, options_.ball_radius, heightLeft(whole_figures));
    const toolpath::GougeCheck gouges(scan, options_.ball_radius, options_.gouge_tolerance, target);
    planned.findings = gouges.check(planned.path, planned.allowances, options_.chord_tolerance, progress);
    setTravelFigures(planned);
    setFigure(planned.figures, {"uncovered_area", uncovered.area, "m^2"});
    setFigure(planned.figures, {"uncovered_share", uncovered.share, "1"});
  }

  CuttingOptions options_;
};

}  // namespace

void validateCutting(const CuttingOptions& options, const std::string& path) {
  validate(options, path);
  if (options.scallop_height >= options.ball_radius) {
    std::ostringstream text;
    text << path << ".scallop_height is " << options.scallop_height << " m, must be below the ball radius "
         << options.ball_radius << " m";
    throw InputError(text.str());
  }
  // A ball cuts with its lower half; how deep its flutes reach nobody has said.
  if (std::min(options.depth_of_cut, options.stock) > options.ball_radius) {
    std::ostringstream text;
    text << path << ".depth_of_cut is " << options.depth_of_cut << " m, must be at most the ball radius "
         << options.ball_radius << " m";
    throw InputError(text.str());
  }
  toolpath::validateRegion(options.region, path + ".region");
  toolpath::RowSelection::parse(options.skip_rows, path + ".skip_rows");
  toolpath::RowSelection::parse(options.reverse_rows, path + ".reverse_rows");
}

std::unique_ptr<Planner> makeCuttingPlanner(const CuttingOptions& options) {
  return std::make_unique<CuttingPlanner>(options);
}

}  // namespace scan_to_path::process
