#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "mesh/file_formats.hpp"

namespace myo::mesh {

/// Numbers of one array of a VTK file. Integers are exact up to 2^53, far above any mesh size.
using VtkArray = std::vector<double>;

/// Appends raw numbers of a VTK type.
/// @param type   "Float64", "double", "Int32", "vtktypeint64", ...
/// @param bytes  whole numbers of that type
/// @return       false for an unknown type or a number of bytes that is not a multiple of its size
bool append_vtk_numbers(std::string_view type, std::string_view bytes, bool big_endian, VtkArray& numbers);

/// Bytes per number of a VTK type name; 0 if unknown.
std::size_t vtk_number_size(std::string_view type);

/// Adds the volume cells of one piece of a file. Cell c has the nodes connectivity[offsets[c - 1]] ...
/// connectivity[offsets[c] - 1].
///
/// @param types       VTK type of each cell
/// @param first_node  added to all node numbers
/// @param regions     number of each cell; empty: none
/// Errors: offsets outside of the array, unsupported or mixed cells, node numbers out of range.
Result<void> add_vtk_cells(const VtkArray& connectivity, const VtkArray& offsets, const VtkArray& types,
                           std::size_t first_node, const std::filesystem::path& path, CellSoup& soup,
                           const VtkArray& regions = {});

/// Position of the array that numbers the cells' regions among the integer arrays of the cells: one of a usual name, or
/// the only one; -1: none.
int region_array(const std::vector<std::string>& names);

/// Adds polygons or triangle strips of one piece; arguments as in add_vtk_cells().
Result<void> add_vtk_polygons(const VtkArray& connectivity, const VtkArray& offsets, bool strips,
                              std::size_t first_vertex, const std::filesystem::path& path, PolygonSoup& soup);

}  // namespace myo::mesh
