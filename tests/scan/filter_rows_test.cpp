// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/scan/filter_rows.h"

#include <gmock/gmock.h>

#include <cmath>
#include <set>

#include "scan_to_path/common/random.h"
#include "support/expect_input_error.h"

namespace scan_to_path::scan {
namespace {

/// One row along x with the height z(x).
template <class Height>
SampleRows rowOf(Height&& z, int count = 2000, double spacing = 50e-6) {
  SampleRows rows;
  rows.spacing = spacing;
  rows.samples_in = static_cast<std::size_t>(count);
  rows.pieces.emplace_back();
  RowPiece& piece = rows.pieces[0];
  for (int i = 0; i < count; ++i) {
    piece.x.push_back(spacing * i);
    piece.y.push_back(0.0);
    piece.z.push_back(z(spacing * i));
    piece.index.push_back(static_cast<std::uint32_t>(i));
  }
  return rows;
}

double wave(double x) { return 0.02 * std::sin(25.0 * x); }

std::set<std::uint32_t> survivors(const SampleRows& rows) {
  std::set<std::uint32_t> indices;
  for (const RowPiece& piece : rows.pieces) indices.insert(piece.index.begin(), piece.index.end());
  return indices;
}

TEST(FilterRows, NoSpikeSurvivesAndLittleElseGoes) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    SampleRows rows = rowOf([&](double x) { return wave(x) + 2e-6 * random.gaussian(); });
    std::set<std::uint32_t> spikes;
    for (std::uint32_t i = 0; i < 2000; ++i) {
      if (random.uniform() >= 0.01) continue;
      rows.pieces[0].z[i] += (random.uniform() < 0.5 ? 1.0 : -1.0) * random.uniform(0.0002, 0.005);
      spikes.insert(i);
    }
    const auto kept = survivors(filterRows(rows, {}));
    for (const std::uint32_t spike : spikes) EXPECT_EQ(kept.count(spike), 0u) << "seed " << seed << " sample " << spike;
    EXPECT_GE(kept.size() + spikes.size(), 1995u) << "seed " << seed;  // a few between two spikes may go with them
  }
}

TEST(FilterRows, TheThresholdIsWhatFindsThem) {
  SampleRows rows = rowOf(wave);
  rows.pieces[0].z[700] += 0.0003;
  FilterOptions blind;
  blind.spike_floor = 0.001;
  EXPECT_EQ(survivors(filterRows(rows, blind)).count(700), 1u);
  EXPECT_EQ(survivors(filterRows(rows, {})).count(700), 0u);
}

TEST(FilterRows, WhiteNoiseLosesNothing) {
  Random random(3);
  const SampleRows rows = rowOf([&](double x) { return wave(x) + 10e-6 * random.gaussian(); }, 20000);
  EXPECT_GE(sampleCount(filterRows(rows, {})), 19980u);  // 0.1 %
}

TEST(FilterRows, SteepSlopesAndRoofEdgesStay) {
  // 50 degrees, then a roof edge of 80 degrees.
  const SampleRows rows = rowOf([](double x) { return x < 0.05 ? 1.19 * x : 0.0595 - 0.577 * (x - 0.05); });
  const SampleRows filtered = filterRows(rows, {});
  EXPECT_EQ(sampleCount(filtered), 2000u);
  EXPECT_EQ(filtered.pieces.size(), 1u);
}

TEST(FilterRows, DepthJumpsCutAndTellTheSides) {
  // A step of 4 mm up and 24 mm down; one sample sees half of each edge.
  SampleRows rows = rowOf([](double x) { return x < 0.03 ? 0.0 : x < 0.07 ? 0.004 : -0.02; });
  rows.pieces[0].z[600] = 0.0021;
  rows.pieces[0].z[1400] = -0.005;
  const SampleRows filtered = filterRows(rows, {});
  ASSERT_EQ(filtered.pieces.size(), 3u);
  EXPECT_EQ(filtered.pieces[0].begins, PieceEnd::border);
  EXPECT_EQ(filtered.pieces[0].ends, PieceEnd::step_up);
  EXPECT_EQ(filtered.pieces[1].begins, PieceEnd::step_down);
  EXPECT_EQ(filtered.pieces[1].ends, PieceEnd::step_down);
  EXPECT_EQ(filtered.pieces[2].begins, PieceEnd::step_up);
  EXPECT_EQ(sampleCount(filtered), 1998u);
}

TEST(FilterRows, ASpikeBesideASpikeDoesNotCut) {
  SampleRows rows = rowOf(wave);
  rows.pieces[0].z[500] += 0.0004;
  rows.pieces[0].z[501] -= 0.0004;
  const SampleRows filtered = filterRows(rows, {});
  EXPECT_EQ(filtered.pieces.size(), 1u);
  EXPECT_EQ(sampleCount(filtered), 1998u);
}

TEST(FilterRows, EdgeMixturesAtTheVeryEndGo) {
  SampleRows rows = rowOf([](double x) { return x < 0.0999 ? 0.0 : -0.02; });
  const std::size_t edge = 1998;
  rows.pieces[0].z[edge - 1] = -0.0001;  // the spot already sees a little of the ground
  const auto kept = survivors(filterRows(rows, {}));
  EXPECT_EQ(kept.count(edge - 1), 0u);
  EXPECT_EQ(kept.count(edge - 2), 1u);
}

TEST(FilterRows, AGapInAWallIsMeasuredInSpace) {
  // A slope of 5 (79 degrees, no jump) of which 0.45 mm along x are missing: 2.3 mm of the wall.
  SampleRows rows = rowOf([](double x) { return 5.0 * x; });
  const RowPiece whole = rows.pieces[0];
  for (const std::size_t missing : {2U, 9U}) {
    RowPiece holed = subPiece(whole, 0, 600);
    for (std::size_t i = 600 + missing; i < 1200; ++i) {
      holed.x.push_back(whole.x[i]);
      holed.y.push_back(whole.y[i]);
      holed.z.push_back(whole.z[i]);
      holed.index.push_back(whole.index[i]);
    }
    rows.pieces = {holed};
    EXPECT_EQ(filterRows(rows, {}).pieces.size(), missing == 9 ? 2U : 1U);
  }
}

TEST(FilterRows, OnlyLongGapsCut) {
  SampleRows rows = rowOf(wave);
  const auto without = [&](double gap) {
    SampleRows holed = rows;
    RowPiece& piece = holed.pieces[0];
    const auto end = static_cast<std::size_t>(std::lround((0.03 + gap) / 50e-6));
    piece = subPiece(rows.pieces[0], 0, 600);
    const RowPiece rest = subPiece(rows.pieces[0], end, 2000);
    piece.x.insert(piece.x.end(), rest.x.begin(), rest.x.end());
    piece.y.insert(piece.y.end(), rest.y.begin(), rest.y.end());
    piece.z.insert(piece.z.end(), rest.z.begin(), rest.z.end());
    piece.index.insert(piece.index.end(), rest.index.begin(), rest.index.end());
    return filterRows(holed, {});
  };
  EXPECT_EQ(without(0.0015).pieces.size(), 1u);  // in space the wave is longer
  const SampleRows cut = without(0.005);
  ASSERT_EQ(cut.pieces.size(), 2u);
  EXPECT_EQ(cut.pieces[0].ends, PieceEnd::gap);
  EXPECT_EQ(cut.pieces[1].begins, PieceEnd::gap);
}

// A rib of 1 mm is too short to fit a curve to. It is there all the same.
TEST(FilterRows, PiecesTooShortToFitStandInTheWay) {
  const SampleRows rows = filterRows(rowOf([](double x) { return std::abs(x - 0.05) < 0.0005 ? 0.01 : 0.0; }), {});
  ASSERT_EQ(rows.pieces.size(), 2U);
  EXPECT_NEAR(static_cast<double>(rows.obstacles.size()), 20.0, 1.0);
  for (const auto& p : rows.obstacles) {
    EXPECT_NEAR(p.x(), 0.05F, 0.00051F);
    EXPECT_FLOAT_EQ(p.z(), 0.01F);
  }
}

TEST(FilterRows, ThreadsDoNotMatter) {
  Random random(5);
  SampleRows rows = rowOf([&](double x) { return wave(x) + 1e-5 * random.gaussian(); });
  for (int row = 1; row < 7; ++row) {
    rows.pieces.push_back(rows.pieces[0]);
    rows.pieces.back().row = row;
    rows.pieces.back().z[static_cast<std::size_t>(100 * row)] += 0.001;
  }
  const SampleRows one = filterRows(rows, {}, 1);
  const SampleRows four = filterRows(rows, {}, 4);
  ASSERT_EQ(one.pieces.size(), four.pieces.size());
  for (std::size_t i = 0; i < one.pieces.size(); ++i) EXPECT_EQ(one.pieces[i].z, four.pieces[i].z);
}

TEST(FilterRows, RefusesOptionsOutOfRange) {
  FilterOptions options;
  options.spike_threshold = 0.0;
  test::expectInputError([&] { filterRows(rowOf(wave), options); }, "filter.spike_threshold is 0 sigma");
}

}  // namespace
}  // namespace scan_to_path::scan
