#pragma once

#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Dense>

#include "mesh/box_mesh.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::test {

/// A folder of its own, removed with its content at the end of the test.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "myoloop_test_XXXXXX").string();
        path_ = ::mkdtemp(name.data());
    }
    ~TemporaryFolder() {
        std::error_code code;
        std::filesystem::remove_all(path_, code);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

inline Box unequal_box() { return {{-0.01, 0.02, 0.005}, {0.05, 0.04, 0.045}}; }

/// One small mesh of each cell type on the same box.
inline std::vector<mesh::VolumeMesh> one_of_each() {
    const Eigen::Vector3i cells(3, 2, 2);
    return {mesh::box_hex_mesh(unequal_box(), cells), mesh::tet_box_mesh(unequal_box(), cells, mesh::CellType::tet4),
            mesh::tet_box_mesh(unequal_box(), cells, mesh::CellType::tet10)};
}

/// Moves the nodes by a smooth map that keeps straight edges straight only on linear cells.
inline mesh::VolumeMesh bent(mesh::VolumeMesh mesh, double strength) {
    for (Eigen::Index i = 0; i < mesh.node_count(); ++i) {
        const Eigen::Vector3d x = mesh.nodes.col(i);
        mesh.nodes.col(i) += strength * Eigen::Vector3d(x[1] * x[2], x[0] * x[0] + x[2] * x[1], x[0] * x[1]);
    }
    return mesh;
}

inline mesh::VolumeMesh rotated(mesh::VolumeMesh mesh) {
    const Eigen::Matrix3d R = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    mesh.nodes = (R * mesh.nodes).eval();
    return mesh;
}

}  // namespace myo::test
