// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/stages.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "scan_to_path/geometry/scene.h"
#include "scan_to_path/geometry/worlds.h"
#include "scan_to_path/motion/trajectory.h"
#include "scan_to_path/program/rapid_reader.h"

#include "scan_to_path/scan/cloud_io.h"
#include "small_scan.h"
#include "support/fitted_scans.h"

namespace scan_to_path::pipeline {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

const Accuracy& figure(const std::vector<Accuracy>& figures, const std::string& name) {
  for (const auto& candidate : figures) {
    if (candidate.name == name) return candidate;
  }
  throw std::runtime_error("no figure " + name);
}

TEST(Stages, ASampleLogAndItsCloudGiveTheSameFit) {
  const Cell cell = makeCell(CellOptions(), source_package);
  const ScanSection options;
  const ScanStage samples = scanFromSamples(smallScan(), cell, options, {}, 1, {});
  const ScanStage cloud = scanFromCloud(scan::formatPcd(*samples.cloud), "cloud.pcd", Units::m, false, options);
  ASSERT_EQ(cloud.cloud->size(), samples.cloud->size());
  EXPECT_LT(geometry::angleBetween(cloud.mean_beam, samples.mean_beam), 1e-6);
  const FitStage a = fitStage(samples, options, {}, {}, 1, {});
  const FitStage b = fitStage(cloud, options, {}, {}, 1, {});
  ASSERT_EQ(a.scan.lines.size(), b.scan.lines.size());
  for (std::size_t i = 0; i < a.scan.lines.size(); ++i) {
    EXPECT_EQ(a.scan.lines[i].curve.control_points.size(), b.scan.lines[i].curve.control_points.size());
  }
}

/// What stands in the tool's way higher than 50 mm over the part: 5 mm less than the sensor's nearest.
std::size_t highObstacles(const scan::SampleLog& log) {
  const Cell cell = makeCell(CellOptions(), source_package);
  const FitStage fit = fitStage(scanFromSamples(log, cell, {}, {}, 1, {}), {}, {}, {}, 1, {});
  return static_cast<std::size_t>(std::count_if(fit.scan.obstacles.begin(), fit.scan.obstacles.end(),
                                                [](const auto& point) { return point.z() > 0.05F; }));
}

// A fault may hide something as high as the sensor. Single ones, 50 samples or 2.5 mm apart, are errors of the
// sensor's.
TEST(Stages, FaultsInAGroupStandInTheWay) {
  const auto log = smallScan();
  auto single = log, group = log;
  for (std::size_t i = 0; i < log.voltage.size(); i += 50) single.voltage[i] = std::nan("");
  std::fill_n(group.voltage.begin() + static_cast<std::ptrdiff_t>(log.voltage.size() / 2), 160, std::nan(""));
  EXPECT_EQ(highObstacles(log), 0U);
  EXPECT_EQ(highObstacles(single), 0U);
  // 8 mm at one point every scan::obstacle_spacing or closer.
  EXPECT_GE(highObstacles(group), 8U);
}

TEST(Stages, AnAssumedViewingDirectionIsNoted) {
  const Cell cell = makeCell(CellOptions(), source_package);
  const ScanStage samples = scanFromSamples(smallScan(), cell, {}, {}, 1, {});
  ScanSection options;
  options.beam = Vector3(0.0, 0.6, -0.8);
  const ScanStage assumed = scanFromCloud(scan::formatPcd(*samples.cloud), "cloud.pcd", Units::m, false, options);
  EXPECT_THAT(assumed.notes, ::testing::ElementsAre(HasSubstr("taken along (0.00, 0.60, -0.80) in its own frame")));
  EXPECT_LT(geometry::angleBetween(assumed.mean_beam, options.beam), 1e-9);
  const Frame T_cloud_sensor = geometry::makeFrame(Vector3(0.8, 0.0, 2.0), Vector3(M_PI, 0.0, 0.0));
  const std::string seen = scan::formatPcd(*samples.cloud, T_cloud_sensor);
  EXPECT_TRUE(scanFromCloud(seen, "cloud.pcd", Units::m, false, options).notes.empty());
}

TEST(Stages, CloudsInMillimetresAreScaledOrSuggested) {
  const Cell cell = makeCell(CellOptions(), source_package);
  scan::ScanCloud millimetres = *scanFromSamples(smallScan(), cell, {}, {}, 1, {}).cloud;
  for (auto& point : millimetres) point.getVector3fMap() *= 1000.0F;
  const std::string text = scan::formatPcd(millimetres);
  const ScanStage scaled = scanFromCloud(text, "mm.pcd", Units::mm, true, {});
  EXPECT_LT(scaled.cloud->front().getVector3fMap().norm(), 3.0F);
  try {
    scanFromCloud(text, "mm.pcd", Units::m, false, {});
    FAIL() << "a part of 60 m was taken";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("--units mm"));
  }
}

TEST(Stages, AClockOffsetThatTheScanDoesNotTellIsTheUsersToState) {
  const Cell cell = makeCell(CellOptions(), source_package);
  const auto one_way = smallScan(smallPart(), sensing::RasterOrder::one_way);
  const ScanStage unknown = scanFromSamples(one_way, cell, {}, {}, 1, {});
  EXPECT_TRUE(fails(unknown.accuracy, "clock_offset_unknown"));
  EXPECT_THAT(unknown.notes, ::testing::ElementsAre(HasSubstr("all rows run in one direction; scan rows to and fro, "),
                                                    HasSubstr("the robot moves unseen in ")));
  ScanSection stated;
  stated.placement.clock_offset = 0.0;
  EXPECT_FALSE(fails(scanFromSamples(one_way, cell, stated, {}, 1, {}).accuracy, "clock_offset_unknown"));
  ReportOptions any;
  any.max_clock_offset = 0.0;
  EXPECT_FALSE(fails(scanFromSamples(one_way, cell, {}, any, 1, {}).accuracy, "clock_offset_unknown"));
  // A flat part looks the same with any offset.
  const geometry::FlatPart flat(geometry::Rectangle{-0.03, 0.03, -0.03, 0.03});
  const ScanStage plate = scanFromSamples(smallScan(flat), cell, {}, {}, 1, {});
  EXPECT_FALSE(fails(plate.accuracy, "clock_offset_unknown"));
  EXPECT_THAT(plate.notes, ::testing::ElementsAre(HasSubstr("the part is flat along them")));
}

/// A plate at z = 0, from x = 0 on `step` higher.
geometry::Scene steppedPlate(double step) {
  const auto low = std::make_shared<geometry::FlatPart>(geometry::Rectangle{-0.03, 0.0, -0.03, 0.03});
  const auto high = std::make_shared<geometry::FlatPart>(geometry::Rectangle{0.0, 0.03, -0.03, 0.03});
  const Frame T_plate_high = geometry::makeFrame({0.0, 0.0, step}, Vector3::Zero());
  return geometry::Scene(std::vector<std::shared_ptr<const geometry::Surface>>{
      low, std::make_shared<geometry::PosedSurface>(high, T_plate_high)});
}

// Rows cannot be compared at a step, and 5 ms at 50 mm/s put it 0.25 mm to and 0.25 mm fro.
TEST(Stages, APlateWithAStepIsNotFlat) {
  const Cell cell = makeCell(CellOptions(), source_package);
  auto log = smallScan(steppedPlate(2e-4));
  for (double& time : log.sensor_time) time -= 5e-3;
  const ScanStage stepped = scanFromSamples(log, cell, {}, {}, 1, {});
  EXPECT_TRUE(fails(stepped.accuracy, "clock_offset_unknown"));
  EXPECT_THAT(stepped.notes, ::testing::ElementsAre(HasSubstr("an offset of 10.0 ms moves the surface by up to 20")));
  ScanSection stated;
  stated.placement.clock_offset = 5e-3;
  EXPECT_FALSE(fails(scanFromSamples(log, cell, stated, {}, 1, {}).accuracy, "clock_offset_unknown"));
  // Twin: a step that is none.
  EXPECT_FALSE(
      fails(scanFromSamples(smallScan(steppedPlate(1e-6)), cell, {}, {}, 1, {}).accuracy, "clock_offset_unknown"));
}

TEST(Stages, AnUncertainClockOffsetFailsOnlyWhereItIsSurelyThere) {
  const Cell cell = makeCell(CellOptions(), source_package);
  auto log = smallScan();
  ScanSection strict;
  strict.clock_offset.max_standard_error = 1e-9;
  const ScanStage good = scanFromSamples(log, cell, strict, {}, 1, {});
  EXPECT_THAT(good.notes, ::testing::ElementsAre(HasSubstr("uncertain: the standard error is ")));
  EXPECT_FALSE(fails(good.accuracy, "clock_offset_left"));
  for (double& time : log.sensor_time) time -= 1e-3;
  const ScanStage off = scanFromSamples(log, cell, strict, {}, 1, {});
  EXPECT_TRUE(fails(off.accuracy, "clock_offset_left"));
  EXPECT_THAT(off.notes, ::testing::Contains(HasSubstr("state a calibrated offset in scan.placement.clock_offset")));
  // An offset known no better than to the limit is not known to be within it.
  ReportOptions tight;
  tight.max_clock_offset = 0.5 * figure(good.accuracy, "clock_offset_standard_error").value;
  EXPECT_TRUE(fails(scanFromSamples(smallScan(), cell, strict, tight, 1, {}).accuracy, "clock_offset_standard_error"));
}

TEST(Stages, TheFitsLimitsComeFromTheOptions) {
  const Cell cell = makeCell(CellOptions(), source_package);
  const ScanStage samples = scanFromSamples(smallScan(), cell, {}, {}, 1, {});
  ReportOptions limits;
  limits.max_line_residual = 0.0;
  const FitStage fit = fitStage(samples, {}, {}, limits, 1, {});
  EXPECT_FALSE(figure(fit.accuracy, "line_residual_rms").limit.has_value());
  EXPECT_EQ(*figure(fit.accuracy, "dropped_share").limit, limits.max_dropped_share);
  EXPECT_EQ(fit.report.in, samples.cloud->size());
}

TEST(Stages, OnlyRowsOnTheSurfaceAnswerForIt) {
  const Cell cell = makeCell(CellOptions(), source_package);
  FitStage fit = fitStage(scanFromSamples(smallScan(), cell, {}, {}, 1, {}), {}, {}, {}, 1, {});
  const auto failures = [&](process::RowSource source) {
    JobOptions options;
    options.path.row_source = source;
    const PathStage path = pathStage(*makePlanner("cutting", options), fit.scan, "base_link", options, {});
    return std::count_if(path.accuracy.begin(), path.accuracy.end(), [](const auto& figure) { return !figure.pass(); });
  };
  EXPECT_EQ(failures(process::RowSource::surface), 0);
  fit.scan.between_rows_rms = 1e-4;
  EXPECT_EQ(failures(process::RowSource::surface), 1);
  fit.scan.surface_rms = 1e-4;
  EXPECT_EQ(failures(process::RowSource::surface), 2);
  EXPECT_EQ(failures(process::RowSource::scan_lines), 0);
}

// Two lines 100 mm apart, then four: the surface between them is a guess, however well it holds the samples.
TEST(Stages, RowsOnTheSurfaceNeedFiveRowsOfTheScan) {
  const auto planned = [](int rows, const JobOptions& options) {
    const geometry::Rectangle square = {0.0, 0.1, 0.0, 0.1};
    const auto scan = test::fittedScan([](double, double) { return 0.01; }, square, 0.1 / (rows - 1), 8, 8);
    return pathStage(*makePlanner("cutting", options), scan, "base_link", options, {});
  };
  JobOptions options;
  for (const int rows : {2, 4}) {
    const PathStage few = planned(rows, options);
    EXPECT_TRUE(fails(few.accuracy, "between_rows_unknown"));
    EXPECT_EQ(figure(few.accuracy, "between_rows_unknown").value, 1.0);
    EXPECT_THAT(few.notes, Contains(HasSubstr("scan at least five rows over every part of it")));
  }
  EXPECT_FALSE(fails(planned(5, options).accuracy, "between_rows_unknown"));
  options.report.max_between_rows = 0.0;
  EXPECT_FALSE(fails(planned(4, options).accuracy, "between_rows_unknown"));
  options = {};
  options.report.max_between_rows_unknown = 1.0;
  EXPECT_FALSE(fails(planned(4, options).accuracy, "between_rows_unknown"));
}

// A twentieth may be a narrow tongue or what lies beside a hole.
TEST(Stages, MuchThatIsUnknownBetweenRowsFails) {
  const Cell cell = makeCell(CellOptions(), source_package);
  FitStage fit = fitStage(scanFromSamples(smallScan(), cell, {}, {}, 1, {}), {}, {}, {}, 1, {});
  EXPECT_EQ(figure(fit.accuracy, "between_rows_share").value, 1.0);
  const auto isFailing = [&](double share) {
    fit.scan.between_rows_share = share;
    const PathStage path = pathStage(*makePlanner("cutting", {}), fit.scan, "base_link", {}, {});
    return fails(path.accuracy, "between_rows_unknown");
  };
  EXPECT_FALSE(isFailing(0.951));
  EXPECT_TRUE(isFailing(0.949));
}

TEST(Stages, FindingsOfThePathOutrankTheMotions) {
  const Cell cell = makeCell(CellOptions(), source_package);
  const ScanStage samples = scanFromSamples(smallScan(), cell, {}, {}, 1, {});
  const FitStage fit = fitStage(samples, {}, {}, {}, 1, {});
  JobOptions options;
  PathStage path = pathStage(*makePlanner("cutting", options), fit.scan, "base_link", options, {});
  path.planned.findings = {{1, 2, toolpath::Verdict::gouge, -1e-3, "m", "a wall", "smaller ball"}};
  const MotionStage motion = motionStage(path, cell, options, {});
  std::size_t gouges = 0;
  for (const auto& verdict : motion.verdicts) {
    if (verdict.verdict != toolpath::Verdict::gouge) continue;
    ++gouges;
    EXPECT_EQ(verdict.segment, 1);
    EXPECT_EQ(verdict.index, 2);
  }
  EXPECT_EQ(gouges, 1U);
  EXPECT_EQ(motion.verdicts.size(), toolpath::waypointCount(path.planned.path));
  EXPECT_EQ(motion.report.out, motion.report.in - 1);
}

TEST(Stages, ProgramIsReadBackWithoutDiscrepancy) {
  const Cell cell = makeCell(CellOptions(), source_package);
  const ScanStage samples = scanFromSamples(smallScan(), cell, {}, {}, 1, {});
  const FitStage fit = fitStage(samples, {}, {}, {}, 1, {});
  const JobOptions options;
  const PathStage path = pathStage(*makePlanner("cutting", options), fit.scan, "base_link", options, {});
  const MotionStage motion = motionStage(path, cell, options, {});
  const ProgramStage program = programStage(path, motion, cell, options, {}, {"a test"});
  EXPECT_EQ(figure(program.accuracy, "read_back_discrepancies").value, 0.0);
  EXPECT_EQ(program.report.in, toolpath::waypointCount(path.planned.path));
  EXPECT_EQ(program.report.out, program.report.in);
  EXPECT_GE(program.files.size(), 2U);
}

/// The part machined so fast that joints must slow the tool down.
JobOptions fastOptions() {
  JobOptions options;
  options.path.feed = 0.04;
  options.motion.speed_fraction = 0.03;
  return options;
}

class FastStages : public ::testing::Test {
protected:
  const Cell cell_ = makeCell(CellOptions(), source_package);
  const FitStage fit_ = fitStage(scanFromSamples(smallScan(), cell_, {}, {}, 1, {}), {}, {}, {}, 1, {});
  const JobOptions options_ = fastOptions();
  const PathStage path_ = pathStage(*makePlanner("cutting", options_), fit_.scan, "base_link", options_, {});
  const MotionStage motion_ = motionStage(path_, cell_, options_, {});
  const ProgramStage program_ = programStage(path_, motion_, cell_, options_, {}, {});
  const program::RapidProgram read_ = program::readRapid(program_.files);
};

TEST_F(FastStages, AFeedTooFastForAJointIsLoweredInTheProgram) {
  EXPECT_EQ(motion_.report.out, motion_.report.in);
  EXPECT_GT(figure(motion_.accuracy, "feed_lowered").value, 0.2 * static_cast<double>(motion_.report.in));
  EXPECT_GE(figure(motion_.accuracy, "feed_least").value, 0.25 * options_.path.feed - 1e-6);
  EXPECT_LT(figure(motion_.accuracy, "feed_least").value, 0.95 * options_.path.feed);
  EXPECT_THAT(motion_.notes, ::testing::Contains(HasSubstr("feed lowered at ")));
  EXPECT_EQ(figure(program_.accuracy, "read_back_discrepancies").value, 0.0);
  std::size_t move = 1, slower = 0;
  for (const auto& segment : path_.planned.path.segments) {
    for (const auto& waypoint : segment.waypoints) {
      const double speed = read_.moves[move].speed;
      EXPECT_DOUBLE_EQ(speed, move == 1 ? options_.program.start_speed : motion_.plan.feeds[move - 1]);
      slower += move > 1 && speed < waypoint.feed ? 1 : 0;
      ++move;
    }
  }
  EXPECT_EQ(static_cast<double>(slower), figure(motion_.accuracy, "feed_lowered").value);
}

// The program against the trajectory's joint angles: between two waypoints no joint is faster than it may be. With the
// feed asked for, the twin, many are.
TEST_F(FastStages, NoJointIsTooFastAtTheProgramsFeeds) {
  const auto& points = motion_.plan.trajectory.points;
  std::size_t move = 1;
  int too_fast = 0, too_fast_as_asked = 0;
  for (std::size_t k = 1, from = 0; k < points.size(); ++k) {
    const bool is_waypoint =
        k + 1 == points.size() || points[k + 1].segment != points[k].segment || points[k + 1].index != points[k].index;
    if (!is_waypoint) continue;
    const auto& waypoint = path_.planned.path.segments[static_cast<std::size_t>(points[k].segment)]
                               .waypoints[static_cast<std::size_t>(points[k].index)];
    const auto &a = read_.moves[move].T_base_tcp, &b = read_.moves[move + 1].T_base_tcp;
    const double speed = read_.moves[++move].speed, way = (b.translation() - a.translation()).norm();
    for (int j = 0; waypoint.process_on && j < 6; ++j) {
      const double limit =
          options_.motion.speed_fraction * cell_.robot.joints[static_cast<std::size_t>(j)].max_velocity;
      const double turn = std::abs(points[k].q[j] - points[from].q[j]);
      // Positions are written to 0.1 um, of ways of 0.1 mm and more.
      too_fast += turn * speed > way * limit * 1.002 ? 1 : 0;
      too_fast_as_asked += turn * waypoint.feed > way * limit * 1.002 ? 1 : 0;
    }
    from = k;
  }
  EXPECT_EQ(move + 1, read_.moves.size());
  EXPECT_EQ(too_fast, 0);
  EXPECT_GT(too_fast_as_asked, 50);
}

// No move of a row is faster than its length over its feed, and most have no ramp: half of them are short of the
// median.
TEST_F(FastStages, MovesShorterThanAControllersCycleAreNoted) {
  EXPECT_EQ(figure(motion_.accuracy, "short_moves").value, 0.0);
  EXPECT_THAT(motion_.notes, ::testing::Each(::testing::Not(HasSubstr("shortest_move_time"))));
  std::vector<double> times;
  std::size_t waypoint = 0;
  for (const auto& segment : path_.planned.path.segments) {
    for (std::size_t i = 0; i < segment.waypoints.size(); ++i, ++waypoint) {
      if (i == 0 || !segment.waypoints[i].process_on) continue;
      const double way = segment.waypoints[i].arc_length - segment.waypoints[i - 1].arc_length;
      times.push_back(way / motion_.plan.feeds[waypoint]);
    }
  }
  std::sort(times.begin(), times.end());
  JobOptions slow = options_;
  slow.motion.shortest_move_time = times[times.size() / 2];
  const MotionStage motion = motionStage(path_, cell_, slow, {});
  EXPECT_GT(figure(motion.accuracy, "short_moves").value, 0.4 * static_cast<double>(times.size()));
  EXPECT_THAT(motion.notes, ::testing::Contains(HasSubstr(" (motion.shortest_move_time), the shortest ")));
  EXPECT_EQ(motion.report.out, motion.report.in) << "a note, no failure";
  const double shortest = figure(motion.accuracy, "shortest_move").value;
  slow.motion.shortest_move_time = 0.999 * shortest;
  EXPECT_EQ(figure(motionStage(path_, cell_, slow, {}).accuracy, "short_moves").value, 0.0);
  slow.motion.shortest_move_time = 1.001 * shortest;
  EXPECT_GE(figure(motionStage(path_, cell_, slow, {}).accuracy, "short_moves").value, 1.0);
}

// The whole air run against the real one: trajectory, pulses and program are the path's lift off it, everywhere.
TEST(Stages, AnAirRunIsTheRealOneLifted) {
  const Cell cell = makeCell(CellOptions(), source_package);
  const FitStage fit = fitStage(scanFromSamples(smallScan(), cell, {}, {}, 1, {}), {}, {}, {}, 1, {});
  JobOptions options;
  options.program.dry_offset = 0.05;
  options.program.dry_direction = Vector3(0.1, 0.0, 2.0);
  const Vector3 lift = 0.05 * (cell.T_base_workpiece.linear() * Vector3(0.1, 0.0, 2.0).normalized());
  const PathStage part = pathStage(*makePlanner("cutting", options), fit.scan, "base_link", options, {});
  const PathStage air = airRun(part, cell, options.program);
  const MotionStage motion = motionStage(air, cell, options, {});
  for (const auto& figure : motion.accuracy) EXPECT_TRUE(figure.pass()) << figure.name << " " << figure.value;
  const auto pulses = motion::parsePulses(pulsesStage(motion, cell).file, "pulses.csv", cell.encoders);
  const auto program = program::readRapid(programStage(air, motion, cell, options, {}, {}).files);
  const auto& points = motion.plan.trajectory.points;
  std::size_t move = 1;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const bool is_waypoint =
        k + 1 == points.size() || points[k + 1].segment != points[k].segment || points[k + 1].index != points[k].index;
    if (!is_waypoint) continue;
    const auto& waypoint = part.planned.path.segments[static_cast<std::size_t>(points[k].segment)]
                               .waypoints[static_cast<std::size_t>(points[k].index)];
    const Vector3 expected = (waypoint.pose * part.planned.path.T_contact_tcp).translation() + lift;
    const auto tcp = [&](const robot::JointVector& q) -> Vector3 {
      return (robot::forwardKinematics(cell.robot, q) * cell.T_tip_tcp).translation();
    };
    // Inverse kinematics solve to 1 um, half a count of 13 million a turn moves the tool by less than 1 um at 2 m, and
    // programs are written to 0.1 um.
    ASSERT_LT((tcp(points[k].q) - expected).norm(), 1e-6);
    ASSERT_LT((tcp(pulses.points[k].q) - expected).norm(), 5e-6);
    ASSERT_LT((program.moves[move].T_base_tcp.translation() - expected).norm(), 1e-6);
    ASSERT_FALSE(program.moves[move++].process_on);
  }
  EXPECT_EQ(move, program.moves.size());
}

}  // namespace
}  // namespace scan_to_path::pipeline
