#include <gtest/gtest.h>

#include <cstdlib>

#include "backend/workbench_backend.hpp"
#include "commands/backend.hpp"
#include "support/folder.hpp"

namespace myo {
namespace {

/// No tetrahedra can be made while it lives.
class NoMesher {
public:
    NoMesher() {
        if (const char* named = std::getenv("MYOLOOP_TETGEN")) before_ = named;
        ::setenv("MYOLOOP_TETGEN", "/nowhere/myoloop-tetgen", 1);
    }
    ~NoMesher() {
        if (before_.empty())
            ::unsetenv("MYOLOOP_TETGEN");
        else
            ::setenv("MYOLOOP_TETGEN", before_.c_str(), 1);
    }
    NoMesher(const NoMesher&) = delete;
    NoMesher& operator=(const NoMesher&) = delete;

private:
    std::string before_;
};

std::string example(const std::string& name) { return std::string(MYOLOOP_SOURCE_DIR) + "/assets/examples/" + name; }

/// A bar of 60 x 12 x 10 mm.
std::string bar_file(const test::Folder& folder) {
    const double x[2] = {0.0, 60.0}, y[2] = {0.0, 12.0}, z[2] = {0.0, 10.0};
    constexpr int faces[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                  {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    std::string text = "solid bar\n";
    for (const auto& face : faces) {
        text += "facet normal 0 0 0\nouter loop\n";
        for (const int corner : face)
            text += "vertex " + std::to_string(x[corner & 1]) + " " + std::to_string(y[(corner >> 1) & 1]) + " " +
                    std::to_string(z[corner >> 2]) + "\n";
        text += "endloop\nendfacet\n";
    }
    folder.write("bar.stl", text + "endsolid bar\n");
    return folder.str("bar.stl");
}

/// Meshes as asked for, and runs a tenth of a second without any mesher: on the mesh that is shown.
void expect_run_on_shown_mesh(ui::commands::Backend& backend, const ui::commands::Scene& scene,
                              const ui::commands::Settings& settings) {
    const Result<ui::commands::MeshedBody> body = backend.mesh(scene, settings, {});
    ASSERT_TRUE(body) << body.error().text();
    const NoMesher none;
    const Result<ui::commands::RunResult> run = backend.simulate(scene, *body, settings,
                                                                 ui::commands::RunExtent{0, 0.05}, {});
    ASSERT_TRUE(run) << run.error().text();
    ASSERT_FALSE(run->trials[0].frames.empty()) << run->problem;
    EXPECT_EQ(run->trials[0].frames.front(), body->mesh.nodes) << "at rest every node is where it is shown";
}

TEST(ShownMesh, IsThatWhichAPlainMeshRunsOn) {
    const test::Folder folder("shown_mesh");
    const std::shared_ptr<ui::commands::Backend> backend = backend::make_core_backend();
    const Result<ui::commands::Scene> scene = backend->open(bar_file(folder), 1e-3, {});
    ASSERT_TRUE(scene) << scene.error().text();
    for (const mesh::CellType element : {mesh::CellType::hex8, mesh::CellType::tet10}) {
        SCOPED_TRACE(to_string(element));
        ui::commands::Settings settings = scene->settings;
        settings.element = element;
        settings.resolution_m = element == mesh::CellType::hex8 ? 0.0035 : 0.006;
        expect_run_on_shown_mesh(*backend, *scene, settings);
    }
}

TEST(ShownMesh, IsThatWhichAnExperimentRunsOn) {
    const std::shared_ptr<ui::commands::Backend> backend = backend::make_core_backend();
    const Result<ui::commands::Scene> scene = backend->open(example("silicone_beam"), std::nullopt, {});
    ASSERT_TRUE(scene) << scene.error().text();
    ui::commands::Settings settings = scene->settings;
    settings.element = mesh::CellType::tet10;
    settings.resolution_m = 0.012;
    expect_run_on_shown_mesh(*backend, *scene, settings);
}

TEST(ShownMesh, ThatOfOpeningIsNotMadeAgain) {
    const std::shared_ptr<ui::commands::Backend> backend = backend::make_core_backend();
    const Result<ui::commands::Scene> scene = backend->open(example("fish_tail"), std::nullopt, {});
    ASSERT_TRUE(scene) << scene.error().text();
    ASSERT_NE(scene->settings.element, mesh::CellType::hex8);
    const NoMesher none;
    EXPECT_TRUE(backend->mesh(*scene, scene->settings, {}));
    ui::commands::Settings finer = scene->settings;
    finer.resolution_m *= 0.9;
    EXPECT_FALSE(backend->mesh(*scene, finer, {}));
}

TEST(ShownMesh, APlainMeshFeelsTheEffectsOfItsSettings) {
    const test::Folder folder("shown_mesh_effects");
    const std::shared_ptr<ui::commands::Backend> backend = backend::make_core_backend();
    const Result<ui::commands::Scene> scene = backend->open(bar_file(folder), 1e-3, {});
    ASSERT_TRUE(scene) << scene.error().text();
    ui::commands::Settings settings = scene->settings;
    settings.resolution_m = 0.005;
    const Result<ui::commands::MeshedBody> body = backend->mesh(*scene, settings, {});
    ASSERT_TRUE(body) << body.error().text();
    const auto fall = [&] {
        const Result<ui::commands::RunResult> run = backend->simulate(*scene, *body, settings,
                                                                      ui::commands::RunExtent{0, 0.05}, {});
        EXPECT_TRUE(run && run->problem.empty());
        return (run->trials[0].frames.back() - run->trials[0].frames.front()).norm();
    };
    const double in_air = fall();
    settings.effects.push_back({{"quadratic_drag", {{"coefficient_kg_m3", 5e4}}, true}, "Quadratic drag", ""});
    EXPECT_LT(fall(), 0.9 * in_air);
}

}  // namespace
}  // namespace myo
