#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "mesh/surface_check.hpp"
#include "mesh/surface_reader.hpp"
#include "mesh/volume_reader.hpp"
#include "support/folder.hpp"

// Encodings of VTK's XML files that VTK's own writer does not choose here: base64, blocks of zlib, either byte order,
// sizes of 32 and 64 bits, several pieces, strips.

namespace myo::mesh::vtk_xml_test {
namespace {

using testing::HasSubstr;
using namespace std::string_literals;

/// Attributes of the file, one array of points, and what stands behind the pieces.
struct Parts {
    std::string of_file = "byte_order=\"LittleEndian\"";
    std::string points = "<DataArray type=\"Float64\" format=\"ascii\">0 0 0 1 0 0 0 1 0 0 0 1</DataArray>";
    std::string behind{};
};

/// A file of one tetrahedron: corners at the origin and at 1 on the axes.
std::string tetrahedron_file(const Parts& parts) {
    return "<?xml version=\"1.0\"?>\n<!-- 1 > 0 <Piece> -->\n<VTKFile type='UnstructuredGrid' " + parts.of_file +
           ">\n<UnstructuredGrid><Piece NumberOfPoints='4' NumberOfCells=\"1\">\n"
           "<PointData><DataArray type=\"Float64\" Name=\"u\" format=\"ascii\">no number</DataArray></PointData>\n"
           "<Points>" +
           parts.points +
           "</Points>\n<Cells>\n<DataArray type=\"Int32\" Name=\"offsets\">4</DataArray>\n"
           "<DataArray type=\"Int32\" Name=\"connectivity\">0 1 2 3</DataArray>\n"
           "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">10</DataArray>\n</Cells>\n"
           "</Piece></UnstructuredGrid>\n" +
           parts.behind + "</VTKFile>\n";
}

class VtkXml : public testing::Test {
protected:
    /// Error of a file with this content; its volume in m3 if there is none.
    std::string error_of(const std::string& content) const {
        folder_.write("one.vtu", content);
        const Result<VolumeMesh> mesh = read_volume(folder_.path() / "one.vtu", 1.0);
        if (!mesh) return mesh.error().text();
        EXPECT_EQ(mesh->node_count(), 4);
        EXPECT_NEAR(cell_volumes(*mesh).sum(), 1.0 / 6.0, 1e-15);
        return "read";
    }
    std::string error_of(const std::string& of_file, const std::string& points) const {
        return error_of(tetrahedron_file({.of_file = of_file, .points = points}));
    }
    test::Folder folder_{"vtk_xml"};
};

const std::string base64 = "<DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"binary\">\n   ";
const std::string base64_doubles = "<DataArray type=\"Float64\" format=\"binary\">";
const std::string array_end = "\n</DataArray>";
/// Bytes of the points in front of which their number stands: 32 or 64 bits, lowest or highest byte first.
const std::string little_32 = "MAAAAAAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/AAAAAAAAAAAAAAAAAACAPw==";
const std::string little_64 = "MAAAAAAAAAAAAAAAAAAAAAAAAAAAAIA/AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8=";
const std::string big_32 = "AAAAMAAAAAAAAAAAAAAAAD+AAAAAAAAAAAAAAAAAAAA/gAAAAAAAAAAAAAAAAAAAP4AAAA==";
const std::string big_64 = "AAAAAAAAADAAAAAAAAAAAAAAAAA/gAAAAAAAAAAAAAAAAAAAP4AAAAAAAAAAAAAAAAAAAD+AAAA=";

TEST_F(VtkXml, Base64InEitherByteOrderAndSize) {
    const std::string little = "byte_order=\"LittleEndian\"", big = "byte_order=\"BigEndian\"",
                      wide = " header_type=\"UInt64\"", narrow = " header_type=\"UInt32\"";
    EXPECT_EQ(error_of(little, base64 + little_32 + array_end), "read") << "files before 1.0 have 32 bits";
    EXPECT_EQ(error_of(little + narrow, base64 + little_32 + array_end), "read");
    EXPECT_EQ(error_of(little + wide, base64 + little_64 + array_end), "read");
    EXPECT_EQ(error_of(big, base64 + big_32 + array_end), "read");
    EXPECT_EQ(error_of(big + wide, base64 + big_64 + array_end), "read");
    std::string folded = little_32;
    for (std::size_t at = 12; at < folded.size(); at += 13) folded.insert(at, "\n");
    EXPECT_EQ(error_of(little, base64 + folded + array_end), "read") << "lines of 12 letters";
    // Sizes read in another order or width are far larger than the file.
    EXPECT_THAT(error_of(big, base64 + little_32 + array_end), HasSubstr("an array is too short"));
    EXPECT_THAT(error_of(little + wide, base64 + big_32 + array_end), HasSubstr("an array is too short"));
    EXPECT_THAT(error_of(little + " header_type=\"Word\"", base64 + little_32 + array_end),
                HasSubstr("an array is too short"));
}

/// Two blocks of zlib, of 64 and 32 bytes: coordinates across their border; then one block that is not cut short.
TEST_F(VtkXml, BlocksOfZlib) {
    const std::string zlib = "byte_order=\"LittleEndian\" compressor=\"vtkZLibDataCompressor\"";
    const std::string two = "AgAAAEAAAAAgAAAAEgAAAA4AAAA=eJxjYMAHPtjjlQbKAwAqXgJfeJxjYMAHPtgDAAI/ATA=";
    EXPECT_EQ(error_of(zlib, base64_doubles + two + array_end), "read");
    EXPECT_EQ(error_of(zlib, base64_doubles + "AQAAAGAAAAAAAAAAEgAAAA==eJxjYMAHPtjjlSZCHgB4XQOO" + array_end), "read");
    // The last block is said to have 40 bytes, but has 32.
    EXPECT_THAT(
        error_of(zlib, base64_doubles +
                           "AgAAAEAAAAAoAAAAEgAAAA4AAAA=eJxjYMAHPtjjlQbKAwAqXgJfeJxjYMAHPtgDAAI/ATA=" + array_end),
        HasSubstr("a compressed array"));
    EXPECT_THAT(error_of(zlib, base64_doubles + two.substr(0, 60) + array_end), HasSubstr("a compressed array"));
    EXPECT_THAT(
        error_of("byte_order=\"LittleEndian\" compressor=\"vtkOwnCompressor\"", base64_doubles + two + array_end),
        HasSubstr("an unknown compression"));
}

/// Bytes behind the mark may look like tags; offsets count from the mark.
TEST_F(VtkXml, AppendedArrays) {
    std::string raw = "\x04\0\0\0</V>"s + "\x30\0\0\0"s;
    for (int i = 0; i < 12; ++i) raw += i == 3 || i == 7 || i == 11 ? "\0\0\x80\x3F"s : "\0\0\0\0"s;
    const auto file = [](const std::string& offset, const std::string& encoding, const std::string& bytes) {
        return tetrahedron_file(
            {.points = "<DataArray type=\"Float32\" format=\"appended\" offset=\"" + offset + "\"/>",
             .behind = "<AppendedData encoding=\"" + encoding + "\">\n  _" + bytes + "\n</AppendedData>\n"});
    };
    EXPECT_EQ(error_of(file("8", "raw", raw)), "read");
    EXPECT_EQ(error_of(file("4", "base64", "AAAA" + little_32)), "read");
    EXPECT_THAT(error_of(file("8000", "raw", raw)), HasSubstr("an offset"));
    EXPECT_THAT(error_of(file("", "raw", raw)), HasSubstr("an offset"));
    EXPECT_THAT(error_of(file("8", "raw", raw.substr(0, raw.size() - 9))), HasSubstr("an array is too short"));
    EXPECT_THAT(error_of(tetrahedron_file({.behind = "<AppendedData encoding=\"raw\">no mark</AppendedData>"})),
                HasSubstr("the appended data"));
}

TEST_F(VtkXml, SaysWhatIsWrong) {
    const std::string whole = tetrahedron_file({});
    EXPECT_EQ(error_of(whole), "read");
    EXPECT_THAT(error_of(whole.substr(0, whole.find("</VTKFile>"))), HasSubstr("one.vtu: the VTK file is truncated"));
    EXPECT_THAT(error_of("<VTKFile type=\"ImageData\"></VTKFile>"),
                HasSubstr("one.vtu: is not a VTK file of type UnstructuredGrid"));
    EXPECT_THAT(error_of("<html></html>"), HasSubstr("its end is missing"));
    EXPECT_THAT(error_of("</VTKFile>"), HasSubstr("is not a VTK file"));
    EXPECT_THAT(error_of("", "<DataArray>0 0 0 1 0 0 0 1 0 0 0</DataArray>"), HasSubstr("garbled: points"));
    EXPECT_THAT(error_of("", "<DataArray>0 0 0 1 0 0 0 1 0 0 0 1mm</DataArray>"), HasSubstr("is not a number"));
    EXPECT_THAT(error_of("", "<DataArray type=\"Half\" format=\"binary\">" + little_32 + array_end),
                HasSubstr("an array's type or length"));
    EXPECT_THAT(error_of("", base64 + "*" + little_32.substr(1) + array_end), HasSubstr("an array is too short"));
    EXPECT_THAT(error_of("", ""), HasSubstr("names a node that does not exist")) << "without points";
}

/// Cells of a second piece count from its own points.
TEST_F(VtkXml, PiecesAreJoined) {
    std::string text = tetrahedron_file({});
    const std::size_t begin = text.find("<Piece "), end = text.find("</UnstructuredGrid>");
    std::string second = text.substr(begin, end - begin);
    const std::string places = "0 0 0 1 0 0 0 1 0 0 0 1";
    second.replace(second.find(places), places.size(), "5 0 0 7 0 0 5 2 0 5 0 2");
    text.insert(end, second);
    folder_.write("two.vtu", text);
    const Result<VolumeMesh> mesh = read_volume(folder_.path() / "two.vtu", 1.0);
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_EQ(mesh->node_count(), 8);
    EXPECT_NEAR(cell_volumes(*mesh)[0], 1.0 / 6.0, 1e-15);
    EXPECT_NEAR(cell_volumes(*mesh)[1], 8.0 / 6.0, 1e-14);
}

/// All four faces of a tetrahedron lie on one strip; vertices and lines beside it are no surface.
TEST_F(VtkXml, StripsMakeASurface) {
    const auto arrays = [](const std::string& nodes, const std::string& end) {
        return "<DataArray type=\"Int32\" Name=\"connectivity\">" + nodes +
               "</DataArray><DataArray type=\"Int32\" Name=\"offsets\">" + end + "</DataArray>";
    };
    folder_.write("strip.vtp",
                  "<VTKFile type=\"PolyData\"><PolyData><Piece>"
                  "<Points><DataArray type=\"Float64\">0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points>"
                  "<Verts>" +
                      arrays("0", "1") + "</Verts><Polys/><Strips>" + arrays("1 0 2 3 1 0", "6") +
                      "</Strips></Piece></PolyData></VTKFile>");
    const Result<SurfaceMesh> surface = read_surface(folder_.path() / "strip.vtp", 1.0);
    ASSERT_TRUE(surface) << surface.error().text();
    EXPECT_EQ(surface->triangles.cols(), 4);
    const SurfaceReport report = check_surface(*surface);
    EXPECT_TRUE(report.meshable() && report.outward);
    EXPECT_NEAR(report.volume, 1.0 / 6.0, 1e-15);
}

}  // namespace
}  // namespace myo::mesh::vtk_xml_test
