#include <bit>
#include <cstdint>
#include <cstring>

#include "base/files.hpp"
#include "mesh/file_formats.hpp"
#include "mesh/polygon.hpp"
#include "mesh/text_scanner.hpp"

// Own reader, because VTK's frees memory twice on truncated files.

namespace myo::mesh {
namespace {

/// Number types of PLY.
enum class Number { none, i8, u8, i16, u16, i32, u32, f32, f64 };

/// Type of a name in the header, in either spelling; none if it is unknown.
Number number_named(std::string_view word) {
    if (word == "char" || word == "int8") return Number::i8;
    if (word == "uchar" || word == "uint8") return Number::u8;
    if (word == "short" || word == "int16") return Number::i16;
    if (word == "ushort" || word == "uint16") return Number::u16;
    if (word == "int" || word == "int32") return Number::i32;
    if (word == "uint" || word == "uint32") return Number::u32;
    if (word == "float" || word == "float32") return Number::f32;
    if (word == "double" || word == "float64") return Number::f64;
    return Number::none;
}

/// Property of a PLY element: a number or a list of numbers.
struct Property {
    std::string name;
    Number count = Number::none;  // type of a list's length; none: a single number
    Number value = Number::none;
};

/// Element of a PLY: how many there are, and the properties of each in their order in the file.
struct Element {
    std::string name;
    long long count = 0;
    std::vector<Property> properties;
};

enum class Encoding { ascii, little, big };

struct Header {
    Encoding encoding = Encoding::ascii;
    std::vector<Element> elements;
};

/// Parses the header up to "end_header".
Result<Header> read_header(TextScanner& text) {
    Header header;
    bool format = false;
    if (text.word_on_line() != "ply") return text.error("a PLY begins with 'ply'");
    while (text.next_line()) {
        const std::string_view word = text.word_on_line();
        if (word == "end_header") {
            if (!format) return text.error("the PLY header names no format");
            return header;
        }
        if (word == "format") {
            const std::string_view name = text.word_on_line();
            // The version after the format name is always 1.0 and is not checked.
            format = name == "ascii" || name == "binary_little_endian" || name == "binary_big_endian";
            if (!format) return text.error("unknown PLY format");
            header.encoding = name == "ascii"               ? Encoding::ascii
                              : name == "binary_big_endian" ? Encoding::big
                                                            : Encoding::little;
        } else if (word == "element") {
            Element element;
            element.name = text.word_on_line();
            if (!text.integer_on_line(element.count) || element.count < 0 ||
                // An element takes at least one byte, so a larger count means corruption.
                static_cast<std::size_t>(element.count) > text.size()) {
                return text.error("the number of '" + element.name + "' is wrong or more than the file can hold");
            }
            header.elements.push_back(element);
        } else if (word == "property") {
            Property property;
            std::string_view type = text.word_on_line();
            if (type == "list") {
                property.count = number_named(text.word_on_line());
                if (property.count == Number::none) return text.error("unknown type of a list's length");
                type = text.word_on_line();
            }
            property.value = number_named(type);
            property.name = text.word_on_line();
            if (header.elements.empty() || property.value == Number::none)
                return text.error("a property cannot be read");
            header.elements.back().properties.push_back(property);
        } else if (word != "comment" && word != "obj_info" && !word.empty()) {
            return text.error("unknown word in the PLY header");
        }
    }
    return text.error("the PLY ends within its header: it is truncated");
}

// Numbers after the header in any encoding.
class Body {
public:
    /// @param by_lines  a text with a line for every element, so that a line's end ends its element
    Body(TextScanner text, std::string_view bytes, Encoding encoding, bool by_lines)
        : text_(std::move(text)), bytes_(bytes), encoding_(encoding), by_lines_(by_lines) {}

    /// Skips blanks and empty lines before an element.
    void begin_element() {
        if (by_lines_) text_.at_end();
    }
    /// Number of words left on the line of an element; skips them.
    int words_left() {
        int count = 0;
        while (by_lines_ && !text_.word_on_line().empty()) ++count;
        return count;
    }
    int line() const { return text_.line(); }

    /// Next number of a type; false at the end of the file, or of the element's line.
    bool next(Number type, double& value) {
        if (encoding_ == Encoding::ascii)
            return TextScanner::parse(by_lines_ ? text_.word_on_line() : text_.word(), value);
        switch (type) {
            case Number::i8: return take<std::int8_t>(value);
            case Number::u8: return take<std::uint8_t>(value);
            case Number::i16: return take<std::int16_t>(value);
            case Number::u16: return take<std::uint16_t>(value);
            case Number::i32: return take<std::int32_t>(value);
            case Number::u32: return take<std::uint32_t>(value);
            case Number::f32: return take<float>(value);
            case Number::f64: return take<double>(value);
            case Number::none: break;
        }
        return false;
    }

private:
    template <class T>
    /// Next binary number of type T as double; false if the bytes end.
    bool take(double& value) {
        if (bytes_.size() < sizeof(T)) return false;
        std::array<char, sizeof(T)> raw{};
        // Bytes are copied individually: the data are not aligned and may need a byte swap.
        const bool swap = (encoding_ == Encoding::big) != (std::endian::native == std::endian::big);
        for (std::size_t i = 0; i < sizeof(T); ++i) raw[swap ? sizeof(T) - 1 - i : i] = bytes_[i];
        bytes_.remove_prefix(sizeof(T));
        T number;
        std::memcpy(&number, raw.data(), sizeof(T));
        value = static_cast<double>(number);
        return true;
    }

    TextScanner text_;
    std::string_view bytes_;
    Encoding encoding_;
    bool by_lines_;
};

/// True if a text has a line for every element.
bool has_a_line_each(TextScanner text, const Header& header) {
    if (header.encoding != Encoding::ascii) return false;
    // Writers that put several elements on a line give fewer lines than elements.
    long long lines = 0, elements = 0;
    do lines += text.word_on_line().empty() ? 0 : 1;
    while (text.next_line());
    for (const Element& element : header.elements) elements += element.properties.empty() ? 0 : element.count;
    return lines >= elements;
}

/// Lines with more numbers than their element declares.
struct SurplusWords {
    long long lines = 0;
    int line = 0, count = 0;  // of the first
    std::string element;

    void add(const std::string& name, int at, int words) {
        if (words > 0 && lines++ == 0) line = at, count = words, element = name;
    }
    std::string sentence() const {
        return std::to_string(lines) + (lines == 1 ? " line has" : " lines have") +
               " more numbers than the header declares, first line " + std::to_string(line) + ": " + element +
               " with " + std::to_string(count) + " more; they were left out";
    }
};

}  // namespace

Result<PolygonSoup> read_ply(const std::filesystem::path& path) {
    const auto content = read_file(path);
    if (!content) return content.error();
    if (content->empty()) return Error{"the file is empty", path.string()};
    TextScanner text(*content, path.string());
    const auto header = read_header(text);
    if (!header) return header.error();
    // The binary body starts directly after the line of "end_header".
    text.next_line();
    const std::size_t begin = content->find('\n', content->find("end_header"));
    const std::string_view bytes = begin == std::string::npos ? std::string_view()
                                                              : std::string_view(*content).substr(begin + 1);
    Body body(text, bytes, header->encoding, has_a_line_each(text, *header));

    PolygonSoup soup;
    SurplusWords surplus;
    std::vector<std::vector<int>> faces;
    for (const Element& element : header->elements) {
        for (long long e = 0; e < element.count; ++e) {
            Eigen::Vector3d x = Eigen::Vector3d::Constant(std::nan(""));
            std::vector<int> corners;
            body.begin_element();
            for (const Property& property : element.properties) {
                double count = 1.0, value = 0.0;
                const Error short_file{
                    element.name + " " +
                        std::to_string(e).append(" (counted from 0) cannot be read: the PLY is truncated or garbled"),
                    path.string()};
                if (property.count != Number::none && !body.next(property.count, count)) return short_file;
                // A length larger than the file can hold means corruption; checked before the loop.
                if (!(count >= 0.0) || count > static_cast<double>(content->size())) return short_file;
                // Both spellings of the property are in use.
                const bool face = element.name == "face" &&
                                  (property.name == "vertex_indices" || property.name == "vertex_index");
                for (double i = 0.0; i < count; ++i) {
                    if (!body.next(property.value, value)) return short_file;
                    if (face && !(value >= 0.0 && value < 2e9)) return short_file;
                    if (face) corners.push_back(static_cast<int>(value));
                }
                // Positions are recognised by name; other properties such as colours are skipped.
                if (property.name.size() == 1 && property.name[0] >= 'x' && property.name[0] <= 'z')
                    x[property.name[0] - 'x'] = value;
            }
            surplus.add(element.name, body.line(), body.words_left());
            if (element.name == "vertex") soup.vertices.push_back(x);
            if (element.name == "face") faces.push_back(std::move(corners));
        }
    }
    if (surplus.lines > 0) soup.warnings.push_back(surplus.sentence());
    // Faces may precede vertices in the file, so they are triangulated at the end.
    for (const auto& corners : faces) {
        for (const int corner : corners) {
            if (static_cast<std::size_t>(corner) >= soup.vertices.size())
                return Error{"a face names a vertex that does not exist", path.string()};
        }
        for (const auto& triangle : triangles_of(corners, soup.vertices)) soup.triangles.push_back(triangle);
    }
    return soup;
}

}  // namespace myo::mesh
