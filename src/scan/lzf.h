// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace scan_to_path::scan {

/// Expands LZF data (the compression of PCD's binary_compressed) to exactly `size` bytes; nothing when the data is
/// not LZF of that size. Takes no more memory than the data can expand to.
std::optional<std::string> expandLzf(std::string_view data, std::size_t size);

}  // namespace scan_to_path::scan
