#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "ui/bare_workbench.hpp"

// Settings whose declaration is refused: nothing changes, whatever asked for them.

namespace myo::ui::refused_settings {
namespace {

using test::BareWorkbench;

/// An experiment whose first run has gravity as it was opened, and which shows a finer mesh and another gravity now.
void run_and_go_on(BareWorkbench& bench) {
    bench.backend->as_experiment = true;
    bench.open_beam();
    bench.execute_and_wait(commands::Run{});
    ASSERT_EQ(bench.state().history.size(), 1u);
    bench.declare("1.6");
    bench.mesh_with(0.015);
    ASSERT_NE(bench.state().history.front().on.body, bench.state().body);
}

TEST(RefusedSettings, ARestoredJobLeavesEverythingAsItWas) {
    BareWorkbench bench;
    ASSERT_NO_FATAL_FAILURE(run_and_go_on(bench));
    const commands::JobRecord record = bench.state().history.front();
    bench.execute_and_wait(commands::Run{});
    const commands::Settings before = bench.settings();
    const auto body = bench.state().body;
    const auto run = bench.state().run;
    bench.backend->refuses_declarations = true;
    bench.execute(commands::RestoreRecord{record.id});
    EXPECT_EQ(bench.settings(), before);
    EXPECT_EQ(bench.state().body, body);
    EXPECT_EQ(bench.state().run, run);
    EXPECT_TRUE(bench.state().run_is_current());
    EXPECT_EQ(bench.state().refused, "this is refused");
    EXPECT_EQ(bench.last_message(), "Not changed: this is refused") << "not that it is restored";
    bench.backend->refuses_declarations = false;
    // No step of undo was spent: the last one is still the finer mesh.
    bench.execute(commands::Undo{});
    EXPECT_EQ(bench.settings().resolution_m, test::CoarseBeam::edge_m);
    EXPECT_EQ(bench.settings().declaration, before.declaration);
}

TEST(RefusedSettings, ARestoredJobThatIsAcceptedIsOneStepOfUndo) {
    BareWorkbench bench;
    ASSERT_NO_FATAL_FAILURE(run_and_go_on(bench));
    const commands::JobRecord record = bench.state().history.front();
    const commands::Settings before = bench.settings();
    bench.execute(commands::RestoreRecord{record.id});
    EXPECT_EQ(bench.settings(), record.settings);
    EXPECT_EQ(bench.state().body, record.on.body);
    EXPECT_EQ(bench.state().run, record.run);
    EXPECT_TRUE(bench.state().run_is_current());
    EXPECT_TRUE(bench.state().mesh_is_current());
    bench.execute(commands::Undo{});
    EXPECT_EQ(bench.settings(), before);
    bench.execute(commands::Redo{});
    EXPECT_EQ(bench.settings(), record.settings);
    bench.execute(commands::RestoreRecord{record.id});
    bench.execute(commands::Undo{});
    EXPECT_EQ(bench.settings(), before) << "what is restored twice is no second step";
}

/// A calibration that also finds a value of the declaration.
class BeamWithFoundGravity : public test::CoarseBeam {
public:
    Result<commands::SearchResult> calibrate(const commands::Scene& scene, const commands::MeshedBody& body,
                                             const commands::Settings& settings, const Progress& progress,
                                             const LiveSearch& live) override {
        Result<commands::SearchResult> found = CoarseBeam::calibrate(scene, body, settings, progress, live);
        if (found) found->settings.declaration.text = std::make_shared<const std::string>("9.7");
        return found;
    }
};

TEST(RefusedSettings, AFoundValueIsShownButNotTakenNorToBeUndone) {
    const auto beam = std::make_shared<BeamWithFoundGravity>();
    beam->as_experiment = true;
    BareWorkbench bench(beam);
    bench.open_beam();
    const commands::Settings before = bench.settings();
    beam->refuses_declarations = true;
    bench.execute_and_wait(commands::Calibrate{});
    EXPECT_EQ(bench.settings(), before);
    EXPECT_FALSE(bench.state().can_undo);
    ASSERT_TRUE(bench.state().found) << "its error and values are a result all the same";
    EXPECT_EQ(bench.state().run_settings, bench.state().found->settings);
    EXPECT_FALSE(bench.state().run_is_current());
    EXPECT_EQ(bench.state().refused, "this is refused");
    // Restored, once it is no longer refused.
    beam->refuses_declarations = false;
    bench.execute(commands::RestoreRecord{bench.state().history.back().id});
    EXPECT_EQ(bench.settings(), bench.state().found->settings);
    EXPECT_EQ(*bench.settings().declaration.text, "9.7");
}

TEST(RefusedSettings, AFoundValueThatIsAcceptedIsUndoneAndRepeated) {
    const auto beam = std::make_shared<BeamWithFoundGravity>();
    beam->as_experiment = true;
    BareWorkbench bench(beam);
    bench.open_beam();
    const commands::Settings before = bench.settings();
    bench.execute_and_wait(commands::Calibrate{});
    const commands::Settings found = bench.settings();
    EXPECT_EQ(found.youngs_modulus_Pa, test::SwingingBeam::measured_modulus);
    EXPECT_TRUE(bench.state().can_undo) << "as soon as the search has ended";
    EXPECT_FALSE(bench.state().can_redo);
    bench.execute(commands::Undo{});
    EXPECT_EQ(bench.settings(), before);
    bench.execute(commands::Redo{});
    EXPECT_EQ(bench.settings(), found);
}

TEST(RefusedSettings, AnEditIsToldUntilAnotherIsAccepted) {
    BareWorkbench bench;
    bench.backend->as_experiment = true;
    bench.open_beam();
    const commands::Settings before = bench.settings();
    bench.declare("refused");
    EXPECT_EQ(bench.settings(), before);
    EXPECT_FALSE(bench.state().can_undo);
    EXPECT_EQ(bench.state().refused, "this is refused");
    bench.change([](commands::Settings& s) { s.density_kg_m3 = 1200.0; }, "density");
    EXPECT_EQ(bench.state().refused, "this is refused") << "an edit of something else settles nothing";
    bench.declare("1.6");
    EXPECT_EQ(bench.state().refused, "");
    EXPECT_EQ(bench.last_message(), "Changed; what was refused before is settled.");
    EXPECT_EQ(bench.state().scene->description, "1.6");
}

/// The tendon of a mesh is named like the declaration that it was asked for.
class BeamWithTendon : public test::CoarseBeam {
public:
    commands::BodyActuators actuators(const commands::Scene& scene, const commands::MeshedBody&) const override {
        commands::BodyActuators all;
        all.tendons.push_back({scene.description, {}});
        return all;
    }
};

TEST(RestoredBody, HasTheActuatorsThatAreDeclaredNow) {
    const auto beam = std::make_shared<BeamWithTendon>();
    beam->as_experiment = true;
    BareWorkbench bench(beam);
    bench.open_beam();
    bench.declare("1.6");
    bench.execute_and_wait(commands::Run{});
    const int id = bench.state().history.back().id;
    bench.mesh_with(0.015);
    bench.execute(commands::RestoreRecord{id});
    // Its mesh is older than the edit.
    ASSERT_EQ(bench.state().actuators.tendons.size(), 1u);
    EXPECT_EQ(bench.state().actuators.tendons.front().name, "1.6");
}

}  // namespace
}  // namespace myo::ui::refused_settings
