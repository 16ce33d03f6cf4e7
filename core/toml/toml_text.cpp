#include "toml/toml_text.hpp"

#include <algorithm>
#include <charconv>
#include <cstdio>

namespace myo::toml {

std::string toml_number(double value) {
    char text[40];
    const auto [end, code] = std::to_chars(text, text + sizeof text, value);
    std::string result(text, end);
    return result.find_first_of(".en") == std::string::npos ? result + ".0"
                                                            : result;  // TOML distinguishes the integer 3 from 3.0
}

std::string toml_text(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        char escaped[8];
        if (c == '"' || c == '\\')
            result += std::string("\\") + c;
        else if (static_cast<unsigned char>(c) < 0x20)
            std::snprintf(escaped, sizeof escaped, "\\u%04x", static_cast<unsigned>(c)), result += escaped;
        else
            result += c;
    }
    return result + "\"";
}

std::string toml_key(const std::string& key) {
    const auto bare = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    };
    return !key.empty() && std::all_of(key.begin(), key.end(), bare) ? key : toml_text(key);
}

std::string toml_vector(const Eigen::Vector3d& v) { return toml_list(v, toml_number); }

}  // namespace myo::toml
