#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/result.hpp"
#include "mesh/surface_mesh.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::mesh {

/// Named field over nodes or cells.
struct MeshField {
    std::string name;        // array name in the file
    Eigen::MatrixXd values;  // components x count, for example 3 x n displacements or 1 x m stresses
};

/// Writes a volume mesh with fields as VTU (XML, appended binary).
///
/// Positions in m. A reader never sees partial content, see write_file().
/// @param point_fields  fields with one column per node (asserted)
/// @param cell_fields   fields with one column per cell (asserted)
/// Error: the file cannot be written.
Result<void> write_vtu(const std::filesystem::path& path, const VolumeMesh& mesh,
                       const std::vector<MeshField>& point_fields = {}, const std::vector<MeshField>& cell_fields = {});

/// Writes a surface as binary STL, in single precision.
///
/// @param metres_per_unit  length of the file's unit [m]
/// Error: the file cannot be written.
Result<void> write_stl(const std::filesystem::path& path, const SurfaceMesh& surface, double metres_per_unit);

/// Writes a ParaView collection, which assigns a time to each file.
///
/// @param times  [s]
/// @param files  one per time (asserted); written as given, relative to the collection
/// Error: the file cannot be written.
Result<void> write_pvd(const std::filesystem::path& path, const std::vector<double>& times,
                       const std::vector<std::filesystem::path>& files);

}  // namespace myo::mesh
