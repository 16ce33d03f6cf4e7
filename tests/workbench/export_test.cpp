#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>

#include "backend/workbench_backend.hpp"
#include "base/files.hpp"
#include "mesh/boundary_surface.hpp"
#include "mesh/surface_reader.hpp"
#include "mesh/volume_reader.hpp"
#include "support/folder.hpp"
#include "ui/driver.hpp"
#include "workbench/beam_take.hpp"

// Files that the window writes for other programs are read again.

namespace myo {
namespace {

namespace fs = std::filesystem;
using test::Driver;

/// Volume inside a closed surface [m3], by the divergence theorem.
double volume_m3(const mesh::SurfaceMesh& surface) {
    double volume = 0.0;
    for (Eigen::Index t = 0; t < surface.triangles.cols(); ++t) {
        const Eigen::Vector3d a = surface.vertices.col(surface.triangles(0, t)),
                              b = surface.vertices.col(surface.triangles(1, t)),
                              c = surface.vertices.col(surface.triangles(2, t));
        volume += a.dot(b.cross(c)) / 6.0;
    }
    return volume;
}

/// The bundled beam after a run, coloured by its displacement, at 0.1 s.
struct RunBeam {
    test::Folder folder;
    Driver driver{backend::make_core_backend(), 1280, 900};

    explicit RunBeam(const std::string& name) : folder(name) {
        driver.workbench->execute(ui::commands::Open{test::beam_in(folder), std::nullopt});
        EXPECT_TRUE(driver.wait_for_job(60));
        ui::commands::Settings coarse = driver.state().settings;
        coarse.resolution_m = 0.01;
        driver.workbench->execute(ui::commands::ChangeSettings{coarse, "resolution"});
        driver.workbench->execute(ui::commands::Run{});
        EXPECT_TRUE(driver.wait_for_job(120));
        EXPECT_TRUE(driver.state().run) << driver.state().log.back().text;
        ui::commands::ViewOptions view = driver.state().view;
        view.field = "displacement";
        driver.workbench->execute(ui::commands::ChangeView{view});
        driver.workbench->execute(ui::commands::SetTime{0.1});
        driver.settle();
    }
    fs::path write(const std::string& name, ui::commands::ShapeExport what) {
        what.path = folder.path() / name;
        driver.workbench->execute(ui::commands::ExportBody{what});
        EXPECT_TRUE(driver.wait_for_job(60));
        EXPECT_EQ(driver.state().log.back().level, ui::commands::LogLevel::done) << driver.state().log.back().text;
        return what.path;
    }
    mesh::SurfaceMesh shown_surface() {
        mesh::VolumeMesh deformed = driver.state().body->mesh;
        deformed.nodes = driver.window->scene().positions;
        return mesh::boundary_surface(deformed);
    }
};

TEST(ExportedFiles, VtuHoldsTheDeformedMeshAndItsFields) {
    RunBeam beam("export_vtu");
    const fs::path file = beam.write("body.vtu", {{}, ui::commands::ShapeFormat::vtu});
    const Result<mesh::VolumeMesh> read = mesh::read_volume(file, 1.0);
    ASSERT_TRUE(read) << read.error().text();
    const mesh::VolumeMesh& body = beam.driver.state().body->mesh;
    EXPECT_EQ(read->cells, body.cells);
    EXPECT_LT((read->nodes - beam.driver.window->scene().positions).cwiseAbs().maxCoeff(), 1e-15);
    EXPECT_GT((read->nodes - body.nodes).cwiseAbs().maxCoeff(), 1e-3) << "the beam has bent";
    const std::string text = *read_file(file);
    EXPECT_THAT(text, testing::HasSubstr("Name=\"displacement\""));
    EXPECT_THAT(text, testing::HasSubstr("[mm]\""));
}

TEST(ExportedFiles, StlHoldsTheVolumeOfTheDeformedBody) {
    RunBeam beam("export_stl");
    const fs::path file = beam.write("body.stl", {{}, ui::commands::ShapeFormat::stl});
    const Result<mesh::SurfaceMesh> read = mesh::read_surface(file, 1e-3);
    ASSERT_TRUE(read) << read.error().text();
    const double truth = volume_m3(beam.shown_surface());
    EXPECT_NEAR(volume_m3(*read), truth, 1e-5 * truth);
    EXPECT_NEAR(truth, 0.12 * 0.03 * 0.02, 0.02 * 0.12 * 0.03 * 0.02);
}

TEST(ExportedFiles, AllFramesAreACollection) {
    RunBeam beam("export_pvd");
    ui::commands::ShapeExport all{{}, ui::commands::ShapeFormat::vtu, true};
    const fs::path file = beam.write("motion.pvd", all);
    const ui::commands::SimulatedTrial& trial = *beam.driver.state().simulated_trial();
    const std::string text = *read_file(file);
    std::size_t count = 0;
    for (std::size_t at = text.find("<DataSet"); at != std::string::npos; at = text.find("<DataSet", at + 1)) ++count;
    EXPECT_EQ(count, trial.frames.size());
    const fs::path last = beam.folder.path() / "motion_frames" /
                          (std::string(4 - std::to_string(count - 1).size(), '0') + std::to_string(count - 1) + ".vtu");
    const Result<mesh::VolumeMesh> read = mesh::read_volume(last, 1.0);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_LT((read->nodes - trial.frames.back()).cwiseAbs().maxCoeff(), 1e-15);
}

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

TEST(ExportedFiles, GlbIsASoundContainerOfTheSurface) {
    RunBeam beam("export_glb");
    const std::string bytes = *read_file(beam.write("body.glb", {{}, ui::commands::ShapeFormat::glb}));
    ASSERT_GT(bytes.size(), 28u);
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(number_at(bytes, 4), 2u);
    EXPECT_EQ(number_at(bytes, 8), bytes.size());
    const std::size_t json_size = number_at(bytes, 12);
    EXPECT_EQ(bytes.substr(16, 4), "JSON");
    EXPECT_EQ(json_size % 4, 0u);
    const std::size_t binary = 20 + json_size;
    EXPECT_EQ(bytes.substr(binary + 4, 3), "BIN");
    EXPECT_EQ(binary + 8 + number_at(bytes, binary), bytes.size());
    const auto json = nlohmann::json::parse(bytes.substr(20, json_size));
    EXPECT_EQ(json["asset"]["version"], "2.0");
    const auto& primitive = json["meshes"][0]["primitives"][0];
    const auto view_of = [&](const nlohmann::json& accessor) {
        return json["bufferViews"][accessor.get<std::size_t>()];
    };
    const auto floats = [&](const std::string& name) {
        const auto& accessor = json["accessors"][primitive["attributes"][name].get<std::size_t>()];
        const auto view = view_of(accessor["bufferView"]);
        EXPECT_LE(view["byteOffset"].get<std::size_t>() + view["byteLength"].get<std::size_t>(),
                  json["buffers"][0]["byteLength"].get<std::size_t>());
        EXPECT_EQ(view["byteOffset"].get<std::size_t>() % 4, 0u);
        Eigen::Matrix3Xf values(3, accessor["count"].get<Eigen::Index>());
        EXPECT_EQ(view["byteLength"].get<std::size_t>(), 4u * static_cast<std::size_t>(values.size()));
        std::memcpy(values.data(), bytes.data() + binary + 8 + view["byteOffset"].get<std::size_t>(),
                    4u * static_cast<std::size_t>(values.size()));
        return values;
    };
    const Eigen::Matrix3Xf positions = floats("POSITION"), normals = floats("NORMAL"), colours = floats("COLOR_0");
    const mesh::SurfaceMesh truth = beam.shown_surface();
    EXPECT_EQ(positions, truth.vertices.cast<float>());
    const auto& bounds = json["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()];
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(bounds["min"][static_cast<std::size_t>(axis)].get<float>(), positions.row(axis).minCoeff());
        EXPECT_EQ(bounds["max"][static_cast<std::size_t>(axis)].get<float>(), positions.row(axis).maxCoeff());
    }
    EXPECT_LT((normals.colwise().norm().array() - 1.0f).abs().maxCoeff(), 1e-5f);
    EXPECT_GE(colours.minCoeff(), 0.0f);
    EXPECT_LE(colours.maxCoeff(), 1.0f);
    EXPECT_GT((colours.rowwise().maxCoeff() - colours.rowwise().minCoeff()).maxCoeff(), 0.2f);
    const auto& indices = json["accessors"][primitive["indices"].get<std::size_t>()];
    EXPECT_EQ(indices["count"].get<Eigen::Index>(), truth.triangles.size());
    mesh::SurfaceMesh read{positions.cast<double>(), Eigen::Matrix3Xi(3, truth.triangles.cols())};
    std::memcpy(read.triangles.data(),
                bytes.data() + binary + 8 + view_of(indices["bufferView"])["byteOffset"].get<std::size_t>(),
                4u * static_cast<std::size_t>(truth.triangles.size()));
    EXPECT_NEAR(volume_m3(read), volume_m3(truth), 1e-5 * volume_m3(truth)) << "outward triangles";
}

}  // namespace
}  // namespace myo
