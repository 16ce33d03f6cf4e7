#include "commands/workbench_state.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "commands/live_preview.hpp"

// What the state means to the panels, from values alone.

namespace myo::ui::workbench_state {
namespace {

using commands::DiagnosisRow;
using commands::WorkbenchState;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A scene with a trial for each of these ranges of times [s].
WorkbenchState with_trials(const std::vector<Eigen::VectorXd>& times_s) {
    auto scene = std::make_shared<commands::Scene>();
    for (std::size_t i = 0; i < times_s.size(); ++i) {
        commands::SceneTrial trial;
        trial.name = "trial " + std::to_string(i);
        trial.time_s = times_s[i];
        scene->trials.push_back(trial);
    }
    WorkbenchState state;
    state.scene = scene;
    return state;
}

std::shared_ptr<const commands::RunResult> run_of(const std::vector<Eigen::VectorXd>& frame_times_s) {
    auto run = std::make_shared<commands::RunResult>();
    for (const Eigen::VectorXd& times : frame_times_s) {
        commands::SimulatedTrial trial;
        trial.frame_time_s = times;
        run->trials.push_back(trial);
    }
    return run;
}

TEST(TimeSpan, HoldsMeasurementAndSimulationOfTheShownTrial) {
    using Span = std::array<double, 2>;
    WorkbenchState state = with_trials({Eigen::Vector3d(-0.5, 0.0, 1.0), Eigen::VectorXd(), Eigen::VectorXd::Ones(1)});
    EXPECT_EQ(commands::time_span(state), (Span{-0.5, 1.0}));
    state.trial = 1;
    EXPECT_EQ(commands::time_span(state), (Span{0.0, 0.0})) << "it has neither";
    state.trial = 2;
    EXPECT_EQ(commands::time_span(state), (Span{1.0, 1.0})) << "a held pose has one time";
    state.run = run_of({Eigen::Vector2d(0.0, 2.5), Eigen::Vector2d(0.25, 0.75), Eigen::VectorXd()});
    EXPECT_EQ(commands::time_span(state), (Span{1.0, 1.0}));
    state.trial = 0;
    EXPECT_EQ(commands::time_span(state), (Span{-0.5, 2.5}));
    state.trial = 1;
    EXPECT_EQ(commands::time_span(state), (Span{0.25, 0.75})) << "not from 0, where nothing is";
    EXPECT_EQ(commands::time_span({}), (Span{0.0, 0.0}));
}

TEST(TimeSpan, OfAnImportCountsFromItsStart) {
    WorkbenchState state = with_trials({Eigen::Vector2d(0.0, 9.0)});
    auto recording = std::make_shared<measurement::Recording>();
    recording->time_s = Eigen::Vector3d(2.0, 3.0, 5.0);
    auto import = std::make_shared<commands::RecordingImport>();
    import->file.recording = recording;
    import->choices.start_s = 2.5;
    state.import = import;
    EXPECT_EQ(commands::time_span(state), (std::array<double, 2>{-0.5, 2.5}));
}

TEST(StateOfTheWorkbench, TrialsBeyondTheListAreNone) {
    WorkbenchState state = with_trials({Eigen::Vector2d(0.0, 1.0), Eigen::Vector2d(0.0, 2.0)});
    state.run = run_of({Eigen::Vector2d(0.0, 1.0)});
    for (const int trial : {-1, 0, 1, 2}) {
        state.trial = trial;
        EXPECT_EQ(state.scene_trial() != nullptr, trial == 0 || trial == 1) << trial;
        EXPECT_EQ(state.simulated_trial() != nullptr, trial == 0) << trial << ": the run has one trial only";
    }
    EXPECT_FALSE(WorkbenchState{}.scene_trial());
    EXPECT_FALSE(WorkbenchState{}.trial_of(nullptr));
}

TEST(StateOfTheWorkbench, TheBestOfASearchOnThisBodyIsShownBeforePreviewAndRun) {
    WorkbenchState state;
    EXPECT_FALSE(state.shown_run());
    const auto run = run_of({}), preview = run_of({}), best = run_of({}), live = run_of({});
    state.body = std::make_shared<commands::MeshedBody>();
    state.run = run;
    EXPECT_EQ(state.shown_run(), run);
    state.preview.run = preview;
    EXPECT_EQ(state.shown_run(), preview);
    EXPECT_TRUE(state.previewing());
    commands::SearchView view;
    view.best = best;
    state.search = std::make_shared<commands::SearchView>(view);
    state.search_body = state.body;
    EXPECT_EQ(state.shown_run(), preview) << "the search has ended";
    state.job = commands::JobView{};
    EXPECT_EQ(state.shown_run(), preview) << "another job runs";
    state.job->searches = true;
    EXPECT_EQ(state.shown_run(), best);
    EXPECT_FALSE(state.previewing());
    state.search_body = std::make_shared<commands::MeshedBody>();
    EXPECT_EQ(state.shown_run(), preview) << "it works on another body";
    state.live = commands::LiveView{};
    EXPECT_EQ(state.drawn_run(), preview) << "the model is not ready";
    auto frame = std::make_shared<commands::LiveFrame>();
    frame->run = live;
    state.live->frame = frame;
    EXPECT_EQ(state.drawn_run(), live);
    EXPECT_EQ(state.shown_run(), preview) << "plots do not follow what plays live";
}

TEST(StateOfTheWorkbench, AVelocityForceIsUnstableBeyondItsCriticalValueOnly) {
    WorkbenchState state;
    state.settings.velocity_force_1_s = 4.0;
    EXPECT_FALSE(state.is_unstable()) << "the scheme has no critical value";
    for (const auto& [critical, unstable] :
         std::vector<std::pair<double, bool>>{{3.999, true}, {4.0, false}, {5.0, false}}) {
        state.critical_velocity_force_1_s = critical;
        EXPECT_EQ(state.is_unstable(), unstable) << critical;
    }
    // A force that brakes never makes the motion grow, whatever the scheme itself does.
    state.settings.velocity_force_1_s = -4.0;
    state.critical_velocity_force_1_s = -5.0;
    EXPECT_FALSE(state.is_unstable());
}

TEST(StateOfTheWorkbench, ResultsAreCurrentAsLongAsNothingTheyDependOnChanges) {
    WorkbenchState state = with_trials({});
    EXPECT_FALSE(state.mesh_is_current());
    EXPECT_FALSE(state.run_is_current());
    EXPECT_FALSE(state.checks_are_current());
    EXPECT_FALSE(state.unsaved());
    state.body = std::make_shared<commands::MeshedBody>();
    state.run = run_of({});
    state.checks = std::make_shared<commands::CheckReport>();
    EXPECT_TRUE(state.mesh_is_current() && state.run_is_current() && state.checks_are_current());
    state.settings.density_kg_m3 += 1.0;
    EXPECT_TRUE(state.mesh_is_current()) << "the mesh does not depend on the density";
    EXPECT_FALSE(state.run_is_current() || state.checks_are_current());
    EXPECT_TRUE(state.unsaved());
    const commands::Settings meshed;
    for (int what = 0; what < 3; ++what) {
        state.settings = meshed;
        EXPECT_TRUE(state.mesh_is_current());
        if (what == 0) state.settings.element = mesh::CellType::tet4;
        if (what == 1) state.settings.resolution_m *= 1.0 + 1e-15;
        if (what == 2) state.settings.declaration.mesh_words = "[clamp]";
        EXPECT_FALSE(state.mesh_is_current()) << what;
    }
}

TEST(StateOfTheWorkbench, TheRowOfADiagnosisIsTheChosenOneThenTheVerdictsThenTheBest) {
    WorkbenchState state;
    EXPECT_FALSE(state.diagnosis_row());
    commands::DiagnosisView view;
    const auto show = [&](const std::string& candidate) {
        state.diagnosis = std::make_shared<commands::DiagnosisView>(view);
        state.candidate = candidate;
        const DiagnosisRow* const row = state.diagnosis_row();
        return row ? row->key : "none";
    };
    EXPECT_EQ(show("drag"), "none");
    view.rows.resize(1);
    view.rows[0].key = "declared";
    EXPECT_EQ(show(""), "declared") << "there is nothing else yet";
    view.rows.resize(3);
    view.rows[1].key = "drag";
    view.rows[2].key = "slip";
    EXPECT_EQ(show(""), "drag") << "the best so far";
    EXPECT_EQ(show("slip"), "slip");
    EXPECT_EQ(show("declared"), "declared");
    view.rows[2].chosen = true;
    EXPECT_EQ(show(""), "slip") << "that of the verdict";
    EXPECT_EQ(show("drag"), "drag");
    EXPECT_EQ(show("gone"), "slip");
}

TEST(StateOfTheWorkbench, EffectsAreInTheModelIfAllAgree) {
    WorkbenchState state;
    DiagnosisRow row;
    EXPECT_FALSE(commands::is_in_model(state, row)) << "no effect is none that was added";
    row.settings.effects = {{{"linear_drag", {{"coefficient_Pa_s_m", 41.0}}}, "Linear drag", ""}};
    EXPECT_FALSE(commands::is_in_model(state, row));
    state.settings.effects = row.settings.effects;
    EXPECT_TRUE(commands::is_in_model(state, row));
    state.settings.effects.front().off = true;
    EXPECT_FALSE(commands::is_in_model(state, row)) << "it is switched off";
}

TEST(LivePreview, EndsWithTheRecordingAndSaysHowFarItGoes) {
    WorkbenchState state = with_trials({Eigen::Vector2d(-0.1, 0.3), Eigen::Vector2d(0.0, 2.0), Eigen::VectorXd()});
    EXPECT_EQ(commands::preview_length_s(state), 0.3);
    state.trial = 1;
    EXPECT_EQ(commands::preview_length_s(state), 0.5) << "as usual";
    state.preview.length_s = 3.0;
    EXPECT_EQ(commands::preview_length_s(state), 2.0);
    state.trial = 2;
    EXPECT_EQ(commands::preview_length_s(state), 3.0) << "without samples there is no end";
    EXPECT_EQ(commands::preview_text(state), "") << "it is off";
    state.preview.on = true;
    EXPECT_EQ(commands::preview_text(state), "Change a value to preview it");
    state.preview.working = true;
    EXPECT_EQ(commands::preview_text(state), "Preview 0–3 s, running…");
    state.job = commands::JobView{};
    state.job->name = "Calibrate";
    EXPECT_EQ(commands::preview_text(state), "Preview 0–3 s waits until Calibrate has ended");
    state.trial = 0;
    auto run = std::make_shared<commands::RunResult>(*run_of({Eigen::Vector2d(0.0, 0.25)}));
    run->trials[0].rms_m = 1.5e-3;
    state.preview.run = run;
    state.preview.end_s = 0.25;
    state.preview.working = false;
    EXPECT_EQ(commands::preview_text(state), "Preview 0–0.25 s, rms error 1.50 mm");
    auto broken = std::make_shared<commands::RunResult>(*run);
    broken->trials[0].rms_m = nan;
    broken->problem = "it blows up";
    state.preview.run = broken;
    EXPECT_EQ(commands::preview_text(state), "Preview 0–0.25 s: it blows up");
    state.preview.problem = "no mesh";
    EXPECT_EQ(commands::preview_text(state), "Preview failed: no mesh");
}

}  // namespace
}  // namespace myo::ui::workbench_state
