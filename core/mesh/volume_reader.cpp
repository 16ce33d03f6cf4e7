#include "mesh/volume_reader.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "base/letter_case.hpp"
#include "mesh/file_formats.hpp"
#include "mesh/mesh_repair.hpp"

namespace myo::mesh {
namespace {

bool is_tetgen(const std::string& extension) { return extension == ".node" || extension == ".ele"; }

/// Selects the reader by the extension.
Result<CellSoup> read_cells(const std::filesystem::path& path) {
    const std::string extension = lower_case(path.extension().string());
    if (extension == ".vtu") return read_vtu(path);
    if (extension == ".vtk") return read_legacy_vtk(path);
    if (extension == ".msh") return read_gmsh(path);
    if (is_tetgen(extension)) return read_tetgen(path);
    return Error{"unknown kind of volume mesh '" + extension + "': .vtu, .vtk, .msh and .node/.ele are read",
                 path.string()};
}

}  // namespace

Result<VolumeMesh> read_volume(const std::filesystem::path& path, double metres_per_unit) {
    if (!(metres_per_unit > 0.0) || !std::isfinite(metres_per_unit))
        return Error{"the length unit must be positive", path.string()};
    const auto soup = read_cells(path);
    if (!soup) return soup.error();

    VolumeMesh mesh;
    mesh.type = soup->type;
    mesh.nodes.resize(3, static_cast<Eigen::Index>(soup->nodes.size()));
    for (std::size_t i = 0; i < soup->nodes.size(); ++i) {
        mesh.nodes.col(static_cast<Eigen::Index>(i)) = metres_per_unit * soup->nodes[i];
    }
    const int per_cell = nodes_per_cell(mesh.type);
    mesh.cells = Eigen::Map<const Eigen::MatrixXi>(soup->cells.data(), per_cell,
                                                   static_cast<Eigen::Index>(soup->cells.size()) / per_cell);
    // Numbers of only some of the cells could not be assigned.
    if (static_cast<Eigen::Index>(soup->regions.size()) == mesh.cell_count()) mesh.regions = soup->regions;
    // Checks node numbers and volumes, and repairs the orientation of mirrored cells.
    return with_positive_cells(std::move(mesh), path.string());
}

std::vector<std::filesystem::path> volume_files(const std::filesystem::path& path) {
    if (!is_tetgen(lower_case(path.extension().string()))) return {path};
    const TetgenFiles files = tetgen_files(path);
    return {files.nodes, files.cells};
}

}  // namespace myo::mesh
