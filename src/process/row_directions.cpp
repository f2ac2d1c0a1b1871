// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/process/row_directions.h"

#include <algorithm>

#include "scan_to_path/common/error.h"

namespace scan_to_path::process {

RowDirections::RowDirections(RowOrder order, const std::string& reverse_rows)
    : order_(order), reversed_(toolpath::RowSelection::parse(reverse_rows, "path.reverse_rows")) {}

bool RowDirections::isForward(int row) const {
  const bool is_forward = order_ == RowOrder::one_way || row % 2 == 0;
  return is_forward != reversed_.contains(row);
}

std::vector<Row> RowDirections::driven(std::vector<Row> rows) const {
  for (auto begin = rows.begin(); begin != rows.end();) {
    const auto end = std::find_if(begin, rows.end(), [&](const Row& row) { return row.row != begin->row; });
    if (!isForward(begin->row)) std::reverse(begin, end);
    begin = end;
  }
  return rows;
}

void checkThatRowsAreThere(const std::string& text, const std::string& name, int last_row) {
  const auto missing = toolpath::RowSelection::parse(text, name).beyond(last_row);
  if (!missing) return;
  throw InputError(name + " names row " + std::to_string(*missing) + ", the part's last one is row " +
                   std::to_string(last_row));
}

}  // namespace scan_to_path::process
