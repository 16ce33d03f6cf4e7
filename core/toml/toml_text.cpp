#include "toml/toml_text.hpp"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cstdio>

#include "toml/toml_value.hpp"

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
        else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F)
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

std::string toml_value_text(const TomlValue& value) {
    assert(value.kind != TomlValue::Kind::date);
    switch (value.kind) {
        case TomlValue::Kind::number: return toml_number(value.number);
        case TomlValue::Kind::boolean: return value.truth ? "true" : "false";
        case TomlValue::Kind::array: return toml_list(value.items, toml_value_text);
        case TomlValue::Kind::table: {
            std::string text;
            for (std::size_t i = 0; i < value.items.size(); ++i)
                text += (i > 0 ? ", " : "") + toml_key(value.keys[i]) + " = " + toml_value_text(value.items[i]);
            return "{" + text + "}";
        }
        default: return toml_text(value.text);
    }
}

std::string toml_vector(const Eigen::Vector3d& v) { return toml_list(v, toml_number); }

}  // namespace myo::toml
