#include "mesh/vtk_arrays.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

// Arrays of VTK files before they become a mesh: number types and byte orders, cells, strips, regions.

namespace myo::mesh::vtk_arrays_test {
namespace {

using namespace std::string_literals;

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// A number of a VTK type with its bytes, lowest first.
struct Stored {
    std::string type, bytes;
    double value;
};

/// Bit patterns that differ between signed and unsigned types, whole numbers and fractions.
const std::vector<Stored> stored_numbers{
    {"Int8", "\xFE"s, -2.0},
    {"char", "\x7F"s, 127.0},
    {"UInt8", "\xFE"s, 254.0},
    {"unsigned_char", "\x80"s, 128.0},
    {"Int16", "\x01\x80"s, -32767.0},
    {"UInt16", "\x01\x80"s, 32769.0},
    {"unsigned_short", "\x00\x01"s, 256.0},
    {"Int32", "\xFF\xFF\xFF\xFF"s, -1.0},
    {"int", "\x00\x00\x01\x00"s, 65536.0},
    {"UInt32", "\xFF\xFF\xFF\xFF"s, 4294967295.0},
    {"Int64", "\xFE\xFF\xFF\xFF\xFF\xFF\xFF\xFF"s, -2.0},
    {"vtktypeint64", "\x00\x00\x00\x00\x00\x00\x20\x00"s, 9007199254740992.0},
    {"vtkIdType", "\x05\x00\x00\x00\x00\x00\x00\x00"s, 5.0},
    {"unsigned_long", "\x00\x00\x00\x00\x01\x00\x00\x00"s, 4294967296.0},
    {"Float32", "\x00\x00\xC0\x3F"s, 1.5},
    {"float", "\x00\x00\x00\xBE"s, -0.125},
    {"Float64", "\x00\x00\x00\x00\x00\x00\x02\xC0"s, -2.25},
    {"double", "\x00\x00\x00\x00\x00\x00\xF0\x3F"s, 1.0},
};

TEST(VtkNumbers, OfEveryTypeAreReadInBothByteOrders) {
    for (const Stored& stored : stored_numbers) {
        EXPECT_EQ(vtk_number_size(stored.type), stored.bytes.size()) << stored.type;
        const std::string reversed(stored.bytes.rbegin(), stored.bytes.rend());
        VtkArray little{7.0}, big;
        EXPECT_TRUE(append_vtk_numbers(stored.type, stored.bytes + stored.bytes, false, little)) << stored.type;
        EXPECT_EQ(little, (VtkArray{7.0, stored.value, stored.value})) << stored.type << ": what was there stays";
        EXPECT_TRUE(append_vtk_numbers(stored.type, reversed, true, big)) << stored.type;
        EXPECT_EQ(big, VtkArray{stored.value}) << stored.type;
    }
}

TEST(VtkNumbers, AreNotReadFromPartsOfThemOrUnknownTypes) {
    for (const Stored& stored : stored_numbers) {
        VtkArray numbers;
        EXPECT_TRUE(append_vtk_numbers(stored.type, "", false, numbers));
        if (stored.bytes.size() > 1)
            EXPECT_FALSE(append_vtk_numbers(stored.type, stored.bytes + "x", false, numbers)) << stored.type;
        EXPECT_TRUE(numbers.empty()) << stored.type;
    }
    for (const char* type : {"", "bit", "Float16", "FLOAT64", "Float64 ", "string"}) {
        VtkArray numbers;
        EXPECT_EQ(vtk_number_size(type), 0u) << type;
        EXPECT_FALSE(append_vtk_numbers(type, "\0\0\0\0\0\0\0\0"s, false, numbers)) << type;
        EXPECT_TRUE(numbers.empty()) << type;
    }
}

/// Corners of a box of 1 x 2 x 3, x fastest, then y.
CellSoup lattice() {
    CellSoup soup;
    for (int k = 0; k < 2; ++k)
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 2; ++i) soup.nodes.emplace_back(i, 2.0 * j, 3.0 * k);
    return soup;
}

VolumeMesh mesh_of(const CellSoup& soup) {
    VolumeMesh mesh{soup.type, Eigen::Matrix3Xd(3, static_cast<Eigen::Index>(soup.nodes.size())), {}};
    for (std::size_t n = 0; n < soup.nodes.size(); ++n) mesh.nodes.col(static_cast<Eigen::Index>(n)) = soup.nodes[n];
    const Eigen::Index per_cell = nodes_per_cell(soup.type);
    mesh.cells = Eigen::Map<const Eigen::MatrixXi>(soup.cells.data(), per_cell,
                                                   static_cast<Eigen::Index>(soup.cells.size()) / per_cell);
    return mesh;
}

constexpr double vtk_vertex = 1.0, vtk_triangle = 5.0, vtk_tetra = 10.0, vtk_voxel = 11.0, vtk_wedge = 13.0;

/// The nodes of a voxel run along the axes; those of a hexahedron run round its faces.
TEST(VtkCells, VoxelBecomesAHexahedronOfItsVolume) {
    CellSoup soup = lattice();
    ASSERT_TRUE(add_vtk_cells({0, 1, 2, 3, 4, 5, 6, 7}, {8}, {vtk_voxel}, 0, "box.vtu", soup));
    EXPECT_EQ(soup.type, CellType::hex8);
    EXPECT_EQ(soup.cells, (std::vector<int>{0, 1, 3, 2, 4, 5, 7, 6}));
    EXPECT_NEAR(cell_volumes(mesh_of(soup))[0], 6.0, 1e-14);
}

TEST(VtkCells, OfLowerDimensionAreLeftOutWithTheirRegions) {
    CellSoup soup = lattice();
    ASSERT_TRUE(add_vtk_cells({6, 0, 1, 2, 0, 1, 2, 4}, {1, 4, 8}, {vtk_vertex, vtk_triangle, vtk_tetra}, 0, "", soup,
                              {9, 8, 7}));
    EXPECT_EQ(soup.type, CellType::tet4);
    EXPECT_EQ(soup.cells, (std::vector<int>{0, 1, 2, 4}));
    EXPECT_EQ(soup.regions, std::vector<int>{7});
    EXPECT_NEAR(cell_volumes(mesh_of(soup))[0], 1.0, 1e-14) << "a sixth of 1 x 2 x 3";
    // An array with another number of values belongs to something else.
    CellSoup other = lattice();
    ASSERT_TRUE(add_vtk_cells({0, 1, 2, 4}, {4}, {vtk_tetra}, 0, "", other, {9, 8}));
    EXPECT_TRUE(other.regions.empty());
    // Numbers that no integer can hold are no regions.
    for (const double region : {no_number, 1e300, -1e300, 2147483648.0}) {
        ASSERT_TRUE(add_vtk_cells({0, 1, 2, 4}, {4}, {vtk_tetra}, 0, "", other, {region}));
        EXPECT_TRUE(other.regions.empty()) << region;
    }
    ASSERT_TRUE(add_vtk_cells({0, 1, 2, 4}, {4}, {vtk_tetra}, 0, "", other, {2147483647.0}));
    EXPECT_EQ(other.regions, std::vector<int>{2147483647});
}

TEST(VtkCells, OfASecondPieceCountFromItsFirstNode) {
    CellSoup soup = lattice();
    ASSERT_TRUE(add_vtk_cells({0, 1, 2, 4}, {4}, {vtk_tetra}, 0, "", soup));
    ASSERT_TRUE(add_vtk_cells({0, 1, 2, 3}, {4}, {vtk_tetra}, 4, "", soup));
    EXPECT_EQ(soup.cells, (std::vector<int>{0, 1, 2, 4, 4, 5, 6, 7}));
}

struct BadCells {
    VtkArray connectivity, offsets, types;
    std::size_t first_node;
    std::string words;  // of the message
};

TEST(VtkCells, ThatCannotBeAreNamed) {
    const std::string no_node = " (counted from 0) names a node that does not exist";
    const std::vector<BadCells> bad{
        {{0, 1, 2, 4}, {4}, {vtk_tetra, vtk_tetra}, 0, "has not one type per cell"},
        {{0, 1, 2, 8}, {4}, {vtk_tetra}, 0, "cell 0" + no_node},
        {{0, 1, 2, -1}, {4}, {vtk_tetra}, 0, "cell 0" + no_node},
        {{0, 1, 2, no_number}, {4}, {vtk_tetra}, 0, "cell 0" + no_node},
        {{0, 1, 2, 4}, {4}, {vtk_tetra}, 4, "cell 0" + no_node},
        {{0, 1, 2, -1}, {4}, {vtk_tetra}, 4, "cell 0" + no_node},
        {{0, 1, 2, 4}, {5}, {vtk_tetra}, 0, "cell 0" + no_node},
        {{0, 1, 2, 4}, {no_number}, {vtk_tetra}, 0, "cell 0" + no_node},
        {{0, 1, 2, 4}, {4, 3}, {vtk_tetra, vtk_tetra}, 0, "cell 1" + no_node},
        {{0, 1, 2}, {3}, {vtk_tetra}, 0, "cell 0 (counted from 0) has a wrong number of nodes"},
        {{0, 1, 2, 3, 4, 5}, {6}, {vtk_wedge}, 0, "is of VTK type 13, which is not read: only hex8, tet4, tet10"},
        {{0, 1, 2, 4}, {4}, {no_number}, 0, "VTK type 255"},
        {{0, 1, 2, 4}, {4}, {-1.0}, 0, "VTK type 255"},
        {{0, 1, 2, 4}, {4}, {1e9}, 0, "VTK type 255"},
        {{0, 1, 2, 4, 0, 1, 2, 3, 4, 5, 6, 7}, {4, 12}, {vtk_tetra, vtk_voxel}, 0, "mixes tet4 and hex8 cells"},
    };
    for (const BadCells& cells : bad) {
        CellSoup soup = lattice();
        const Result<void> added = add_vtk_cells(cells.connectivity, cells.offsets, cells.types, cells.first_node,
                                                 "bad.vtu", soup);
        ASSERT_FALSE(added) << cells.words;
        EXPECT_NE(added.error().what.find(cells.words), std::string::npos) << added.error().what;
        EXPECT_EQ(added.error().where, "bad.vtu");
    }
}

/// Twice the area of each triangle along z.
std::vector<double> twice_areas(const PolygonSoup& soup) {
    std::vector<double> areas;
    for (const auto& [a, b, c] : soup.triangles) {
        const auto at = [&](int v) -> const Eigen::Vector3d& { return soup.vertices[static_cast<std::size_t>(v)]; };
        areas.push_back((at(b) - at(a)).cross(at(c) - at(a)).z());
    }
    return areas;
}

/// A zigzag along x: each triangle of a strip leans on the last two vertices of the one before.
TEST(VtkPolygons, TrianglesOfAStripFaceTheSameWay) {
    PolygonSoup soup;
    for (int v = 0; v < 7; ++v) soup.vertices.emplace_back(v / 2, v % 2, 0.0);
    ASSERT_TRUE(add_vtk_polygons({0, 1, 2, 3, 4, 5, 6}, {7}, true, 0, "", soup));
    ASSERT_EQ(soup.triangles.size(), 5u);
    for (const double area : twice_areas(soup)) EXPECT_EQ(area, -1.0);
    // Two vertices make no triangle; vertices of a later piece count from its first.
    soup.triangles.clear();
    ASSERT_TRUE(add_vtk_polygons({0, 1, 2, 0, 1}, {3, 5}, true, 2, "", soup));
    EXPECT_EQ(soup.triangles, (std::vector<std::array<int, 3>>{{2, 3, 4}}));
}

TEST(VtkPolygons, AreCutIntoTrianglesAndChecked) {
    PolygonSoup soup;
    for (const auto& [x, y] : {std::pair{0, 0}, {3, 0}, {3, 2}, {0, 2}}) soup.vertices.emplace_back(x, y, 1.0);
    ASSERT_TRUE(add_vtk_polygons({0, 1, 2, 3, 3, 2, 1}, {4, 7}, false, 0, "", soup));
    ASSERT_EQ(soup.triangles.size(), 3u);
    const std::vector<double> areas = twice_areas(soup);
    EXPECT_EQ(areas[0] + areas[1], 12.0);
    EXPECT_EQ(areas[2], -6.0) << "the orientation of the file stays";
    const Result<void> beyond = add_vtk_polygons({0, 1, 2, 3, 4, 1}, {3, 6}, false, 0, "bad.vtp", soup);
    ASSERT_FALSE(beyond);
    EXPECT_EQ(beyond.error().text(), "bad.vtp: cell 1 (counted from 0) names a vertex that does not exist");
}

TEST(VtkRegions, AreTheArrayOfAUsualNameOrTheOnlyOne) {
    EXPECT_EQ(region_array({}), -1);
    EXPECT_EQ(region_array({"whatever"}), 0);
    EXPECT_EQ(region_array({"one", "other"}), -1) << "nobody knows which";
    EXPECT_EQ(region_array({"one", "gmsh:physical"}), 1);
    EXPECT_EQ(region_array({"material", "one", "region"}), 2) << "by the list of names, not by the order of the file";
    EXPECT_EQ(region_array({"Material", "Region"}), -1) << "names are those of programs, letter by letter";
}

}  // namespace
}  // namespace myo::mesh::vtk_arrays_test
