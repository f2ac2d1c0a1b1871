// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/left_out.h"

#include <gmock/gmock.h>

#include "scan_to_path/toolpath/modifiers.h"
#include "support/paths.h"

namespace scan_to_path::pipeline {
namespace {

using ::testing::HasSubstr;
using toolpath::Verdict;
using toolpath::WaypointVerdict;

WaypointVerdict verdictAt(int segment, int index, Verdict verdict) {
  return {segment, index, verdict, -1.0, "m", "why", "how"};
}

/// Two passes over two rows of eleven contacts, 10 mm apart, without leads and links.
process::PlannedPath twoPasses() {
  process::PlannedPath planned;
  planned.path = test::planeRows(4, 0.004, 0.1, 10);
  planned.passes = 2;
  for (int row = 0; row < 4; ++row) planned.parts.push_back({row, 0});
  return planned;
}

TEST(LeftOut, NamesWhatFailsAndWhatIsLeftOutForIt) {
  const process::PlannedPath whole = twoPasses();
  const Causes causes = {{{0, 3}, {LeftOutKind::fails, verdictAt(0, 3, Verdict::gouge)}},
                         {{0, 9}, {LeftOutKind::way_fails, verdictAt(0, 10, Verdict::jump)}},
                         {{0, 10}, {LeftOutKind::way_fails, verdictAt(0, 10, Verdict::jump)}}};
  std::set<toolpath::WaypointIndex> places;
  for (const auto& [place, cause] : causes) places.insert(place);
  const auto cut = process::cutPasses(whole.path, places, 2, 0.035);
  process::PlannedPath partial = whole;
  partial.path.segments = cut.rows;
  partial.parts = cut.parts;
  const auto list = leftOut(whole, partial, causes, 0.035);
  // Of row 0 contacts 4 to 8 stay, 40 mm; of row 2, the same row on the later pass, too.
  ASSERT_EQ(list.size(), 12U);
  for (std::size_t k = 0; k < list.size(); ++k) {
    const LeftOut& at = list[k];
    const bool is_later = k >= 6;
    EXPECT_EQ(at.segment, is_later ? "row_2" : "row_0");
    EXPECT_EQ(at.caused_by, "row_0");
    EXPECT_DOUBLE_EQ(at.position.x(), 0.01 * at.index);
    EXPECT_EQ(at.verdict.verdict, at.index < 7 ? Verdict::gouge : Verdict::jump) << at.index;
    if (is_later || at.index < 3) {
      EXPECT_EQ(at.kind, LeftOutKind::with_others);
      EXPECT_EQ(at.reason, "less than 35.0 mm of the row is left here, or an earlier pass left it out");
    } else {
      EXPECT_EQ(at.kind, at.index == 3 ? LeftOutKind::fails : LeftOutKind::way_fails);
      EXPECT_EQ(at.reason, at.index == 3 ? "" : "the way to it or from it fails");
    }
  }
  // 2 rows of 100 mm lose all but 40 mm each.
  EXPECT_NEAR(leftOutShare(whole.path, partial.path), 0.12 / 0.4, 1e-12);
}

TEST(PartialNotices, NamesStretches) {
  const auto out = [](int segment, int index, Verdict verdict, LeftOutKind kind = LeftOutKind::fails) {
    const std::string row = "row_" + std::to_string(segment);
    return LeftOut{row, index, Vector3::Zero(), kind, verdictAt(segment, index, verdict), row, "why"};
  };
  const std::vector<LeftOut> list = {out(1, 4, Verdict::gouge),
                                     out(1, 5, Verdict::gouge),
                                     out(1, 6, Verdict::gouge, LeftOutKind::with_others),
                                     out(1, 7, Verdict::jump, LeftOutKind::with_others),
                                     out(1, 8, Verdict::jump, LeftOutKind::way_fails),
                                     out(3, 8, Verdict::speed)};
  const auto lines = partialNotices(list, 0.125, 3);
  ASSERT_EQ(lines.size(), 5U);
  EXPECT_THAT(lines[0], HasSubstr("PARTIAL PROGRAM: 6 waypoints, 12.50 % of"));
  EXPECT_EQ(lines[1], "- left out: row_1 waypoints 4 to 5: gouge");
  EXPECT_EQ(lines[2], "- left out: row_1 waypoints 6 to 7: with others");
  EXPECT_EQ(lines[3], "- left out: row_1 waypoints 8 to 8: the way to it or from it, jump");
  EXPECT_EQ(lines[4], "- and 1 stretches more, see report.json");
  EXPECT_TRUE(partialNotices({}, 0.0).empty());
}

}  // namespace
}  // namespace scan_to_path::pipeline
