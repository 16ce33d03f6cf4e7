#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "mesh/surface_reader.hpp"
#include "mesh/volume_reader.hpp"
#include "mesh/vtk_writer.hpp"
#include "support/folder.hpp"

// Variants of mesh files that other programs write, and what is said of wrong ones: file, line, sentence.

namespace myo::mesh::file_dialects_test {
namespace {

using testing::HasSubstr;

/// Messages of readers on files with a given content; "read" where there is none.
class Mistakes {
public:
    std::string of_volume(const std::string& file, const std::string& content) const {
        folder_.write(file, content);
        const Result<VolumeMesh> mesh = read_volume(folder_.path() / file, 1.0);
        return mesh ? "read" : mesh.error().text();
    }
    std::string of_surface(const std::string& file, const std::string& content) const {
        folder_.write(file, content);
        const Result<SurfaceMesh> surface = read_surface(folder_.path() / file, 1.0);
        return surface ? "read" : surface.error().text();
    }
    const test::Folder& folder() const { return folder_; }

private:
    test::Folder folder_{"file_dialects"};
};

/// One tetrahedron of 1/6 m3 behind an unused point, in the layout of VTK 5.1.
const std::string legacy_5 =
    "# vtk DataFile Version 5.1\ntitle\nascii\ndataset unstructured_grid\n"
    "FIELD FieldData 1\nTIME 1 2 double\n0.5 0.75\n"
    "points 5 float\n9 9 9 0 0 0 1 0 0 0 1 0 0 0 1\n"
    "CELLS 2 4\nOFFSETS vtktypeint64\n0 4\nCONNECTIVITY vtktypeint64\n1 2 3 4\nCELL_TYPES 1\n10\n"
    "CELL_DATA 1\nwhatever comes here is not read\n";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

TEST(LegacyVtk, OfVersion5HasOffsetsAndKeywordsInAnyCase) {
    const Mistakes mistakes;
    ASSERT_EQ(mistakes.of_volume("five.vtk", legacy_5), "read");
    const Result<VolumeMesh> mesh = read_volume(mistakes.folder().path() / "five.vtk", 0.1);
    EXPECT_EQ(mesh->node_count(), 4) << "the unused point is left out";
    EXPECT_NEAR(cell_volumes(*mesh)[0], 1e-3 / 6.0, 1e-17);
    EXPECT_EQ(mistakes.of_volume("UPPER.VTK", legacy_5), "read");
}

TEST(LegacyVtk, SaysWhatIsMissing) {
    const Mistakes mistakes;
    const auto error = [&](const std::string& from, const std::string& to) {
        return mistakes.of_volume("bad.vtk", replaced(legacy_5, from, to));
    };
    EXPECT_THAT(error("# vtk", "# VTK"), HasSubstr("bad.vtk: does not begin with '# vtk DataFile'"));
    EXPECT_THAT(error("ascii", "text"), HasSubstr("neither ASCII nor BINARY is stated"));
    EXPECT_THAT(error("unstructured_grid", "polydata"), HasSubstr("is not a VTK unstructured grid"));
    EXPECT_THAT(error("TIME 1 2", "TIME 1 3"), HasSubstr("truncated or garbled: field"));
    EXPECT_THAT(error("points 5", "points 6"), HasSubstr("truncated or garbled: points"));
    EXPECT_THAT(error("points 5", "points 500000"), HasSubstr("the number of points"));
    EXPECT_THAT(error("points 5", "vertices 5"), HasSubstr("unknown section"));
    EXPECT_THAT(error("0 4\n", "1 4\n"), HasSubstr("truncated or garbled: offsets"));
    EXPECT_THAT(error("CONNECTIVITY", "NODES"), HasSubstr("connectivity is missing"));
    EXPECT_THAT(error("1 2 3 4\nC", "1 2 3 5\nC"), HasSubstr("cell 0 (counted from 0) names a node"));
    EXPECT_THAT(error("CELL_TYPES 1\n10\n", ""), HasSubstr("points or cells are missing"));
    // Versions before 5 give each cell the number of its nodes.
    const std::string old = "CELLS 1 5\n4 1 2 3 4\n";
    const std::string layout = "CELLS 2 4\nOFFSETS vtktypeint64\n0 4\nCONNECTIVITY vtktypeint64\n1 2 3 4\n";
    EXPECT_EQ(error(layout, old), "read");
    EXPECT_THAT(error(layout, "CELLS 1 5\n5 1 2 3 4\n"), HasSubstr("garbled: cells"));
    EXPECT_THAT(error(layout, "CELLS 1 5\n-4 1 2 3 4\n"), HasSubstr("garbled: cells"));
    EXPECT_THAT(error(layout, "CELLS 2 5\n4 1 2 3 4\n"), HasSubstr("garbled: cells"));
}

const std::string gmsh_head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
/// Numbers of nodes with gaps, in any order.
const std::string gmsh_sparse = "$Nodes\n4\n70 0 0 1\n5 0 0 0\n8 1 0 0\n1000000000000 0 1 0\n$EndNodes\n";
const std::string gmsh_cell = "$Elements\n1\n1 4 0 5 8 1000000000000 70\n$EndElements\n";

TEST(Gmsh, NumbersOfNodesAreNames) {
    const Mistakes mistakes;
    const std::string notes = "$Comments\nof $Nodes 17\n$EndComments\n";
    ASSERT_EQ(mistakes.of_volume("sparse.msh", gmsh_head + notes + gmsh_sparse + gmsh_cell), "read");
    const Result<VolumeMesh> mesh = read_volume(mistakes.folder().path() / "sparse.msh", 1.0);
    EXPECT_NEAR(cell_volumes(*mesh)[0], 1.0 / 6.0, 1e-15);
    EXPECT_EQ(mesh->cells, Eigen::Vector4i(1, 2, 3, 0)) << "nodes in the order of the file";
}

/// Nodes on curves and faces of version 4.1 may carry their parameters there: as many as the entity has dimensions.
TEST(Gmsh, ParametersOfNodesAreSkipped) {
    const Mistakes mistakes;
    const std::string text =
        "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n3 4 1 9\n"
        "0 1 1 1\n1\n0 0 0\n"
        "1 3 1 1\n9\n1 0 0 0.25\n"
        "2 4 1 2\n3\n4\n0 1 0 0.5 0.5\n0 0 1 0.125 0.75\n$EndNodes\n"
        "$Elements\n2 2 1 2\n2 4 2 1\n1 1 9 3\n3 1 4 1\n2 1 9 3 4\n$EndElements\n";
    ASSERT_EQ(mistakes.of_volume("curved.msh", text), "read");
    const Result<VolumeMesh> mesh = read_volume(mistakes.folder().path() / "curved.msh", 1.0);
    EXPECT_EQ(mesh->cell_count(), 1) << "the triangle is no cell";
    EXPECT_NEAR(cell_volumes(*mesh)[0], 1.0 / 6.0, 1e-15);
}

TEST(Gmsh, SaysWhatIsWrongAndInWhichLine) {
    const Mistakes mistakes;
    const auto error = [&](const std::string& text) { return mistakes.of_volume("bad.msh", text); };
    EXPECT_THAT(error("$Nodes\n"), HasSubstr("bad.msh:1: expected '$MeshFormat'"));
    EXPECT_THAT(error("$MeshFormat\n4.0 0 8\n$EndMeshFormat\n"), HasSubstr("bad.msh:2: this version"));
    EXPECT_THAT(error("$MeshFormat\n2.2 0 8\n$Nodes\n"), HasSubstr("bad.msh:3: expected '$EndMeshFormat'"));
    EXPECT_THAT(error(gmsh_head), HasSubstr("ends without nodes or elements"));
    EXPECT_THAT(error(gmsh_head + gmsh_cell), HasSubstr("bad.msh:4: '$Elements' before '$Nodes'"));
    EXPECT_THAT(error(gmsh_head + "$Comments\nno end\n"), HasSubstr("'$EndComments' is missing"));
    EXPECT_THAT(error(gmsh_head + "4\n"), HasSubstr("bad.msh:4: expected a section that begins with '$'"));
    EXPECT_THAT(error(gmsh_head + replaced(gmsh_sparse, "\n8 1", "\n5 1")),
                HasSubstr("bad.msh:8: two nodes have the same number"));
    EXPECT_THAT(error(gmsh_head + replaced(gmsh_sparse, "8 1 0 0", "8 1 0 nan")),
                HasSubstr("bad.msh:8: a node needs three finite coordinates"));
    EXPECT_THAT(error(gmsh_head + gmsh_sparse + replaced(gmsh_cell, " 70", " 71")),
                HasSubstr("bad.msh:13: an element names node 71, which does not exist"));
    EXPECT_THAT(error(gmsh_head + gmsh_sparse + replaced(gmsh_cell, "1 4 0", "1 6 0")),
                HasSubstr("bad.msh:13: cells of Gmsh type 6 are not read: only hex8, tet4, tet10"));
    EXPECT_THAT(error(gmsh_head + gmsh_sparse + replaced(gmsh_cell, "1 4 0", "1 99 0")), HasSubstr("Gmsh type 99"));
    EXPECT_THAT(error(gmsh_head + gmsh_sparse + replaced(gmsh_cell, "\n1\n", "\n2\n")),
                HasSubstr("an element cannot be read"));
    EXPECT_THAT(error(gmsh_head + gmsh_sparse + "$Elements\n0\n$EndElements\n"), HasSubstr("has no volume cells"));
}

const std::string tetgen_nodes =
    "# made by hand\n4 3 1 1 # points, attributes\n1 0 0 0 7.5 1\n2 1 0 0 7.5 1\n"
    "3 0 1 0 7.5 0\n\n4 0 0 1 7.5 0\n";
const std::string tetgen_cells = "1 4 1\n1 1 2 3 4 -3 # region\n";

TEST(Tetgen, SkipsCommentsAttributesAndMarkers) {
    const Mistakes mistakes;
    mistakes.folder().write("body.node", tetgen_nodes);
    ASSERT_EQ(mistakes.of_volume("body.ele", tetgen_cells), "read");
    const Result<VolumeMesh> mesh = read_volume(mistakes.folder().path() / "body.node", 1.0);
    EXPECT_NEAR(cell_volumes(*mesh)[0], 1.0 / 6.0, 1e-15);
    EXPECT_EQ(mesh->regions, std::vector<int>{-3});
    const std::filesystem::path folder = mistakes.folder().path();
    EXPECT_EQ(volume_files(folder / "body.ele"),
              (std::vector<std::filesystem::path>{folder / "body.node", folder / "body.ele"}));
    EXPECT_EQ(volume_files("a.msh"), std::vector<std::filesystem::path>{"a.msh"});
}

TEST(Tetgen, SaysWhatIsWrongInWhichOfTheTwoFiles) {
    const Mistakes mistakes;
    const auto error = [&](const std::string& node_text, const std::string& cell_text) {
        mistakes.folder().write("bad.node", node_text);
        return mistakes.of_volume("bad.ele", cell_text);
    };
    EXPECT_THAT(mistakes.of_volume("lonely.ele", tetgen_cells), HasSubstr("lonely.node"));
    EXPECT_THAT(error(replaced(tetgen_nodes, "4 3 1", "4 2 1"), tetgen_cells),
                HasSubstr("bad.node:2: expected '<number of points> 3 ...'"));
    EXPECT_THAT(error(replaced(tetgen_nodes, "4 3 1", "5 3 1"), tetgen_cells), HasSubstr("ends after 4 points"));
    EXPECT_THAT(error(replaced(tetgen_nodes, "4 3 1", "999 3 1"), tetgen_cells), HasSubstr("bad.node:2: the file is"));
    EXPECT_THAT(error(replaced(tetgen_nodes, "\n2 1 0 0", "\n3 1 0 0"), tetgen_cells),
                HasSubstr("bad.node:4: points must be numbered from 0 or 1 without gaps"));
    EXPECT_THAT(error(replaced(tetgen_nodes, "1 0 0 0 7.5 1\n", "2 0 0 0 7.5 1\n"), tetgen_cells),
                HasSubstr("bad.node:3: points must be numbered"));
    EXPECT_THAT(error(replaced(tetgen_nodes, "4 0 0 1 7.5 0", "4 0 0"), tetgen_cells),
                HasSubstr("bad.node:7: a point needs three finite coordinates"));
    EXPECT_THAT(error(tetgen_nodes, "1 5 1\n"), HasSubstr("bad.ele:1: expected '<number of tetrahedra> <4 or 10>"));
    EXPECT_THAT(error(tetgen_nodes, replaced(tetgen_cells, "2 3 4", "2 3 5")),
                HasSubstr("bad.ele:2: a cell names a point that does not exist"));
    EXPECT_THAT(error(tetgen_nodes, replaced(tetgen_cells, "1 2 3 4", "0 2 3 4")), HasSubstr("bad.ele:2: a cell"));
    EXPECT_THAT(error(tetgen_nodes, replaced(tetgen_cells, "1 4 1", "2 4 1")), HasSubstr("ends after 1 cells"));
}

TEST(SurfaceFiles, SayWhatIsWrongAndInWhichLine) {
    const Mistakes mistakes;
    const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    EXPECT_EQ(mistakes.of_surface("Body.OBJ", corners + "f 1 2 3\n"), "read");
    EXPECT_THAT(mistakes.of_surface("body.off", corners), HasSubstr("unknown kind of surface file '.off'"));
    const auto obj = [&](const std::string& text) { return mistakes.of_surface("bad.obj", text); };
    EXPECT_THAT(obj(""), HasSubstr("bad.obj: the file is empty"));
    EXPECT_THAT(obj(corners), HasSubstr("bad.obj: the file holds no triangles"));
    EXPECT_THAT(obj("v 0 0\nv 1 0 0\n"), HasSubstr("bad.obj:1: a vertex needs three finite numbers"));
    EXPECT_THAT(obj(corners + "f 1 2\n"), HasSubstr("bad.obj:4: a face needs at least three vertices"));
    EXPECT_THAT(obj(corners + "f 1 2 x\n"), HasSubstr("bad.obj:4: a face needs vertex numbers"));
    for (const char* face : {"f 0 1 2\n", "f 1 2 4\n", "f -4 -3 -2\n"})
        EXPECT_THAT(obj(corners + face), HasSubstr("bad.obj:4: a face names a vertex that does not exist")) << face;
    EXPECT_EQ(obj(corners + "f -3 -2 -1\n"), "read");
}

/// A surface in inches, written and read back: single precision rounds at 6e-8.
TEST(SurfaceFiles, StlKeepsPlacesInItsUnit) {
    const Mistakes mistakes;
    const SurfaceMesh surface = box_surface({{-0.0254, 0.0, 0.1}, {0.0508, 0.3, 0.2}});
    const std::filesystem::path path = mistakes.folder().path() / "box.stl";
    ASSERT_TRUE(write_stl(path, surface, 0.0254));
    EXPECT_EQ(std::filesystem::file_size(path), 84u + 50u * 12u);
    const Result<SurfaceMesh> inches = read_surface(path, 1.0), metres = read_surface(path, 0.0254);
    ASSERT_TRUE(inches && metres);
    EXPECT_NEAR(inches->vertices.row(0).maxCoeff(), 2.0, 2e-7);
    EXPECT_NEAR(enclosed_volume(*metres), enclosed_volume(surface), 1e-6 * enclosed_volume(surface));
    EXPECT_LT((bounding_box(metres->vertices).lowest - bounding_box(surface.vertices).lowest).norm(), 1e-8);
}

}  // namespace
}  // namespace myo::mesh::file_dialects_test
