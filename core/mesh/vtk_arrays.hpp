#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "mesh/file_formats.hpp"

namespace myo::mesh {

/// Numbers of one array of a VTK file. Indices are exact up to 2^53, far above what a mesh can hold.
using VtkArray = std::vector<double>;

/// Appends raw numbers of a VTK type name ("Float64", "double", "Int32", "vtktypeint64", ...). False for an unknown
/// type or a number of bytes that does not fit.
bool append_vtk_numbers(std::string_view type, std::string_view bytes, bool big_endian, VtkArray& numbers);

/// Bytes per number of a VTK type name, 0 when unknown.
std::size_t vtk_number_size(std::string_view type);

/// Adds the volume cells of one piece: cell c has the nodes connectivity[offsets[c - 1]] ... connectivity[offsets[c] -
/// 1]. `first_node` is added to every index. Errors: offsets that run out of the array, unsupported and mixed cells,
/// indices outside the nodes of the soup.
Result<void> add_vtk_cells(const VtkArray& connectivity, const VtkArray& offsets, const VtkArray& types,
                           std::size_t first_node, const std::filesystem::path& path, CellSoup& soup);

/// Adds polygons or triangle strips, likewise.
Result<void> add_vtk_polygons(const VtkArray& connectivity, const VtkArray& offsets, bool strips,
                              std::size_t first_vertex, const std::filesystem::path& path, PolygonSoup& soup);

}  // namespace myo::mesh
