// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/clock_findings.h"

#include <gmock/gmock.h>

namespace scan_to_path::pipeline {
namespace {

using sensing::Observability;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

sensing::ClockOffsetEstimate estimateOf(Observability observability, double offset = 0.0, double error = 0.0) {
  sensing::ClockOffsetEstimate estimate;
  estimate.observability = observability;
  estimate.offset = offset;
  estimate.standard_error = error;
  if (observability != Observability::observable) estimate.reason = "of the test";
  return estimate;
}

ScanSection stating(double offset) {
  ScanSection options;
  options.placement.clock_offset = offset;
  return options;
}

sensing::OffsetEffect moving(double height, double noise) {
  sensing::OffsetEffect effect;
  effect.height = height;
  effect.noise = noise;
  effect.place = Vector3(0.1, 0.2, 0.3);
  return effect;
}

/// Names of the figures that fail.
std::vector<std::string> failures(const ClockFindings& found) {
  std::vector<std::string> names;
  for (const auto& figure : found.accuracy) {
    if (!figure.pass()) names.push_back(figure.name);
  }
  return names;
}

TEST(ClockFindings, AnOffsetThatTheScanDoesNotTellMustBeStatedBeItZero) {
  const auto none = estimateOf(Observability::none);
  const ClockFindings unknown = clockFindings(none, {}, {}, 0.0, {});
  EXPECT_THAT(failures(unknown), ElementsAre("clock_offset_unknown"));
  EXPECT_THAT(unknown.notes, ElementsAre(HasSubstr("of the test; scan rows to and fro, state a calibrated one in")));
  for (const double stated : {0.0, 1e-3, -2e-3}) {
    EXPECT_THAT(failures(clockFindings(none, {}, stating(stated), stated, {})), IsEmpty());
  }
  ReportOptions any;
  any.max_clock_offset = 0.0;
  EXPECT_THAT(failures(clockFindings(none, {}, {}, 0.0, any)), IsEmpty());
}

TEST(ClockFindings, APartIsFlatOnlyWhereAnOffsetDoesNotMoveIt) {
  const auto few = estimateOf(Observability::few_slopes);
  const ScanSection options;
  const double most = options.clock_offset.max_effect;
  const ClockFindings flat = clockFindings(few, moving(most, 0.0), options, 0.0, {});
  EXPECT_THAT(failures(flat), IsEmpty());
  EXPECT_THAT(flat.notes, ElementsAre(HasSubstr("the part is flat along them, an offset of 10.0 ms moves the surface "
                                                "by no more than 20 um in height, noise included")));
  const sensing::OffsetEffect step = moving(5e-4, 1e-6);
  const ClockFindings moved = clockFindings(few, step, options, 0.0, {});
  EXPECT_THAT(failures(moved), ElementsAre("clock_offset_unknown"));
  EXPECT_THAT(moved.notes, ElementsAre(HasSubstr("of the test, yet an offset of 10.0 ms moves the surface by up to 500 "
                                                 "um in height at (0.1000, 0.2000, 0.3000); state a calibrated one")));
  EXPECT_THAT(failures(clockFindings(few, step, stating(0.0), 0.0, {})), IsEmpty());
  // What noise explains is no shape.
  EXPECT_THAT(failures(clockFindings(few, moving(5e-4, 1e-4), options, 0.0, {})), IsEmpty());
  EXPECT_THAT(failures(clockFindings(few, moving(5e-4, 8e-5), options, 0.0, {})), ElementsAre("clock_offset_unknown"));
}

TEST(ClockFindings, AStatedOffsetNeedsNoSmallStandardErrorButMustNotBeContradicted) {
  const double limit = ReportOptions().max_clock_offset;
  const auto uncertain = estimateOf(Observability::uncertain, 1e-3, 3.0 * limit);
  EXPECT_THAT(failures(clockFindings(uncertain, {}, {}, 0.0, {})),
              ElementsAre("clock_offset_standard_error"));  // 1 ms is within two standard errors and the limit
  EXPECT_THAT(failures(clockFindings(uncertain, {}, stating(0.0), 0.0, {})), IsEmpty());
  EXPECT_THAT(failures(clockFindings(uncertain, {}, stating(1.2e-3), 1.2e-3, {})), IsEmpty());
  const ClockFindings wrong = clockFindings(uncertain, {}, stating(-1e-3), -1e-3, {});
  EXPECT_THAT(failures(wrong), ElementsAre("clock_offset_left"));
  EXPECT_THAT(wrong.notes,
              ElementsAre(HasSubstr("uncertain: of the test"), HasSubstr("off the encoders' by 2.000 ms")));
}

TEST(ClockFindings, AnObservableOffsetIsNotLeftBeItStated) {
  const auto known = estimateOf(Observability::observable, 1e-3, 1e-6);
  EXPECT_THAT(failures(clockFindings(known, {}, {}, 0.0, {})), ElementsAre("clock_offset_left"));
  EXPECT_THAT(failures(clockFindings(known, {}, stating(0.0), 0.0, {})), ElementsAre("clock_offset_left"));
  EXPECT_THAT(failures(clockFindings(known, {}, stating(1e-3), 1e-3, {})), IsEmpty());
  EXPECT_THAT(failures(clockFindings(known, {}, {}, 1e-3, {})), IsEmpty());  // corrected
}

}  // namespace
}  // namespace scan_to_path::pipeline
