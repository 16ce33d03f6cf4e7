#include <gtest/gtest.h>

#include <string>

#include "mesh/volume_reader.hpp"
#include "support/folder.hpp"

// Numbers that files give their cells: physical tags, attributes, arrays of the cells.

namespace myo::mesh {
namespace {

using Regions = std::vector<int>;

/// Two tetrahedra on one face.
const std::string gmsh_nodes_2 =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n"
    "5 1 1 1\n$EndNodes\n";

Regions regions_of(const test::Folder& folder, const std::string& file) {
    const Result<VolumeMesh> mesh = read_volume(folder.path() / file, 1.0);
    EXPECT_TRUE(mesh) << mesh.error().text();
    return mesh ? mesh->regions : Regions{};
}

TEST(CellRegions, AreThePhysicalTagsOfGmsh2) {
    const test::Folder folder("regions_gmsh2");
    // A triangle comes first; it has a number, too, but is no cell.
    folder.write("two.msh", gmsh_nodes_2 +
                                "$Elements\n3\n1 2 2 9 1 1 2 3\n2 4 2 7 1 1 2 3 4\n3 4 2 3 2 2 3 4 5\n"
                                "$EndElements\n");
    EXPECT_EQ(regions_of(folder, "two.msh"), (Regions{7, 3}));
    folder.write("plain.msh", gmsh_nodes_2 + "$Elements\n2\n1 4 2 0 1 1 2 3 4\n2 4 2 0 2 2 3 4 5\n$EndElements\n");
    EXPECT_EQ(regions_of(folder, "plain.msh"), (Regions{1, 2})) << "without physical groups: the entities";
}

TEST(CellRegions, AreThePhysicalTagsOfTheVolumesOfGmsh4) {
    const test::Folder folder("regions_gmsh4");
    const auto mesh = [](const std::string& entities) {
        return "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n" + entities +
               "$Nodes\n1 5 1 5\n3 1 0 5\n1\n2\n3\n4\n5\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n$EndNodes\n"
               "$Elements\n2 2 1 2\n3 1 4 1\n1 1 2 3 4\n3 2 4 1\n2 2 3 4 5\n$EndElements\n";
    };
    folder.write("plain.msh", mesh(""));
    EXPECT_EQ(regions_of(folder, "plain.msh"), (Regions{1, 2})) << "without physical tags: the entities";
    folder.write("tagged.msh", mesh("$Entities\n1 1 1 2\n5 0 0 0 0\n6 0 0 0 1 1 1 0 1 5\n7 0 0 0 1 1 1 1 40 1 6\n"
                                    "1 0 0 0 1 1 1 1 12 1 7\n2 0 0 0 1 1 1 2 13 14 1 -7\n$EndEntities\n"));
    EXPECT_EQ(regions_of(folder, "tagged.msh"), (Regions{12, 13}));
    folder.write("broken.msh", mesh("$Entities\n1 1 1 2\n5 0 0\n$EndEntities\n"));
    const Result<VolumeMesh> broken = read_volume(folder.path() / "broken.msh", 1.0);
    ASSERT_FALSE(broken);
    EXPECT_NE(broken.error().what.find("an entity cannot be read"), std::string::npos) << broken.error().what;
}

TEST(CellRegions, AreTheFirstAttributesOfTetGen) {
    const test::Folder folder("regions_tetgen");
    folder.write("two.node", "5 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1\n");
    folder.write("two.ele", "2 4 1\n1 1 2 3 4 -20\n2 2 3 4 5 30\n");
    EXPECT_EQ(regions_of(folder, "two.ele"), (Regions{-20, 30}));
    folder.write("two.ele", "2 4 0\n1 1 2 3 4\n2 2 3 4 5\n");
    EXPECT_EQ(regions_of(folder, "two.ele"), Regions{});
}

TEST(CellRegions, AreAnIntegerArrayOfTheCellsOfVtk) {
    const test::Folder folder("regions_vtk");
    const auto vtu = [](const std::string& arrays) {
        return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\">\n<UnstructuredGrid>\n"
               "<Piece NumberOfPoints=\"5\" NumberOfCells=\"3\">\n<CellData>" +
               arrays +
               "</CellData>\n<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 "
               "0 1 "
               "0 0 0 1 1 1 1</DataArray></Points>\n<Cells>\n<DataArray type=\"Int64\" Name=\"connectivity\" "
               "format=\"ascii\">0 1 2 0 1 2 3 1 2 3 4</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" "
               "format=\"ascii\">3 7 11</DataArray>\n<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">5 10 10"
               "</DataArray>\n</Cells></Piece></UnstructuredGrid></VTKFile>\n";
    };
    const auto array = [](const std::string& type, const std::string& name, const std::string& values) {
        return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" format=\"ascii\">" + values + "</DataArray>";
    };
    // Triangles are no cells; their number is left out.
    folder.write("one.vtu", vtu(array("Int32", "anything", "9 4 6") + array("Float64", "region", "1 2 3")));
    EXPECT_EQ(regions_of(folder, "one.vtu"), (Regions{4, 6}));
    folder.write("named.vtu", vtu(array("Int32", "rank", "0 0 0") + array("Int64", "gmsh:physical", "9 5 8")));
    EXPECT_EQ(regions_of(folder, "named.vtu"), (Regions{5, 8}));
    folder.write("two.vtu", vtu(array("Int32", "a", "0 0 0") + array("Int32", "b", "9 5 8")));
    EXPECT_EQ(regions_of(folder, "two.vtu"), Regions{}) << "nothing says which of two";
    folder.write("none.vtu", vtu(""));
    EXPECT_EQ(regions_of(folder, "none.vtu"), Regions{});
}

}  // namespace
}  // namespace myo::mesh
