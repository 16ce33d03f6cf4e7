#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "measurement/c3d_words.hpp"

namespace myo::measurement {

/// One parameter of the parameter section. Values are decoded from the file on request.
struct C3dParameter {
    enum class Type { text, byte, word, real };
    Type type = Type::byte;
    std::vector<std::size_t> dimensions;  // the first index varies fastest; empty: a single value
    std::size_t offset = 0;               // of the values, from the start of the file [bytes]
    std::size_t count = 0;                // number of values; of characters for text
};

/// The parameter section of a C3D file, addressed by "GROUP:NAME" in capitals.
class C3dParameters {
public:
    C3dParameters(C3dWords words, std::map<std::string, C3dParameter> entries)
        : words_(words), entries_(std::move(entries)) {}

    /// Whether the parameter exists.
    bool contains(const std::string& name) const { return entries_.count(name) > 0; }
    /// Value i as a number, 16-bit words as unsigned; nullopt if absent, too short, or text.
    std::optional<double> number(const std::string& name, std::size_t i = 0) const;
    /// Whether the parameter exists and consists of 16-bit words.
    bool is_word(const std::string& name) const;
    /// Strings of a text parameter as valid UTF-8, without surrounding blanks and zero bytes; empty if absent.
    std::vector<std::string> texts(const std::string& name) const;

private:
    C3dWords words_;
    std::map<std::string, C3dParameter> entries_;
};

/// Reads the records of the parameter section, up to its end mark or the end of its declared blocks.
///
/// @param start  byte offset of the section
/// @param file   file name for messages
/// Errors (with byte offset): a record beyond the end of the file; an unknown type; a record without group.
/// Source: the C3D file format, www.c3d.org, "The parameter section".
Result<C3dParameters> read_c3d_parameters(const C3dWords& words, std::size_t start, const std::string& file);

/// Text without surrounding blanks, tabs and zero bytes and without control characters. Bytes that are not UTF-8 are
/// decoded as Latin-1.
std::string clean_c3d_text(std::string_view text);

}  // namespace myo::measurement
