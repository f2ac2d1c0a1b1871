// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/pipeline/beyond_range.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace scan_to_path::pipeline {
namespace {

using geometry::Vector3;

struct Index {
  int column = 0;  ///< along the rows
  int row = 0;     ///< across

  bool operator<(const Index& other) const { return row != other.row ? row < other.row : column < other.column; }
  Index operator+(const Index& step) const { return {column + step.column, row + step.row}; }
};

constexpr std::array<Index, 4> directions = {{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

enum class Beyond { no, too_near, too_far };

struct Patch {
  std::size_t part = 0;
  std::size_t other = 0;
  std::size_t near_beams = 0;  ///< that say themselves that they are too near
  std::size_t beams = 0;       ///< without a return, those included
  Vector3 part_sum = Vector3::Zero();
  Vector3 far_end_sum = Vector3::Zero();
  Beyond beyond = Beyond::no;

  bool isPart() const { return part > 0; }
  // What is left of an edge does not make a patch one where something was seen.
  bool isUnseen() const { return part == 0 && beams > other; }
  bool isNear() const { return isUnseen() && 2 * near_beams > beams; }
  Vector3 partMiddle() const { return part_sum / static_cast<double>(part); }
  Vector3 farEnd() const { return far_end_sum / static_cast<double>(beams); }
};

class Grid {
public:
  /// `middle` of a row across: rows lie in the middle of their patches.
  Grid(double length, double width, double middle, double range)
      : length_(length), width_(width), begin_(middle - 0.5 * width), range_(range) {}

  Index indexOf(double x, double y) const {
    return {static_cast<int>(std::floor(x / length_)), static_cast<int>(std::floor((y - begin_) / width_))};
  }

  Patch& at(const Vector3& p) { return patches_[indexOf(p.x(), p.y())]; }

  void mark() {
    markNear();
    for (const auto& entry : patches_) {
      if (!entry.second.isPart()) continue;
      for (const Index& step : directions) markAlong(entry.first, step);
    }
  }

  BeyondRangeLengths lengths(const std::function<bool(double x, double y)>& is_inside) const {
    BeyondRangeLengths lengths;
    for (const auto& entry : patches_) {
      const Patch& patch = entry.second;
      if (patch.beyond == Beyond::no) continue;
      const Vector3 middle = patch.farEnd();
      BeyondRange& where = is_inside(middle.x(), middle.y()) ? lengths.inside : lengths.outside;
      (patch.beyond == Beyond::too_near ? where.too_near : where.too_far) += length_;
    }
    return lengths;
  }

private:
  using Patches = std::map<Index, Patch>;

  /// The next patch with samples; rows that are not quite straight leave one empty now and then.
  Patches::iterator next(const Index& from, const Index& step) {
    constexpr int most_empty = 1;
    Index index = from;
    for (int empty = 0; empty <= most_empty; ++empty) {
      index = index + step;
      const auto found = patches_.find(index);
      if (found != patches_.end()) return found;
    }
    return patches_.end();
  }

  void markNear() {
    std::vector<Index> reached;
    for (const auto& entry : patches_) {
      if (entry.second.isPart()) reached.push_back(entry.first);
    }
    while (!reached.empty()) {
      const Index from = reached.back();
      reached.pop_back();
      for (const Index& step : directions) {
        const auto to = next(from, step);
        if (to == patches_.end() || !to->second.isNear() || to->second.beyond != Beyond::no) continue;
        to->second.beyond = Beyond::too_near;
        reached.push_back(to->first);
      }
    }
  }

  /// Where the part's patches `behind` and `last`, one after the other, lead to in an unseen one.
  Beyond leaves(const Patch& behind, const Patch& last, const Patch& unseen, bool along_row) const {
    const Vector3 a = behind.partMiddle();
    const Vector3 b = last.partMiddle();
    const Vector3 end = unseen.farEnd();
    const int axis = along_row ? 0 : 1;
    const double run = b[axis] - a[axis];
    if (!(std::abs(run) > 0.1 * (along_row ? length_ : width_))) return Beyond::no;
    // Steeper flanks lead anywhere within a row's distance.
    constexpr double steepest = 1.0;
    const double slope = std::clamp((b.z() - a.z()) / run, -steepest, steepest);
    const double z = b.z() + slope * (end[axis] - b[axis]);
    constexpr double margin = 2e-4;  // [m], what a curvature of 1/50 mm adds within 4 mm, and noise
    if (z <= end.z() + margin) return Beyond::too_far;
    if (z >= end.z() + range_ - margin) return Beyond::too_near;
    return Beyond::no;
  }

  void markAlong(const Index& last, const Index& step) {
    auto unseen = next(last, step);
    if (unseen == patches_.end() || !unseen->second.isUnseen()) return;
    const auto behind = next(last, {-step.column, -step.row});
    if (behind == patches_.end() || !behind->second.isPart()) return;
    const Beyond beyond = leaves(behind->second, patches_[last], unseen->second, step.row == 0);
    if (beyond == Beyond::no) return;
    for (; unseen != patches_.end() && unseen->second.isUnseen(); unseen = next(unseen->first, step)) {
      if (unseen->second.beyond == Beyond::no) unseen->second.beyond = beyond;
    }
  }

  double length_;
  double width_;
  double begin_;
  double range_;
  Patches patches_;
};

void addSeen(Grid& grid, const scan::ScanCloud& cloud, const scan::SampleRows& rows,
             const geometry::Frame& T_scan_cloud) {
  std::vector<char> is_part(cloud.size(), 0);
  for (const scan::RowPiece& piece : rows.pieces) {
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const Vector3 p(piece.x[i], piece.y[i], piece.z[i]);
      Patch& patch = grid.at(p);
      ++patch.part;
      patch.part_sum += p;
      is_part[piece.index[i]] = 1;
    }
  }
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (is_part[i] == 0) ++grid.at(T_scan_cloud * cloud[i].getVector3fMap().cast<double>()).other;
  }
}

void addBeams(Grid& grid, const scan::NoReturns& no_returns, const geometry::Frame& T_scan_cloud) {
  for (const auto& beam : no_returns.beams) {
    const Vector3 far_end = T_scan_cloud * beam.far_end.cast<double>();
    Patch& patch = grid.at(far_end);
    ++patch.beams;
    patch.near_beams += beam.is_too_near ? 1 : 0;
    patch.far_end_sum += far_end;
  }
}

}  // namespace

BeyondRangeLengths lengthsBeyondRange(const scan::ScanCloud& cloud, const scan::SampleRows& rows,
                                      const scan::NoReturns& no_returns, double row_distance,
                                      const std::function<bool(double x, double y)>& is_inside) {
  constexpr double samples_in_patch = 10.0;
  const scan::RowPiece& first = rows.pieces.front();
  Grid grid(std::min(samples_in_patch * rows.spacing, row_distance), row_distance, first.y[first.size() / 2],
            no_returns.range);
  const geometry::Frame T_scan_cloud = rows.T_cloud_scan.inverse();
  addSeen(grid, cloud, rows, T_scan_cloud);
  addBeams(grid, no_returns, T_scan_cloud);
  grid.mark();
  return grid.lengths(is_inside);
}

}  // namespace scan_to_path::pipeline
