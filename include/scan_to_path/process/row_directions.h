// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "scan_to_path/process/cutting_options.h"
#include "scan_to_path/process/row.h"
#include "scan_to_path/toolpath/row_selection.h"

namespace scan_to_path::process {

/// Which way rows are driven.
class RowDirections {
public:
  /// `reverse_rows` as in path.reverse_rows; throws InputError for what are no row numbers.
  RowDirections(RowOrder order, const std::string& reverse_rows);

  bool isForward(int row) const;

  /// Rows sorted by row in the order in which they are driven: pieces of a row in its own direction.
  std::vector<Row> driven(std::vector<Row> rows) const;

private:
  RowOrder order_;
  toolpath::RowSelection reversed_;
};

/// Throws InputError when the row numbers `text` of option `name` go beyond the part's last row.
void checkThatRowsAreThere(const std::string& text, const std::string& name, int last_row);

}  // namespace scan_to_path::process
