#include "mesh/vtk_arrays.hpp"

#include <vtkCellType.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <optional>

#include "base/text.hpp"
#include "mesh/cell_traits.hpp"
#include "mesh/polygon.hpp"

// VTK 9.1's own readers access memory out of bounds on corrupt files (2000 damaged files each, legacy binary: 5 of 6
// batches crashed). The arrays are therefore read here and checked before use.

namespace myo::mesh {
namespace {

enum class NumberKind { none, i8, u8, i16, u16, i32, u32, i64, u64, f32, f64 };

/// Number type of a name in the XML or the legacy format.
NumberKind number_kind(std::string_view type) {
    if (type == "Int8" || type == "char" || type == "signed_char" || type == "vtktypeint8") return NumberKind::i8;
    if (type == "UInt8" || type == "unsigned_char" || type == "vtktypeuint8") return NumberKind::u8;
    if (type == "Int16" || type == "short" || type == "vtktypeint16") return NumberKind::i16;
    if (type == "UInt16" || type == "unsigned_short" || type == "vtktypeuint16") return NumberKind::u16;
    if (type == "Int32" || type == "int" || type == "vtktypeint32") return NumberKind::i32;
    if (type == "UInt32" || type == "unsigned_int" || type == "vtktypeuint32") return NumberKind::u32;
    if (type == "Int64" || type == "long" || type == "vtktypeint64" || type == "vtkIdType") return NumberKind::i64;
    if (type == "UInt64" || type == "unsigned_long" || type == "vtktypeuint64") return NumberKind::u64;
    if (type == "Float32" || type == "float") return NumberKind::f32;
    if (type == "Float64" || type == "double") return NumberKind::f64;
    return NumberKind::none;
}

/// Appends the numbers of one type, with byte order conversion.
template <class T>
void append_as(std::string_view bytes, bool big_endian, VtkArray& numbers) {
    // Bytes are copied one by one: the data are not aligned.
    const bool swap = big_endian != (std::endian::native == std::endian::big);
    for (std::size_t at = 0; at < bytes.size(); at += sizeof(T)) {
        std::array<char, sizeof(T)> raw{};
        for (std::size_t i = 0; i < sizeof(T); ++i) raw[swap ? sizeof(T) - 1 - i : i] = bytes[at + i];
        T value;
        std::memcpy(&value, raw.data(), sizeof(T));
        numbers.push_back(static_cast<double>(value));
    }
}

/// Treatment of a VTK cell type: ignore, use or reject.
enum class Keep { no, yes, unsupported };

/// What is to be done with a cell; sets `type` if it is used.
Keep keep(int vtk_type, CellType& type) {
    for (const CellTraits& traits : all_cell_traits())
        if (traits.vtk_type == vtk_type) {
            type = traits.type;
            return Keep::yes;
        }
    switch (vtk_type) {
        case VTK_VOXEL: type = CellType::hex8; return Keep::yes;
        // Cells of lower dimension are ignored.
        case VTK_EMPTY_CELL:
        case VTK_VERTEX:
        case VTK_POLY_VERTEX:
        case VTK_LINE:
        case VTK_POLY_LINE:
        case VTK_TRIANGLE:
        case VTK_TRIANGLE_STRIP:
        case VTK_POLYGON:
        case VTK_PIXEL:
        case VTK_QUAD:
        case VTK_QUADRATIC_EDGE:
        case VTK_QUADRATIC_TRIANGLE:
        case VTK_QUADRATIC_QUAD:
        case VTK_BIQUADRATIC_QUAD:
        case VTK_QUADRATIC_POLYGON: return Keep::no;
        default: return Keep::unsupported;
    }
}

// Node numbers of cell c; empty if offsets or indices are out of bounds.
std::optional<std::vector<int>> nodes_of(std::size_t c, const VtkArray& connectivity, const VtkArray& offsets,
                                         std::size_t first, std::size_t node_count) {
    // Offsets are the ends of the cells. Comparisons are written such that NaN fails.
    const double begin = c == 0 ? 0.0 : offsets[c - 1], end = offsets[c];
    if (!(begin >= 0.0 && begin <= end && end <= static_cast<double>(connectivity.size()))) return std::nullopt;
    std::vector<int> nodes;
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
        const double node = connectivity[i] + static_cast<double>(first);
        if (!(connectivity[i] >= 0.0 && node < static_cast<double>(node_count))) return std::nullopt;
        nodes.push_back(static_cast<int>(node));
    }
    return nodes;
}

/// Error at a cell of the file.
Error bad_cell(std::size_t c, std::string_view what, const std::filesystem::path& path) {
    return {"cell " + std::to_string(c).append(" (counted from 0) ").append(what), path.string()};
}

}  // namespace

std::size_t vtk_number_size(std::string_view type) {
    switch (number_kind(type)) {
        case NumberKind::i8:
        case NumberKind::u8: return 1;
        case NumberKind::i16:
        case NumberKind::u16: return 2;
        case NumberKind::i32:
        case NumberKind::u32:
        case NumberKind::f32: return 4;
        case NumberKind::i64:
        case NumberKind::u64:
        case NumberKind::f64: return 8;
        case NumberKind::none: break;
    }
    return 0;
}

bool append_vtk_numbers(std::string_view type, std::string_view bytes, bool big_endian, VtkArray& numbers) {
    const std::size_t size = vtk_number_size(type);
    if (size == 0 || bytes.size() % size != 0) return false;
    switch (number_kind(type)) {
        case NumberKind::i8: append_as<std::int8_t>(bytes, big_endian, numbers); break;
        case NumberKind::u8: append_as<std::uint8_t>(bytes, big_endian, numbers); break;
        case NumberKind::i16: append_as<std::int16_t>(bytes, big_endian, numbers); break;
        case NumberKind::u16: append_as<std::uint16_t>(bytes, big_endian, numbers); break;
        case NumberKind::i32: append_as<std::int32_t>(bytes, big_endian, numbers); break;
        case NumberKind::u32: append_as<std::uint32_t>(bytes, big_endian, numbers); break;
        case NumberKind::i64: append_as<std::int64_t>(bytes, big_endian, numbers); break;
        case NumberKind::u64: append_as<std::uint64_t>(bytes, big_endian, numbers); break;
        case NumberKind::f32: append_as<float>(bytes, big_endian, numbers); break;
        case NumberKind::f64: append_as<double>(bytes, big_endian, numbers); break;
        case NumberKind::none: return false;
    }
    return true;
}

Result<void> add_vtk_cells(const VtkArray& connectivity, const VtkArray& offsets, const VtkArray& types,
                           std::size_t first_node, const std::filesystem::path& path, CellSoup& soup,
                           const VtkArray& regions) {
    if (types.size() != offsets.size())
        return Error{"has not one type per cell: it is truncated or garbled", path.string()};
    // Only an array with one number per cell can be the regions. Written so that NaN is none.
    const bool numbered = regions.size() == offsets.size() &&
                          std::all_of(regions.begin(), regions.end(), [](double region) {
                              return region >= std::numeric_limits<int>::min() &&
                                     region <= std::numeric_limits<int>::max();
                          });
    for (std::size_t c = 0; c < offsets.size(); ++c) {
        // Values outside of the range of VTK types are mapped to an unsupported type.
        const int vtk_type = types[c] >= 0.0 && types[c] < 256.0 ? static_cast<int>(types[c]) : 255;
        CellType type{};
        const Keep kept = keep(vtk_type, type);
        if (kept == Keep::no) continue;
        if (kept == Keep::unsupported) {
            return bad_cell(c,
                            "is of VTK type " +
                                std::to_string(vtk_type).append(", which is not read: only " + join(cell_type_names())),
                            path);
        }
        // Mixed meshes are rejected: a VolumeMesh has one cell type.
        if (!soup.accepts(type)) {
            return Error{"the mesh mixes " + to_string(soup.type).append(" and ") +
                             to_string(type).append(" cells; one type is needed"),
                         path.string()};
        }
        auto nodes = nodes_of(c, connectivity, offsets, first_node, soup.nodes.size());
        if (!nodes) return bad_cell(c, "names a node that does not exist", path);
        if (nodes->size() != static_cast<std::size_t>(nodes_per_cell(type)))
            return bad_cell(c, "has a wrong number of nodes", path);
        if (vtk_type == VTK_VOXEL) {  // ordered x first, then y: corners 2 and 3, 6 and 7 change places
            std::swap((*nodes)[2], (*nodes)[3]);
            std::swap((*nodes)[6], (*nodes)[7]);
        }
        soup.type = type;
        if (numbered) soup.regions.push_back(static_cast<int>(regions[c]));
        soup.cells.insert(soup.cells.end(), nodes->begin(), nodes->end());
    }
    return {};
}

int region_array(const std::vector<std::string>& names) {
    // Names that mesh generators write: gmsh, meshio, TetGen, FEniCS, Salome, ParaView.
    static constexpr std::array<std::string_view, 11> usual{
        "region",        "regions",   "material",  "MaterialIds", "gmsh:physical", "PhysicalIds",
        "CellEntityIds", "medit:ref", "cell_tags", "attribute",   "RegionId"};
    for (const std::string_view name : usual)
        for (std::size_t i = 0; i < names.size(); ++i)
            if (names[i] == name) return static_cast<int>(i);
    return names.size() == 1 ? 0 : -1;
}

Result<void> add_vtk_polygons(const VtkArray& connectivity, const VtkArray& offsets, bool strips,
                              std::size_t first_vertex, const std::filesystem::path& path, PolygonSoup& soup) {
    for (std::size_t c = 0; c < offsets.size(); ++c) {
        const auto corners = nodes_of(c, connectivity, offsets, first_vertex, soup.vertices.size());
        if (!corners) return bad_cell(c, "names a vertex that does not exist", path);
        if (!strips) {
            for (const auto& triangle : triangles_of(*corners, soup.vertices)) soup.triangles.push_back(triangle);
            continue;
        }
        for (std::size_t i = 2; i < corners->size(); ++i) {
            const std::size_t odd = i % 2;  // every second triangle of a strip has the opposite orientation
            soup.triangles.push_back({(*corners)[i - 2], (*corners)[i - 1 + odd], (*corners)[i - odd]});
        }
    }
    return {};
}

}  // namespace myo::mesh
