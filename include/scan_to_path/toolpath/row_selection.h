// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace scan_to_path::toolpath {

/// Rows by their numbers, as people write them.
class RowSelection {
public:
  RowSelection() = default;  ///< no row

  static RowSelection all();

  /// "3, 7-9"; "all": every row; empty: none. `name` stands in messages. Throws InputError for anything else.
  static RowSelection parse(const std::string& text, const std::string& name);

  bool contains(int row) const;
  bool empty() const { return ranges_.empty(); }

  /// A number it names that no row up to `last` has; none of "all".
  std::optional<int> beyond(int last) const;

private:
  std::vector<std::pair<int, int>> ranges_;  ///< first and last
};

/// The number in a segment's name: 3 of "row_3", "row_3_1" and "pass_0_row_3"; none of approaches, links and retracts.
std::optional<int> rowNumber(const std::string& segment);

}  // namespace scan_to_path::toolpath
