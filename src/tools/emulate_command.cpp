// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include "commands.h"
#include "common_flags.h"
#include "progress_bar.h"
#include "scan_to_path/common/output_directory.h"
#include "scan_to_path/common/text.h"
#include "scan_to_path/geometry/scene.h"
#include "scan_to_path/geometry/worlds.h"
#include "scan_to_path/pipeline/configuration.h"
#include "scan_to_path/sensing/emulate_scan.h"

namespace scan_to_path::tools {
namespace {

struct EmulateFlags {
  CommonFlags common;
  std::string workpiece;
  std::string units;
  std::optional<double> scale;
  std::string errors;
  std::optional<double> table;
  bool no_table = false;
  std::optional<int> seed;
  std::string out;
};

constexpr double s_part_table = -0.024;  // [m], spec of the S part

void addFlags(CLI::App& command, EmulateFlags& flags) {
  command.add_option("--workpiece", flags.workpiece, "mesh to scan (PLY, STL, OBJ, OFF); default: the S part")
      ->type_name("FILE");
  command.add_option("--units", flags.units, "of the mesh: m (default), mm or inch");
  command.add_option("--scale", flags.scale, "factor on the mesh's coordinates")->check(CLI::PositiveNumber);
  command.add_option("--errors", flags.errors, "error set: none (default), white or realistic");
  command.add_option("--table", flags.table, "height of the table plane in the workpiece frame [m] (S part: -0.024)");
  command.add_flag("--no-table", flags.no_table, "nothing behind the part");
  command.add_option("--seed", flags.seed, "of all random errors (default 1)");
  command.add_option("--out", flags.out, "sample log to write")->type_name("FILE");
  flags.common.addTo(command);
}

struct World {
  std::shared_ptr<const geometry::Surface> scene;
  Eigen::AlignedBox3d bounds;
};

World worldFrom(const EmulateFlags& flags) {
  std::optional<pipeline::Units> units;
  if (!flags.units.empty()) units = parseEnum<pipeline::Units>("--units", flags.units);
  const bool own_part = flags.workpiece.empty();
  const Workpiece part = own_part ? sPart() : readWorkpiece(flags.workpiece, units, flags.scale);
  std::optional<double> table = flags.table;
  if (own_part && !table) table = s_part_table;
  if (!table || flags.no_table) return {part.surface, part.bounds};
  const auto plane = std::make_shared<geometry::PosedSurface>(
      std::make_shared<geometry::Plane>(), geometry::makeFrame({0.0, 0.0, *table}, geometry::Vector3::Zero()));
  using Surfaces = std::vector<std::shared_ptr<const geometry::Surface>>;
  return {std::make_shared<geometry::Scene>(Surfaces{part.surface, plane}), part.bounds};
}

/// The sensor is carried so that the part's heights lie in the middle of its range.
double rasterHeight(const Eigen::AlignedBox3d& bounds, const sensing::PointLaserOptions& laser) {
  return 0.5 * (bounds.min().z() + bounds.max().z()) + 0.5 * (laser.distance_min + laser.distance_max);
}

std::string share(std::size_t part, std::size_t whole) {
  return fixed(100.0 * static_cast<double>(part) / static_cast<double>(std::max<std::size_t>(whole, 1)), 1) + " %";
}

void printEvidence(const sensing::EmulatedScan& scan, const std::string& out) {
  const auto& range = scan.range;
  std::printf("emulated  %d rows, %zu samples, %.1f s of scanning\n", scan.rows, range.samples, scan.duration);
  std::printf("range     nearest %.1f mm, farthest %.1f mm\n", 1e3 * range.nearest, 1e3 * range.farthest);
  if (range.too_near + range.too_far > 0) {
    std::printf(
        "note      out of the sensor's range: %s too near, %s too far; if that is the part, sweep it a second time "
        "with --set emulate.raster.height=… higher or lower\n",
        share(range.too_near, range.samples).c_str(), share(range.too_far, range.samples).c_str());
  }
  std::printf("log in    %s\n", out.c_str());
}

int emulate(const EmulateFlags& flags) {
  std::set<std::string> given;
  pipeline::JobOptions options = flags.common.options(&given);
  if (!flags.errors.empty()) {
    options.emulate.errors = sensing::errorPreset(parseEnum<sensing::ErrorSet>("--errors", flags.errors));
    const auto fields = pipeline::fieldReferences(options);
    for (const auto& assignment : flags.common.assignments) pipeline::applyAssignment(fields, assignment);
  }
  if (flags.seed) options.emulate.seed = *flags.seed;
  const World world = worldFrom(flags);
  if (!flags.workpiece.empty() && given.count("emulate.raster.height") == 0) {
    options.emulate.raster.height = rasterHeight(world.bounds, options.cell.laser);
  }
  if (flags.common.print_config) {
    std::fputs(pipeline::formatYaml(pipeline::fieldReferences(options)).c_str(), stdout);
    return 0;
  }
  if (flags.out.empty()) throw InputError("emulate: --out is missing");
  validate(options, "");
  const pipeline::Cell cell = pipeline::makeCell(options.cell, flags.common.packagePath());
  const Eigen::AlignedBox2d rectangle(world.bounds.min().head<2>(), world.bounds.max().head<2>());
  sensing::EmulatedScan scan;
  {
    ProgressBar bar(flags.common.quiet);
    scan = sensing::emulateScan(*world.scene, rectangle, cell.T_base_workpiece, cell.robot, cell.encoders, cell.laser,
                                cell.T_tip_sensor, options.emulate, flags.common.threads, bar.progress());
    writeFileAtomically(flags.out, scan::formatSampleLog(scan.log));
  }
  if (!flags.common.quiet) printEvidence(scan, flags.out);
  return 0;
}

}  // namespace

std::function<int()> addEmulateCommand(CLI::App& app) {
  const auto flags = std::make_shared<EmulateFlags>();
  CLI::App* command = app.add_subcommand("emulate", "Scan a part with an emulated point laser on the robot");
  addFlags(*command, *flags);
  command->footer("Example: scan_to_path emulate --errors realistic --seed 1 --out samples.csv");
  return [flags] { return emulate(*flags); };
}

}  // namespace scan_to_path::tools
