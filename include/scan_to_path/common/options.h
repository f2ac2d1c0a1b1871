// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

#include "scan_to_path/common/error.h"

namespace scan_to_path {

/// How a field of an option struct is seen from outside (configuration files, ROS parameters, documents).
///
/// An option struct lists its fields once:
///
///     struct HampelOptions {
///       double threshold = 6.0;
///       template <class Self, class Visitor>
///       static void fields(Self& self, Visitor&& visit) {
///         visit(self.threshold, Field{"threshold", "sigma", "residual that makes a sample a spike", 1.0, 100.0});
///       }
///     };
///
/// and every reader, writer, check and table walks that list. A field's type is bool, int, double,
/// std::optional<double> (unset where no number stands for "not known"), std::string, an enum with EnumNames,
/// Eigen::Vector3d, a std::vector of double, std::string or Eigen::Vector2d, or another option struct.
struct Field {
  const char* name;
  const char* unit = "";
  const char* help = "";
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
};

/// Names of an enum's values, in order from 0: specialise with `static constexpr std::array<const char*, N> names`.
template <class Enum>
struct EnumNames;

template <class Enum>
const char* enumName(Enum value) {
  return EnumNames<Enum>::names[static_cast<std::size_t>(value)];
}

/// The value of an enum by its name; `where` stands in messages. Throws InputError naming the choices.
template <class Enum>
Enum parseEnum(const std::string& where, const std::string& text) {
  const auto& names = EnumNames<Enum>::names;
  std::string choices;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (text == names[i]) return static_cast<Enum>(i);
    choices += (i > 0 ? ", " : "") + std::string(names[i]);
  }
  throw InputError(where, "value", "'" + text + "'", "one of " + choices);
}

namespace detail {
struct AnyVisitor {
  template <class T>
  void operator()(T&, const Field&) const {}
};
}  // namespace detail

/// True for an option struct, that is, one with a static `fields`.
template <class T, class = void>
struct IsOptions : std::false_type {};
template <class T>
struct IsOptions<T, std::void_t<decltype(T::fields(std::declval<T&>(), detail::AnyVisitor{}))>> : std::true_type {};

namespace detail {

inline void checkNumber(double number, const Field& field, const std::string& name) {
  if (std::isfinite(number) && number >= field.min && number <= field.max) return;
  std::ostringstream text;
  text << name << " is " << number << (*field.unit != 0 ? " " : "") << field.unit << ", must be ";
  if (std::isfinite(field.min) || std::isfinite(field.max)) {
    text << "in [" << field.min << ", " << field.max << "]";
  } else {
    text << "finite";
  }
  throw InputError(text.str());
}

}  // namespace detail

/// Throws InputError naming the first number that is not finite or outside its range, as "PATH.NAME is VALUE UNIT,
/// must be in [MIN, MAX]"; ranges hold for every element of a list.
template <class Options>
void validate(const Options& options, const std::string& path) {
  Options::fields(options, [&path](const auto& value, const Field& field) {
    using T = std::decay_t<decltype(value)>;
    const std::string name = path.empty() ? field.name : path + "." + field.name;
    if constexpr (IsOptions<T>::value) {
      validate(value, name);
    } else if constexpr (std::is_same_v<T, std::vector<double>> || std::is_same_v<T, Eigen::Vector3d>) {
      for (long i = 0; i < static_cast<long>(value.size()); ++i) {
        detail::checkNumber(value[i], field, name + "[" + std::to_string(i) + "]");
      }
    } else if constexpr (std::is_same_v<T, std::vector<Eigen::Vector2d>>) {
      for (std::size_t i = 0; i < value.size(); ++i) {
        for (int k = 0; k < 2; ++k) {
          detail::checkNumber(value[i][k], field, name + "[" + std::to_string(i) + "][" + std::to_string(k) + "]");
        }
      }
    } else if constexpr (std::is_same_v<T, std::optional<double>>) {
      if (value) detail::checkNumber(*value, field, name);
    } else if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) {
      detail::checkNumber(static_cast<double>(value), field, name);
    }
  });
}

}  // namespace scan_to_path
