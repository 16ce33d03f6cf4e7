#include <gtest/gtest.h>

#include <cmath>

#include "backend/workbench_backend.hpp"
#include "commands/force_arrows.hpp"
#include "support/recorded_motion.hpp"
#include "support/swung_beam.hpp"
#include "ui/driver.hpp"

namespace myo {
namespace {

using test::Driver;

constexpr double drag_kg_m3 = 1500.0;

/// The folder's recording, replaced by the motion in a fluid that its model does not have, on a finer mesh.
void record_in_fluid(const test::Folder& folder) {
    setup::SetupSettings settings;
    settings.mesh.resolution_m = 0.0075;
    Result<setup::Setup> setup = setup::prepare_setup(*experiment::read_experiment(folder.path()), settings);
    ASSERT_TRUE(setup) << setup.error().text();
    prediction::ParameterValues values = prediction::declared_values(*setup);
    values.effects.push_back({"quadratic_drag", {{"coefficient_kg_m3", drag_kg_m3}}});
    const effect::Affected trial = prediction::affected_trial(*setup, 0, values);
    ASSERT_NO_FATAL_FAILURE(test::record(*setup, 0, values, dynamics::simulate(trial.model, trial.options)));
    const measurement::Recording& seen = setup->trials[0].measured;
    std::string text = "time_s";
    for (const std::string& name : setup->marker_names)
        for (const char axis : {'x', 'y', 'z'}) text += "," + name + "_" + axis + "_m";
    for (Eigen::Index k = 0; k < seen.sample_count(); ++k) {
        text += "\n" + std::to_string(seen.time_s(k));
        for (const Eigen::Matrix3Xd& track : seen.tracks)
            for (int axis = 0; axis < 3; ++axis) text += "," + std::to_string(track(axis, k));
    }
    folder.write("swing.csv", text + "\n");
}

TEST(Diagnose, FindsTheDragOfABeamAddsItAndRunsWithIt) {
    const test::Folder folder("workbench_diagnose");
    static_cast<void>(test::swung_beam(folder, 0.3));
    ASSERT_NO_FATAL_FAILURE(record_in_fluid(folder));
    Driver driver(backend::make_core_backend(), 1280, 800);
    driver.window->open(folder.path());
    ASSERT_TRUE(driver.wait_for_job(60));
    ASSERT_TRUE(driver.state().scene) << driver.state().log.back().text;
    ui::commands::Settings coarse = driver.state().settings;
    coarse.resolution_m = 0.015;
    driver.workbench->execute(ui::commands::ChangeSettings{coarse, "resolution"});
    driver.click("run/run");
    ASSERT_TRUE(driver.wait_for_job(120));
    ASSERT_TRUE(driver.state().run) << driver.state().log.back().text;
    const double rms_without = driver.state().run->rms_m;

    driver.click("panel/diagnose");
    driver.click("diagnose/diagnose");
    ASSERT_TRUE(driver.state().diagnosing());
    bool ranked = false;
    while (driver.state().diagnosing()) {
        driver.frame_beside_job();
        ranked = ranked ||
                 (driver.state().diagnosing() && driver.state().diagnosis && driver.state().diagnosis->rows.size() > 5);
    }
    driver.settle();
    EXPECT_TRUE(ranked) << "no ranking was shown before the end";
    ASSERT_TRUE(driver.state().diagnosis) << driver.state().log.back().text;
    const ui::commands::DiagnosisView& d = *driver.state().diagnosis;
    ASSERT_TRUE(d.complete);
    EXPECT_FALSE(d.headline.empty());
    ASSERT_EQ(d.trials.size(), 2u);
    // What the verdict is on so coarse a mesh does not matter here: the drag was fitted, and what it predicts is the
    // residual.
    ASSERT_TRUE(d.row("quadratic_drag"));
    driver.workbench->execute(ui::commands::ChooseCandidate{"quadratic_drag"});
    driver.settle();
    const ui::commands::DiagnosisRow* const row = driver.state().diagnosis_row();
    ASSERT_TRUE(row->fitted);
    EXPECT_GT(row->explained, 0.5);
    EXPECT_LT(row->after_m[0], 0.5 * d.trials[0].before_m);
    ASSERT_EQ(row->predicted_m[0].size(), 4u);
    const Eigen::Matrix3Xd left = d.trials[0].residual_m[0] - row->predicted_m[0][0];
    double before = 0.0, after = 0.0;
    int count = 0;
    for (Eigen::Index i = 0; i < left.size(); ++i) {
        if (!std::isfinite(left.data()[i])) continue;
        before += std::pow(d.trials[0].residual_m[0].data()[i], 2);
        after += std::pow(left.data()[i], 2);
        ++count;
    }
    ASSERT_GT(count, 50);
    EXPECT_LT(after, 0.2 * before);
    // A drag takes energy: its force goes against the fall of the first moments.
    const ui::commands::PatchForces* const forces = ui::commands::shown_forces(driver.state());
    ASSERT_TRUE(forces);
    EXPECT_GT(forces->force_N[5].row(2).sum(), 0.0);
    // At t = 0 all is at rest: whoever chooses the row then is taken to where the force can be seen.
    driver.workbench->execute(ui::commands::SetTime{0.0});
    driver.workbench->execute(ui::commands::ChooseCandidate{"quadratic_drag"});
    driver.settle();
    EXPECT_GT(driver.state().time_s, 0.0);
    EXPECT_TRUE(driver.window->scene().arrows);

    driver.click("diagnose/add");  // of the chosen row
    ASSERT_EQ(driver.state().settings.effects.size(), 1u);
    EXPECT_NEAR(std::get<double>(driver.state().settings.effects[0].declaration.parameters.at("coefficient_kg_m3")),
                drag_kg_m3, 0.3 * drag_kg_m3);
    driver.click("run/run");
    ASSERT_TRUE(driver.wait_for_job(120));
    ASSERT_TRUE(driver.state().run_is_current()) << driver.state().log.back().text;
    EXPECT_LT(driver.state().run->rms_m, 0.6 * rms_without);
    driver.click("bar/undo");
    EXPECT_TRUE(driver.state().settings.effects.empty());
}

}  // namespace
}  // namespace myo
