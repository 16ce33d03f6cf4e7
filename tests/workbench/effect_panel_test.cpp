#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "commands/effect_words.hpp"
#include "effect/catalogue.hpp"
#include "mesh/vtk_writer.hpp"
#include "workbench/opened_beam.hpp"

// Effects of an experiment: declared, edited, switched off and removed in the window.

namespace myo {
namespace {

using test::Driver;
using test::OpenedBeam;
using testing::HasSubstr;

Eigen::Matrix3Xd tip_path(OpenedBeam& beam) { return beam.driver.state().simulated_trial()->markers.front(); }

void add_effect(Driver& driver, const std::string& id) {
    driver.window->show_panel("effect");
    driver.settle();
    driver.click("effect/add");
    driver.settle();
    driver.click("effect/find");
    driver.key(ImGuiKey_A, {.ctrl = true});
    driver.type(effect::find_effect(id)->summary);
    driver.settle();
    driver.click("effect/add/" + id);
    driver.settle();
}

TEST(EffectsInWindow, SwitchedOffAnEffectLeavesTheRunAsIfItWereNotDeclared) {
    OpenedBeam beam("effect_off");
    beam.keep_step();
    ASSERT_NO_FATAL_FAILURE(beam.run());
    const Eigen::Matrix3Xd without = tip_path(beam);
    add_effect(beam.driver, "linear_drag");
    ASSERT_EQ(beam.driver.state().scene->effects.declared.size(), 1u) << beam.driver.state().refused;
    EXPECT_THAT(*beam.driver.state().settings.declaration.text, HasSubstr("linear_drag"));
    ASSERT_NO_FATAL_FAILURE(beam.run());
    const Eigen::Matrix3Xd with = tip_path(beam);
    EXPECT_GT((with - without).cwiseAbs().maxCoeff(), 1e-4);
    beam.driver.window->show_panel("effect");
    beam.driver.settle();
    beam.driver.click("effect/declared/0/on");
    EXPECT_EQ(beam.driver.state().settings.off.size(), 1u);
    EXPECT_FALSE(beam.driver.state().run_is_current());
    ASSERT_NO_FATAL_FAILURE(beam.run());
    EXPECT_EQ(tip_path(beam), without);
    beam.driver.workbench->execute(ui::commands::Undo{});
    EXPECT_TRUE(beam.driver.state().settings.off.empty());
    ASSERT_NO_FATAL_FAILURE(beam.run());
    EXPECT_EQ(tip_path(beam), with);
    beam.driver.workbench->execute(ui::commands::Undo{});
    EXPECT_TRUE(beam.driver.state().scene->effects.declared.empty());
}

/// What a diagnosis added becomes part of the experiment: the same run, one step of undo.
TEST(EffectsInWindow, AddedOnesArePutIntoTheExperiment) {
    OpenedBeam beam("effect_declared");
    beam.keep_step();
    ui::commands::Settings settings = beam.driver.state().settings;
    settings.effects.push_back({{"linear_drag", {{"coefficient_Pa_s_m", 50.0}}, true}, "Linear drag", ""});
    beam.driver.workbench->execute(ui::commands::ChangeSettings{settings, "effects"});
    ASSERT_NO_FATAL_FAILURE(beam.run());
    const Eigen::Matrix3Xd added = tip_path(beam);
    beam.driver.window->show_panel("effect");
    beam.driver.settle();
    beam.driver.click("effect/added/0");
    beam.driver.settle();
    beam.driver.click("effect/added/0/declare");
    ASSERT_EQ(beam.driver.state().scene->effects.declared.size(), 1u) << beam.driver.state().refused;
    EXPECT_TRUE(beam.driver.state().settings.effects.empty());
    EXPECT_TRUE(beam.driver.state().scene->effects.declared[0].calibrate);
    EXPECT_THAT(*beam.driver.state().settings.declaration.text, HasSubstr("coefficient_Pa_s_m = 50"));
    ASSERT_NO_FATAL_FAILURE(beam.run());
    EXPECT_LT((tip_path(beam) - added).cwiseAbs().maxCoeff(), 1e-12);
    beam.driver.workbench->execute(ui::commands::Undo{});
    EXPECT_EQ(beam.driver.state().settings.effects.size(), 1u);
    EXPECT_TRUE(beam.driver.state().scene->effects.declared.empty());
}

TEST(EffectsInWindow, AddedOnesAreSwitchedOffToo) {
    OpenedBeam beam("effect_added_off");
    beam.keep_step();
    ASSERT_NO_FATAL_FAILURE(beam.run());
    const Eigen::Matrix3Xd without = tip_path(beam);
    ui::commands::Settings settings = beam.driver.state().settings;
    settings.effects.push_back({{"linear_drag", {{"coefficient_Pa_s_m", 50.0}}, true}, "Linear drag", ""});
    beam.driver.workbench->execute(ui::commands::ChangeSettings{settings, "effects"});
    ASSERT_NO_FATAL_FAILURE(beam.run());
    EXPECT_GT((tip_path(beam) - without).cwiseAbs().maxCoeff(), 1e-4);
    beam.driver.window->show_panel("effect");
    beam.driver.settle();
    beam.driver.click("effect/added/0/on");
    ASSERT_NO_FATAL_FAILURE(beam.run());
    EXPECT_EQ(tip_path(beam), without);
}

TEST(EffectsInWindow, ValuesFitAndRemovalAreEditsOfTheDeclaration) {
    OpenedBeam beam("effect_values");
    Driver& driver = beam.driver;
    const std::size_t calibrated = driver.state().scene->calibrated.size();
    add_effect(driver, "point_mass");
    ASSERT_EQ(driver.state().scene->effects.declared.size(), 1u) << driver.state().refused;
    driver.double_click("effect/declared/0/mass_kg");
    driver.key(ImGuiKey_A, {.ctrl = true});
    driver.type("2,5 g");
    driver.key(ImGuiKey_Enter);
    driver.settle();
    EXPECT_THAT(*driver.state().settings.declaration.text, HasSubstr("mass_kg = 0.0025"));
    driver.click("effect/declared/0/fit");
    EXPECT_TRUE(driver.state().scene->effects.declared[0].calibrate) << driver.state().refused;
    EXPECT_EQ(driver.state().scene->calibrated.size(), calibrated + 4) << "a mass and three coordinates";
    // Effects behind a removed one keep their switches.
    add_effect(driver, "linear_drag");
    ASSERT_EQ(driver.state().scene->effects.declared.size(), 2u);
    driver.click("effect/declared/1/on");
    driver.click("effect/declared/0/remove");
    ASSERT_EQ(driver.state().scene->effects.declared.size(), 1u);
    EXPECT_EQ(driver.state().settings.off, (std::vector<ui::commands::SwitchedOff>{{0, "linear_drag"}}));
    driver.workbench->execute(ui::commands::Undo{});
    EXPECT_EQ(driver.state().settings.off, (std::vector<ui::commands::SwitchedOff>{{1, "linear_drag"}}));
}

/// The start values of every effect that can act are an experiment.
TEST(EffectsInWindow, EveryEffectOfTheCatalogueCanBeAdded) {
    OpenedBeam beam("effect_catalogue");
    const auto& effects = beam.driver.state().scene->effects;
    ASSERT_EQ(effects.offered.size(), effect::effect_catalogue().size());
    int added = 0;
    for (std::size_t i = 0; i < effects.offered.size(); ++i) {
        const std::string& id = effects.offered[i].id;
        const auto kind = effect::find_effect(id)->kind;
        EXPECT_EQ(effects.lacking[i].empty(), kind != effect::EffectKind::actuation && !id.starts_with("tendon_"))
            << id << " needs " << effects.lacking[i];
        if (!effects.lacking[i].empty()) continue;
        const auto edited = beam.driver.workbench->backend().edited(
            *beam.driver.state().scene, {},
            {ui::commands::AppendDeclared{{"effect"}, ui::commands::new_effect_text(effects.offered[i])}});
        ASSERT_TRUE(edited) << id << ": " << edited.error().text();
        const auto scene = beam.driver.workbench->backend().redeclared(*beam.driver.state().scene, *edited,
                                                                       beam.driver.state().body.get());
        EXPECT_TRUE(scene) << id << ": " << scene.error().text();
        EXPECT_EQ(scene ? scene->effects.declared.size() : 0u, 1u);
        ++added;
    }
    EXPECT_GT(added, 20);
}

TEST(EffectsInWindow, WhatTheExperimentLacksIsRefusedWithTheSentenceOfTheReader) {
    const test::Folder folder("effect_refused");
    ASSERT_TRUE(
        mesh::write_stl(folder.path() / "bar.stl", mesh::box_surface(Box{{0.0, 0.0, 0.0}, {0.08, 0.02, 0.02}}), 1.0));
    Driver driver(backend::make_core_backend(), 1280, 1400);
    driver.workbench->execute(ui::commands::Open{folder.path() / "bar.stl", 1.0});
    ASSERT_TRUE(driver.wait_for_job(60));
    driver.workbench->execute(ui::commands::MakeExperiment{folder.path() / "bar"});
    ASSERT_TRUE(driver.wait_for_job(60));
    ASSERT_TRUE(driver.state().scene->is_experiment) << driver.state().log.back().text;
    add_effect(driver, "marker_offset");
    EXPECT_TRUE(driver.state().scene->effects.declared.empty());
    EXPECT_THAT(driver.state().refused, HasSubstr("unknown marker \"marker\"; none is known here"));
    add_effect(driver, "linear_drag");
    EXPECT_EQ(driver.state().scene->effects.declared.size(), 1u);
    EXPECT_EQ(driver.state().refused, "");
}

}  // namespace
}  // namespace myo
