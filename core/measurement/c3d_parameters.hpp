#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "measurement/c3d_words.hpp"

namespace myo::measurement {

/// One parameter of the parameter section; its values stay in the file until they are asked for.
struct C3dParameter {
    enum class Type { text, byte, word, real };
    Type type = Type::byte;
    std::vector<std::size_t> dimensions;  // the first one runs fastest; none = a single value
    std::size_t offset = 0;               // of the values, from the start of the file
    std::size_t count = 0;                // number of values (characters for text)
};

/// The parameter section, addressed by "GROUP:NAME" in capitals.
class C3dParameters {
public:
    C3dParameters(C3dWords words, std::map<std::string, C3dParameter> entries)
        : words_(words), entries_(std::move(entries)) {}

    bool contains(const std::string& name) const { return entries_.count(name) > 0; }
    /// Value i as a number, 16-bit words taken as unsigned; nothing when absent, too short, or text.
    std::optional<double> number(const std::string& name, std::size_t i = 0) const;
    /// Whether the parameter is there and holds 16-bit words.
    bool is_word(const std::string& name) const;
    /// The strings of a text parameter, blanks and zero bytes trimmed, as valid UTF-8; empty when absent.
    std::vector<std::string> texts(const std::string& name) const;

private:
    C3dWords words_;
    std::map<std::string, C3dParameter> entries_;
};

/// Walks the records of the parameter section.
///
/// @param start  byte offset of the section
/// @param file   name for messages
/// Error: a record that runs over the end of the file, an unknown type; says the byte offset.
/// Source: the C3D file format, www.c3d.org, "The parameter section".
Result<C3dParameters> read_c3d_parameters(const C3dWords& words, std::size_t start, const std::string& file);

/// Blanks, tabs and zero bytes removed on both sides, control characters left out; bytes that are no UTF-8 are taken as
/// Latin-1.
std::string clean_c3d_text(std::string_view text);

}  // namespace myo::measurement
