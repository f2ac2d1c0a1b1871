// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "../src/nurbs/sorted_samples.h"

#include <gmock/gmock.h>

#include <limits>

#include "support/expect_input_error.h"
#include "support/spline_lines.h"

namespace scan_to_path::nurbs {
namespace {

using test::expectInputError;
using test::SampledLine;
using testing::ElementsAre;

std::vector<double> copied(const double* values, std::size_t count) { return {values, values + count}; }

TEST(SortedSamples, RisingOnesAreNotCopied) {
  SampledLine line;
  for (const double u : {0.0, 0.5, 0.5, 2.0}) line.add(u, u, 0.0, 0.0);
  const SortedSamples sorted(line.view());
  EXPECT_EQ(sorted.view().u, line.u.data());
  EXPECT_DOUBLE_EQ(sorted.largestGap(), 1.5);
}

TEST(SortedSamples, OthersAreSortedTogetherAndEqualOnesKeepTheirOrder) {
  SampledLine line;
  line.add(2.0, 20.0, 21.0, 22.0);
  line.add(1.0, 10.0, 11.0, 12.0);
  line.add(2.0, 23.0, 24.0, 25.0);
  line.add(0.5, 5.0, 6.0, 7.0);
  const SortedSamples sorted(line.view());
  const LineSamples& view = sorted.view();
  ASSERT_EQ(view.count, 4U);
  EXPECT_THAT(copied(view.u, 4), ElementsAre(0.5, 1.0, 2.0, 2.0));
  EXPECT_THAT(copied(view.x, 4), ElementsAre(5.0, 10.0, 20.0, 23.0));
  EXPECT_THAT(copied(view.y, 4), ElementsAre(6.0, 11.0, 21.0, 24.0));
  EXPECT_THAT(copied(view.z, 4), ElementsAre(7.0, 12.0, 22.0, 25.0));
  EXPECT_THAT(line.u, ElementsAre(2.0, 1.0, 2.0, 0.5)) << "the caller's own stay as they are";
}

TEST(SortedSamples, RefusesNoneAndParametersThatAreNotFinite) {
  expectInputError([] { SortedSamples(LineSamples{}); }, "number of samples is 0");
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (std::size_t place = 0; place < 3; ++place) {
      SampledLine line;
      for (int i = 0; i < 3; ++i) line.add(i, 0.0, 0.0, 0.0);
      line.u[place] = bad;
      expectInputError([&line] { SortedSamples sorted(line.view()); }, "u of sample " + std::to_string(place));
    }
  }
}

}  // namespace
}  // namespace scan_to_path::nurbs
