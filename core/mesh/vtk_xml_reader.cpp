#include <vtkDataCompressor.h>
#include <vtkLZ4DataCompressor.h>
#include <vtkLZMADataCompressor.h>
#include <vtkSmartPointer.h>
#include <vtkZLibDataCompressor.h>

#include <map>

#include "base/files.hpp"
#include "mesh/file_formats.hpp"
#include "mesh/text_scanner.hpp"
#include "mesh/vtk_arrays.hpp"
#include "mesh/vtk_session.hpp"

// Source: VTK file formats, "XML file formats": ASCII, base64 and appended arrays, plain or compressed in blocks.

namespace myo::mesh {
namespace {

using Attributes = std::map<std::string, std::string, std::less<>>;

/// XML tag with its attributes.
struct Tag {
    std::string name;  // "/Name" for an end tag
    Attributes attributes;
    bool empty = false;  // self-closing <Name ... />
};

std::string_view value_of(const Attributes& attributes, std::string_view key) {
    const auto found = attributes.find(key);
    return found == attributes.end() ? std::string_view() : std::string_view(found->second);
}

// <DataArray> element with its undecoded text.
struct ArrayText {
    Attributes attributes;
    std::string_view text;
};

/// Arrays of a <Piece> by section.
struct Piece {
    std::map<std::string, std::vector<ArrayText>, std::less<>> sections;  // Points, Cells, Polys, Strips
};

/// Minimal parser for the XML subset of VTK files. Arrays are located first and decoded on request.
class XmlVtkParser {
public:
    XmlVtkParser(std::string_view content, std::filesystem::path path) : content_(content), path_(std::move(path)) {}

    Error broken(const std::string& why) const {
        return {"the VTK file is truncated or garbled: " + why, path_.string()};
    }

    // Locates the pieces and their arrays without decoding them.
    Result<std::vector<Piece>> pieces(std::string_view dataset) {
        std::vector<Piece> found;
        std::string section;
        bool closed = false, right_kind = false;
        Tag tag;
        while (!closed) {
            if (!next_tag(tag)) return broken("its end is missing");
            if (tag.name == "VTKFile") {
                right_kind = value_of(tag.attributes, "type") == dataset;
                if (!right_kind) return Error{"is not a VTK file of type " + std::string(dataset), path_.string()};
                big_endian_ = value_of(tag.attributes, "byte_order") == "BigEndian";
                // Files before version 1.0 have no header type and use 32-bit sizes.
                header_type_ = tag.attributes.contains("header_type")
                                   ? std::string(value_of(tag.attributes, "header_type"))
                                   : "UInt32";
                compressor_ = value_of(tag.attributes, "compressor");
            } else if (tag.name == "Piece") {
                found.emplace_back();
                section.clear();
            } else if (tag.name == "Points" || tag.name == "Cells" || tag.name == "Polys" || tag.name == "Strips" ||
                       tag.name == "CellData") {
                section = tag.empty ? "" : tag.name;  // PointData is skipped
            } else if (tag.name == "DataArray") {
                std::string_view text;
                if (!tag.empty) {
                    const std::size_t end = content_.find('<', at_);
                    if (end == std::string_view::npos) return broken("an array has no end");
                    text = content_.substr(at_, end - at_);
                }
                if (!section.empty() && !found.empty())
                    found.back().sections[section].push_back({tag.attributes, text});
            } else if (!section.empty() && tag.name == "/" + section) {
                section.clear();
            } else if (tag.name == "AppendedData") {
                // Appended data start after '_' and may contain any bytes, so their end is searched from the end of the
                // file.
                const std::size_t mark = content_.find('_', at_);
                const std::size_t end = content_.rfind("</AppendedData>");
                if (mark == std::string_view::npos || end == std::string_view::npos || end <= mark)
                    return broken("the appended data");
                appended_ = content_.substr(mark + 1, end - mark - 1);
                appended_raw_ = value_of(tag.attributes, "encoding") == "raw";
                at_ = end;
            } else if (tag.name == "/VTKFile") {
                closed = true;
            }
        }
        if (!right_kind) return Error{"is not a VTK file", path_.string()};
        return found;
    }

    /// Decodes an array of any format.
    Result<VtkArray> decode(const ArrayText& array) const {
        const std::string_view type = value_of(array.attributes, "type"), format = value_of(array.attributes, "format");
        VtkArray numbers;
        // ASCII is the default of the format.
        if (format == "ascii" || format.empty()) {
            TextScanner text(array.text, path_.string());
            for (std::string_view word = text.word(); !word.empty(); word = text.word()) {
                double value = 0.0;
                if (!TextScanner::parse(word, value)) return broken("an array holds something that is not a number");
                numbers.push_back(value);
            }
            return numbers;
        }
        std::string_view encoded = array.text;
        bool raw = false;
        if (format == "appended") {
            std::size_t offset = 0;
            if (!TextScanner::parse(value_of(array.attributes, "offset"), offset) || offset > appended_.size())
                return broken("an offset");
            // Offsets count from the mark '_' of the appended data.
            encoded = appended_.substr(offset);
            raw = appended_raw_;
        }
        std::string bytes;
        const std::string why = compressor_.empty() ? plain(encoded, raw, bytes) : compressed(encoded, raw, bytes);
        if (!why.empty() || !append_vtk_numbers(type, bytes, big_endian_, numbers))
            return broken(why.empty() ? "an array's type or length" : why);
        return numbers;
    }

private:
    /// Next tag; comments and declarations are skipped. False at the end of the file.
    bool next_tag(Tag& tag) {
        for (;;) {
            at_ = content_.find('<', at_);
            if (at_ == std::string_view::npos) return false;
            // A comment may contain '>', so it needs its own end mark.
            const bool comment = content_.substr(at_, 4) == "<!--";
            const std::size_t end = content_.find(comment ? "-->" : ">", at_);
            if (end == std::string_view::npos) return false;
            std::string_view inside = content_.substr(at_ + 1, end - at_ - 1);
            at_ = end + (comment ? 3 : 1);
            if (comment || inside.empty() || inside.front() == '?' || inside.front() == '!') continue;
            return split(inside, tag);
        }
    }

    /// Splits the inside of a tag into name and attributes; false if malformed.
    static bool split(std::string_view inside, Tag& tag) {
        tag = {};
        if (inside.back() == '/') {
            tag.empty = true;
            inside.remove_suffix(1);
        }
        const auto name_end = std::min(inside.find_first_of(" \t\r\n"), inside.size());
        tag.name = inside.substr(0, name_end);
        std::size_t at = name_end;
        for (;;) {
            at = inside.find_first_not_of(" \t\r\n", at);
            if (at == std::string_view::npos) return true;
            const std::size_t equals = inside.find('=', at);
            if (equals == std::string_view::npos || equals + 1 >= inside.size()) return false;
            const char quote = inside[equals + 1];
            // Attribute values may use either kind of quote.
            if (quote != '"' && quote != '\'') return false;
            const std::size_t close = inside.find(quote, equals + 2);
            if (close == std::string_view::npos) return false;
            tag.attributes.emplace(inside.substr(at, equals - at), inside.substr(equals + 2, close - equals - 2));
            at = close + 1;
        }
    }

    // Takes n bytes from the front. Base64 is padded per block: n bytes are (n + 2) / 3 * 4 letters.
    static bool take(std::string_view& encoded, bool raw, std::size_t n, std::string& bytes) {
        if (raw) {
            if (n > encoded.size()) return false;
            bytes.assign(encoded.substr(0, n));
            encoded.remove_prefix(n);
            return true;
        }
        const auto blank = [](char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; };
        if (n > encoded.size()) return false;
        bytes.clear();
        unsigned buffer = 0;
        int letters = 0;
        std::size_t at = 0;
        const std::size_t wanted = (n + 2) / 3 * 4;
        for (std::size_t seen = 0; seen < wanted; ++at) {
            if (at >= encoded.size()) return false;
            const char c = encoded[at];
            if (blank(c)) continue;
            unsigned value = 0;
            if (c >= 'A' && c <= 'Z')
                value = static_cast<unsigned>(c - 'A');
            else if (c >= 'a' && c <= 'z')
                value = static_cast<unsigned>(c - 'a') + 26;
            else if (c >= '0' && c <= '9')
                value = static_cast<unsigned>(c - '0') + 52;
            else if (c == '+')
                value = 62;
            else if (c == '/')
                value = 63;
            else if (c != '=')
                return false;
            buffer = buffer << 6 | value;
            ++seen;
            // Four letters hold three bytes.
            if (++letters == 4) {
                for (int shift = 16; shift >= 0; shift -= 8) bytes.push_back(static_cast<char>(buffer >> shift & 0xff));
                buffer = 0, letters = 0;
            }
        }
        encoded.remove_prefix(at);
        bytes.resize(n);
        return true;
    }

    /// Reads `count` numbers of the header type without consuming them.
    bool header(std::string_view encoded, bool raw, std::size_t count, std::vector<std::size_t>& values) const {
        std::string bytes;
        VtkArray numbers;
        const std::size_t size = vtk_number_size(header_type_);
        if (size == 0 || count > content_.size() / size || !take(encoded, raw, count * size, bytes) ||
            !append_vtk_numbers(header_type_, bytes, big_endian_, numbers)) {
            return false;
        }
        values.clear();
        for (const double number : numbers) {
            // No block can be larger than the best compression ratio allows. Protects against huge allocations.
            if (!(number >= 0.0 && number <= 1100.0 * static_cast<double>(content_.size()))) return false;
            values.push_back(static_cast<std::size_t>(number));
        }
        return true;
    }

    // Number of bytes, then the bytes, in one base64 run.
    std::string plain(std::string_view encoded, bool raw, std::string& bytes) const {
        std::vector<std::size_t> size;
        const std::size_t header_bytes = vtk_number_size(header_type_);
        if (!header(encoded, raw, 1, size) || !take(encoded, raw, header_bytes + size[0], bytes))
            return "an array is too short";
        bytes.erase(0, header_bytes);
        return {};
    }

    // Number of blocks, block size, size of the last block, compressed sizes; then the blocks in a second base64 run.
    std::string compressed(std::string_view encoded, bool raw, std::string& bytes) const {
        std::vector<std::size_t> sizes;
        const std::string bad = "a compressed array";
        if (!header(encoded, raw, 3, sizes)) return bad;
        const std::size_t blocks = sizes[0], block_size = sizes[1], last_size = sizes[2];
        if (blocks == 0) return {};
        if (blocks > content_.size() || !header(encoded, raw, 3 + blocks, sizes)) return bad;
        std::size_t total = 0;
        for (std::size_t b = 0; b < blocks; ++b) {
            total += sizes[3 + b];
            // The compressed blocks cannot be larger than the file.
            if (total > content_.size()) return bad;
        }
        std::string packed;
        if (!take(encoded, raw, (3 + blocks) * vtk_number_size(header_type_), packed) ||
            !take(encoded, raw, total, packed))
            return bad;
        // Largest expansion of the supported compressors, as in header().
        const std::size_t limit = 1100 * content_.size();

        const VtkSession session;
        vtkSmartPointer<vtkDataCompressor> compressor;
        if (compressor_ == "vtkZLibDataCompressor")
            compressor = vtkSmartPointer<vtkZLibDataCompressor>::New();
        else if (compressor_ == "vtkLZ4DataCompressor")
            compressor = vtkSmartPointer<vtkLZ4DataCompressor>::New();
        else if (compressor_ == "vtkLZMADataCompressor")
            compressor = vtkSmartPointer<vtkLZMADataCompressor>::New();
        else
            return "an unknown compression";
        std::size_t from = 0;
        for (std::size_t b = 0; b < blocks; ++b) {
            // A last size of 0 means that the last block is complete.
            const std::size_t size = b + 1 == blocks && last_size > 0 ? last_size : block_size;
            const std::size_t begin = bytes.size();
            if (size > limit || begin + size > limit) return bad;
            bytes.resize(begin + size);
            const std::size_t done = compressor->Uncompress(
                reinterpret_cast<const unsigned char*>(packed.data() + from), sizes[3 + b],
                reinterpret_cast<unsigned char*>(bytes.data() + begin), size);
            if (done != size) return bad;
            from += sizes[3 + b];
        }
        return {};
    }

    std::string_view content_;
    std::filesystem::path path_;
    std::size_t at_ = 0;
    bool big_endian_ = false, appended_raw_ = false;
    std::string header_type_ = "UInt32", compressor_;
    std::string_view appended_;
};

// Decoded array of the given name in a section; empty if absent.
Result<VtkArray> array_named(const XmlVtkParser& parser, const Piece& piece, std::string_view section,
                             std::string_view name) {
    const auto found = piece.sections.find(section);
    if (found == piece.sections.end()) return VtkArray{};
    for (const ArrayText& array : found->second) {
        if (name.empty() || value_of(array.attributes, "Name") == name) return parser.decode(array);
    }
    return VtkArray{};
}

/// Numbers of the regions of the cells, see region_array(); empty: none that can be read.
VtkArray regions_of(const XmlVtkParser& parser, const Piece& piece) {
    std::vector<std::string> names;
    std::vector<const ArrayText*> arrays;
    if (const auto data = piece.sections.find("CellData"); data != piece.sections.end())
        for (const ArrayText& array : data->second) {
            const std::string_view size = value_of(array.attributes, "NumberOfComponents");
            if (value_of(array.attributes, "type").starts_with("Float") || size.size() > 1 || size > "1") continue;
            names.emplace_back(value_of(array.attributes, "Name"));
            arrays.push_back(&array);
        }
    const int chosen = region_array(names);
    if (chosen < 0) return {};
    const Result<VtkArray> numbers = parser.decode(*arrays[static_cast<std::size_t>(chosen)]);
    return numbers ? *numbers : VtkArray{};  // values besides the geometry never make a mesh unreadable
}

/// Appends the points of a piece.
Result<void> add_points(const XmlVtkParser& parser, const Piece& piece, std::vector<Eigen::Vector3d>& points) {
    const auto x = array_named(parser, piece, "Points", "");
    if (!x) return x.error();
    if (x->size() % 3 != 0) return parser.broken("points");
    for (std::size_t i = 0; i < x->size(); i += 3) points.emplace_back((*x)[i], (*x)[i + 1], (*x)[i + 2]);
    return {};
}

/// Reads all pieces of a file into one soup.
///
/// @param points_of  member of the soup that receives the points
/// @param add_cells  (parser, piece, index of its first point, soup) -> Result<void>
template <class Soup, class AddCells>
Result<Soup> read_pieces(const std::filesystem::path& path, std::string_view kind,
                         std::vector<Eigen::Vector3d> Soup::*points_of, const AddCells& add_cells) {
    const auto content = read_file(path);
    if (!content) return content.error();
    if (content->empty()) return Error{"the file is empty", path.string()};
    XmlVtkParser parser(*content, path);
    const auto pieces = parser.pieces(kind);
    if (!pieces) return pieces.error();
    Soup soup;
    for (const Piece& piece : *pieces) {
        const std::size_t first = (soup.*points_of).size();
        if (const auto points = add_points(parser, piece, soup.*points_of); !points) return points.error();
        if (const Result<void> cells = add_cells(parser, piece, first, soup); !cells) return cells.error();
    }
    return soup;
}

}  // namespace

Result<CellSoup> read_vtu(const std::filesystem::path& path) {
    const auto add_cells = [&](const XmlVtkParser& parser, const Piece& piece, std::size_t first,
                               CellSoup& soup) -> Result<void> {
        const auto connectivity = array_named(parser, piece, "Cells", "connectivity");
        const auto offsets = array_named(parser, piece, "Cells", "offsets");
        const auto types = array_named(parser, piece, "Cells", "types");
        // Missing arrays are empty and are reported by add_vtk_cells() through their lengths.
        for (const auto* part : {&connectivity, &offsets, &types}) {
            if (!*part) return part->error();
        }
        return add_vtk_cells(*connectivity, *offsets, *types, first, path, soup, regions_of(parser, piece));
    };
    return read_pieces(path, "UnstructuredGrid", &CellSoup::nodes, add_cells);
}

Result<PolygonSoup> read_vtp(const std::filesystem::path& path) {
    const auto add_polygons = [&](const XmlVtkParser& parser, const Piece& piece, std::size_t first,
                                  PolygonSoup& soup) -> Result<void> {
        // Vertices and lines of a PolyData set carry no surface and are ignored.
        for (const bool strips : {false, true}) {
            const auto connectivity = array_named(parser, piece, strips ? "Strips" : "Polys", "connectivity");
            const auto offsets = array_named(parser, piece, strips ? "Strips" : "Polys", "offsets");
            if (!connectivity) return connectivity.error();
            if (!offsets) return offsets.error();
            if (const auto added = add_vtk_polygons(*connectivity, *offsets, strips, first, path, soup); !added)
                return added.error();
        }
        return {};
    };
    return read_pieces(path, "PolyData", &PolygonSoup::vertices, add_polygons);
}

}  // namespace myo::mesh
