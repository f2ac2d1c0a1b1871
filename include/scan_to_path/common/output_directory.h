// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace scan_to_path {

/// A result directory that appears whole or not at all: files are written to `<final>.part`, and commit() renames
/// it into place. Without commit() the part directory is removed and an older result stays as it was.
class OutputDirectory {
public:
  /// Creates `<final>.part`, replacing a left-over one. `is_ours` tells the names of files that a result may hold:
  /// a directory that holds anything else is somebody's own, and is refused rather than replaced.
  /// Throws InputError when it is, or when the part directory cannot be made.
  OutputDirectory(std::filesystem::path final_directory, const std::function<bool(const std::string&)>& is_ours);
  ~OutputDirectory();
  OutputDirectory(const OutputDirectory&) = delete;
  OutputDirectory& operator=(const OutputDirectory&) = delete;

  /// Writes a file into the part directory, flushed to disk. Throws InputError, e.g. when the disk is full.
  void write(const std::string& name, std::string_view content);

  /// Replaces the final directory by the part directory; files of the older result that this one does not have
  /// are gone with it. Throws InputError and leaves the older result when it cannot.
  void commit();

  const std::filesystem::path& finalDirectory() const { return final_; }

private:
  std::filesystem::path final_;
  std::filesystem::path part_;
  bool committed_ = false;
};

/// Writes one file through `<path>.part` and a rename; a device or pipe directly. Throws InputError.
void writeFileAtomically(const std::filesystem::path& path, std::string_view content);

}  // namespace scan_to_path
