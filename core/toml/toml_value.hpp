#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"

namespace myo::toml {

/// TOML document as plain values with their locations. Entries keep the order of the file.
///
/// Wraps the TOML library, which is slow to compile and sorts tables by name, so that only one file includes it.
struct TomlValue {
    enum class Kind { text, number, boolean, date, array, table };

    Kind kind = Kind::table;
    std::string text;               // for kind text
    double number = 0.0;            // for kind number, integers included; may be inf or nan
    bool truth = false;             // for kind boolean
    std::vector<TomlValue> items;   // elements of an array, or values of a table
    std::vector<std::string> keys;  // of a table: keys[i] is the key of items[i]
    std::string where;              // "folder/experiment.toml:12", or "--set"

    /// Value of a key in a table; null if absent.
    const TomlValue* find(std::string_view key) const;
    /// The same for a value to be changed.
    TomlValue* find(std::string_view key);
};

/// Type name for messages: "a number", "an array", ...
std::string kind_name(TomlValue::Kind kind);

/// True if both hold the same values. The order of keys and the locations may differ; dates are compared by kind only.
bool same_values(const TomlValue& a, const TomlValue& b);

/// Reads a TOML file.
///
/// @return  the document as a table with the location of every value
/// Errors: missing or unreadable file; larger than 16 MB, thus not written by hand; syntax error, with line.
Result<TomlValue> read_toml(const std::filesystem::path& path);

/// Parses the text of a TOML document.
///
/// @param name  stands in locations in place of the path: "name:12". Empty: "line 12"
/// @return      as read_toml()
/// Errors: syntax error, with line.
Result<TomlValue> parse_toml(std::string_view text, const std::string& name);

/// Parses one value in TOML syntax: "3e5", "[0, 0, -1]", "true". A bare word or file name is read as a string.
///
/// @param where  location recorded for the value and all its elements
/// Errors: malformed text, or more than one value.
Result<TomlValue> parse_toml_value(std::string_view text, const std::string& where);

}  // namespace myo::toml
