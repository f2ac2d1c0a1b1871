// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

namespace scan_to_path {

/// Bad input or configuration. `what()` is one line saying what is wrong, where, and which limit it broke;
/// the command line prints it and ends with exit status 2.
class InputError : public std::runtime_error {
public:
  explicit InputError(const std::string& message) : std::runtime_error(message) {}

  /// "WHERE: QUANTITY is VALUE, must be LIMIT", e.g. "samples.csv line 17: voltage is inf, must be finite".
  InputError(const std::string& where, const std::string& quantity, const std::string& value, const std::string& limit)
      : std::runtime_error(where + ": " + quantity + " is " + value + ", must be " + limit) {}
};

/// The user or a caller asked to stop; nothing is left half-written.
class Interrupted : public std::runtime_error {
public:
  Interrupted() : std::runtime_error("interrupted") {}

protected:
  explicit Interrupted(const std::string& why) : std::runtime_error(why) {}
};

/// Somebody looked at what was planned and does not want it: nothing is written.
class Rejected : public Interrupted {
public:
  Rejected() : Interrupted("rejected by the user") {}
};

}  // namespace scan_to_path
