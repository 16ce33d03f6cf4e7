#include <cstdint>
#include <cstring>
#include <limits>

#include "base/files.hpp"
#include "mesh/file_formats.hpp"
#include "mesh/text_scanner.hpp"

namespace myo::mesh {
namespace {

/// Sizes of the binary format.
struct StlReaderFormat {
    std::size_t stl_header_bytes = 84;
    std::size_t triangle_bytes = 50;
};
constexpr StlReaderFormat stl_reader_format;

// Little-endian as specified; all supported platforms are little-endian.
PolygonSoup read_binary(const std::string& content, std::size_t count) {
    PolygonSoup soup;
    soup.vertices.reserve(count * 3);
    for (std::size_t t = 0; t < count; ++t) {
        // The normal comes first, 12 bytes, and is not used: it follows from the order of the corners.
        float corners[9];
        std::memcpy(corners,
                    content.data() + stl_reader_format.stl_header_bytes + t * stl_reader_format.triangle_bytes + 12,
                    sizeof corners);
        for (int i = 0; i < 3; ++i) {
            soup.vertices.emplace_back(double{corners[3 * i]}, double{corners[3 * i + 1]}, double{corners[3 * i + 2]});
        }
        // Every triangle has vertices of its own; weld() merges them.
        const int first = static_cast<int>(soup.vertices.size()) - 3;
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

/// Text form: facets of three vertices each, in one or several solids.
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

/// Binary STL whose size does not agree with its count of triangles: read where it is clear what is meant.
Result<PolygonSoup> read_binary_of_other_size(const std::string& content, std::uint32_t count,
                                              const std::string& path) {
    const StlReaderFormat& format = stl_reader_format;
    const std::size_t held = content.size() - format.stl_header_bytes;
    // Programs that cannot go back to the header leave 0 or all bits set in it.
    const bool no_count = count == 0 || count == std::numeric_limits<std::uint32_t>::max();
    if (no_count && held > 0 && held % format.triangle_bytes == 0) {
        PolygonSoup soup = read_binary(content, held / format.triangle_bytes);
        soup.warnings.push_back("the header names no number of triangles; all " +
                                std::to_string(held / format.triangle_bytes) + " of the file were read");
        return soup;
    }
    const std::size_t needed = std::size_t{count} * format.triangle_bytes;
    if (held < needed)
        return Error{"the STL is truncated: " + std::to_string(count) + " triangles need " +
                         std::to_string(needed + format.stl_header_bytes) + " bytes, it has " +
                         std::to_string(content.size()),
                     path};
    const std::string more = std::to_string(held - needed) + " bytes more than its " + std::to_string(count) +
                             " triangles need";
    // With more bytes behind the triangles than in them the count is likely to be wrong.
    if (held - needed > needed) return Error{"the STL has " + more + ": it is garbled", path};
    PolygonSoup soup = read_binary(content, count);
    soup.warnings.push_back("the STL has " + more + "; they were left out");
    return soup;
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
    if (content->size() >= stl_reader_format.stl_header_bytes && content->size() == expected && count > 0)
        return read_binary(*content, count);

    TextScanner text(*content, path.string());
    const bool has_zero = content->substr(0, 512).find('\0') != std::string::npos;
    if (is(text.word(), "solid") && !has_zero) return read_ascii(*content, path.string());
    if (content->size() < stl_reader_format.stl_header_bytes)
        return Error{"the file is too short for an STL", path.string()};
    if (!has_zero) return Error{"is no STL: neither a text that begins with 'solid' nor binary", path.string()};
    return read_binary_of_other_size(*content, count, path.string());
}

}  // namespace myo::mesh
