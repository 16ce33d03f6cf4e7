#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <limits>

#include "backend/project_file.hpp"
#include "backend/user_files.hpp"
#include "backend/workbench_backend.hpp"
#include "base/files.hpp"
#include "support/folder.hpp"

namespace myo {
namespace {

namespace fs = std::filesystem;

/// Numbers that take all their digits, names that need care.
ui::commands::Project some_project(const fs::path& source) {
    ui::commands::Project project;
    project.source = source;
    project.metres_per_unit = 1e-3;
    project.trial = "a \"quoted\" name";
    for (bool ui::commands::ViewOptions::*const shown :
         {&ui::commands::ViewOptions::edges, &ui::commands::ViewOptions::grid, &ui::commands::ViewOptions::measured,
          &ui::commands::ViewOptions::simulated, &ui::commands::ViewOptions::trails, &ui::commands::ViewOptions::errors,
          &ui::commands::ViewOptions::labels, &ui::commands::ViewOptions::clamp, &ui::commands::ViewOptions::fibres,
          &ui::commands::ViewOptions::effect_force})
        project.view.*shown = false;
    project.view.opacity = 0.3;
    project.view.field = "von_mises";
    project.view.color_map = "magma";
    project.view.field_ranges = {{"von_mises", {0.0, 1e4 / 3.0}}, {"a field", {-0.25, 0.125}}};
    project.view.clip = {true, Eigen::Vector3d(0.6, 0.0, -0.8), -0.012, true};
    ui::commands::Settings& s = project.settings;
    s.element = mesh::CellType::tet10;
    s.resolution_m = 0.1 / 3.0;
    s.material = "gent";
    s.law = {{"gent_limit", 100.0 / 3.0}, {"mooney_rivlin_share", 0.0}};
    s.integrator = "generalized_alpha";
    s.youngs_modulus_Pa = 1e5 / 7.0 * 3.0;
    s.poissons_ratio = 0.43;
    s.density_kg_m3 = 1.1e3 / 3.0;
    s.damping_s = 0.007;
    s.spectral_radius = 0.8;
    s.time_step_s = 0.004 / 3.0;
    s.velocity_force_1_s = -0.125;
    s.effects = {{{"wild_effect",
                   {{"coefficient", 1.0 / 3.0},
                    {"direction", Eigen::VectorXd(Eigen::Vector3d(0.0, 1e-17, 1.0))},
                    {"marker", std::string("tip")},
                    {"list", std::vector<std::string>{"a", "b"}}},
                   true},
                  "Wild effect",
                  "1 ± 2",
                  true},
                 {{"calm_effect", {{"coefficient", 0.5}}, false}, "Calm effect", "0.5"}};
    s.off = {{0, "linear_drag"}, {3, "point_mass"}};
    fibre::PaintedMask mask;
    mask.cell_size_m = 0.004;
    mask.centroids_m.resize(3, 2);
    mask.centroids_m << 0.001, 0.005, 0.0, 0.0, 0.002, 0.002;
    mask.weights = Eigen::Vector2d(1.0, 0.0);
    mask.directions = Eigen::Matrix3Xd::Zero(3, 2);
    mask.directions.row(0).setOnes();
    ui::commands::Muscle upper{"upper / left",
                               "",
                               3,
                               1.25e5,
                               true,
                               "",
                               -1.0,
                               std::make_shared<const fibre::PaintedMask>(mask),
                               true,
                               fibre::Signal{{0.0, 0.5, 0.5}, {1.0, 0.8, 1.0}}};
    ui::commands::Muscle lower{"lower", "", 1, 8e4, false, "upper / left", -0.5, nullptr, false, std::nullopt};
    s.muscles = {upper, lower};
    return project;
}

TEST(ProjectFile, BringsBackAllThatWasWritten) {
    const test::Folder folder("project_file");
    folder.write("body.stl", "solid");
    const ui::commands::Project written = some_project(folder.path() / "body.stl");
    const fs::path file = folder.path() / "deep" / "arm.myoloop";
    ASSERT_TRUE(backend::write_project_file(file, written));
    const Result<ui::commands::Project> read = backend::read_project_file(file);
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->settings.muscles.size(), 2u);
    const fibre::PaintedMask &mask = *written.settings.muscles[0].paint, &again = *read->settings.muscles[0].paint;
    EXPECT_EQ(again.count(), 2);
    EXPECT_NEAR((again.centroids_m - mask.centroids_m).norm(), 0.0, 1e-9);
    ui::commands::Project same = *read;
    same.settings.muscles[0].paint = written.settings.muscles[0].paint;
    EXPECT_EQ(same, written);
    EXPECT_FALSE(fs::exists(file.string() + ".tmp"));
}

TEST(ProjectFile, KeepsNoMaskThatNothingNames) {
    const test::Folder folder("project_masks");
    folder.write("body.stl", "solid");
    ui::commands::Project project = some_project(folder.path() / "body.stl");
    const fs::path file = folder.path() / "arm.myoloop";
    const auto masks = [&] {
        return std::distance(fs::directory_iterator(folder.path() / "arm.files"), fs::directory_iterator());
    };
    ASSERT_TRUE(backend::write_project_file(file, project));
    EXPECT_EQ(masks(), 1);
    fibre::PaintedMask other = *project.settings.muscles[0].paint;
    other.weights(0) = 0.5;
    project.settings.muscles[0].paint = std::make_shared<const fibre::PaintedMask>(other);
    ASSERT_TRUE(backend::write_project_file(file, project));
    EXPECT_EQ(masks(), 1);
    EXPECT_DOUBLE_EQ(backend::read_project_file(file)->settings.muscles[0].paint->weights(0), 0.5);
}

/// A project in which the painted muscle was painted on, and which was copied before.
class CopiedProject : public ::testing::TestWithParam<const char*> {
protected:
    CopiedProject() {
        folder.write("body.stl", "solid");
        const fs::path file = folder.path() / "arm.myoloop";
        ui::commands::Project project = some_project(folder.path() / "body.stl");
        EXPECT_TRUE(backend::write_project_file(file, project));
        fs::copy_file(file, folder.path() / GetParam());
        fibre::PaintedMask other = *project.settings.muscles[0].paint;
        other.weights(0) = 0.5;
        project.settings.muscles[0].paint = std::make_shared<const fibre::PaintedMask>(other);
        EXPECT_TRUE(backend::write_project_file(file, project));
    }
    test::Folder folder{"project_copy"};
};

TEST_P(CopiedProject, KeepsItsPaint) {
    const fs::path again = folder.path() / "again.myoloop";
    fs::rename(folder.path() / GetParam(), again);
    const Result<ui::commands::Project> copy = backend::read_project_file(again);
    ASSERT_TRUE(copy) << copy.error().text();
    EXPECT_TRUE(copy->warnings.empty());
    EXPECT_DOUBLE_EQ(copy->settings.muscles[0].paint->weights(0), 1.0);
    EXPECT_DOUBLE_EQ(backend::read_project_file(folder.path() / "arm.myoloop")->settings.muscles[0].paint->weights(0),
                     0.5);
}
INSTANTIATE_TEST_SUITE_P(Names, CopiedProject,
                         ::testing::Values("arm_backup.myoloop", "arm.myoloop~", "arm.myoloop.2026-01-01"));

TEST(ProjectFile, OpensWithoutAMaskThatIsMissing) {
    const test::Folder folder("project_mask_missing");
    folder.write("body.stl", "solid");
    const fs::path file = folder.path() / "arm.myoloop";
    const ui::commands::Project project = some_project(folder.path() / "body.stl");
    ASSERT_TRUE(backend::write_project_file(file, project));
    const std::string mask = fs::directory_iterator(folder.path() / "arm.files")->path().filename().string();
    fs::remove_all(folder.path() / "arm.files");
    const Result<ui::commands::Project> read = backend::read_project_file(file);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->warnings,
              std::vector<std::string>{"The paint of muscle \"upper / left\" is lost: its mask arm.files/" + mask +
                                       " is not there."});
    EXPECT_EQ(read->settings.muscles[0].paint, nullptr);
    EXPECT_EQ(read->settings.muscles[0].signal, project.settings.muscles[0].signal);
    fs::create_directories(folder.path() / "arm.files");
    folder.write("arm.files/" + mask, "x,y\n");
    EXPECT_FALSE(backend::read_project_file(file));  // one that is there and broken
}

TEST(ProjectFile, LeavesTablesAloneThatItDidNotWrite) {
    const test::Folder folder("project_tables");
    folder.write("body.stl", "solid");
    fs::create_directories(folder.path() / "arm.files");
    folder.write("arm.files/take.csv", "time_s\n");
    folder.write("arm.files/other-0123456789abcdef.csv", "of another project");
    ui::commands::Project project = some_project(folder.path() / "body.stl");
    const fs::path file = folder.path() / "arm.myoloop";
    ASSERT_TRUE(backend::write_project_file(file, project));
    // Not even one that a person has named in the project by hand.
    Result<std::string> text = read_file(file);
    ASSERT_TRUE(text);
    const std::size_t at = text->find("arm.files/") + 10, end = text->find('"', at);
    const std::string mask = text->substr(at, end - at);
    fs::copy_file(folder.path() / "arm.files" / mask, folder.path() / "arm.files" / "drawn.csv");
    folder.write("arm.myoloop", text->replace(at, end - at, "drawn.csv"));
    project.settings.muscles[0].paint.reset();
    ASSERT_TRUE(backend::write_project_file(file, project));
    for (const char* const kept : {"take.csv", "other-0123456789abcdef.csv", "drawn.csv"})
        EXPECT_TRUE(fs::exists(folder.path() / "arm.files" / kept)) << kept;
}

TEST(ProjectFile, MayMoveWithItsExperiment) {
    const test::Folder folder("project_moves");
    folder.write("body.stl", "solid");
    fs::create_directories(folder.path() / "a" / "data");
    fs::copy_file(folder.path() / "body.stl", folder.path() / "a" / "data" / "body.stl");
    ASSERT_TRUE(backend::write_project_file(folder.path() / "a" / "p.myoloop",
                                            some_project(folder.path() / "a" / "data" / "body.stl")));
    fs::rename(folder.path() / "a", folder.path() / "b");
    const Result<ui::commands::Project> read = backend::read_project_file(folder.path() / "b" / "p.myoloop");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->source, fs::weakly_canonical(folder.path() / "b" / "data" / "body.stl"));
}

TEST(ProjectFile, SaysWhereItIsBroken) {
    const test::Folder folder("project_broken");
    folder.write("body.stl", "solid");
    const fs::path file = folder.path() / "arm.myoloop";
    ASSERT_TRUE(backend::write_project_file(file, some_project(folder.path() / "body.stl")));
    const std::string good = *read_file(file);
    struct Fault {
        std::string part, instead, told;
    };
    for (const Fault& fault : {Fault{"step_s", "stepp_s", "stepp_s"},
                               {"myoloop-project/1", "experiment/1", "schema"},
                               {"\"tet10\"", "\"hex20\"", "element"},
                               {"lower", "upper / left", "name"},
                               {"poissons_ratio = 0.43", "poissons_ratio = 0.7", "poissons_ratio"},
                               {"time_s = [0.0, 0.5, 0.5]", "time_s = [0.5, 0.0, 0.5]", "ascend"},
                               {"follows = { muscle = \"upper / left\"", "follows = { muscle = \"nobody\"", "nobody"},
                               {"[0.6, 0.0, -0.8]", "[0.6, 0.1, -0.8]", "normal"},
                               {"[-0.25, 0.125]", "[0.25, 0.125]", "a field"},
                               {"color_map", "colour_map", "colour_map"},
                               {"[material]", "[material", "arm.myoloop"}}) {
        std::string text = good;
        const std::size_t at = text.find(fault.part);
        ASSERT_NE(at, std::string::npos) << fault.part;
        folder.write("arm.myoloop", text.replace(at, fault.part.size(), fault.instead));
        const Result<ui::commands::Project> read = backend::read_project_file(file);
        ASSERT_FALSE(read) << fault.instead;
        EXPECT_NE(read.error().text().find(fault.told), std::string::npos) << read.error().text();
    }
}

TEST(UserFiles, PreferencesComeBackAndBrokenOnesAreTold) {
    const test::Folder folder("preferences");
    const fs::path file = folder.path() / "preferences.toml";
    EXPECT_EQ(*backend::read_preferences(file), ui::commands::Preferences{});
    ui::commands::Preferences p;
    p.theme = ui::platform::ThemeName::light;
    p.scale = 1.5f;
    p.layout = {400.0f, 200.0f};
    p.recent = {folder.path()};
    p.bookmarks = {folder.path(), "/elsewhere"};
    p.step_costs = {{mesh::CellType::hex8, 4608.0, 0.0068}, {mesh::CellType::tet10, 31725.0, 0.125}};
    ASSERT_TRUE(backend::write_preferences(file, p));
    EXPECT_EQ(*backend::read_preferences(file), p);
    p.recent.emplace_back(folder.path() / "gone");
    ASSERT_TRUE(backend::write_preferences(file, p));
    EXPECT_EQ(backend::read_preferences(file)->recent.size(), 1u) << "what is no longer there is not offered";
    folder.write("preferences.toml", "theme = 'pink'\n");
    EXPECT_FALSE(backend::read_preferences(file));
}

TEST(UserFiles, FindsUnsavedWorkOfProcessesThatAreGone) {
    const test::Folder folder("recoveries");
    folder.write("unsaved-999999999.myoloop", "");
    folder.write("other.myoloop", "");
    // Numbers are given anew: one belongs to another program now, the other to this process.
    folder.write("unsaved-" + std::to_string(getppid()) + ".myoloop", "");
    folder.write("unsaved-" + std::to_string(getpid()) + "-17.myoloop", "");
    folder.write(backend::recovery_file().filename().string(), "");  // this process writes to it
    EXPECT_EQ(backend::found_recoveries(folder.path()).size(), 3u);
    EXPECT_TRUE(backend::found_recoveries(folder.path() / "nowhere").empty());
}

TEST(UserFiles, UnsavedWorkHasANameAndATime) {
    const test::Folder folder("recovery_words");
    const std::string head = "schema = \"myoloop-project/1\"\nsource = \"/robots/finger/experiment.toml\"\n";
    folder.write("never_saved.myoloop", head);
    folder.write("saved.myoloop", head + "copy_of = \"/projects/bent.myoloop\"\n");
    EXPECT_EQ(backend::unsaved_work_words(folder.path() / "never_saved.myoloop").rfind("finger, ", 0), 0u)
        << backend::unsaved_work_words(folder.path() / "never_saved.myoloop");
    const std::string words = backend::unsaved_work_words(folder.path() / "saved.myoloop");
    EXPECT_EQ(words.rfind("bent.myoloop, ", 0), 0u) << words;
    EXPECT_NE(words.find(":"), std::string::npos) << words;
}

TEST(ProjectFile, IsClaimedByOneWindow) {
    const test::Folder folder("claims");
    const std::shared_ptr<ui::commands::Backend> one = backend::make_core_backend(), other = one;
    const fs::path file = folder.path() / "robot.myoloop";
    auto held = one->claim_project(file);
    ASSERT_TRUE(held);
    const auto refused = other->claim_project(file);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().what.rfind("robot.myoloop is open in another window of Myoloop, process ", 0), 0u);
    EXPECT_TRUE(other->claim_project(folder.path() / "other.myoloop"));
    held = std::shared_ptr<const void>();
    EXPECT_TRUE(other->claim_project(file));
}

}  // namespace
}  // namespace myo
