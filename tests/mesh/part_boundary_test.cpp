#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "mesh/face_table.hpp"
#include "mesh/mesh_repair.hpp"
#include "mesh/surface_check.hpp"
#include "mesh/test_meshes.hpp"
#include "mesh/test_surfaces.hpp"
#include "mesh/tetgen_exchange.hpp"
#include "mesh/voxel_mesh.hpp"
#include "support/folder.hpp"

// Boundaries of parts of a mesh, repair of cells, files for the worker that makes tetrahedra, options of voxels.

namespace myo::mesh::part_boundary_test {
namespace {

using testing::HasSubstr;

std::vector<int> sorted(Eigen::VectorXi nodes) {
    std::sort(nodes.begin(), nodes.end());
    return {nodes.begin(), nodes.end()};
}

/// Behind a face lies a cell that has the same face, from which this one lies behind.
TEST(FaceTable, NamesTheCellBehindEachFace) {
    for (const VolumeMesh& mesh : test::one_of_each()) {
        const FaceTable table = face_table(mesh);
        const Eigen::Index faces = mesh.type == CellType::hex8 ? 6 : 4;
        ASSERT_EQ(table.cell.size(), faces * mesh.cell_count());
        Eigen::Index free = 0;
        for (Eigen::Index k = 0; k < table.cell.size(); ++k) {
            EXPECT_EQ(table.cell[k], k / faces);
            const int beyond = table.beyond[k];
            if (beyond < 0) {
                ++free;
                continue;
            }
            int same = 0;
            for (Eigen::Index other = faces * beyond; other < faces * (beyond + 1); ++other)
                same += table.beyond[other] == table.cell[k] &&
                        sorted(table.nodes.col(other)) == sorted(table.nodes.col(k));
            EXPECT_EQ(same, 1) << to_string(mesh.type) << ", face " << k;
        }
        EXPECT_EQ(free, boundary_faces(mesh).count());
    }
}

/// Three cubes in a row; what is left of them has a face where a neighbour was taken away.
TEST(BoundaryOfPart, HasTheFacesTowardsWhatIsLeftOut) {
    const VolumeMesh row = box_hex_mesh({{0, 0, 0}, {3, 1, 1}}, {3, 1, 1});
    const FaceTable table = face_table(row);
    const auto count = [&](std::vector<char> kept) { return boundary_of_part(table, kept).count(); };
    EXPECT_EQ(count({1, 1, 1}), 14);
    EXPECT_EQ(count({1, 1, 0}), 10);
    EXPECT_EQ(count({1, 0, 1}), 12);
    EXPECT_EQ(count({0, 0, 0}), 0);
    const BoundaryFaces middle = boundary_of_part(table, {0, 1, 0});
    ASSERT_EQ(middle.count(), 6);
    EXPECT_TRUE((middle.cell.array() == 1).all());
    // Faces x-, x+, y-, y+, z-, z+ of the cell, turned outward.
    const auto normal = [&](Eigen::Index f) -> Eigen::Vector3d {
        const Eigen::Matrix3Xd X = row.nodes(Eigen::all, middle.nodes.col(f));
        return Eigen::Vector3d(X.col(1) - X.col(0)).cross(Eigen::Vector3d(X.col(2) - X.col(1)));
    };
    for (int f = 0; f < 6; ++f) EXPECT_EQ(normal(f), (f % 2 == 0 ? -1.0 : 1.0) * Eigen::Vector3d::Unit(f / 2)) << f;
}

TEST(BoundaryOfPart, EnclosesThePartOfEveryCellType) {
    for (const VolumeMesh& mesh : test::one_of_each()) {
        std::vector<char> kept(static_cast<std::size_t>(mesh.cell_count()), 0);
        for (std::size_t c = 0; c < kept.size(); c += 2) kept[c] = 1;
        const BoundaryFaces faces = boundary_of_part(face_table(mesh), kept);
        double volume = 0.0, expected = 0.0;
        for (Eigen::Index f = 0; f < faces.count(); ++f) {
            EXPECT_EQ(kept[static_cast<std::size_t>(faces.cell[f])], 1);
            const Eigen::Matrix3Xd X = mesh.nodes(Eigen::all, faces.nodes.col(f));
            // Flat faces: corners alone, two triangles of a quadrilateral.
            for (Eigen::Index t = 0; t < (mesh.type == CellType::hex8 ? 2 : 1); ++t)
                volume += Eigen::Vector3d(X.col(0)).dot(
                              Eigen::Vector3d(X.col(1 + t)).cross(Eigen::Vector3d(X.col(2 + t)))) /
                          6.0;
        }
        const Eigen::VectorXd volumes = cell_volumes(mesh);
        for (std::size_t c = 0; c < kept.size(); c += 2) expected += volumes[static_cast<Eigen::Index>(c)];
        EXPECT_NEAR(volume, expected, 1e-13 * expected) << to_string(mesh.type);
    }
}

TEST(MeshRepair, KeepsOrderAndRegionsOfWhatIsUsed) {
    VolumeMesh mesh = box_hex_mesh({{0, 0, 0}, {3, 1, 1}}, {3, 1, 1});
    mesh.cells = mesh.cells(Eigen::all, std::vector<int>{2, 0}).eval();
    mesh.regions = {7, -1};
    const VolumeMesh row = box_hex_mesh({{0, 0, 0}, {3, 1, 1}}, {3, 1, 1});
    const VolumeMesh compact = without_unused_nodes(mesh);
    EXPECT_EQ(compact.node_count(), 16);
    EXPECT_EQ(compact.regions, mesh.regions);
    EXPECT_EQ(compact.nodes(Eigen::all, compact.cells.col(0)), row.nodes(Eigen::all, row.cells.col(2)));
    EXPECT_EQ(compact.nodes(Eigen::all, compact.cells.col(1)), row.nodes(Eigen::all, row.cells.col(0)));
    // A mesh with all nodes in use stays as it is.
    EXPECT_EQ(without_unused_nodes(row).nodes, row.nodes);
    EXPECT_EQ(without_unused_nodes(row).cells, row.cells);
}

TEST(MeshRepair, SaysWhatCannotBeRepaired) {
    const VolumeMesh whole = box_hex_mesh({{0, 0, 0}, {2, 1, 1}}, {2, 1, 1});
    const auto error = [](const VolumeMesh& mesh) {
        const Result<VolumeMesh> repaired = with_positive_cells(mesh, "mesh.vtu");
        return repaired ? "none" : repaired.error().text();
    };
    EXPECT_EQ(error(whole), "none");
    EXPECT_EQ(error({}), "mesh.vtu: the mesh has no volume cells");
    VolumeMesh bad = whole;
    bad.cells(3, 1) = -1;
    EXPECT_EQ(error(bad), "mesh.vtu: a cell names a node that does not exist");
    bad.cells(3, 1) = 12;
    EXPECT_EQ(error(bad), "mesh.vtu: a cell names a node that does not exist");
    bad = whole;
    bad.nodes(1, 5) = std::numeric_limits<double>::infinity();
    EXPECT_EQ(error(bad), "mesh.vtu: a node's coordinates are not finite numbers");
    bad = whole;
    bad.nodes.row(2).setZero();
    EXPECT_EQ(error(bad), "mesh.vtu: cell 0 (counted from 0) has no volume");
    // A cell 1e-9 thick has a volume, far above rounding.
    bad.nodes.row(2) = 1e-9 * whole.nodes.row(2);
    EXPECT_EQ(error(bad), "none");
}

TEST(TetgenExchange, IsReadAsItWasWritten) {
    const test::Folder folder("tetgen_exchange");
    const TetgenExchange request{{0.1, -1e300, 5e-324, 1.0 / 3.0}, {0, -1, 2147483647}, {}};
    ASSERT_TRUE(write_exchange(folder.path() / "request", request));
    TetgenExchange read{{9.0}, {9}, {9.0, 9.0}};
    ASSERT_TRUE(read_exchange(folder.path() / "request", read));
    EXPECT_EQ(read.points, request.points);
    EXPECT_EQ(read.cells, request.cells);
    EXPECT_TRUE(read.holes.empty()) << "what was there is replaced";
    EXPECT_FALSE(write_exchange(folder.path() / "no folder" / "request", request));
    EXPECT_FALSE(read_exchange(folder.path() / "missing", read));
}

TEST(TetgenExchange, IsRefusedIfItIsCutOrGarbled) {
    const test::Folder folder("tetgen_exchange_cut");
    const std::filesystem::path path = folder.path() / "request";
    ASSERT_TRUE(write_exchange(path, {{1.0, 2.0, 3.0}, {4, 5, 6, 7}, {0.5}}));
    const auto size = static_cast<std::size_t>(std::filesystem::file_size(path));
    // Magic number and three counts of 8 bytes, then the numbers.
    ASSERT_EQ(size, 4u * 8u + 3u * 8u + 4u * 4u + 8u);
    std::ifstream stream(path, std::ios::binary);
    const std::string content((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    TetgenExchange read;
    for (std::size_t length = 0; length < size; ++length) {
        folder.write("cut", content.substr(0, length));
        EXPECT_FALSE(read_exchange(folder.path() / "cut", read)) << length;
    }
    std::string other = content;
    other[0] = static_cast<char>(other[0] + 1);
    folder.write("other", other);
    EXPECT_FALSE(read_exchange(folder.path() / "other", read)) << "another format";
    std::string endless = content;
    for (std::size_t i = 8; i < 16; ++i) endless[i] = '\x7F';  // the number of points
    folder.write("endless", endless);
    EXPECT_FALSE(read_exchange(folder.path() / "endless", read)) << "memory is not asked for";
}

/// The last layer of cells is filled to 0.6 of its height: along z the fraction is exact.
TEST(Voxelize, KeepsCellsFromTheirFractionOn) {
    const SurfaceMesh body = box_surface({{0, 0, -0.004}, {0.01, 0.01, 0.026}});
    VoxelOptions options;
    options.grid = GridLines{{{{0.0, 0.01}, {0.0, 0.01}, {0.0, 0.01, 0.02, 0.03}}}};
    const auto layers = [&](double fraction) {
        options.solid_fraction = fraction;
        const Result<VolumeMesh> mesh = voxelize(body, options);
        return mesh ? mesh->cell_count() : -1;
    };
    EXPECT_EQ(layers(0.5), 3);
    EXPECT_EQ(layers(0.599), 3);
    EXPECT_EQ(layers(0.601), 2);
    EXPECT_EQ(layers(1.0), 2) << "what the surface fills below the grid is no part of it";
    EXPECT_EQ(layers(1.001), -1);
}

TEST(Voxelize, StopsWhenToldAndSaysWhatIsWrong) {
    const SurfaceMesh body = box_surface({{0, 0, 0}, {0.02, 0.02, 0.02}});
    VoxelOptions options;
    std::atomic<bool> cancel = true;
    const Result<VolumeMesh> stopped = voxelize(body, options, Progress({}, &cancel));
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().what, "meshing was stopped");
    double rows = 0.0;
    EXPECT_TRUE(voxelize(body, options, Progress([&](const ProgressEvent& event) { rows = event.total; })));
    EXPECT_EQ(rows, 4.0) << "20 mm by cells of 5 mm";
    EXPECT_THAT(voxelize(box_surface({{0, 0, 0}, {0.02, 0.02, 0}}), options).error().what, HasSubstr("is flat"));
    SurfaceMesh far = body;
    far.vertices(1, 3) = std::numeric_limits<double>::infinity();
    EXPECT_THAT(voxelize(far, options).error().what, HasSubstr("not finite"));
    options.edge = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(voxelize(body, options).error().what, HasSubstr("must be positive"));
}

}  // namespace
}  // namespace myo::mesh::part_boundary_test
