// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "scan_to_path/common/output_directory.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "scan_to_path/common/error.h"

namespace scan_to_path {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& what, const fs::path& path, int error) {
  throw InputError("cannot " + what + " " + path.string() + ": " + std::strerror(error));
}

void writeAll(int file, const fs::path& path, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(file, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail("write", path, errno);
    content.remove_prefix(static_cast<std::size_t>(written));
  }
}

void writeFlushed(const fs::path& path, std::string_view content) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file < 0) fail("write", path, errno);
  try {
    writeAll(file, path, content);
    // /dev/full and full disks may report only here.
    if (::fsync(file) != 0 && errno != EINVAL && errno != EROFS) fail("write", path, errno);
  } catch (...) {
    ::close(file);
    throw;
  }
  if (::close(file) != 0) fail("write", path, errno);
}

fs::path withSuffix(const fs::path& path, const char* suffix) {
  return fs::path(path.lexically_normal().string() + suffix);
}

/// A result is replaced whole; what is not of a result must not go with it.
void refuseForeignFiles(const fs::path& directory, const std::function<bool(const std::string&)>& is_ours) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(directory, error)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_regular_file(error) && is_ours(name)) continue;
    throw InputError("cannot replace " + directory.string() + ": it holds " + name +
                     ", which is no file of a result; name another directory");
  }
}

fs::path withoutTrailingSlash(const fs::path& path) {
  const fs::path normal = path.lexically_normal();
  return normal.has_filename() ? normal : normal.parent_path();
}

}  // namespace

OutputDirectory::OutputDirectory(fs::path final_directory, const std::function<bool(const std::string&)>& is_ours)
    : final_(withoutTrailingSlash(final_directory)), part_(withSuffix(final_, ".part")) {
  std::error_code error;
  for (const char* suffix : {"", ".part", ".old"}) refuseForeignFiles(withSuffix(final_, suffix), is_ours);
  if (fs::exists(final_, error) && !fs::is_directory(final_, error)) {
    throw InputError("cannot write " + final_.string() + ": exists and is not a directory");
  }
  fs::remove_all(part_, error);
  if (error) fail("replace", part_, error.value());
  fs::create_directories(part_, error);
  if (error) fail("create", part_, error.value());
}

OutputDirectory::~OutputDirectory() {
  if (committed_) return;
  std::error_code ignored;
  fs::remove_all(part_, ignored);
}

void OutputDirectory::write(const std::string& name, std::string_view content) { writeFlushed(part_ / name, content); }

void OutputDirectory::commit() {
  const fs::path older = withSuffix(final_, ".old");
  std::error_code error;
  fs::remove_all(older, error);
  const bool had_older = fs::exists(final_, error);
  if (had_older) {
    fs::rename(final_, older, error);
    if (error) fail("replace", final_, error.value());
  }
  fs::rename(part_, final_, error);
  if (error) {
    const int reason = error.value();
    if (had_older) fs::rename(older, final_, error);
    fail("create", final_, reason);
  }
  committed_ = true;
  fs::remove_all(older, error);
}

void writeFileAtomically(const fs::path& path, std::string_view content) {
  // A device or pipe, such as /dev/stdout, is written to: a rename would put a file in its place.
  std::error_code unknown;
  const fs::file_status status = fs::status(path, unknown);
  if (fs::is_other(status)) return writeFlushed(path, content);
  const fs::path part = withSuffix(path, ".part");
  try {
    writeFlushed(part, content);
  } catch (...) {
    std::error_code ignored;
    fs::remove(part, ignored);
    throw;
  }
  std::error_code error;
  fs::rename(part, path, error);
  if (error) {
    std::error_code ignored;
    fs::remove(part, ignored);
    fail("write", path, error.value());
  }
}

}  // namespace scan_to_path
