// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/stages.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "scan_to_path/common/error.h"
#include "scan_to_path/common/text.h"
#include "scan_to_path/motion/trajectory.h"
#include "scan_to_path/pipeline/background_findings.h"
#include "scan_to_path/pipeline/blind_spots.h"
#include "scan_to_path/pipeline/clock_findings.h"
#include "scan_to_path/pipeline/joint_findings.h"
#include "scan_to_path/pipeline/lowered_feeds.h"
#include "scan_to_path/pipeline/short_moves.h"
#include "scan_to_path/pipeline/unseen_share.h"
#include "scan_to_path/scan/cloud_io.h"
#include "scan_to_path/verification/playback.h"
#include "scan_to_path/verification/pulse_check.h"

namespace scan_to_path::pipeline {
namespace {

/// What lies beside the part is no loss, and what of it did not come back is the unseen share's; everything else that
/// does not reach the fit is.
bool isLoss(const std::string& reason) { return reason != "turn" && reason != "background" && reason != "no return"; }

double lossShare(const std::vector<scan::Dropped>& dropped, std::size_t used) {
  std::size_t lost = 0;
  for (const auto& entry : dropped) {
    if (isLoss(entry.reason)) lost += entry.count;
  }
  return lost + used == 0 ? 0.0 : static_cast<double>(lost) / static_cast<double>(lost + used);
}

/// What was nearer than the sensor sees, or made it fail, may reach as high as the sensor went. A single beam of that
/// kind is an error of the sensor's, as spikes are; three within a square of a millimetre are not.
void addTooNear(const scan::NoReturns& no_returns, scan::FittedScan& scan) {
  constexpr double side = 0.001;  // [m]
  constexpr std::size_t least = 3;
  const geometry::Frame T_scan_cloud = scan.T_cloud_scan.inverse();
  std::map<std::pair<double, double>, scan::Obstacles> squares;
  for (const auto& beam : no_returns.beams) {
    if (!beam.is_too_near) continue;
    Vector3 top = T_scan_cloud * beam.far_end.cast<double>();
    top.z() += no_returns.range + no_returns.nearest;
    squares[{std::floor(top.x() / side), std::floor(top.y() / side)}].push_back(top.cast<float>());
  }
  scan::Obstacles tops;
  for (const auto& [square, points] : squares) {
    if (points.size() >= least) tops.insert(tops.end(), points.begin(), points.end());
  }
  tops = scan::highestPoints(tops, scan::obstacle_spacing);
  scan.obstacles.insert(scan.obstacles.end(), tops.begin(), tops.end());
}

Eigen::AlignedBox3d boundsOf(const scan::ScanCloud& cloud) {
  Eigen::AlignedBox3d bounds;
  for (const auto& point : cloud) bounds.extend(Vector3(point.x, point.y, point.z));
  return bounds;
}

/// The beam decides on which side of the cloud the material is, and so from where the tool comes.
void noteAssumedBeam(const Vector3& beam, ScanStage& stage) {
  stage.notes.push_back("the cloud does not say from where it was seen: taken along (" + fixed(beam.x(), 2) + ", " +
                        fixed(beam.y(), 2) + ", " + fixed(beam.z(), 2) +
                        ") in its own frame, with the material behind it; else set scan.beam");
}

/// The worse of the path's finding and the motion's verdict: a gouge is the part's loss, so it comes first.
std::vector<toolpath::WaypointVerdict> merged(const std::vector<toolpath::WaypointVerdict>& findings,
                                              std::vector<toolpath::WaypointVerdict> verdicts) {
  auto finding = findings.begin();
  for (auto& verdict : verdicts) {
    if (finding == findings.end() || finding->segment != verdict.segment || finding->index != verdict.index) continue;
    verdict = *finding++;
  }
  return verdicts;
}

/// What stands in the way up there need not on the part.
void markAirRun(std::vector<toolpath::WaypointVerdict>& verdicts) {
  for (auto& verdict : verdicts) {
    if (verdict.verdict == toolpath::Verdict::ok) continue;
    verdict.reason = "in the air run " + verdict.reason;
    verdict.remedy += ", or lower program.dry_offset";
  }
}

/// Rows to and fro turn a leaning tool by half a turn, which an arm's wrist often cannot do.
void noteRowOrder(const process::CuttingOptions& options, MotionStage& stage) {
  const bool leans = options.lead != 0.0 || options.tilt != 0.0;
  if (!leans || options.row_order != process::RowOrder::zig_zag || stage.report.out == stage.report.in) return;
  stage.notes.push_back(
      "a leaning tool turns by 180 degrees from row to row to and fro: try --set path.row_order=one_way");
}

}  // namespace

ScanStage scanFromSamples(const scan::SampleLog& log, const Cell& cell, const ScanSection& options,
                          const ReportOptions& limits, int threads, const Progress& progress) {
  ScanStage stage;
  const auto estimate = sensing::estimateClockOffset(log, cell.robot, cell.encoders, cell.laser, cell.T_tip_sensor,
                                                     options.placement, options.clock_offset, progress);
  sensing::PlacementOptions placement = options.placement;
  if (options.correct_clock_offset) {
    if (estimate.observability != sensing::Observability::observable) {
      throw InputError("scan.correct_clock_offset: " + estimate.reason);
    }
    placement.clock_offset = estimate.offset;
  }
  auto placed = sensing::placeSamples(log, cell.robot, cell.encoders, cell.laser, cell.T_tip_sensor, placement, threads,
                                      progress);
  stage.cloud = std::make_shared<const scan::ScanCloud>(std::move(placed.cloud));
  stage.no_returns = std::move(placed.no_returns);
  stage.mean_beam = placed.mean_beam;
  stage.report = {"scan", placed.samples_in, stage.cloud->size(), placed.dropped};
  std::optional<sensing::OffsetEffect> effect;
  if (estimate.observability == sensing::Observability::few_slopes) {
    const scan::SampleRows rows = scan::cleanRows(*stage.cloud, stage.mean_beam, options.cloud, threads, progress);
    effect = sensing::offsetEffect(rows, *stage.cloud, options.clock_offset.largest_offset);
  }
  ClockFindings clocks = clockFindings(estimate, effect, options, placement.clock_offset.value_or(0.0), limits);
  stage.accuracy = std::move(clocks.accuracy);
  stage.notes = std::move(clocks.notes);
  JointFindings joints = jointFindings(placed.unseen_jumps, placed.times_repeated, limits);
  stage.accuracy.insert(stage.accuracy.end(), joints.accuracy.begin(), joints.accuracy.end());
  std::move(joints.notes.begin(), joints.notes.end(), std::back_inserter(stage.notes));
  return stage;
}

ScanStage scanFromCloud(std::string_view content, const std::string& name, Units units, bool units_given,
                        const ScanSection& options) {
  auto file = scan::parseCloud(content, name);
  const float scale = static_cast<float>(metresPerUnit(units));
  if (units != Units::m) {
    for (auto& point : file.cloud) point.getVector3fMap() *= scale;
  }
  if (!units_given) checkPlausibleSize(boundsOf(file.cloud), units, name);
  ScanStage stage;
  stage.mean_beam = file.viewing_direction.value_or(options.beam);
  if (!file.viewing_direction) noteAssumedBeam(options.beam, stage);
  if (!(stage.mean_beam.norm() > 0.0)) throw InputError("scan.beam is zero, must be a direction");
  stage.mean_beam = geometry::roundedDirection(stage.mean_beam);
  stage.cloud = std::make_shared<const scan::ScanCloud>(std::move(file.cloud));
  stage.report = {"scan", stage.cloud->size() + file.no_return, stage.cloud->size(), {}};
  scan::addDropped(stage.report.dropped, "no return", file.no_return);
  return stage;
}

FitStage fitStage(const ScanStage& scanned, const ScanSection& scan_options, const scan::FitOptions& fit_options,
                  const ReportOptions& limits, int threads, const Progress& progress) {
  FitStage stage;
  const scan::SampleRows rows =
      scan::cleanRows(*scanned.cloud, scanned.mean_beam, scan_options.cloud, threads, progress);
  stage.scan = scan::fitRows(rows, fit_options, threads, progress);
  addTooNear(scanned.no_returns, stage.scan);
  const scan::FittedScan& scan = stage.scan;
  stage.report = {"fit", scan.samples_in, scan.samples_used, scan.dropped};
  double squares = 0.0;
  for (const auto& line : scan.lines)
    squares += line.residual_rms * line.residual_rms * static_cast<double>(line.samples);
  const double line_rms = std::sqrt(squares / static_cast<double>(std::max<std::size_t>(scan.samples_used, 1)));
  stage.accuracy.push_back({"line_residual_rms", line_rms, "m", limitUnlessZero(limits.max_line_residual)});
  stage.accuracy.push_back({"line_noise", scan.line_sigma, "m"});
  if (!scan.surface.control_points.empty()) {
    stage.accuracy.push_back({"surface_residual_rms", scan.surface_rms, "m"});
  }
  stage.accuracy.push_back({"between_rows_rms", scan.between_rows_rms, "m"});
  stage.accuracy.push_back({"between_rows_largest", scan.between_rows_largest, "m"});
  stage.accuracy.push_back({"between_rows_share", scan.between_rows_share, "1"});
  std::vector<scan::Dropped> dropped = scanned.report.dropped;
  dropped.insert(dropped.end(), scan.dropped.begin(), scan.dropped.end());
  const BackgroundFindings background = backgroundFindings(stage.scan, rows, scan_options.cloud.background);
  stage.accuracy.push_back(background.share);
  stage.notes.insert(stage.notes.end(), background.notes.begin(), background.notes.end());
  stage.accuracy.push_back({"dropped_share", lossShare(dropped, scan.samples_used), "1", limits.max_dropped_share});
  stage.accuracy.push_back({"row_pitch", scan.pitch, "m"});
  // The filter cuts a row at a gap of max_gap, and of five samples at least.
  const double shortest_gap = std::max(scan_options.cloud.filter.max_gap, 5.0 * rows.spacing);
  const UnseenShare unseen = unseenShare(*scanned.cloud, rows, scanned.no_returns, shortest_gap);
  stage.accuracy.push_back({"unseen_share", unseen.sum(), "1", limits.max_unseen_share});
  if (const auto note = unseenNote(unseen, limits.note_unseen_share)) stage.notes.push_back(*note);
  if (const auto note = blindSpotNote(blindSpots(rows, shortest_gap))) stage.notes.push_back(*note);
  return stage;
}

std::vector<toolpath::WaypointVerdict> pathVerdicts(const PathStage& path) {
  std::vector<toolpath::WaypointVerdict> verdicts;
  const auto& segments = path.planned.path.segments;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    for (std::size_t i = 0; i < segments[s].waypoints.size(); ++i) {
      toolpath::WaypointVerdict verdict;
      verdict.segment = static_cast<int>(s);
      verdict.index = static_cast<int>(i);
      verdict.margin = std::numeric_limits<double>::quiet_NaN();
      verdicts.push_back(std::move(verdict));
    }
  }
  return merged(path.planned.findings, std::move(verdicts));
}

MotionStage motionStage(const PathStage& path, const Cell& cell, const JobOptions& options, const Progress& progress) {
  MotionStage stage;
  const auto& planned = path.planned;
  const bool is_air_run = !planned.path.lift.isZero(0.0);
  stage.plan = motion::planMotion(planned.path, cell.robot, cell.T_tip_tcp, options.motion, progress);
  if (is_air_run) markAirRun(stage.plan.verdicts);
  stage.verdicts = merged(planned.findings, stage.plan.verdicts);
  const auto failed =
      static_cast<std::size_t>(std::count_if(stage.verdicts.begin(), stage.verdicts.end(), [](const auto& verdict) {
        return verdict.verdict != toolpath::Verdict::ok;
      }));
  stage.report = {"motion", stage.verdicts.size(), stage.verdicts.size() - failed, {}};
  const auto playback = verification::playBack(stage.plan.trajectory, cell.robot, cell.T_tip_tcp, planned.path);
  constexpr double position_limit = 1e-6;               // [m]
  constexpr double angle_limit = 0.001 * M_PI / 180.0;  // [rad]
  stage.accuracy = {{"playback_missing", static_cast<double>(playback.missing), "1", 0.0},
                    {"playback_position", playback.position_largest, "m", position_limit},
                    {"playback_angle", playback.angle_largest, "rad", angle_limit},
                    {"chord_error", is_air_run ? playback.air_chord_largest : playback.chord_largest, "m",
                     options.motion.chord_tolerance}};
  const auto& chord_largest_at = is_air_run ? playback.air_chord_largest_at : playback.chord_largest_at;
  for (const auto& [name, at] :
       {std::pair("playback_position", playback.position_largest_at),
        std::pair("playback_angle", playback.angle_largest_at), std::pair("chord_error", chord_largest_at)}) {
    if (const auto note = worstPlaceNote(stage.accuracy, name, planned.path, at)) stage.notes.push_back(*note);
  }
  noteRowOrder(options.path, stage);
  const LoweredFeeds lowered = loweredFeeds(planned.path, stage.plan.feeds);
  stage.accuracy.insert(stage.accuracy.end(), lowered.accuracy.begin(), lowered.accuracy.end());
  if (lowered.note) stage.notes.push_back(*lowered.note);
  const ShortMoves moves = shortMoves(planned.path, stage.plan.trajectory, options.motion.shortest_move_time);
  stage.accuracy.insert(stage.accuracy.end(), moves.accuracy.begin(), moves.accuracy.end());
  if (moves.note) stage.notes.push_back(*moves.note);
  if (!stage.plan.trajectory.points.empty()) {
    stage.accuracy.push_back({"duration", stage.plan.trajectory.points.back().time, "s"});
  }
  return stage;
}

ProgramStage programStage(const PathStage& path, const MotionStage& motion, const Cell& cell, const JobOptions& options,
                          const std::vector<std::string>& notices, const std::vector<std::string>& provenance) {
  program::ProgramInput input;
  input.path = path.planned.path;
  input.plan = motion.plan;
  input.robot = cell.robot;
  input.T_tip_tcp = cell.T_tip_tcp;
  input.T_base_workobject = cell.T_base_workpiece;
  input.options = options.program;
  input.notices = notices;
  input.provenance = provenance;
  ProgramStage stage;
  stage.files = program::writeProgram(program::Controller::abb, input);
  auto read = program::readBack(program::Controller::abb, input, stage.files);
  stage.report = {"program", toolpath::waypointCount(input.path), read.waypoints, {}};
  stage.accuracy = {{"read_back_discrepancies", static_cast<double>(read.discrepancies.size()), "1", 0.0}};
  for (const auto& discrepancy : read.discrepancies) stage.notes.push_back("read-back: " + discrepancy.text);
  return stage;
}

PulsesStage pulsesStage(const MotionStage& motion, const Cell& cell) {
  PulsesStage stage;
  stage.file = motion::formatPulses(motion.plan.trajectory, cell.encoders);
  const auto check = verification::checkPulses(stage.file, motion.plan.trajectory, cell.encoder_options, cell.robot);
  // Rounding takes half a count; a whole one is what the controller's own resolution is.
  stage.accuracy = {{"pulses_mismatches", static_cast<double>(check.mismatches), "1", 0.0},
                    {"pulses_difference", check.largest_difference, "count", 1.0}};
  if (!check.first_mismatch.empty()) stage.notes.push_back("read-back: " + check.first_mismatch);
  return stage;
}

}  // namespace scan_to_path::pipeline
