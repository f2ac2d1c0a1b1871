// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "../src/scan/track.h"

#include <gmock/gmock.h>

#include <cmath>

#include "../src/scan/keep_samples.h"
#include "support/expect_input_error.h"
#include "support/tracks.h"

namespace scan_to_path::scan {
namespace {

using testing::ElementsAre;

ScanCloud cloudOf(std::size_t count) {
  ScanCloud cloud;
  for (std::size_t i = 0; i < count; ++i) {
    ScanPoint point;
    point.x = static_cast<float>(i);
    point.y = 0.0F;
    point.z = 1.0F;
    point.line = no_line;
    point.time = 0.01 * static_cast<double>(i);
    cloud.push_back(point);
  }
  return cloud;
}

TEST(KeepSamples, KeepsOrderAndSaysHowManyWent) {
  Track track = test::trackOf({{0, 10}, {1, 11}, {2, 12}, {3, 13}, {4, 14}});
  EXPECT_EQ(keepSamples(track, [](std::size_t i) { return i % 2 == 1; }), 3U);
  EXPECT_THAT(track.x, ElementsAre(1.0, 3.0));
  EXPECT_THAT(track.y, ElementsAre(11.0, 13.0));
  EXPECT_EQ(track.z.size(), 2U);
  EXPECT_THAT(track.index, ElementsAre(1U, 3U));
  EXPECT_EQ(keepSamples(track, [](std::size_t) { return true; }), 0U);
  EXPECT_EQ(keepSamples(track, [](std::size_t) { return false; }), 2U);
  EXPECT_EQ(track.size(), 0U);
}

TEST(MakeTrack, TurnsIntoTheBeamsFrameAndCountsWhatGoes) {
  ScanCloud cloud = cloudOf(8);
  cloud[2].y = std::nanf("");
  cloud[5].line = 4;
  cloud[6].line = 4;
  const Frame T_beam_cloud = geometry::makeFrame({9, 9, 9}, {0, 0, M_PI_2});  // a direction's frame: no translation
  std::vector<Dropped> dropped;
  const Track track = makeTrack(cloud, T_beam_cloud, false, dropped);
  EXPECT_THAT(track.index, ElementsAre(0, 1, 3, 4, 5, 6, 7));
  EXPECT_NEAR(track.x[2], 0.0, 1e-15);
  EXPECT_NEAR(track.y[2], 3.0, 1e-15);
  EXPECT_THAT(dropped, ElementsAre(testing::Field(&Dropped::count, 1U)));
  test::expectInputError([&] { makeTrack(cloud, T_beam_cloud, true, dropped); },
                         "number of finite points on lines is 2, must be at least 4");
}

TEST(MedianSpacing, SamplesThatStandStillDoNotCount) {
  EXPECT_DOUBLE_EQ(medianSpacing(test::trackOf({{0, 0}, {0, 0}, {0, 0}, {3, 4}, {3, 4}, {6, 8}, {6, 9}})), 5.0);
}

TEST(Track, TurnsAndHasAMiddle) {
  Track track = test::trackOf({{1, 2}, {-3, 4}, {0, 8}});
  EXPECT_EQ(middle(track), Vector3(-1.0, 5.0, 0.0));
  rotate(track, Vector2(0.6, 0.8));
  EXPECT_LT((track.at(0) - Vector2(2.2, 0.4)).norm(), 1e-15);  // the axis itself becomes x
}

TEST(CutTrack, AtLongStepsSilencesAndOtherLines) {
  ScanCloud cloud = cloudOf(10);
  cloud[3].x += 0.5F;                                         // a step of 1.5 to it
  for (std::size_t i = 6; i < 10; ++i) cloud[i].time += 1.0;  // a silence before it
  for (std::size_t i = 8; i < 10; ++i) cloud[i].line = 1;
  std::vector<Dropped> dropped;
  const Track track = makeTrack(cloud, Frame::Identity(), false, dropped);
  const auto begins = [&](double step, double silence) {
    std::vector<std::size_t> found;
    std::size_t end = 0;
    for (const Stretch& stretch : cutTrack(cloud, track, step, silence)) {
      EXPECT_EQ(stretch.begin, end);
      end = stretch.end;
      found.push_back(stretch.begin);
    }
    EXPECT_EQ(end, track.size());
    return found;
  };
  EXPECT_THAT(begins(1.2, 0.5), ElementsAre(0, 3, 6, 8));
  EXPECT_THAT(begins(2.0, 0.5), ElementsAre(0, 6, 8));
  EXPECT_THAT(begins(2.0, 2.0), ElementsAre(0, 8));
}

}  // namespace
}  // namespace scan_to_path::scan
