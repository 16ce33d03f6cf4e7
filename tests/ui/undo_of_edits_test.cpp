#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "fibre/cell_paint.hpp"
#include "ui/bare_workbench.hpp"

// Undo of every kind of edit, and what is no edit.

namespace myo::ui::undo_of_edits {
namespace {

using commands::Settings;
using test::BareWorkbench;

/// Expects that what was done since `before` is one step of undo, forth and back, and undoes it.
void expect_one_step(BareWorkbench& bench, const Settings& before, const std::string& what) {
    const Settings after = bench.settings();
    EXPECT_FALSE(after == before) << what;
    EXPECT_TRUE(bench.state().can_undo) << what;
    EXPECT_FALSE(bench.state().can_redo) << what;
    bench.execute(commands::Undo{});
    EXPECT_EQ(bench.settings(), before) << what;
    EXPECT_FALSE(bench.state().can_undo) << what;
    EXPECT_TRUE(bench.state().can_redo) << what;
    bench.execute(commands::Redo{});
    EXPECT_EQ(bench.settings(), after) << what;
    EXPECT_FALSE(bench.state().can_redo) << what;
    bench.execute(commands::Undo{});
    EXPECT_EQ(bench.settings(), before) << what;
}

commands::AddedEffect added_drag() {
    return {{"linear_drag", {{"coefficient_Pa_s_m", 22.0}}, false}, "Linear drag", "coefficient 22 Pa s/m"};
}

TEST(UndoOfEdits, EveryNumberAndChoiceOfTheSettings) {
    struct Edit {
        const char* what;
        std::function<void(Settings&)> apply;
    };
    const std::vector<Edit> edits{{"element", [](Settings& s) { s.element = mesh::CellType::tet10; }},
                                  {"edge length", [](Settings& s) { s.resolution_m = 0.02; }},
                                  {"material", [](Settings& s) { s.material = "gent"; }},
                                  {"number of a law", [](Settings& s) { s.law["gent_limit"] = 12.0; }},
                                  {"modulus", [](Settings& s) { s.youngs_modulus_Pa = 3e5; }},
                                  {"ratio", [](Settings& s) { s.poissons_ratio = 0.45; }},
                                  {"density", [](Settings& s) { s.density_kg_m3 = 1200.0; }},
                                  {"damping", [](Settings& s) { s.damping_s = 0.004; }},
                                  {"integrator", [](Settings& s) { s.integrator = "implicit_euler"; }},
                                  {"spectral radius", [](Settings& s) { s.spectral_radius = 0.8; }},
                                  {"time step", [](Settings& s) { s.time_step_s = 0.005; }},
                                  {"automatic step", [](Settings& s) { s.own_step = true; }},
                                  {"velocity force", [](Settings& s) { s.velocity_force_1_s = -2.0; }},
                                  {"effect", [](Settings& s) { s.effects = {added_drag()}; }},
                                  {"effect off",
                                   [](Settings& s) {
                                       s.off = {{0, "linear_drag"}};
                                   }},
                                  {"muscle", [](Settings& s) { s.muscles.resize(1); }},
                                  {"mesh words", [](Settings& s) { s.declaration.mesh_words = "another clamp"; }}};
    BareWorkbench bench;
    bench.open_beam();
    const Settings before = bench.settings();
    for (const Edit& edit : edits) {
        bench.change(edit.apply, edit.what);
        expect_one_step(bench, before, edit.what);
    }
}

TEST(UndoOfEdits, ASignalThatIsImported) {
    BareWorkbench bench;
    bench.open_beam();
    bench.backend->signals["/level.csv"] = {{0.0, 1.0}, {1.0, 0.7}};
    bench.change([](Settings& s) { s.muscles.resize(2); }, "muscles");
    const Settings before = bench.settings();
    for (const commands::ImportSignal& without :
         {commands::ImportSignal{1, "/missing.csv"}, {2, "/level.csv"}, {-1, "/level.csv"}}) {
        bench.execute(without);
        EXPECT_EQ(bench.settings(), before) << without.muscle;
    }
    bench.execute(commands::ImportSignal{1, "/level.csv"});
    EXPECT_FALSE(bench.settings().muscles[0].signal);
    ASSERT_TRUE(bench.settings().muscles[1].signal);
    EXPECT_EQ(*bench.settings().muscles[1].signal, bench.backend->signals["/level.csv"]);
    bench.execute(commands::Undo{});
    EXPECT_EQ(bench.settings(), before);
    bench.execute(commands::Undo{});
    EXPECT_TRUE(bench.settings().muscles.empty());
}

TEST(UndoOfEdits, APaintedMuscleWithTheCellsOnTheBody) {
    BareWorkbench bench;
    bench.open_beam();
    bench.change([](Settings& s) { s.muscles.resize(1); }, "muscle");
    const mesh::VolumeMesh& mesh = bench.state().body->mesh;
    const auto whole = [&] {
        auto paint = std::make_shared<fibre::CellPaint>(fibre::blank_paint(mesh));
        paint->weights.setOnes();
        paint->directions.row(0).setOnes();
        return paint;
    };
    const Settings before = bench.settings();
    // A stroke that began on another mesh, and one without a muscle, are dropped.
    auto other = whole();
    other->weights.conservativeResize(other->count() - 1);
    bench.execute(commands::Paint{0, other, "stroke"});
    bench.execute(commands::Paint{1, whole(), "stroke"});
    bench.execute(commands::Paint{-1, whole(), "stroke"});
    bench.execute(commands::Paint{0, nullptr, "stroke"});
    EXPECT_EQ(bench.settings(), before);
    EXPECT_EQ(bench.state().chosen_paint()->weights.maxCoeff(), 0.0);
    bench.execute(commands::Paint{0, whole(), "stroke"});
    const auto mask = bench.settings().muscles[0].paint;
    ASSERT_TRUE(mask);
    EXPECT_EQ(bench.state().chosen_paint()->weights.minCoeff(), 1.0);
    bench.execute(commands::Undo{});
    EXPECT_EQ(bench.settings(), before);
    EXPECT_EQ(bench.state().chosen_paint()->weights.maxCoeff(), 0.0);
    bench.execute(commands::Redo{});
    EXPECT_EQ(bench.settings().muscles[0].paint, mask);
    EXPECT_EQ(bench.state().chosen_paint()->weights.minCoeff(), 1.0);
}

TEST(UndoOfEdits, AnEffectThatMovesIntoTheExperimentWithItsSwitch) {
    for (const bool off : {false, true}) {
        BareWorkbench bench;
        bench.backend->as_experiment = true;
        bench.open_beam();
        commands::AddedEffect drag = added_drag();
        drag.off = off;
        bench.change([&](Settings& s) { s.effects = {drag}; }, "effect");
        const Settings before = bench.settings();
        bench.execute(commands::DeclareEffect{1});
        EXPECT_EQ(bench.settings(), before) << "there is only one";
        bench.execute(commands::DeclareEffect{0});
        EXPECT_TRUE(bench.settings().effects.empty()) << "a run must not have it twice";
        const auto expected = off ? std::vector<commands::SwitchedOff>{{0, "linear_drag"}}
                                  : std::vector<commands::SwitchedOff>{};
        EXPECT_EQ(bench.settings().off, expected);
        const auto& edit = std::get<commands::AppendDeclared>(bench.backend->edits.back());
        EXPECT_EQ(edit.body.substr(0, 20), "id = \"linear_drag\"\nc");
        bench.execute(commands::Undo{});
        EXPECT_EQ(bench.settings(), before);
    }
}

TEST(UndoOfEdits, TheEffectsOfADiagnosis) {
    BareWorkbench bench;
    bench.open_beam();
    bench.execute_and_wait(commands::Diagnose{});
    ASSERT_TRUE(bench.state().diagnosis);
    const Settings before = bench.settings();
    for (const char* key : {"declared", "added_mass", "unknown"}) {
        bench.execute(commands::AddEffect{key});
        EXPECT_EQ(bench.settings(), before) << key << " has no fitted effect";
    }
    bench.execute(commands::AddEffect{"linear_drag"});
    ASSERT_EQ(bench.settings().effects.size(), 1u);
    EXPECT_EQ(bench.settings().youngs_modulus_Pa, 2.55e5) << "fitted together with it";
    expect_one_step(bench, before, "effects");
}

TEST(UndoOfEdits, ADragIsOneStepAndAnEditWithoutAChangeNone) {
    BareWorkbench bench;
    bench.open_beam();
    const Settings before = bench.settings();
    bench.change([](Settings&) {}, "nothing");
    EXPECT_FALSE(bench.state().can_undo);
    for (const double density : {1100.0, 1150.0, 3e4, 4e4})
        bench.change([&](Settings& s) { s.density_kg_m3 = density; }, "density", density > 1100.0);
    EXPECT_EQ(bench.settings().density_kg_m3, commands::density_limits.highest);
    expect_one_step(bench, before, "density");
    // At its limit it stays, so there is nothing to undo.
    bench.change([](Settings& s) { s.spectral_radius = 1.0; }, "radius");
    bench.change([](Settings& s) { s.spectral_radius = 2.0; }, "radius");
    bench.execute(commands::Undo{});
    EXPECT_EQ(bench.settings(), before);
}

TEST(UndoOfEdits, WhatIsShownIsNoEdit) {
    BareWorkbench bench;
    bench.open_beam();
    bench.change([](Settings& s) { s.density_kg_m3 = 1200.0; }, "density");
    const Settings after = bench.settings();
    bench.execute(commands::Undo{});
    const std::vector<commands::Command> shown{commands::ChooseTrial{1},
                                               commands::ChooseMarker{2},
                                               commands::ChooseMuscle{0},
                                               commands::SetTime{0.5},
                                               commands::Play{},
                                               commands::SetSpeed{2.0},
                                               commands::ChangeView{},
                                               commands::ChangeBrush{},
                                               commands::SetDampingFrequency{3},
                                               commands::SetTheme{},
                                               commands::SetLayout{},
                                               commands::Bookmark{"/beam"},
                                               commands::ChangeOptimize{},
                                               commands::ChooseCandidate{"declared"},
                                               commands::LogMessage{},
                                               commands::ClearLog{}};
    for (const commands::Command& command : shown) bench.execute(command);
    EXPECT_FALSE(bench.state().can_undo);
    ASSERT_TRUE(bench.state().can_redo);
    EXPECT_FALSE(bench.state().unsaved());
    bench.execute(commands::Redo{});
    EXPECT_EQ(bench.settings(), after);
}

TEST(UndoOfEdits, AnImportHasItsOwnAndAnotherBodyNone) {
    BareWorkbench bench;
    bench.open_beam();
    bench.change([](Settings& s) { s.density_kg_m3 = 1200.0; }, "density");
    const Settings edited = bench.settings();
    bench.execute_and_wait(commands::ReadRecording{"/take.c3d"});
    ASSERT_TRUE(bench.state().import);
    // The markers that the program proposed are its first step, and its only one.
    bench.execute(commands::Undo{});
    EXPECT_TRUE(bench.state().import->choices.markers[0].name.empty());
    EXPECT_FALSE(bench.state().can_undo);
    bench.execute(commands::Undo{});
    EXPECT_EQ(bench.settings(), edited) << "the settings are not what is being edited";
    bench.execute(commands::CancelImport{});
    EXPECT_TRUE(bench.state().can_undo);
    bench.execute(commands::Undo{});
    EXPECT_EQ(bench.settings().density_kg_m3, 1070.0);
    ASSERT_TRUE(bench.state().can_redo);
    bench.execute_and_wait(commands::Open{"/other", {}});
    EXPECT_FALSE(bench.state().can_redo);
    EXPECT_FALSE(bench.state().can_undo);
}

}  // namespace
}  // namespace myo::ui::undo_of_edits
