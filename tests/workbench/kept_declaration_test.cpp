#include <gtest/gtest.h>

#include <algorithm>

#include "toml/toml_text.hpp"
#include "workbench/opened_beam.hpp"

// Edits of trials and markers, kept in a project or in a copy for recovery, are there again when it is opened.

namespace myo {
namespace {

using test::OpenedBeam;

/// Adds a probe, turns gravity off and leaves the experiment's file as it is.
void edit(OpenedBeam& beam) {
    const Eigen::Vector3d corner = beam.driver.state().scene->surface.vertices.col(0);
    beam.driver.workbench->execute(ui::commands::EditDeclaration{
        {ui::commands::SetDeclared{{"markers", "probe_m", "added"}, toml::toml_vector(corner)},
         ui::commands::SetDeclared{{"environment", "gravity_m_s2"}, "[0.0, 0.0, 0.0]"}},
        "edit"});
    ASSERT_EQ(beam.driver.state().refused, "");
}

void expect_edited(const ui::commands::WorkbenchState& state) {
    ASSERT_TRUE(state.scene);
    const auto& markers = state.scene->markers;
    EXPECT_TRUE(std::any_of(markers.begin(), markers.end(), [](const auto& m) { return m.name == "added"; }));
    EXPECT_TRUE(state.scene->gravity_m_s2.isZero());
    EXPECT_TRUE(state.settings.declaration.text);
}

TEST(KeptDeclaration, IsThatOfTheProject) {
    OpenedBeam beam("kept_project");
    ASSERT_NO_FATAL_FAILURE(edit(beam));
    const std::filesystem::path file = beam.folder.path() / "beam.myoloop";
    beam.driver.workbench->execute(ui::commands::SaveAs{file});
    test::Driver next(backend::make_core_backend(), 1280, 900);
    next.window->open(file);
    ASSERT_TRUE(next.wait_for_job(60));
    expect_edited(next.state());
    EXPECT_FALSE(next.state().unsaved());
}

TEST(KeptDeclaration, IsRecovered) {
    OpenedBeam beam("kept_recovery");
    ASSERT_NO_FATAL_FAILURE(edit(beam));
    const std::filesystem::path file = beam.folder.path() / "unsaved.myoloop";
    beam.driver.workbench->autosave(file);
    beam.driver.workbench->finish_autosave();
    test::Driver next(backend::make_core_backend(), 1280, 900);
    next.workbench->execute(ui::commands::OfferRecovery{{file}});
    next.settle();
    next.click("recovery/recover");
    ASSERT_TRUE(next.wait_for_job(60));
    expect_edited(next.state());
    EXPECT_TRUE(next.state().unsaved());
}

/// The experiment's file changed since: the rest of the project is shown, and what is lost is said.
TEST(KeptDeclaration, ThatNoLongerAppliesIsLeftOut) {
    OpenedBeam beam("kept_stale");
    ASSERT_NO_FATAL_FAILURE(edit(beam));
    ui::commands::Settings stiff = beam.driver.state().settings;
    stiff.youngs_modulus_Pa = 321e3;
    beam.driver.workbench->execute(ui::commands::ChangeSettings{stiff, "stiff"});
    const std::filesystem::path file = beam.folder.path() / "beam.myoloop";
    beam.driver.workbench->execute(ui::commands::SaveAs{file});
    // A recording that the kept text names is gone, and the file no longer names it.
    std::string text = beam.text();
    const std::size_t last = text.rfind("[[trial]]");
    ASSERT_NE(last, std::string::npos);
    ASSERT_TRUE(write_file(beam.copy / "experiment.toml", text.substr(0, last)));
    std::filesystem::remove(beam.copy / "tip_weight.csv");
    test::Driver next(backend::make_core_backend(), 1280, 900);
    next.window->open(file);
    ASSERT_TRUE(next.wait_for_job(60));
    ASSERT_TRUE(next.state().scene) << next.state().log.back().text;
    EXPECT_EQ(next.state().settings.youngs_modulus_Pa, 321e3);
    EXPECT_TRUE(std::any_of(next.state().log.begin(), next.state().log.end(),
                            [](const auto& line) { return line.text.find("no longer apply") != std::string::npos; }));
}

}  // namespace
}  // namespace myo
