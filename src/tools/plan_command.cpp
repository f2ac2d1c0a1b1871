// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include "commands.h"
#include "common_flags.h"
#include "emulated_world.h"
#include "progress_bar.h"
#include "scan_to_path/geometry/scene.h"
#include "scan_to_path/pipeline/configuration.h"
#include "scan_to_path/pipeline/job.h"

namespace scan_to_path::tools {
namespace {

struct PlanFlags {
  CommonFlags common;
  std::string process = "cutting";
  std::string input;
  std::string input_kind;
  std::string units;
  std::string stop_after = "program";
  std::vector<std::string> controllers;
  std::string reference;
  std::string reference_units;
  std::optional<double> reference_scale;
  bool allow_partial = false;
  int seed = 1;
  std::string out;
};

void addPlanFlags(CLI::App& command, PlanFlags& flags) {
  command.add_option("--process", flags.process, "what is done to the part: cutting")->capture_default_str();
  command.add_option("--input", flags.input, "sample log, or a scan cloud as PCD or PLY; told by content")
      ->type_name("FILE");
  command.add_option("--input-kind", flags.input_kind, "insist: samples, cloud, mesh or cad");
  command.add_option("--units", flags.units, "of a cloud: m (default), mm or inch");
  command.add_option("--stop-after", flags.stop_after, "scan, fit, path, motion or program")->capture_default_str();
  command.add_option("--controller", flags.controllers, "abb or pulses (repeatable; default both)")
      ->allow_extra_args(false);
  command.add_flag("--allow-partial", flags.allow_partial,
                   "leave out waypoints that fail and write a program of the rest; exit status stays 1");
  CLI::Option* reference =
      command
          .add_option("--reference", flags.reference,
                      "true surface to measure the finished path against: a mesh in the workpiece frame, or s_part; a "
                      "path too far off it fails the job (report.max_reference_path)")
          ->type_name("FILE");
  command.add_option("--reference-units", flags.reference_units, "of the reference mesh: m (default), mm or inch")
      ->needs(reference);
  command.add_option("--reference-scale", flags.reference_scale, "factor on the reference mesh's coordinates")
      ->check(CLI::PositiveNumber)
      ->needs(reference);
  command
      .add_option("--seed", flags.seed,
                  "of random choices, written to the report; cutting draws no random numbers: it changes nothing else")
      ->check(seedRange())
      ->capture_default_str();
  command.add_option("--out", flags.out, "directory of the result (default out/<process>)")
      ->type_name("DIR")
      ->check(notEmpty());
  flags.common.addTo(command);
}

std::shared_ptr<const geometry::Surface> referenceSurface(const PlanFlags& flags, const pipeline::MountOptions& mount) {
  if (flags.reference.empty()) return nullptr;
  std::optional<pipeline::Units> units;
  if (!flags.reference_units.empty()) units = parseEnum<pipeline::Units>("--reference-units", flags.reference_units);
  const Workpiece part = flags.reference == "s_part"
                             ? sPart()
                             : readWorkpiece(flags.reference, units, flags.reference_scale, "--reference-units");
  return std::make_shared<geometry::PosedSurface>(part.surface, mount.frame());
}

pipeline::JobRequest requestFrom(const PlanFlags& flags, const pipeline::JobOptions& options) {
  if (flags.input.empty()) throw InputError("plan: --input is missing");
  pipeline::JobRequest request;
  request.process = flags.process;
  request.input = flags.input;
  if (!flags.input_kind.empty()) request.input_kind = parseEnum<pipeline::InputKind>("--input-kind", flags.input_kind);
  if (!flags.units.empty()) request.units = parseEnum<pipeline::Units>("--units", flags.units);
  request.stop_after = parseEnum<pipeline::Stage>("--stop-after", flags.stop_after);
  request.allow_partial = flags.allow_partial;
  request.threads = flags.common.threads;
  request.seed = static_cast<std::uint64_t>(flags.seed);
  request.out = flags.out.empty() ? "out/" + flags.process : flags.out;
  if (!flags.controllers.empty()) request.outputs.clear();
  for (const auto& name : flags.controllers)
    request.outputs.push_back(parseEnum<pipeline::Output>("--controller", name));
  request.package_path = flags.common.packagePath();
  request.reference = referenceSurface(flags, options.cell.workpiece);
  return request;
}

int plan(const PlanFlags& flags) {
  pipeline::JobOptions options = flags.common.options();
  if (flags.common.print_config) {
    std::fputs(pipeline::formatYaml(pipeline::fieldReferences(options)).c_str(), stdout);
    return 0;
  }
  const pipeline::JobRequest request = requestFrom(flags, options);
  pipeline::JobResult result;
  {
    ProgressBar bar(flags.common.quiet);
    result = pipeline::runJob(request, options, bar.progress());
  }
  if (!flags.common.quiet) {
    for (const auto& line : result.summary) std::puts(line.c_str());
  }
  return result.exit;
}

}  // namespace

std::function<int()> addPlanCommand(CLI::App& app) {
  const auto flags = std::make_shared<PlanFlags>();
  CLI::App* command = app.add_subcommand("plan", "From a scan to a robot program");
  addPlanFlags(*command, *flags);
  command->footer(
      "Exit status: 0 every waypoint planned and verified; 1 planned, but a waypoint or a tolerance fails (then no\n"
      "program is written, unless only waypoints fail and --allow-partial leaves them out); 2 bad input or "
      "configuration; 3 a bug; 130 interrupted.\n\n"
      "Example: scan_to_path plan --process cutting --input samples.csv --set path.scallop_height=5e-5");
  return [flags] { return plan(*flags); };
}

}  // namespace scan_to_path::tools
