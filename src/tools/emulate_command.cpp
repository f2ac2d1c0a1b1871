// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include "commands.h"
#include "common_flags.h"
#include "emulated_world.h"
#include "progress_bar.h"
#include "scan_to_path/common/output_directory.h"
#include "scan_to_path/common/text.h"
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

void addEmulateFlags(CLI::App& command, EmulateFlags& flags) {
  command.add_option("--workpiece", flags.workpiece, "mesh to scan (PLY, STL, OBJ, OFF); default: the S part")
      ->type_name("FILE");
  command.add_option("--units", flags.units, "of the mesh: m (default), mm or inch");
  command.add_option("--scale", flags.scale, "factor on the mesh's coordinates")->check(CLI::PositiveNumber);
  command.add_option("--errors", flags.errors,
                     "error set: none (default), white or realistic; single errors of --config and --set win over it");
  command.add_option("--table", flags.table, "height of the table plane in the workpiece frame [m] (S part: -0.024)");
  command.add_flag("--no-table", flags.no_table, "nothing behind the part");
  command.add_option("--seed", flags.seed, "of all random errors (default 1)")->check(seedRange());
  command.add_option("--out", flags.out, "sample log to write")->type_name("FILE");
  flags.common.addTo(command);
}

WorldOptions worldOptions(const EmulateFlags& flags) {
  WorldOptions options{flags.workpiece, std::nullopt, flags.scale, flags.table, flags.no_table};
  if (!flags.units.empty()) options.units = parseEnum<pipeline::Units>("--units", flags.units);
  return options;
}

std::string share(std::size_t part, std::size_t whole) {
  return fixed(100.0 * static_cast<double>(part) / static_cast<double>(std::max<std::size_t>(whole, 1)), 1) + " %";
}

void printEvidence(const sensing::EmulatedScan& scan, const std::string& out) {
  const auto& range = scan.range;
  std::printf("emulated  %d rows, %zu samples, %.1f s of scanning\n", scan.rows, range.samples, scan.duration);
  if (range.nothing == range.samples) {
    std::puts("range     nothing seen: no surface below any sample");
  } else {
    std::printf("range     nearest %.1f mm, farthest %.1f mm\n", 1e3 * range.nearest, 1e3 * range.farthest);
  }
  if (range.too_near + range.too_far > 0) {
    std::printf(
        "note      out of the sensor's range: %s too near, %s too far; if that is the part, sweep it a second time "
        "with --set emulate.raster.height=… higher or lower\n",
        share(range.too_near, range.samples).c_str(), share(range.too_far, range.samples).c_str());
  }
  std::printf("log in    %s\n", out.c_str());
}

int emulate(const EmulateFlags& flags) {
  pipeline::JobOptions defaults;
  if (!flags.errors.empty()) {
    defaults.emulate.errors = sensing::errorPreset(parseEnum<sensing::ErrorSet>("--errors", flags.errors));
  }
  std::set<std::string> given;
  pipeline::JobOptions options = flags.common.options(defaults, &given);
  if (flags.seed) options.emulate.seed = *flags.seed;
  const World world = makeWorld(worldOptions(flags));
  if (!flags.workpiece.empty() && given.count("emulate.raster.height") == 0) {
    options.emulate.raster.height = rasterHeight(world, options.cell.laser);
  }
  if (flags.common.print_config) {
    std::fputs(pipeline::formatYaml(pipeline::fieldReferences(options)).c_str(), stdout);
    return 0;
  }
  if (flags.out.empty()) throw InputError("emulate: --out is missing");
  validate(options, "");
  checkRasterHeight(world, options.emulate.raster.height);
  const pipeline::Cell cell = pipeline::makeCell(options.cell, flags.common.packagePath());
  sensing::EmulatedScan scan;
  {
    ProgressBar bar(flags.common.quiet);
    scan = sensing::emulateScan(*world.scene, world.rectangle(), cell.T_base_workpiece, cell.robot, cell.encoders,
                                cell.laser, cell.T_tip_sensor, options.emulate, flags.common.threads, bar.progress());
    writeFileAtomically(flags.out, scan::formatSampleLog(scan.log));
  }
  if (!flags.common.quiet) printEvidence(scan, flags.out);
  return 0;
}

}  // namespace

std::function<int()> addEmulateCommand(CLI::App& app) {
  const auto flags = std::make_shared<EmulateFlags>();
  CLI::App* command = app.add_subcommand("emulate", "Scan a part with an emulated point laser on the robot");
  addEmulateFlags(*command, *flags);
  command->footer("Example: scan_to_path emulate --errors realistic --seed 1 --out samples.csv");
  return [flags] { return emulate(*flags); };
}

}  // namespace scan_to_path::tools
