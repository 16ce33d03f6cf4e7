#pragma once

#include <Eigen/Core>

#include <string>

namespace myo::toml {

// Values as they are written into TOML files.

/// The shortest text that reads as the same number.
std::string toml_number(double value);

/// In quotes; control characters are escaped.
std::string toml_text(const std::string& text);

/// "[a, b, c]" of what `text` makes of each item.
template <class Items, class Text>
std::string toml_list(const Items& items, const Text& text) {
    std::string result;
    for (const auto& item : items) result += (result.empty() ? "" : ", ") + text(item);
    return "[" + result + "]";
}

/// "[x, y, z]"
std::string toml_vector(const Eigen::Vector3d& v);

}  // namespace myo::toml
