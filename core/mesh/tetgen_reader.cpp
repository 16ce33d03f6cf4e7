#include <limits>

#include "base/files.hpp"
#include "mesh/file_formats.hpp"
#include "mesh/text_scanner.hpp"

namespace myo::mesh {
namespace {

// Replaces comments by blanks. Line ends are kept, so that line numbers in messages stay correct.
std::string without_comments(std::string content) {
    bool comment = false;
    for (char& c : content) {
        if (c == '#') comment = true;
        if (c == '\n') comment = false;
        if (comment) c = ' ';
    }
    return content;
}

// VTK's mid-side nodes 01, 12, 20, 03, 13, 23 as positions in TetGen's order 23, 03, 01, 12, 13, 02 (measured:
// tetrahedralize("o2") on one tetrahedron).
constexpr std::array<std::size_t, 10> from_tetgen{0, 1, 2, 3, 6, 7, 9, 5, 8, 4};

}  // namespace

TetgenFiles tetgen_files(const std::filesystem::path& path) {
    TetgenFiles files{path, path};
    files.nodes.replace_extension(".node");
    files.cells.replace_extension(".ele");
    return files;
}

Result<CellSoup> read_tetgen(const std::filesystem::path& path) {
    const auto [node_path, cell_path] = tetgen_files(path);
    const auto node_file = read_file(node_path);
    if (!node_file) return node_file.error();
    const auto cell_file = read_file(cell_path);
    if (!cell_file) return cell_file.error();
    const std::string node_text = without_comments(*node_file), cell_text = without_comments(*cell_file);

    CellSoup soup;
    TextScanner nodes(node_text, node_path.string());
    long long count = 0, dimension = 0, first = 0;
    if (!nodes.integer(count) || !nodes.integer(dimension) || dimension != 3 || count < 1) {
        return nodes.error("expected '<number of points> 3 ...'");
    }
    // A point takes more than one character; a larger count is an error of the file, found before memory is allocated.
    if (static_cast<std::size_t>(count) > node_text.size())
        return nodes.error("the file is shorter than its number of points says");
    nodes.next_line();
    for (long long i = 0; i < count; ++i) {
        long long number = 0;
        Eigen::Vector3d x;
        if (nodes.at_end())
            return nodes.error("the file ends after " + std::to_string(i).append(" points: it is truncated"));
        if (!nodes.integer(number)) return nodes.error("expected a point number");
        if (i == 0) first = number;
        // TetGen numbers from 0 or 1; gaps would need a map and do not occur in its output.
        if ((first != 0 && first != 1) || number != first + i)
            return nodes.error("points must be numbered from 0 or 1 without gaps");
        for (Eigen::Index a = 0; a < 3; ++a) {
            if (!nodes.number_on_line(x[a])) return nodes.error("a point needs three finite coordinates");
        }
        soup.nodes.push_back(x);
        nodes.next_line();  // attributes and markers
    }

    TextScanner cells(cell_text, cell_path.string());
    long long per_cell = 0;
    if (!cells.integer(count) || !cells.integer(per_cell) || count < 1 || (per_cell != 4 && per_cell != 10)) {
        return cells.error("expected '<number of tetrahedra> <4 or 10> ...'");
    }
    if (static_cast<std::size_t>(count) > cell_text.size())
        return cells.error("the file is shorter than its number of cells says");
    cells.next_line();
    soup.type = per_cell == 4 ? CellType::tet4 : CellType::tet10;
    for (long long c = 0; c < count; ++c) {
        long long number = 0;
        std::array<long long, 10> own{};
        if (cells.at_end())
            return cells.error("the file ends after " + std::to_string(c).append(" cells: it is truncated"));
        if (!cells.integer(number)) return cells.error("expected a cell number");
        for (std::size_t i = 0; i < static_cast<std::size_t>(per_cell); ++i) {
            if (!cells.integer_on_line(own[i]) || own[i] < first ||
                own[i] >= first + static_cast<long long>(soup.nodes.size())) {
                return cells.error("a cell names a point that does not exist");
            }
        }
        for (std::size_t i = 0; i < static_cast<std::size_t>(per_cell); ++i) {
            soup.cells.push_back(static_cast<int>(own[from_tetgen[i]] - first));
        }
        // TetGen writes the region as first attribute (switch A). Anything but an integer is none.
        if (long long region = 0; cells.integer_on_line(region)) soup.regions.push_back(static_cast<int>(region));
        cells.next_line();
    }
    return soup;
}

}  // namespace myo::mesh
