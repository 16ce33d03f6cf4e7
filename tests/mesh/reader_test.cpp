#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <sstream>

#include "base/files.hpp"
#include "mesh/surface_check.hpp"
#include "mesh/surface_reader.hpp"
#include "mesh/test_meshes.hpp"
#include "mesh/test_surfaces.hpp"
#include "mesh/volume_reader.hpp"
#include "mesh/vtk_writer.hpp"

namespace myo::mesh {
namespace {

namespace fs = std::filesystem;

const Box box_mm{{0, 0, 0}, {100, 30, 20}};

void write_text(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

std::string ascii_stl(const SurfaceMesh& s) {
    std::ostringstream text;
    text << "solid a free name\n";
    for (Eigen::Index t = 0; t < s.triangles.cols(); ++t) {
        text << "facet normal 0 0 0\n outer loop\n";
        for (Eigen::Index i = 0; i < 3; ++i)
            text << "  vertex " << s.vertices.col(s.triangles(i, t)).transpose() << "\n";
        text << " endloop\nendfacet\n";
    }
    return text.str() + "endsolid a free name\n";
}

// Quadrilaterals, texture indices, comments, and one face counted backwards.
const std::string obj_box = R"(# a box
mtllib none.mtl
v 0 0 0
v 100 0 0
v 100 30 0
v 0 30 0
v 0 0 20
v 100 0 20
v 100 30 20
v 0 30 20
vt 0 0
f 1/1 4/1 3/1 2/1
f 5//1 6//1 7//1 8//1
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f -8 -4 -1 -5
)";

template <class T>
void append(std::string& bytes, T value, bool big) {
    std::array<char, sizeof(T)> raw{};
    std::memcpy(raw.data(), &value, sizeof value);
    if (big) std::reverse(raw.begin(), raw.end());
    bytes.append(raw.data(), raw.size());
}

std::string ply(const SurfaceMesh& s, const std::string& format) {
    std::ostringstream text;
    text << "ply\nformat " << format << " 1.0\ncomment made by hand\nelement vertex " << s.vertices.cols()
         << "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nelement face "
         << s.triangles.cols() << "\nproperty list uchar int vertex_indices\nend_header\n";
    std::string bytes;
    const bool big = format == "binary_big_endian";
    for (Eigen::Index v = 0; v < s.vertices.cols(); ++v) {
        for (const double x : s.vertices.col(v)) append(bytes, static_cast<float>(x), big);
        append(bytes, std::uint8_t{255}, big);
        if (format == "ascii") text << s.vertices.col(v).transpose() << " 255\n";
    }
    for (Eigen::Index t = 0; t < s.triangles.cols(); ++t) {
        append(bytes, std::uint8_t{3}, big);
        for (const int v : s.triangles.col(t)) append(bytes, std::int32_t{v}, big);
        if (format == "ascii") text << "3 " << s.triangles.col(t).transpose() << "\n";
    }
    return format == "ascii" ? text.str() : text.str() + bytes;
}

std::string vtp(const SurfaceMesh& s) {
    std::ostringstream text;
    text << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
            "byte_order=\"LittleEndian\">\n<PolyData>\n<Piece NumberOfPoints=\""
         << s.vertices.cols() << "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\""
         << s.triangles.cols()
         << "\">\n<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n"
         << s.vertices.transpose()
         << "\n</DataArray></Points>\n<Polys>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n"
         << s.triangles.transpose() << "\n</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n";
    for (Eigen::Index t = 1; t <= s.triangles.cols(); ++t) text << 3 * t << " ";
    text << "\n</DataArray>\n</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
    return text.str();
}

int vtk_type(CellType type) { return type == CellType::hex8 ? 12 : type == CellType::tet4 ? 10 : 24; }

std::string legacy(const VolumeMesh& mesh, bool binary) {
    std::ostringstream text;
    text.precision(17);
    text << "# vtk DataFile Version 3.0\nby hand\n"
         << (binary ? "BINARY" : "ASCII") << "\nDATASET UNSTRUCTURED_GRID\nPOINTS " << mesh.node_count() << " double\n";
    const auto block = [&](const auto& matrix, auto number) {
        if (!binary) {
            text << matrix.transpose() << "\n";
            return;
        }
        std::string bytes;
        for (const auto value : matrix.reshaped()) append(bytes, static_cast<decltype(number)>(value), true);
        text << bytes << "\n";
    };
    block(mesh.nodes, double{});
    // As VTK and ParaView write it behind an array.
    text << "METADATA\nCOMPONENT_NAMES\nX\n\n\nINFORMATION 1\nNAME L2_NORM_RANGE LOCATION vtkDataArray\nDATA 2 0 1.7 "
            "\n\n";
    Eigen::MatrixXi cells(mesh.cells.rows() + 1, mesh.cell_count());
    cells.row(0).setConstant(static_cast<int>(mesh.cells.rows()));
    cells.bottomRows(mesh.cells.rows()) = mesh.cells;
    text << "CELLS " << mesh.cell_count() << " " << cells.size() << "\n";
    block(cells, std::int32_t{});
    text << "CELL_TYPES " << mesh.cell_count() << "\n";
    block(Eigen::MatrixXi::Constant(1, mesh.cell_count(), vtk_type(mesh.type)).eval(), std::int32_t{});
    return text.str();
}

std::string gmsh(const VolumeMesh& mesh, int version) {
    std::ostringstream text;
    text.precision(17);
    const int type = mesh.type == CellType::hex8 ? 5 : mesh.type == CellType::tet4 ? 4 : 11;
    const auto cell = [&](Eigen::Index c) {
        Eigen::VectorXi tags = mesh.cells.col(c).array() + 1;
        if (type == 11) std::swap(tags[8], tags[9]);
        text << tags.transpose() << "\n";
    };
    if (version == 2) {
        text << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n3 1 \"body\"\n$EndPhysicalNames\n$Nodes\n"
             << mesh.node_count() << "\n";
        for (Eigen::Index i = 0; i < mesh.node_count(); ++i)
            text << i + 1 << " " << mesh.nodes.col(i).transpose() << "\n";
        text << "$EndNodes\n$Elements\n" << mesh.cell_count() + 1 << "\n1 2 2 0 1 1 2 3\n";
        for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) text << c + 2 << " " << type << " 2 1 1 ", cell(c);
        text << "$EndElements\n";
    } else {
        text << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 " << mesh.node_count() << " 1 " << mesh.node_count()
             << "\n3 1 0 " << mesh.node_count() << "\n";
        for (Eigen::Index i = 0; i < mesh.node_count(); ++i) text << i + 1 << "\n";
        text << mesh.nodes.transpose() << "\n$EndNodes\n$Elements\n2 " << mesh.cell_count() + 1 << " 1 "
             << mesh.cell_count() + 1 << "\n2 1 2 1\n1 1 2 3\n3 1 " << type << " " << mesh.cell_count() << "\n";
        for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) text << c + 2 << " ", cell(c);
        text << "$EndElements\n";
    }
    return text.str();
}

// TetGen's mid-node order is 23, 03, 01, 12, 13, 02.
void write_tetgen(const fs::path& stem, const VolumeMesh& mesh, int first) {
    const Eigen::Index order[10] = {0, 1, 2, 3, 9, 7, 4, 5, 8, 6};
    std::ostringstream nodes, cells;
    nodes.precision(17);
    nodes << "# points\n" << mesh.node_count() << " 3 0 1\n";
    for (Eigen::Index i = 0; i < mesh.node_count(); ++i)
        nodes << i + first << " " << mesh.nodes.col(i).transpose() << " 1\n";
    cells << mesh.cell_count() << " " << mesh.cells.rows() << " 0\n";
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) {
        cells << c + first;
        for (Eigen::Index i = 0; i < mesh.cells.rows(); ++i) cells << " " << mesh.cells(order[i], c) + first;
        cells << "   # cell\n";
    }
    write_text(fs::path(stem).concat(".node"), nodes.str());
    write_text(fs::path(stem).concat(".ele"), cells.str());
}

class Readers : public ::testing::Test {
protected:
    // Files of every kind, by name.
    void SetUp() override {
        const SurfaceMesh box = box_surface(box_mm);
        write_text(folder_ / "ascii.stl", ascii_stl(box));
        ASSERT_TRUE(write_stl(folder_ / "binary.stl", box, 1.0));
        write_text(folder_ / "box.obj", obj_box);
        write_text(folder_ / "ascii.ply", ply(box, "ascii"));
        write_text(folder_ / "little.ply", ply(box, "binary_little_endian"));
        write_text(folder_ / "big.ply", ply(box, "binary_big_endian"));
        write_text(folder_ / "box.vtp", vtp(box));
        surfaces_ = {"ascii.stl", "binary.stl", "box.obj", "ascii.ply", "little.ply", "big.ply", "box.vtp"};
        for (const VolumeMesh& mesh : test::one_of_each()) {
            const std::string name = to_string(mesh.type);
            ASSERT_TRUE(write_vtu(folder_ / (name + ".vtu"), mesh));
            write_text(folder_ / (name + "_ascii.vtk"), legacy(mesh, false));
            write_text(folder_ / (name + "_binary.vtk"), legacy(mesh, true));
            write_text(folder_ / (name + "_2.msh"), gmsh(mesh, 2));
            write_text(folder_ / (name + "_4.msh"), gmsh(mesh, 4));
            for (const char* kind : {".vtu", "_ascii.vtk", "_binary.vtk", "_2.msh", "_4.msh"})
                volumes_.push_back(name + kind);
            if (mesh.type == CellType::hex8) continue;
            write_tetgen(folder_ / (name + "_0"), mesh, 0);
            write_tetgen(folder_ / (name + "_1"), mesh, 1);
            volumes_.push_back(name + "_0.node");
            volumes_.push_back(name + "_1.ele");
        }
    }
    test::TemporaryFolder folder_;
    std::vector<std::string> surfaces_, volumes_;
};

TEST_F(Readers, EverySurfaceFormat) {
    Eigen::Matrix3d rotation;
    rotation << 0, 0, 1, 0, 1, 0, -1, 0, 0;
    for (const std::string& name : surfaces_) {
        const auto surface = read_surface(folder_ / name, 1e-3, rotation);
        ASSERT_TRUE(surface) << surface.error().text();
        const SurfaceReport report = check_surface(weld(*surface));
        EXPECT_TRUE(report.meshable() && report.outward) << name;
        EXPECT_NEAR(report.volume, 6e-5, 1e-11) << name;
        EXPECT_LT((report.size - Eigen::Vector3d(0.02, 0.03, 0.1)).norm(), 1e-8) << name;
        EXPECT_NEAR(surface->vertices.row(2).minCoeff(), -0.1, 1e-8) << name;
    }
}

TEST_F(Readers, EveryVolumeFormatRoundTrips) {
    for (const std::string& name : volumes_) {
        const auto mesh = read_volume(folder_ / name, 1.0);
        ASSERT_TRUE(mesh) << mesh.error().text();
        for (const VolumeMesh& original : test::one_of_each()) {
            if (!name.starts_with(to_string(original.type))) continue;
            if (original.type == CellType::tet4 && name.starts_with("tet10")) continue;
            EXPECT_EQ(mesh->type, original.type) << name;
            EXPECT_EQ(mesh->cells, original.cells) << name;
            EXPECT_LT((mesh->nodes - original.nodes).cwiseAbs().maxCoeff(), 1e-16) << name;
        }
        const auto in_mm = read_volume(folder_ / name, 1e-3);
        ASSERT_TRUE(in_mm);
        EXPECT_NEAR(cell_volumes(*in_mm).sum(), 1e-9 * cell_volumes(*mesh).sum(), 1e-20);
    }
}

TEST_F(Readers, TruncatedFilesAreErrorsWithThePath) {
    auto check = [&](const std::string& name, const auto& read) {
        const std::string content = *read_file(folder_ / name);
        for (const double part : {0.0, 0.03, 0.2, 0.5, 0.8, 0.95}) {
            const std::string cut = content.substr(
                0, static_cast<std::size_t>(part * static_cast<double>(content.size())));
            write_text(folder_ / ("cut_" + name), cut);
            const auto error = read(folder_ / ("cut_" + name));
            EXPECT_NE(error.find(name), std::string::npos) << name << " at " << part << ": " << error;
        }
    };
    for (const std::string& name : surfaces_) {
        // An OBJ has no end mark: cut between faces it is another, shorter file.
        if (name.ends_with(".obj")) continue;
        check(name, [](const fs::path& path) {
            const auto result = read_surface(path, 1e-3);
            return result ? "no error" : result.error().text();
        });
    }
    for (const std::string& name : volumes_) {
        if (name.ends_with(".node") || name.ends_with(".ele")) {
            const std::string other = name.ends_with(".node") ? name.substr(0, name.size() - 4) + "ele"
                                                              : name.substr(0, name.size() - 3) + "node";
            fs::copy_file(folder_ / other, folder_ / ("cut_" + other));
        }
        check(name, [](const fs::path& path) {
            const auto result = read_volume(path, 1e-3);
            return result ? "no error" : result.error().text();
        });
    }
}

// Whatever bytes stand in the file: a mesh with finite coordinates or one error, never a crash.
TEST_F(Readers, GarbledFilesNeverCrash) {
    std::mt19937 random(11);
    const auto garble = [&](std::string content) {
        const int hits = 1 + static_cast<int>(random() % 6);
        for (int h = 0; h < hits; ++h) {
            const std::size_t at = random() % content.size();
            switch (random() % 4) {
                case 0: content[at] = static_cast<char>(random() % 256); break;
                case 1: content[at] = static_cast<char>('0' + random() % 10); break;
                case 2: content.erase(at, random() % 9); break;
                default: content.insert(at, std::string(random() % 5, "-9 e.\n"[random() % 6])); break;
            }
            if (content.empty()) content = "x";
        }
        return content;
    };
    int errors = 0, read = 0;
    for (const std::string& name : surfaces_) {
        const std::string content = *read_file(folder_ / name);
        for (int k = 0; k < 60; ++k) {
            write_text(folder_ / ("garbled_" + name), garble(content));
            const auto surface = read_surface(folder_ / ("garbled_" + name), 1e-3);
            EXPECT_TRUE(!surface || surface->vertices.allFinite());
            ++(surface ? read : errors);
        }
    }
    for (const std::string& name : volumes_) {
        const std::string content = *read_file(folder_ / name);
        if (name.ends_with(".node") || name.ends_with(".ele")) {
            const std::string other = name.ends_with(".node") ? name.substr(0, name.size() - 4) + "ele"
                                                              : name.substr(0, name.size() - 3) + "node";
            fs::copy_file(folder_ / other, folder_ / ("garbled_" + other));
        }
        for (int k = 0; k < 40; ++k) {
            write_text(folder_ / ("garbled_" + name), garble(content));
            const auto mesh = read_volume(folder_ / ("garbled_" + name), 1e-3);
            EXPECT_TRUE(!mesh || (mesh->nodes.allFinite() && cell_volumes(*mesh).minCoeff() > 0.0));
            ++(mesh ? read : errors);
        }
    }
    EXPECT_GT(errors, 300);
    EXPECT_GT(read, 50);
}

TEST_F(Readers, PlainMistakesAreNamed) {
    EXPECT_NE(read_surface(folder_ / "none.stl", 1.0).error().text().find("none.stl"), std::string::npos);
    EXPECT_FALSE(read_surface(folder_ / "ascii.stl", 0.0));
    EXPECT_FALSE(read_surface(folder_ / "ascii.stl", 1.0, 2.0 * Eigen::Matrix3d::Identity()));
    EXPECT_FALSE(read_surface(folder_ / "ascii.stl", 1.0, Eigen::Vector3d(1, 1, -1).asDiagonal()));
    EXPECT_FALSE(read_volume(folder_ / "ascii.stl", 1.0));
    write_text(folder_ / "index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 4\n");
    EXPECT_NE(read_surface(folder_ / "index.obj", 1.0).error().where.find("index.obj:5"), std::string::npos);
    write_text(folder_ / "nan.stl",
               "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex nan 0 0\nvertex 0 1 "
               "0\nendloop\nendfacet\nendsolid\n");
    EXPECT_NE(read_surface(folder_ / "nan.stl", 1.0).error().where.find(":5"), std::string::npos);
    write_text(folder_ / "empty.stl", "solid empty\nendsolid empty\n");
    EXPECT_FALSE(read_surface(folder_ / "empty.stl", 1.0));
    write_text(folder_ / "binary.msh", "$MeshFormat\n4.1 1 8\n");
    EXPECT_NE(read_volume(folder_ / "binary.msh", 1.0).error().what.find("binary"), std::string::npos);
}

TEST_F(Readers, BytesBehindTheLastTriangleAreAWarning) {
    const std::string binary = *read_file(folder_ / "binary.stl");
    std::vector<std::string> warnings;
    const auto read = [&](const std::string& content) {
        write_text(folder_ / "other.stl", content);
        return read_surface(folder_ / "other.stl", 1e-3, Eigen::Matrix3d::Identity(), &warnings);
    };
    EXPECT_TRUE(read(binary) && warnings.empty());
    for (const std::size_t bytes : {1u, 50u, 150u}) {
        const auto surface = read(binary + std::string(bytes, 'x'));
        ASSERT_TRUE(surface) << surface.error().text();
        EXPECT_NEAR(check_surface(weld(*surface)).volume, 6e-5, 1e-11);
        ASSERT_EQ(warnings.size(), 1u);
        EXPECT_NE(warnings[0].find("other.stl: the STL has " + std::to_string(bytes) + " bytes more than its 12"),
                  std::string::npos)
            << warnings[0];
        warnings.clear();
    }
    // More behind the triangles than in them: the count is wrong.
    EXPECT_FALSE(read(binary + std::string(700, 'x')));
    // Programs that cannot return to the header leave no count in it.
    for (const char byte : {'\0', '\xff'}) {
        std::string uncounted = binary;
        uncounted.replace(80, 4, std::string(4, byte));
        const auto surface = read(uncounted);
        ASSERT_TRUE(surface) << surface.error().text();
        EXPECT_EQ(surface->triangles.cols(), 12);
        EXPECT_EQ(warnings.size(), 1u);
        EXPECT_FALSE(read(uncounted.substr(0, uncounted.size() - 20)));
        warnings.clear();
    }
    EXPECT_NE(read(std::string(200, 'a')).error().what.find("is no STL"), std::string::npos);
}

TEST_F(Readers, NumbersThatAPlyDoesNotDeclareAreAWarning) {
    const std::string head =
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
        "property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n";
    const std::string faces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
    std::vector<std::string> warnings;
    const auto read = [&](const std::string& content) {
        write_text(folder_ / "other.ply", content);
        return read_surface(folder_ / "other.ply", 1.0, Eigen::Matrix3d::Identity(), &warnings);
    };
    const auto more = read(head + "0 0 0 9 9\n\n1 0 0 9 9\n0 1 0\n0 0 1 9 9\n" + faces);
    ASSERT_TRUE(more) << more.error().text();
    EXPECT_NEAR(enclosed_volume(*more), 1.0 / 6.0, 1e-15);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("3 lines have more numbers than the header declares, first line 10: vertex with 2 more"),
              std::string::npos)
        << warnings[0];
    warnings.clear();
    EXPECT_FALSE(read(head + "0 0 0\n1 0\n0 1 0\n0 0 1\n" + faces)) << "a number is missing in a line";
    // Without a line for every element the numbers are read one after the other.
    const auto wrapped = read(head + "0 0 0 1 0 0\n0 1 0 0 0 1 3 0 2 1 3 0\n1 3 3 1 2 3 3 2 0 3\n");
    ASSERT_TRUE(wrapped) << wrapped.error().text();
    EXPECT_NEAR(enclosed_volume(*wrapped), 1.0 / 6.0, 1e-15);
    EXPECT_TRUE(warnings.empty());
}

TEST_F(Readers, ConcavePolygonIsCutRight) {
    // An L drawn as one face; triangles that leave it would change the area.
    write_text(folder_ / "l.obj", "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4 5 6\n");
    const auto surface = read_surface(folder_ / "l.obj", 1.0);
    ASSERT_TRUE(surface);
    EXPECT_EQ(surface->triangles.cols(), 4);
    EXPECT_NEAR(check_surface(*surface).area, 3.0, 1e-14);
}

TEST_F(Readers, CellsAreTurnedRoundCountedAndChecked) {
    for (VolumeMesh mesh : test::one_of_each()) {
        const double volume = cell_volumes(mesh).sum();
        mesh.nodes.row(1) *= -1.0;  // a mirror image: every cell inside out
        ASSERT_LT(cell_volumes(mesh).maxCoeff(), 0.0);
        ASSERT_TRUE(write_vtu(folder_ / "mirror.vtu", mesh));
        const auto read = read_volume(folder_ / "mirror.vtu", 1.0);
        ASSERT_TRUE(read) << read.error().text();
        EXPECT_GT(cell_volumes(*read).minCoeff(), 0.0);
        EXPECT_NEAR(cell_volumes(*read).sum(), volume, 1e-12 * volume);

        mesh.nodes.conservativeResize(3, mesh.node_count() + 1);  // a node nobody uses
        mesh.nodes.rightCols(1).setConstant(7.0);
        ASSERT_TRUE(write_vtu(folder_ / "unused.vtu", mesh));
        EXPECT_EQ(read_volume(folder_ / "unused.vtu", 1.0)->node_count(), mesh.node_count() - 1);

        for (Eigen::Index i = 0; i < mesh.cells.rows(); ++i) mesh.nodes(2, mesh.cells(i, 1)) = 0.0;  // flat
        ASSERT_TRUE(write_vtu(folder_ / "flat.vtu", mesh));
        const auto flat = read_volume(folder_ / "flat.vtu", 1.0);
        ASSERT_FALSE(flat);
        EXPECT_NE(flat.error().what.find("cell 1 "), std::string::npos) << flat.error().text();
    }
}

TEST_F(Readers, MixedMeshesAreRefused) {
    write_text(folder_ / "mixed.vtk",
               "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 double\n0 0 0 1 0 0 1 1 0 0 "
               "1 0 0 0 1 1 0 1 1 1 1 0 1 1\n"
               "CELLS 2 14\n8 0 1 2 3 4 5 6 7\n4 0 1 2 4\nCELL_TYPES 2\n12 10\n");
    const auto mixed = read_volume(folder_ / "mixed.vtk", 1.0);
    ASSERT_FALSE(mixed);
    EXPECT_NE(mixed.error().what.find("mixes hex8 and tet4"), std::string::npos) << mixed.error().text();
}

TEST_F(Readers, PvdListsTimesAndEscapesNames) {
    ASSERT_TRUE(write_pvd(folder_ / "series.pvd", {0.0, 0.01}, {"a_0.vtu", "a&b_1.vtu"}));
    const std::string text = *read_file(folder_ / "series.pvd");
    EXPECT_NE(text.find("timestep=\"0.01\" part=\"0\" file=\"a&amp;b_1.vtu\""), std::string::npos);
}

TEST_F(Readers, WritingToABadPlaceIsAnError) {
    EXPECT_FALSE(write_vtu("/proc/none/x.vtu", box_hex_mesh(box_mm, {1, 1, 1})));
}

}  // namespace
}  // namespace myo::mesh
