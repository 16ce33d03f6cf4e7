#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/result.hpp"
#include "mesh/surface_mesh.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::mesh {

/// A named array over nodes or cells: components x count, as 3 x n displacements or 1 x m stresses.
struct MeshField {
    std::string name;
    Eigen::MatrixXd values;
};

/// Writes a volume mesh as VTU (XML, appended binary) [m], under a temporary name that is then renamed.
/// Asserts that every field has one column per node, or per cell. Error: the file cannot be written.
Result<void> write_vtu(const std::filesystem::path& path, const VolumeMesh& mesh,
                       const std::vector<MeshField>& point_fields = {}, const std::vector<MeshField>& cell_fields = {});

/// Writes a surface as binary STL; `metres_per_unit` is the length of the file's unit [m].
Result<void> write_stl(const std::filesystem::path& path, const SurfaceMesh& surface, double metres_per_unit);

/// Writes a ParaView collection: which file shows which time [s]. File names are written as given, relative to the
/// collection. Asserts as many times as files.
Result<void> write_pvd(const std::filesystem::path& path, const std::vector<double>& times,
                       const std::vector<std::filesystem::path>& files);

}  // namespace myo::mesh
