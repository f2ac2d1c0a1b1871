// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

namespace scan_to_path {

/// Calls `work(begin, end)` over contiguous chunks of [0, count) on up to `threads` threads (0: all of them).
/// Each index is worked on by itself and writes only its own slot, so the result does not depend on `threads`.
/// The exception of the lowest chunk that threw is rethrown after all have ended.
void parallelFor(std::size_t count, int threads, const std::function<void(std::size_t, std::size_t)>& work);

}  // namespace scan_to_path
