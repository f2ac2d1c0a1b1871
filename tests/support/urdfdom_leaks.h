// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

/// urdfdom never frees a description that it refuses when joints form a loop. Tests feed it such descriptions; the leak
/// checker is told to look away from that library. Include in one source of an executable.
extern "C" __attribute__((used)) inline const char* __lsan_default_suppressions() { return "leak:liburdfdom_model\n"; }
