#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"

namespace myo::toml {

/// A TOML document as plain values that remember where they stand. Entries keep the order of the file.
///
/// The library behind it is seen by one file only: it is slow to compile, and its tables are sorted by name.
struct TomlValue {
    enum class Kind { text, number, boolean, date, array, table };

    Kind kind = Kind::table;
    std::string text;               // kind text
    double number = 0.0;            // kind number, integers included; may be inf or nan
    bool truth = false;             // kind boolean
    std::vector<TomlValue> items;   // elements of an array, or values of a table
    std::vector<std::string> keys;  // of a table: keys[i] names items[i]
    std::string where;              // "folder/experiment.toml:12", or "--set"

    const TomlValue* find(std::string_view key) const;
    TomlValue* find(std::string_view key);
};

/// "a number", "an array", ... for messages.
std::string kind_name(TomlValue::Kind kind);

/// The document in a file. Errors: missing or unreadable file, one larger than 16 MB (not written by hand), syntax,
/// with line.
Result<TomlValue> read_toml(const std::filesystem::path& path);

/// One value in TOML syntax ("3e5", "[0, 0, -1]", "true"); a bare word or file name counts as text. `where` is given to
/// all of it.
Result<TomlValue> parse_toml_value(std::string_view text, const std::string& where);

}  // namespace myo::toml
