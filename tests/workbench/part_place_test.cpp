#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "experiment/read_experiment.hpp"
#include "mesh/box_mesh.hpp"
#include "mesh/surface_mesh.hpp"
#include "mesh/vtk_writer.hpp"
#include "workbench/by_hand.hpp"
#include "workbench/opened_beam.hpp"

// Parts of the body by paint, by a second surface and by the numbers of a volume mesh, set in the window.

namespace myo {
namespace {

using test::Driver;
using test::OpenedBeam;
using testing::HasSubstr;

void show_parts(Driver& driver) {
    driver.window->show_panel("part");
    driver.settle();
}

/// Cells that are held by a part to more than a half.
Eigen::Index held(const Driver& driver, Eigen::Index part = 0) {
    const Eigen::MatrixXd& shares = driver.state().part_shares;
    return shares.cols() > part + 1 ? (shares.col(part + 1).array() > 0.5).count() : 0;
}

/// A stroke of the brush along the top of the beam.
void stroke(Driver& driver, double from_x, double to_x, double y) {
    driver.drag(test::pixel_of(driver, {from_x, y, 0.02}), test::pixel_of(driver, {to_x, y, 0.02}));
    driver.settle();
}

/// Paints a part with the first stroke and returns how many cells it has.
Eigen::Index paint_part(OpenedBeam& beam) {
    beam.driver.workbench->execute(ui::commands::SetTime{0.0});
    show_parts(beam.driver);
    beam.driver.click("part/add_painted");
    stroke(beam.driver, 0.02, 0.06, 0.015);
    EXPECT_EQ(beam.driver.state().scene->parts.size(), 1u) << beam.driver.state().refused;
    return held(beam.driver);
}

TEST(PaintedPart, IsDeclaredByAStrokeExtendedByTheNextAndUndoneByStep) {
    OpenedBeam beam("part_painted");
    Driver& driver = beam.driver;
    const std::string file = beam.text();
    const Eigen::Index first = paint_part(beam);
    ASSERT_GT(first, 2);
    EXPECT_TRUE(driver.state().mesh_is_current()) << "paint leaves the mesh as it is";
    EXPECT_EQ(driver.state().scene->parts[0].youngs_modulus_Pa, driver.state().settings.youngs_modulus_Pa);
    ASSERT_EQ(driver.window->scene().legend.size(), 2u);
    EXPECT_THAT(driver.window->scene().legend[1].text, HasSubstr("part "));
    stroke(driver, 0.06, 0.1, 0.015);
    EXPECT_GT(held(driver), first);
    EXPECT_EQ(driver.state().scene->parts.size(), 1u);
    driver.click("part/0/brush/tool/erase");
    stroke(driver, 0.02, 0.04, 0.015);
    const Eigen::Index erased = held(driver);
    driver.workbench->execute(ui::commands::Undo{});
    EXPECT_GT(held(driver), erased);
    driver.workbench->execute(ui::commands::Undo{});
    EXPECT_EQ(held(driver), first);
    driver.workbench->execute(ui::commands::Undo{});
    EXPECT_TRUE(driver.state().scene->parts.empty());
    driver.workbench->execute(ui::commands::Redo{});
    EXPECT_EQ(held(driver), first);
    EXPECT_EQ(beam.text(), file) << "the file is written on request only";
}

TEST(PaintedPart, IsKeptInTheExperimentInACopyAndInAProject) {
    OpenedBeam beam("part_painted_kept");
    Driver& driver = beam.driver;
    const Eigen::Index cells = paint_part(beam);
    const std::filesystem::path project = beam.folder.path() / "beam.myoloop", copy = beam.folder.path() / "copy";
    driver.workbench->execute(ui::commands::SaveAs{project});
    driver.workbench->execute(ui::commands::SaveExperimentAs{copy});
    Driver next(backend::make_core_backend(), 1280, 900);
    next.window->open(project);
    ASSERT_TRUE(next.wait_for_job(60));
    ASSERT_TRUE(next.state().scene) << next.state().log.back().text;
    ASSERT_EQ(next.state().scene->parts.size(), 1u);
    EXPECT_TRUE(next.state().scene->parts[0].mask);
    EXPECT_EQ(held(next), cells);
    EXPECT_FALSE(std::filesystem::exists(beam.copy / "parts")) << "the experiment is written on request only";
    driver.workbench->execute(ui::commands::SaveDeclaration{});
    for (const std::filesystem::path& folder : {beam.copy, copy}) {
        const Result<experiment::Experiment> read = experiment::read_experiment(folder);
        ASSERT_TRUE(read) << read.error().text();
        const auto& painted = std::get<experiment::PartDeclaration::Painted>(read->parts.at(0).place);
        EXPECT_TRUE(fibre::read_painted_mask(std::get<std::filesystem::path>(painted.mask)));
    }
}

/// Another place is one edit, and paint begins with what the part held.
TEST(PartPlace, ChangesFromABoxToPaintInOneStep) {
    OpenedBeam beam("part_place");
    Driver& driver = beam.driver;
    show_parts(driver);
    driver.click("part/add");
    const Eigen::Index cells = held(driver);
    ASSERT_GT(cells, 0);
    driver.click("part/0/place");
    driver.click("part/0/place/mask");
    EXPECT_TRUE(driver.state().scene->parts[0].mask) << driver.state().refused;
    EXPECT_FALSE(driver.state().scene->parts[0].box_m);
    EXPECT_EQ(held(driver), cells);
    driver.workbench->execute(ui::commands::Undo{});
    EXPECT_TRUE(driver.state().scene->parts[0].box_m);
}

/// In the unit of the body; one that is open is refused.
TEST(PartPlace, IsASecondSurface) {
    const test::Folder folder("part_surface_window");
    const Box bar{{0.0, 0.0, 0.0}, {0.08, 0.02, 0.02}}, core{{-0.01, -0.01, -0.01}, {0.1, 0.1, 0.01}};
    mesh::SurfaceMesh open = mesh::box_surface(core);
    open.triangles.conservativeResize(3, open.triangles.cols() - 1);
    ASSERT_TRUE(mesh::write_stl(folder.path() / "bar.stl", mesh::box_surface(bar), 1.0));
    ASSERT_TRUE(mesh::write_stl(folder.path() / "core.stl", mesh::box_surface(core), 1.0));
    ASSERT_TRUE(mesh::write_stl(folder.path() / "open.stl", open, 1.0));
    Driver driver(backend::make_core_backend(), 1280, 1400);
    driver.workbench->execute(ui::commands::Open{folder.path() / "bar.stl", 1.0});
    ASSERT_TRUE(driver.wait_for_job(60));
    driver.workbench->execute(ui::commands::MakeExperiment{folder.path() / "bar"});
    ASSERT_TRUE(driver.wait_for_job(60));
    ASSERT_TRUE(driver.state().scene->is_experiment && driver.state().body) << driver.state().log.back().text;
    show_parts(driver);
    driver.click("part/add_file");
    driver.settle();
    test::choose_file(driver, folder.path() / "core.stl");
    ASSERT_EQ(driver.state().scene->parts.size(), 1u) << driver.state().refused;
    EXPECT_EQ(driver.state().scene->parts[0].file.filename(), "core.stl");
    EXPECT_TRUE(driver.state().mesh_is_current()) << "a surface leaves the mesh as it is";
    const double share = driver.state().part_shares.col(1).mean();
    EXPECT_NEAR(share, 0.5, 0.1);
    driver.click("part/0/file");
    driver.settle();
    test::choose_file(driver, folder.path() / "open.stl");
    EXPECT_THAT(driver.state().refused, HasSubstr("open.stl is not closed"));
    EXPECT_EQ(driver.state().scene->parts[0].file.filename(), "core.stl");
    driver.workbench->execute(ui::commands::Undo{});
    EXPECT_TRUE(driver.state().scene->parts.empty());
}

/// Four cells in a row whose upper two have the number 7, in millimetres.
void write_two_regions(const std::filesystem::path& path) {
    const mesh::VolumeMesh mesh = mesh::box_hex_mesh({{0, 0, 0}, {80, 20, 20}}, {8, 2, 2});
    std::ofstream file(path);
    file << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << mesh.node_count() << "\n";
    for (Eigen::Index i = 0; i < mesh.node_count(); ++i) file << i + 1 << " " << mesh.nodes.col(i).transpose() << "\n";
    file << "$EndNodes\n$Elements\n" << mesh.cell_count() << "\n";
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) {
        const int region = mesh.nodes(0, mesh.cells.col(c)).mean() > 40.0 ? 7 : 3;
        file << c + 1 << " 5 2 " << region << " " << region << " " << (mesh.cells.col(c).array() + 1).transpose()
             << "\n";
    }
    file << "$EndElements\n";
}

TEST(PartPlace, IsANumberOfTheVolumeMesh) {
    const test::Folder folder("part_region");
    write_two_regions(folder.path() / "bar.msh");
    folder.write("experiment.toml",
                 "schema = \"experiment/1\"\nname = \"bar\"\n"
                 "[geometry]\nkind = \"volume\"\nfile = \"bar.msh\"\nunit = \"mm\"\n"
                 "[clamp]\nbox_m = [[-0.001, -0.001, -0.001], [0.001, 0.021, 0.021]]\n"
                 "[material]\nmodel = \"neo_hookean\"\nyoungs_modulus_Pa = 2.0e5\npoissons_ratio = 0.49\n"
                 "density_kg_m3 = 1000.0\ndamping_s = 0.003\n"
                 "[markers]\ncompare = \"displacement\"\n[markers.rest_m]\n"
                 "[[trial]]\nname = \"release\"\nrole = \"simulate\"\nduration_s = 1.0\nstart = \"straight\"\n");
    Driver driver(backend::make_core_backend(), 1280, 1400);
    driver.window->open(folder.path());
    ASSERT_TRUE(driver.wait_for_job(60));
    ASSERT_TRUE(driver.state().scene && driver.state().body) << driver.state().log.back().text;
    ASSERT_EQ(driver.state().scene->regions, (std::map<int, int>{{3, 16}, {7, 16}}));
    show_parts(driver);
    driver.click("part/add");
    driver.click("part/0/place");
    driver.click("part/0/place/region");
    EXPECT_EQ(driver.state().scene->parts.at(0).region, 3) << driver.state().refused;
    driver.click("part/0/region");
    driver.click("part/0/region/7");
    EXPECT_EQ(driver.state().scene->parts.at(0).region, 7) << driver.state().refused;
    EXPECT_EQ(held(driver), 16);
    driver.workbench->execute(ui::commands::Undo{});
    EXPECT_EQ(driver.state().scene->parts.at(0).region, 3);
}

}  // namespace
}  // namespace myo
