#include <gtest/gtest.h>

#include <fstream>

#include "backend/file_preview.hpp"
#include "backend/workbench_backend.hpp"
#include "mesh/boundary_surface.hpp"
#include "mesh/box_mesh.hpp"
#include "mesh/vtk_writer.hpp"
#include "support/folder.hpp"
#include "ui/driver.hpp"

namespace myo {
namespace {

namespace fs = std::filesystem;
using test::Driver;
using test::Folder;

const Box box{{0.0, 0.0, 0.0}, {0.06, 0.02, 0.02}};

/// A mesh as a file of Gmsh 2.2, legacy VTK or TetGen, in millimetres.
void write_gmsh(const fs::path& path, const mesh::VolumeMesh& mesh) {
    std::ofstream file(path);
    file << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << mesh.node_count() << "\n";
    for (Eigen::Index i = 0; i < mesh.node_count(); ++i)
        file << i + 1 << " " << 1e3 * mesh.nodes.col(i).transpose() << "\n";
    file << "$EndNodes\n$Elements\n" << mesh.cell_count() << "\n";
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c)
        file << c + 1 << " 4 0 " << (mesh.cells.col(c).array() + 1).transpose() << "\n";
    file << "$EndElements\n";
}

void write_legacy_vtk(const fs::path& path, const mesh::VolumeMesh& mesh) {
    std::ofstream file(path);
    file << "# vtk DataFile Version 3.0\nbox\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS " << mesh.node_count()
         << " double\n"
         << 1e3 * mesh.nodes.transpose() << "\n";
    file << "CELLS " << mesh.cell_count() << " " << 5 * mesh.cell_count() << "\n";
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) file << "4 " << mesh.cells.col(c).transpose() << "\n";
    file << "CELL_TYPES " << mesh.cell_count() << "\n";
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) file << "10\n";
}

void write_tetgen(const fs::path& stem, const mesh::VolumeMesh& mesh) {
    std::ofstream nodes(stem.string() + ".node"), cells(stem.string() + ".ele");
    nodes << mesh.node_count() << " 3 0 0\n";
    for (Eigen::Index i = 0; i < mesh.node_count(); ++i)
        nodes << i << " " << 1e3 * mesh.nodes.col(i).transpose() << "\n";
    cells << mesh.cell_count() << " 4 0\n";
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) cells << c << " " << mesh.cells.col(c).transpose() << "\n";
}

/// Opened with the unit that is asked for, meshed and shown.
void open(Driver& driver, const fs::path& file) {
    driver.window->open(file);
    driver.settle();
    driver.click("unit/mm");
    ASSERT_TRUE(driver.wait_for_job(60));
    ASSERT_TRUE(driver.state().scene) << driver.state().log.back().text;
    ASSERT_TRUE(driver.state().body) << driver.state().log.back().text;
}

TEST(Volume, EveryListedFormatIsOpenedWithItsOwnElements) {
    const Folder folder("volumes");
    const mesh::VolumeMesh mesh = mesh::tet_box_mesh(box, {6, 2, 2}, mesh::CellType::tet4);
    mesh::VolumeMesh in_mm = mesh;
    in_mm.nodes *= 1e3;
    ASSERT_TRUE(mesh::write_vtu(folder.path() / "box.vtu", in_mm));
    write_gmsh(folder.path() / "box.msh", mesh);
    write_legacy_vtk(folder.path() / "box.vtk", mesh);
    write_tetgen(folder.path() / "box", mesh);
    for (const char* const name : {"box.vtu", "box.msh", "box.vtk", "box.node", "box.ele"}) {
        SCOPED_TRACE(name);
        Driver driver(backend::make_core_backend(), 1280, 800);
        ASSERT_NO_FATAL_FAILURE(open(driver, folder.path() / name));
        const ui::commands::MeshedBody& body = *driver.state().body;
        EXPECT_EQ(body.mesh.type, mesh::CellType::tet4);
        EXPECT_EQ(body.mesh.cell_count(), mesh.cell_count());
        EXPECT_LT((body.mesh.nodes - mesh.nodes).norm(), 1e-6);
        EXPECT_EQ(driver.state().prediction.elements, static_cast<double>(mesh.cell_count()));
    }
}

TEST(Volume, RunsOnItsOwnElementsAndCanBeMeshedAnew) {
    const Folder folder("volume_runs");
    mesh::VolumeMesh mesh = mesh::box_hex_mesh(box, {6, 2, 2});
    mesh.nodes *= 1e3;
    ASSERT_TRUE(mesh::write_vtu(folder.path() / "box.vtu", mesh));
    Driver driver(backend::make_core_backend(), 1280, 800);
    ASSERT_NO_FATAL_FAILURE(open(driver, folder.path() / "box.vtu"));
    driver.workbench->execute(ui::commands::Run{});
    ASSERT_TRUE(driver.wait_for_job(120));
    ASSERT_TRUE(driver.state().run) << driver.state().log.back().text;
    EXPECT_EQ(driver.state().run->problem, "");
    const ui::commands::SimulatedTrial& trial = driver.state().run->trials.front();
    ASSERT_EQ(trial.frames.back().cols(), mesh.node_count());
    EXPECT_LT((trial.frames.back() - driver.state().body->mesh.nodes).row(2).minCoeff(), -1e-3) << "the free end sinks";
    ui::commands::Settings settings = driver.state().settings;
    settings.resolution_m = 0.005;
    driver.workbench->execute(ui::commands::ChangeSettings{settings, "resolution"});
    driver.workbench->execute(ui::commands::BuildMesh{});
    ASSERT_TRUE(driver.wait_for_job(60));
    EXPECT_EQ(driver.state().body->mesh.cell_count(), 12 * 4 * 4);
    driver.workbench->execute(ui::commands::Undo{});
    driver.workbench->execute(ui::commands::BuildMesh{});
    ASSERT_TRUE(driver.wait_for_job(60));
    EXPECT_EQ(driver.state().body->mesh.cell_count(), mesh.cell_count());
}

TEST(Volume, AFileOfAnotherKindIsToldAtOnce) {
    const Folder folder("other_kind");
    folder.write("photo.png", "not a mesh");
    Driver driver(backend::make_core_backend(), 1280, 800);
    driver.window->drop({folder.path() / "photo.png"});
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_FALSE(driver.state().unit_question) << "a unit does not make a mesh of it";
    EXPECT_EQ(driver.state().log.back().level, ui::commands::LogLevel::failure);
    EXPECT_NE(driver.state().log.back().text.find(".vtu"), std::string::npos);
}

const ui::commands::ReportLine* line(const std::vector<ui::commands::ReportLine>& lines, const std::string& label) {
    const auto found = std::find_if(lines.begin(), lines.end(),
                                    [&](const ui::commands::ReportLine& l) { return l.label == label; });
    return found != lines.end() ? &*found : nullptr;
}

TEST(Preview, TellsSizeAndElementsOfAMesh) {
    const Folder folder("preview_mesh");
    mesh::VolumeMesh mesh = mesh::box_hex_mesh(box, {6, 2, 2});
    ASSERT_TRUE(mesh::write_stl(folder.path() / "box.STL", mesh::boundary_surface(mesh), 1e-3));
    const std::vector<ui::commands::ReportLine> surface = backend::preview_of(folder.path() / "box.STL");
    ASSERT_TRUE(line(surface, "Triangles"));
    EXPECT_EQ(line(surface, "Triangles")->value, "112");
    ASSERT_TRUE(line(surface, "Size, read as millimetres"));
    EXPECT_EQ(line(surface, "Size, read as millimetres")->value, "60 × 20 × 20 mm");
    EXPECT_FALSE(line(surface, "Size, read as metres")) << "nobody has a robot of 60 m";
    ASSERT_TRUE(mesh::write_vtu(folder.path() / "box.vtu", mesh));
    const std::vector<ui::commands::ReportLine> volume = backend::preview_of(folder.path() / "box.vtu");
    ASSERT_TRUE(line(volume, "Size, read as metres"));
    EXPECT_EQ(line(volume, "Size, read as metres")->value, "60 × 20 × 20 mm");
    ASSERT_TRUE(line(volume, "Elements"));
    EXPECT_EQ(line(volume, "Elements")->value, "24 hex8");
    folder.write("broken.stl", "nothing");
    EXPECT_TRUE(line(backend::preview_of(folder.path() / "broken.stl"), "Cannot be opened"));
}

TEST(Preview, TellsMarkersFramesRateAndDurationOfARecording) {
    const std::vector<ui::commands::ReportLine> lines = backend::preview_of(
        fs::path(MYOLOOP_SOURCE_DIR) / "assets/examples/silicone_beam/gravity_release.csv");
    for (const char* const label : {"Format", "Markers", "Frames", "Rate", "Duration", "File"})
        ASSERT_TRUE(line(lines, label)) << label;
    EXPECT_NE(line(lines, "Rate")->value.find(" Hz"), std::string::npos);
    EXPECT_NE(line(lines, "Duration")->value.find(" s"), std::string::npos);
    const Folder folder("preview_table");
    folder.write("signals.csv", "hello\n");
    EXPECT_EQ(backend::preview_of(folder.path() / "signals.csv").size(), 1u)
        << "a table that is no recording has a size only";
}

}  // namespace
}  // namespace myo
