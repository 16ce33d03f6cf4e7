#include <cstdint>
#include <cstring>

#include "base/files.hpp"
#include "mesh/file_formats.hpp"
#include "mesh/text_scanner.hpp"

namespace myo::mesh {
namespace {

struct StlReaderFormat {
    std::size_t stl_header_bytes = 84;
    std::size_t triangle_bytes = 50;
};
constexpr StlReaderFormat stl_reader_format;

// Little-endian as specified; all supported platforms are little-endian.
PolygonSoup read_binary(const std::string& content, std::uint32_t count) {
    PolygonSoup soup;
    soup.vertices.reserve(std::size_t{count} * 3);
    for (std::uint32_t t = 0; t < count; ++t) {
        float corners[9];
        std::memcpy(corners,
                    content.data() + stl_reader_format.stl_header_bytes + t * stl_reader_format.triangle_bytes + 12,
                    sizeof corners);
        for (int i = 0; i < 3; ++i) {
            soup.vertices.emplace_back(double{corners[3 * i]}, double{corners[3 * i + 1]}, double{corners[3 * i + 2]});
        }
        const int first = static_cast<int>(3 * t);
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    return soup;
}

/// Case-insensitive comparison; `expected` is in lower case.
bool is(std::string_view word, std::string_view expected) {
    if (word.size() != expected.size()) return false;
    for (std::size_t i = 0; i < word.size(); ++i) {
        if (std::tolower(static_cast<unsigned char>(word[i])) != expected[i]) return false;
    }
    return true;
}

Result<PolygonSoup> read_ascii(const std::string& content, const std::string& path) {
    PolygonSoup soup;
    TextScanner text(content, path);
    text.next_line();  // "solid" and a free name
    for (;;) {
        const std::string_view word = text.word();
        if (word.empty()) return text.error("the STL ends before 'endsolid': it is truncated");
        if (is(word, "endsolid")) {
            // A file may contain several solids.
            text.next_line();
            if (text.at_end()) return soup;
            if (!is(text.word(), "solid")) return text.error("expected 'solid' or the end of the STL");
            text.next_line();
            continue;
        }
        double skip = 0.0;
        if (!is(word, "facet")) return text.error("expected 'facet' in the STL");
        // Normals are often NaN or zero in practice and are ignored.
        if (!is(text.word(), "normal")) return text.error("expected 'normal' in the STL");
        for (int i = 0; i < 3; ++i) {
            if (!TextScanner::parse(text.word(), skip)) return text.error("expected a number in the STL");
        }
        if (!is(text.word(), "outer") || !is(text.word(), "loop"))
            return text.error("expected 'outer loop' in the STL");
        const int first = static_cast<int>(soup.vertices.size());
        for (int i = 0; i < 3; ++i) {
            Eigen::Vector3d x;
            if (!is(text.word(), "vertex")) return text.error("expected 'vertex' in the STL");
            for (Eigen::Index a = 0; a < 3; ++a) {
                if (!text.number(x[a])) return text.error("expected a finite number in the STL");
            }
            soup.vertices.push_back(x);
        }
        if (!is(text.word(), "endloop") || !is(text.word(), "endfacet")) {
            return text.error("expected 'endloop' and 'endfacet' in the STL");
        }
        soup.triangles.push_back({first, first + 1, first + 2});
    }
}

}  // namespace

Result<PolygonSoup> read_stl(const std::filesystem::path& path) {
    const auto content = read_file(path);
    if (!content) return content.error();
    if (content->empty()) return Error{"the file is empty", path.string()};
    // The header of a binary file may also begin with "solid", so the file size is checked first.
    std::uint32_t count = 0;
    if (content->size() >= stl_reader_format.stl_header_bytes) std::memcpy(&count, content->data() + 80, sizeof count);
    // 80 bytes of header, a 32-bit count, then 50 bytes per triangle.
    const std::size_t expected = stl_reader_format.stl_header_bytes +
                                 std::size_t{count} * stl_reader_format.triangle_bytes;
    if (content->size() >= stl_reader_format.stl_header_bytes && content->size() == expected)
        return read_binary(*content, count);

    TextScanner text(*content, path.string());
    const bool has_zero = content->substr(0, 512).find('\0') != std::string::npos;
    if (is(text.word(), "solid") && !has_zero) return read_ascii(*content, path.string());
    if (content->size() < stl_reader_format.stl_header_bytes)
        return Error{"the file is too short for an STL", path.string()};
    // Neither text nor a binary file of the right size: the message says which defect is likely.
    if (content->size() < expected) {
        return Error{"the STL is truncated: " + std::to_string(count).append(" triangles need ") +
                         std::to_string(expected).append(" bytes, it has ") + std::to_string(content->size()),
                     path.string()};
    }
    return Error{"the STL has " + std::to_string(content->size() - expected).append(" bytes more than its ") +
                     std::to_string(count).append(" triangles need: it is garbled"),
                 path.string()};
}

}  // namespace myo::mesh
