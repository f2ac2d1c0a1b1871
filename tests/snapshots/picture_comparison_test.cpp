// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "picture_comparison.h"

#include <gmock/gmock.h>

namespace scan_to_path::test_support {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const DisplayColour blue = {"Line", QColor(0, 0, 100), QColor(0, 0, 255)};

/// 200 x 200, white, with a blue bar of `rows` rows: 0.5 % of the pixels are one row.
QImage barOf(int rows) {
  QImage picture(200, 200, QImage::Format_RGB32);
  picture.fill(Qt::white);
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < 200; ++x) picture.setPixelColor(x, y, QColor(0, 0, 180));
  }
  return picture;
}

TEST(PictureComparison, FindsNothingWrongWithTheSamePicture) {
  EXPECT_THAT(compare(barOf(10), barOf(10), {blue}), IsEmpty());
}

TEST(PictureComparison, AllowsHalfAPercentOfThePixelsAndNotMore) {
  EXPECT_THAT(compare(barOf(10), barOf(11), {blue}), IsEmpty());
  EXPECT_THAT(compare(barOf(10), barOf(12), {blue}), ElementsAre(HasSubstr("of the pixels differ")));
}

TEST(PictureComparison, AllowsADifferenceOfSixteenAndNotMore) {
  QImage golden(10, 10, QImage::Format_RGB32);
  QImage picture = golden;
  golden.fill(QColor(100, 100, 100));
  picture.fill(QColor(100, 116, 100));
  EXPECT_EQ(differingShare(golden, picture), 0.0);
  picture.fill(QColor(100, 100, 117));
  EXPECT_EQ(differingShare(golden, picture), 1.0);
}

TEST(PictureComparison, MissesAThinDisplayThatIsGone) {
  // 350 of 400 x 200 pixels are 0.44 %: the first rule alone would let that pass.
  QImage golden(400, 200, QImage::Format_RGB32);
  golden.fill(Qt::white);
  const QImage without = golden;
  for (int x = 0; x < 350; ++x) golden.setPixelColor(x, 100, QColor(0, 0, 200));
  EXPECT_LE(differingShare(golden, without), differing_share);
  EXPECT_THAT(compare(golden, without, {blue}), ElementsAre(HasSubstr("Line covers 0 of 350 pixels")));
}

TEST(PictureComparison, SaysThatAGoldenPictureShowsTooLittle) {
  const QImage picture = barOf(1).copy(0, 0, 90, 100);
  EXPECT_THAT(compare(picture, picture, {blue}), ElementsAre(HasSubstr("only 90 pixels in the golden")));
}

TEST(PictureComparison, TakesOtherSizesForOtherPictures) {
  EXPECT_EQ(differingShare(barOf(1), QImage(200, 100, QImage::Format_RGB32)), 1.0);
  EXPECT_EQ(differingShare(QImage(), QImage()), 1.0);
}

}  // namespace
}  // namespace scan_to_path::test_support
