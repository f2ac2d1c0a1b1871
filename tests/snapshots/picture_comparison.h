// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QImage>
#include <string>
#include <vector>

/// What makes two pictures of a figure the same: see compare.
namespace scan_to_path::test_support {

/// The colours a display draws with: all between two, since light and edges darken and lighten them.
struct DisplayColour {
  std::string display;
  QColor from;
  QColor to;
};

/// Largest difference of a channel that counts as the same. Across processors' vector widths rounding differs by one or
/// two; an edge that moves by a tenth of a pixel changes 0.1 * 255.
constexpr int channel_tolerance = 16;

/// Share of the pixels that may differ by more. Across vector widths some 0.1 % do.
constexpr double differing_share = 0.005;

/// Share of its golden area that a display must cover with its colour.
constexpr double covered_share = 0.5;

/// Pixels that a display must have in the golden picture for its share to say anything.
constexpr int least_golden_pixels = 100;

/// Pixels whose colour lies on the line between the two in RGB, or not far off it.
int pixelsOf(const DisplayColour& colour, const QImage& picture);

/// Share of pixels of which a channel differs by more than the tolerance; 1 for pictures of different sizes.
double differingShare(const QImage& golden, const QImage& picture);

/// What is wrong with the picture, a line each; empty: nothing. Half of the golden's area of each display's colour has
/// to be there too: a display that draws little would not be missed among 0.5 % of the pixels.
std::vector<std::string> compare(const QImage& golden, const QImage& picture,
                                 const std::vector<DisplayColour>& displays);

}  // namespace scan_to_path::test_support
