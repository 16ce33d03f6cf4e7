#pragma once

#include <Eigen/Core>

#include <string>

namespace myo::toml {

struct TomlValue;

// Formatting of values for TOML files.

/// Shortest decimal text that parses to the same double.
///
/// @return  always with a decimal point or exponent, so that it is read as a float
std::string toml_number(double value);

/// Quoted string; quotes, backslashes and control characters are escaped.
std::string toml_text(const std::string& text);

/// Key as it stands in a file: bare if possible, otherwise quoted.
std::string toml_key(const std::string& key);

/// TOML array "[a, b, c]".
///
/// @param text  formats one item
template <class Items, class Text>
std::string toml_list(const Items& items, const Text& text) {
    std::string result;
    for (const auto& item : items) result += (result.empty() ? "" : ", ") + text(item);
    return "[" + result + "]";
}

/// A value with all that it holds, on one line: `[1.0, "a"]`, `{box_m = [...], name = "a"}`.
///
/// @param value  without dates, whose text is not kept (asserted)
std::string toml_value_text(const TomlValue& value);

/// TOML array "[x, y, z]".
std::string toml_vector(const Eigen::Vector3d& v);

}  // namespace myo::toml
