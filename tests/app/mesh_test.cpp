#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/program.hpp"
#include "app/small_experiment.hpp"
#include "mesh/volume_reader.hpp"

namespace myo::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

class MeshTypes : public ::testing::TestWithParam<const char*> {};

TEST_P(MeshTypes, FillTheBoxExactly) {
    const Folder folder(std::string("mesh_") + GetParam());
    folder.write("box.stl", box_stl(40.0, 20.0, 10.0));
    const ProgramRun run = run_program({"mesh", folder.str("box.stl"), "--unit", "mm", "--type", GetParam(),
                                        "--resolution", "0.005", "--out", folder.str("box.vtu"), "--json"});
    ASSERT_EQ(run.status, 0) << run.err;
    const json j = json::parse(run.out);
    EXPECT_EQ(j.at("element"), GetParam());
    EXPECT_LT(std::abs(j.at("volume_error").get<double>()), 1e-6);
    EXPECT_NEAR(j.at("volume_m3").get<double>(), 8e-6, 1e-11);
    EXPECT_EQ(j.at("dofs").get<int>(), 3 * j.at("nodes").get<int>());
    int total = 0;
    for (const int count : j.at("quality").at("histogram")) total += count;
    EXPECT_EQ(total, j.at("elements").get<int>());
    const Result<mesh::VolumeMesh> written = mesh::read_volume(folder.path() / "box.vtu", 1.0);
    ASSERT_TRUE(written);
    EXPECT_EQ(written->cell_count(), j["elements"].get<int>());
    EXPECT_NEAR(mesh::cell_volumes(*written).sum(), 8e-6, 1e-11);
}
INSTANTIATE_TEST_SUITE_P(All, MeshTypes, ::testing::Values("hex8", "tet4", "tet10"));

TEST(Mesh, PrintsCountsAndBars) {
    const Folder folder("mesh_text");
    folder.write("box.stl", box_stl(40.0, 20.0, 10.0));
    const ProgramRun run = run_program(
        {"mesh", folder.str("box.stl"), "--unit", "mm", "--type", "hex8", "--resolution", "0.01"});
    EXPECT_EQ(run.status, 0);
    EXPECT_THAT(run.out, HasSubstr("8 hex8 elements, 30 nodes, 90 degrees of freedom"));
    EXPECT_THAT(run.out, HasSubstr("0.9-1.0        8  ########"));
}

TEST(Mesh, ChecksAndConvertsVolumes) {
    const Folder folder("mesh_volume");
    folder.write("box.stl", box_stl(40.0, 20.0, 10.0));
    ASSERT_EQ(run_program({"mesh", folder.str("box.stl"), "--unit", "mm", "--type", "tet4", "--resolution", "0.01",
                           "--out", folder.str("box.vtu"), "--quiet"})
                  .status,
              0);
    const ProgramRun run = run_program(
        {"mesh", folder.str("box.vtu"), "--unit", "m", "--type", "tet10", "--out", folder.str("ten.vtu"), "--json"});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(json::parse(run.out)["element"], "tet10");
    EXPECT_THAT(run_program({"mesh", folder.str("box.vtu")}).err, HasSubstr("taken as metres"));
    EXPECT_EQ(run_program({"mesh", folder.str("box.vtu"), "--resolution", "0.01"}).status, 2);
    EXPECT_EQ(run_program({"mesh", folder.str("box.vtu"), "--type", "hex8"}).status, 2);
}

TEST(Mesh, BadCallsAndFilesAreOneSentence) {
    const Folder folder("mesh_bad");
    folder.write("box.stl", box_stl(40.0, 20.0, 10.0));
    folder.write("open.stl", [] {
        const std::string whole = box_stl(40.0, 20.0, 10.0);
        return whole.substr(0, whole.rfind("facet normal")) + "endsolid box\n";
    }());
    folder.write("garbled.stl", "solid \x01\x02 facet normal x\n vertex 1 2");
    folder.write("garbled.vtu", "<VTKFile type=\"UnstructuredGrid\"><Piece");
    folder.write("garbled.msh", "$MeshFormat\n2.2 0 8\n");
    folder.write("empty.obj", "");
    const struct {
        std::vector<std::string> words;
        const char* expected;
    } cases[] = {
        {{"box.stl", "--type", "hex8", "--resolution", "0.01"}, "--unit"},
        {{"box.stl", "--type", "hex8", "--resolution", "0.01", "--unit", "cm"}, "--unit"},
        {{"box.stl", "--type", "hex8", "--resolution", "0.01", "--unit", "m"}, "10 m"},
        {{"box.stl", "--unit", "mm", "--resolution", "0.01"}, "--type"},
        {{"box.stl", "--unit", "mm", "--type", "hex20", "--resolution", "0.01"}, "hex8, tet4, tet10"},
        {{"box.stl", "--unit", "mm", "--type", "hex8"}, "--resolution"},
        {{"box.stl", "--unit", "mm", "--type", "hex8", "--resolution", "1e-6"}, "2 million"},
        {{"box.stl", "--unit", "mm", "--type", "hex8", "--resolution", "0.01", "--quality", "1.4"}, "--quality"},
        {{"box.stl", "--unit", "mm", "--type", "tet4", "--resolution", "0.01", "--quality", "1.0"}, "--quality"},
        {{"box.stl", "--unit", "mm", "--type", "hex8", "--resolution", "0.01", "--out", "box.stl"}, ".vtu"},
        {{"open.stl", "--unit", "mm", "--type", "hex8", "--resolution", "0.01"}, "open.stl"},
        {{"garbled.stl", "--unit", "mm", "--type", "hex8", "--resolution", "0.01"}, "garbled.stl"},
        {{"garbled.vtu", "--unit", "mm"}, "garbled.vtu"},
        {{"garbled.msh", "--unit", "mm"}, "garbled.msh"},
        {{"empty.obj", "--unit", "mm", "--type", "hex8", "--resolution", "0.01"}, "empty.obj"},
        {{"absent.stl", "--unit", "mm", "--type", "hex8", "--resolution", "0.01"}, "absent.stl"},
    };
    for (const auto& bad : cases) {
        std::vector<std::string> words{"mesh", folder.str(bad.words[0])};
        words.insert(words.end(), bad.words.begin() + 1, bad.words.end());
        const ProgramRun run = run_program(words);
        EXPECT_EQ(run.status, 2) << run.err;
        EXPECT_EQ(count_lines(run.err), 1) << run.err;
        EXPECT_THAT(run.err, HasSubstr(bad.expected));
    }
}

}  // namespace
}  // namespace myo::test
