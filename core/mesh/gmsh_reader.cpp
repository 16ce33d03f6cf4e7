#include <array>
#include <optional>
#include <unordered_map>

#include "base/files.hpp"
#include "base/text.hpp"
#include "mesh/cell_traits.hpp"
#include "mesh/file_formats.hpp"
#include "mesh/text_scanner.hpp"

namespace myo::mesh {
namespace {

// Gmsh element types. Source: Gmsh reference manual, "MSH file format" and "Node ordering".
struct GmshCell {
    int nodes = 0;  // 0: unknown type
    int dimension = 0;
    std::optional<CellType> cell;  // supported volume cell
};

/// Nodes and dimension of an element type, and its cell if meshes may consist of it.
GmshCell gmsh_cell(long long type) {
    for (const CellTraits& traits : all_cell_traits())
        if (traits.gmsh_type == type) return {traits.nodes, 3, traits.type};
    switch (type) {
        case 1: return {2, 1, {}};
        case 2: return {3, 2, {}};
        case 3: return {4, 2, {}};
        case 6: return {6, 3, {}};
        case 7: return {5, 3, {}};
        case 8: return {3, 1, {}};
        case 9: return {6, 2, {}};
        case 10: return {9, 2, {}};
        case 12: return {27, 3, {}};
        case 13: return {18, 3, {}};
        case 14: return {14, 3, {}};
        case 15: return {1, 0, {}};
        case 16: return {8, 2, {}};
        case 17: return {20, 3, {}};
        case 18: return {15, 3, {}};
        case 19: return {13, 3, {}};
        case 20: return {9, 2, {}};
        case 21: return {10, 2, {}};
        case 26: return {4, 1, {}};
        case 27: return {5, 1, {}};
        case 29: return {20, 3, {}};
        default: return {};
    }
}

/// Parser of the versions 2.x and 4.1, ASCII. Unknown sections are skipped.
class GmshParser {
public:
    GmshParser(const std::string& content, const std::string& path) : text_(content, path) {}

    Result<CellSoup> parse() {
        bool format = false, nodes = false, elements = false;
        for (std::string_view word = text_.word(); !word.empty(); word = text_.word()) {
            Result<void> section;
            if (word == "$MeshFormat") {
                section = read_format();
                format = true;
            } else if (!format) {
                return text_.error("expected '$MeshFormat': not a Gmsh mesh of version 2 or 4");
            } else if (word == "$Nodes") {
                section = version_ < 3.0 ? read_nodes_2() : read_nodes_4();
                nodes = true;
            } else if (word == "$Elements") {
                if (!nodes) return text_.error("'$Elements' before '$Nodes'");
                section = version_ < 3.0 ? read_elements_2() : read_elements_4();
                elements = true;
            } else if (word == "$Entities" && version_ > 3.0) {
                section = read_entities_4();
            } else if (word.front() == '$') {
                // Other sections (physical names, periodicity, data) are skipped up to their end mark.
                const std::string end = "$End" + std::string(word.substr(1));
                std::string_view inside = text_.word();
                while (!inside.empty() && inside != end) inside = text_.word();
                if (inside.empty()) return text_.error("'" + end + "' is missing: the file is truncated");
            } else {
                return text_.error("expected a section that begins with '$'");
            }
            if (!section) return section.error();
        }
        if (!format) return text_.error("not a Gmsh mesh");
        if (!nodes || !elements) return text_.error("the mesh ends without nodes or elements: it is truncated");
        return std::move(soup_);
    }

private:
    // Consumes the end mark of a section.
    Result<void> end_of(std::string_view section) {
        if (text_.word() == section) return {};
        return text_.error("expected '" + std::string(section) + "'");
    }

    /// Reads a count. A count larger than the file size is rejected before memory is allocated.
    bool count(long long& value) {
        return text_.integer(value) && value >= 0 && static_cast<std::size_t>(value) <= text_.size();
    }

    Result<void> read_format() {
        long long binary = 0, size = 0;
        if (!text_.number(version_) || !text_.integer(binary) || !text_.integer(size))
            return text_.error("the mesh format cannot be read");
        if (binary != 0) return text_.error("binary Gmsh meshes are not read: save it as ASCII");
        // Version 4.0 has a different block header and is not supported.
        if (version_ != 2.0 && version_ != 2.1 && version_ != 2.2 && version_ != 4.1) {
            return text_.error("this version of the Gmsh format is not read: save it as 2.2 or 4.1");
        }
        return end_of("$EndMeshFormat");
    }

    Result<void> add_node(long long tag) {
        Eigen::Vector3d x;
        for (Eigen::Index a = 0; a < 3; ++a) {
            if (!text_.number(x[a])) return text_.error("a node needs three finite coordinates");
        }
        // Node tags are arbitrary and may have gaps, so they are mapped to indices.
        if (!number_.emplace(tag, static_cast<int>(soup_.nodes.size())).second)
            return text_.error("two nodes have the same number");
        soup_.nodes.push_back(x);
        return {};
    }

    /// Version 4.1: geometric entities of all dimensions. Those of the volumes give the cells their physical numbers.
    Result<void> read_entities_4() {
        std::array<long long, 4> of_dimension{};
        for (long long& number : of_dimension)
            if (!count(number)) return text_.error("the numbers of entities cannot be read");
        for (std::size_t dimension = 0; dimension < 4; ++dimension)
            for (long long e = 0; e < of_dimension[dimension]; ++e)
                if (const auto read = read_entity_4(dimension); !read) return read;
        return end_of("$EndEntities");
    }

    /// An entity: its tag, its bounds (a point has its place), physical tags, and the tags of what bounds it.
    Result<void> read_entity_4(std::size_t dimension) {
        const Error garbled = text_.error("an entity cannot be read: the file is truncated or garbled");
        long long tag = 0, physicals = 0, physical = 0, bounding = 0;
        double skip = 0.0;
        if (!text_.integer(tag)) return garbled;
        for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k)
            if (!text_.number(skip)) return garbled;
        if (!count(physicals)) return garbled;
        for (long long k = 0; k < physicals; ++k) {
            if (!text_.integer(physical)) return garbled;
            if (dimension == 3 && k == 0) physical_[tag] = static_cast<int>(physical);
        }
        if (dimension == 0) return {};
        if (!count(bounding)) return garbled;
        // Boundaries of an entity are read to reach the next one.
        for (long long k = 0; k < bounding; ++k)
            if (!text_.integer(physical)) return garbled;
        return {};
    }

    // Version 2: number of nodes, then tag and position of each.
    Result<void> read_nodes_2() {
        long long total = 0, tag = 0;
        if (!count(total)) return text_.error("the number of nodes cannot be read");
        for (long long i = 0; i < total; ++i) {
            if (!text_.integer(tag)) return text_.error("expected a node number: the file is truncated or garbled");
            if (const auto added = add_node(tag); !added) return added;
        }
        return end_of("$EndNodes");
    }

    // Version 4.1: blocks of nodes per geometric entity.
    Result<void> read_nodes_4() {
        long long blocks = 0, total = 0, skip = 0;
        if (!count(blocks) || !count(total) || !text_.integer(skip) || !text_.integer(skip))
            return text_.error("the header of '$Nodes' cannot be read");
        for (long long b = 0; b < blocks; ++b) {
            long long dimension = 0, parametric = 0, in_block = 0;
            if (!text_.integer(dimension) || !text_.integer(skip) || !text_.integer(parametric) || !count(in_block) ||
                dimension < 0 || dimension > 3) {
                return text_.error("a block of nodes cannot be read: the file is truncated or garbled");
            }
            // Version 4 lists all tags of a block first, then all coordinates.
            std::vector<long long> tags(static_cast<std::size_t>(in_block));
            for (long long& tag : tags) {
                if (!text_.integer(tag)) return text_.error("expected a node number: the file is truncated or garbled");
            }
            for (const long long tag : tags) {
                if (const auto added = add_node(tag); !added) return added;
                double parameter = 0.0;
                // Parametric coordinates follow the position and are not used.
                for (long long p = 0; parametric != 0 && p < dimension; ++p) {
                    if (!text_.number(parameter)) return text_.error("a node's parameter is not a number");
                }
            }
        }
        return end_of("$EndNodes");
    }

    /// Reads the nodes of one element. Elements of lower dimension are read and ignored.
    ///
    /// @param region  number of the volume that the element belongs to
    Result<void> add_element(long long type, int region) {
        const GmshCell kind = gmsh_cell(type);
        // The number of nodes of an unknown type is unknown, so the rest of the file could not be read.
        if (kind.nodes == 0 || (kind.dimension == 3 && !kind.cell)) {
            return text_.error("cells of Gmsh type " +
                               std::to_string(type).append(" are not read: only " + join(cell_type_names())));
        }
        std::vector<int> own(static_cast<std::size_t>(kind.nodes));
        for (int i = 0; i < kind.nodes; ++i) {
            long long tag = 0;
            if (!text_.integer(tag))
                return text_.error("an element's nodes cannot be read: the file is truncated or garbled");
            if (!kind.cell) continue;
            const auto found = number_.find(tag);
            if (found == number_.end())
                return text_.error("an element names node " + std::to_string(tag).append(", which does not exist"));
            // Tags become indices into the list of nodes read so far.
            own[static_cast<std::size_t>(i)] = found->second;
        }
        if (!kind.cell) return {};
        if (!soup_.accepts(*kind.cell)) {
            return text_.error("the mesh mixes " + to_string(soup_.type).append(" and ") +
                               to_string(*kind.cell).append(" cells; one type is needed"));
        }
        // Regions are kept per cell, so elements of lower dimension add none.
        soup_.type = *kind.cell;
        soup_.regions.push_back(region);
        for (const int place : cell_traits(*kind.cell).gmsh_order)
            soup_.cells.push_back(own[static_cast<std::size_t>(place)]);
        return {};
    }

    // Version 2: number, type, tags and nodes of each element.
    Result<void> read_elements_2() {
        long long total = 0, skip = 0, type = 0, tags = 0;
        if (!count(total)) return text_.error("the number of elements cannot be read");
        for (long long e = 0; e < total; ++e) {
            if (!text_.integer(skip) || !text_.integer(type) || !count(tags)) {
                return text_.error("an element cannot be read: the file is truncated or garbled");
            }
            int region = 0;
            for (long long t = 0; t < tags; ++t) {
                if (!text_.integer(skip)) return text_.error("an element's tag is not a number");
                // The physical group comes first, 0 without one: then the geometric entity separates the parts.
                if (t == 0 || (t == 1 && region == 0)) region = static_cast<int>(skip);
            }
            if (const auto added = add_element(type, region); !added) return added;
        }
        return end_of("$EndElements");
    }

    // Version 4.1: blocks of elements of one type.
    Result<void> read_elements_4() {
        long long blocks = 0, skip = 0;
        if (!count(blocks) || !text_.integer(skip) || !text_.integer(skip) || !text_.integer(skip)) {
            return text_.error("the header of '$Elements' cannot be read");
        }
        for (long long b = 0; b < blocks; ++b) {
            long long entity = 0, type = 0, in_block = 0;
            if (!text_.integer(skip) || !text_.integer(entity) || !text_.integer(type) || !count(in_block)) {
                return text_.error("a block of elements cannot be read: the file is truncated or garbled");
            }
            // Without a physical group the geometric entity separates the parts.
            const auto physical = physical_.find(entity);
            const int region = physical == physical_.end() ? static_cast<int>(entity) : physical->second;
            for (long long e = 0; e < in_block; ++e) {
                if (!text_.integer(skip))
                    return text_.error("expected an element number: the file is truncated or garbled");
                if (const auto added = add_element(type, region); !added) return added;
            }
        }
        return end_of("$EndElements");
    }

    TextScanner text_;
    double version_ = 0.0;
    CellSoup soup_;
    std::unordered_map<long long, int> number_;    // node tag to index
    std::unordered_map<long long, int> physical_;  // tag of a volume to its first physical tag
};

}  // namespace

Result<CellSoup> read_gmsh(const std::filesystem::path& path) {
    const auto content = read_file(path);
    if (!content) return content.error();
    if (content->empty()) return Error{"the file is empty", path.string()};
    return GmshParser(*content, path.string()).parse();
}

}  // namespace myo::mesh
