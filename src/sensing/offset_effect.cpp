// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/sensing/offset_effect.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "scan_to_path/common/median.h"

namespace scan_to_path::sensing {
namespace {

constexpr std::size_t fewest_in_stretch = 5;  // of a stretch
constexpr double longest_gap = 2.0;           // stretches

struct TimedHeight {
  double time;  // [s]
  double height;
  std::uint32_t index;  // of the sample in the cloud
};

/// Samples of pieces that follow each other without a long gap.
using Sweep = std::vector<TimedHeight>;

double samplePeriod(const scan::SampleRows& rows, const scan::ScanCloud& cloud) {
  std::vector<double> periods;
  for (const auto& piece : rows.pieces) {
    for (std::size_t i = 1; i < piece.size(); ++i) {
      periods.push_back(std::abs(cloud[piece.index[i]].time - cloud[piece.index[i - 1]].time));
    }
  }
  return median(std::move(periods));
}

std::vector<Sweep> sweepsOf(const scan::SampleRows& rows, const scan::ScanCloud& cloud, double longest) {
  std::vector<Sweep> sweeps;
  int row = -1;
  for (const auto& piece : rows.pieces) {
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const double time = cloud[piece.index[i]].time;
      const bool follows = !sweeps.empty() && piece.row == row && std::abs(time - sweeps.back().back().time) <= longest;
      if (!follows) sweeps.emplace_back();
      row = piece.row;
      sweeps.back().push_back({time, piece.z[i], piece.index[i]});
    }
  }
  return sweeps;
}

double medianHeight(const Sweep& sweep, std::size_t begin, std::size_t count) {
  std::vector<double> heights;
  for (std::size_t i = begin; i < begin + count; ++i) heights.push_back(sweep[i].height);
  return median(std::move(heights));
}

class EffectFinder {
public:
  EffectFinder(const scan::ScanCloud& cloud, std::size_t count) : cloud_(cloud), count_(count) {}

  void add(const Sweep& sweep) {
    std::vector<double> heights;
    for (std::size_t i = 0; i + count_ <= sweep.size(); i += count_) heights.push_back(medianHeight(sweep, i, count_));
    for (std::size_t k = 1; k < heights.size(); ++k) compare(heights[k - 1], heights[k], sweep[k * count_]);
    for (std::size_t k = 3; k < heights.size(); ++k) {
      thirds_.push_back(std::abs(heights[k] - 3.0 * heights[k - 1] + 3.0 * heights[k - 2] - heights[k - 3]));
    }
    if (sweep.size() < 2 * count_) return;
    const std::size_t last = sweep.size() - count_;  // what is left over at the end
    compare(medianHeight(sweep, last - count_, count_), medianHeight(sweep, last, count_), sweep[last]);
  }

  OffsetEffect effect() {
    // Third differences of stretches have 20 times their variance, and of smooth parts little else; first ones twice.
    effect_.noise = median(std::move(thirds_)) / (0.6745 * std::sqrt(10.0));
    return effect_;
  }

private:
  void compare(double before, double after, const TimedHeight& sample) {
    const double height = std::abs(after - before);
    if (height <= effect_.height) return;
    effect_.height = height;
    effect_.place = cloud_[sample.index].getVector3fMap().cast<double>();
  }

  const scan::ScanCloud& cloud_;
  std::size_t count_;
  std::vector<double> thirds_;
  OffsetEffect effect_;
};

}  // namespace

OffsetEffect offsetEffect(const scan::SampleRows& rows, const scan::ScanCloud& cloud, double offset) {
  const double period = samplePeriod(rows, cloud);
  if (!(period > 0.0)) return {};
  const std::size_t count = std::max(fewest_in_stretch, static_cast<std::size_t>(std::ceil(offset / period)));
  EffectFinder finder(cloud, count);
  const double stretch = static_cast<double>(count) * period;
  for (const auto& sweep : sweepsOf(rows, cloud, longest_gap * stretch)) finder.add(sweep);
  return finder.effect();
}

}  // namespace scan_to_path::sensing
