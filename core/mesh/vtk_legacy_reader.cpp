#include "base/files.hpp"
#include "mesh/file_formats.hpp"
#include "mesh/text_scanner.hpp"
#include "mesh/vtk_arrays.hpp"

// Source: VTK file formats, "Simple legacy formats", versions 1 to 5.1.

namespace myo::mesh {
namespace {

/// Word in lower case.
std::string lower(std::string_view word) {
    std::string text(word);
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

/// Parser of one file; sections in any order.
class LegacyParser {
public:
    LegacyParser(const std::string& content, std::filesystem::path path) : content_(content), path_(std::move(path)) {}

    Result<CellSoup> parse() {
        if (line().substr(0, 14) != "# vtk DataFile")
            return Error{"does not begin with '# vtk DataFile'", path_.string()};
        line();  // title
        // Keywords are not case-sensitive in the format.
        const std::string encoding = lower(first_word(line()));
        if (encoding != "ascii" && encoding != "binary") return broken("neither ASCII nor BINARY is stated");
        binary_ = encoding == "binary";
        for (std::string word = lower(next_word()); !word.empty(); word = lower(next_word())) {
            Result<void> section;
            if (word == "dataset") {
                if (lower(next_word()) != "unstructured_grid")
                    return Error{"is not a VTK unstructured grid", path_.string()};
            } else if (word == "points") {
                section = read_points();
            } else if (word == "cells") {
                section = read_cells();
            } else if (word == "cell_types") {
                section = read_types();
            } else if (word == "metadata" || word == "information") {
                // Metadata of an array: ends at an empty line.
                line();
                while (at_ < content_.size() && !line().empty()) {}
            } else if (word == "field") {
                section = skip_field();
            } else if (word == "point_data" || word == "cell_data") {
                break;  // values on the mesh, after it
            } else {
                return broken("unknown section");
            }
            if (!section) return section.error();
        }
        if (soup_.nodes.empty() || types_.empty()) return broken("points or cells are missing");
        if (const auto added = add_vtk_cells(connectivity_, offsets_, types_, 0, path_, soup_); !added)
            return added.error();
        return std::move(soup_);
    }

private:
    // Error with the reason for rejecting the file.
    Error broken(const std::string& why) const {
        return {"the VTK file is truncated or garbled: " + why, path_.string()};
    }

    // Rest of the current line, without its end.
    std::string_view line() {
        const std::size_t end = std::min(content_.find('\n', at_), content_.size());
        std::string_view text = std::string_view(content_).substr(at_, end - at_);
        if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
        at_ = std::min(end + 1, content_.size());
        return text;
    }
    static std::string_view first_word(std::string_view text) { return TextScanner(text, "").word(); }

    static bool blank(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }
    /// Next word on any line; empty at the end of the file.
    std::string_view next_word() {
        while (at_ < content_.size() && blank(content_[at_])) ++at_;
        const std::size_t begin = at_;
        while (at_ < content_.size() && !blank(content_[at_])) ++at_;
        return std::string_view(content_).substr(begin, at_ - begin);
    }
    /// Reads a count; a count larger than the file size is rejected.
    bool count(std::size_t& value) {
        long long number = 0;
        if (!TextScanner::parse(next_word(), number) || number < 0 ||
            static_cast<std::size_t>(number) > content_.size())
            return false;
        value = static_cast<std::size_t>(number);
        return true;
    }

    // `n` numbers after the line that announces them. Binary numbers are big-endian.
    bool numbers(std::string_view type, std::size_t n, VtkArray& values) {
        values.clear();
        if (!binary_) {
            for (std::size_t i = 0; i < n; ++i) {
                double value = 0.0;
                if (!TextScanner::parse(next_word(), value)) return false;
                values.push_back(value);
            }
            return true;
        }
        line();
        const std::size_t size = vtk_number_size(type);
        if (size == 0 || n > (content_.size() - at_) / size) return false;
        const bool read = append_vtk_numbers(type, std::string_view(content_).substr(at_, n * size), true, values);
        at_ += n * size;
        return read;
    }

    // "POINTS n type", then 3 n numbers.
    Result<void> read_points() {
        std::size_t n = 0;
        VtkArray values;
        if (!count(n)) return broken("the number of points");
        const std::string type = lower(next_word());
        if (!numbers(type, 3 * n, values)) return broken("points");
        for (std::size_t i = 0; i < n; ++i)
            soup_.nodes.emplace_back(values[3 * i], values[3 * i + 1], values[3 * i + 2]);
        return {};
    }

    // "CELLS n size", then the cells in the layout of the file's version.
    Result<void> read_cells() {
        std::size_t first = 0, second = 0;
        if (!count(first) || !count(second)) return broken("the number of cells");
        const std::size_t before = at_;
        // Version 5.1 announces arrays by name; earlier versions continue with numbers.
        if (lower(next_word()) == "offsets") {  // version 5.1: n + 1 offsets, then the nodes
            std::string type = lower(next_word());
            if (first < 1 || !numbers(type, first, offsets_)) return broken("offsets");
            if (lower(next_word()) != "connectivity") return broken("connectivity is missing");
            type = lower(next_word());
            if (!numbers(type, second, connectivity_)) return broken("connectivity");
            if (offsets_.front() != 0.0) return broken("offsets");
            // The leading 0 is dropped: the offsets are the ends of the cells, as in the XML format.
            offsets_.erase(offsets_.begin());
            return {};
        }
        // Older versions: each cell is its number of nodes followed by the nodes.
        at_ = before;
        VtkArray values;
        if (!numbers("int", second, values)) return broken("cells");
        std::size_t at = 0;
        for (std::size_t c = 0; c < first; ++c) {
            if (at >= values.size() || !(values[at] >= 0.0) || values[at] > static_cast<double>(values.size() - at - 1))
                return broken("cells");
            const auto n = static_cast<std::size_t>(values[at]);
            connectivity_.insert(connectivity_.end(), values.begin() + static_cast<std::ptrdiff_t>(at + 1),
                                 values.begin() + static_cast<std::ptrdiff_t>(at + 1 + n));
            offsets_.push_back(static_cast<double>(connectivity_.size()));
            at += n + 1;
        }
        return {};
    }

    // "CELL_TYPES n", then n type numbers.
    Result<void> read_types() {
        std::size_t n = 0;
        if (!count(n) || !numbers("int", n, types_)) return broken("cell types");
        return {};
    }

    // "FIELD name n", then n times "name components tuples type" and the numbers, for example the time.
    Result<void> skip_field() {
        std::size_t arrays = 0, components = 0, tuples = 0;
        next_word();
        if (!count(arrays)) return broken("field");
        for (std::size_t a = 0; a < arrays; ++a) {
            VtkArray values;
            next_word();
            if (!count(components) || !count(tuples)) return broken("field");
            const std::string type = lower(next_word());
            if (components * tuples > content_.size() || !numbers(type, components * tuples, values))
                return broken("field");
        }
        return {};
    }

    const std::string& content_;
    std::filesystem::path path_;
    std::size_t at_ = 0;
    bool binary_ = false;
    CellSoup soup_;
    VtkArray connectivity_, offsets_, types_;
};

}  // namespace

Result<CellSoup> read_legacy_vtk(const std::filesystem::path& path) {
    const auto content = read_file(path);
    if (!content) return content.error();
    if (content->empty()) return Error{"the file is empty", path.string()};
    return LegacyParser(*content, path).parse();
}

}  // namespace myo::mesh
