#include "diagnosis/discretisation/coarser_cells.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "diagnosis/diagnosis.hpp"
#include "diagnosis/fit/declared_fit.hpp"
#include "prediction/predict_trials.hpp"
#include "support/recorded_motion.hpp"
#include "support/swung_beam.hpp"

namespace myo::diagnosis::coarser_cells_test {
namespace {

constexpr double any = std::numeric_limits<double>::infinity();

/// The swung beam on cells of 7.5 mm, chosen as a default would be: no edge is stated.
setup::Setup finer_beam(const test::Folder& folder, double end_s = 0.3) {
    setup::Setup setup = test::swung_beam(folder, end_s);
    setup::SetupSettings settings = setup.settings;
    settings.mesh.resolution_m.reset();
    return test::setup_of_folder(folder, settings);
}

CoarserCells cells_of(const setup::Setup& setup, double max_m) {
    const prediction::ParameterValues values = prediction::declared_values(setup);
    return coarser_cells(setup, values, {0}, prediction::predict_trials_with(setup, values, {0}, {}), max_m, {}, {});
}

TEST(CoarserCells, AreTheCoarsestThatMoveAlike) {
    const test::Folder folder("coarser_cells");
    const setup::Setup setup = finer_beam(folder);
    const CoarserCells coarsest = cells_of(setup, any);
    ASSERT_TRUE(coarsest.setup);
    EXPECT_NEAR(coarsest.setup->mesh.resolution_m, 2.0 * setup.mesh.resolution_m, 1e-12);
    EXPECT_LT(coarsest.setup->body->dofs(), 0.3 * setup.body->dofs());
    EXPECT_EQ(coarsest.setup->trials[0].options.h_s, setup.trials[0].options.h_s);
    EXPECT_EQ(coarsest.runs, 2);
    const CoarserCells finer = cells_of(setup, 0.9 * coarsest.change_m);
    ASSERT_TRUE(finer.setup);
    EXPECT_NEAR(finer.setup->mesh.resolution_m, 1.5 * setup.mesh.resolution_m, 1e-12);
    EXPECT_LT(finer.change_m, 0.9 * coarsest.change_m);
    EXPECT_FALSE(cells_of(setup, 0.9 * finer.change_m).setup);
}

/// What another modulus makes up for does not count: the change is the least that scaled moduli leave.
TEST(CoarserCells, ChangeIsWhatNoModulusMakesUpFor) {
    const test::Folder folder("matched_cells");
    const setup::Setup setup = finer_beam(folder);
    const CoarserCells coarse = cells_of(setup, any);
    ASSERT_TRUE(coarse.setup);
    const prediction::ParameterValues values = prediction::declared_values(setup);
    const prediction::TrialPrediction fine = prediction::predict_trial(setup, 0, values);
    double least = any, same = 0.0;
    for (int k = -20; k <= 20; ++k) {
        setup::Setup scaled = *coarse.setup;
        scaled.modulus_factor = 1.0 + 0.002 * k;
        const double change = prediction::rms_between(prediction::predict_trial(scaled, 0, values), fine);
        least = std::min(least, change);
        if (k == 0) same = change;
    }
    EXPECT_NEAR(coarse.change_m, least, 0.05 * least);
    EXPECT_LT(coarse.change_m, 0.8 * same) << "otherwise the modulus makes no difference here";
}

TEST(CoarserCells, AreNotTakenWherePersonOrCellsForbidThem) {
    const test::Folder folder("kept_cells");
    setup::Setup stated = test::swung_beam(folder, 0.05);
    EXPECT_FALSE(cells_of(stated, any).setup) << "the edge length is stated";
    setup::SetupSettings tetrahedra = stated.settings;
    tetrahedra.mesh.resolution_m.reset();
    tetrahedra.mesh.element = fem::ElementKind::tet10;
    EXPECT_FALSE(cells_of(test::setup_of_folder(folder, tetrahedra), any).setup);
}

/// The declared fit takes them where the mesh error is removed, says so, and its result leads back to them.
TEST(CoarserCells, AreThoseOfAllFitsIfTheMeshErrorIsRemoved) {
    const test::Folder folder("cells_of_fits");
    setup::Setup setup = finer_beam(folder);
    const prediction::ParameterValues truth = prediction::declared_values(setup);
    for (std::size_t t = 0; t < setup.trials.size(); ++t)
        test::record(setup, t, truth, prediction::predict_trial(setup, t, truth).trace);
    for (const bool refine : {true, false}) {
        DiagnoseSettings settings;
        settings.refine_mesh = refine;
        settings.policy.numerics.max_cell_change = 100.0;
        PhaseLog log{Progress()};
        FitStore store;
        const DeclaredFit declared = fit_declared(prepared_setup(setup, settings), settings, store, log);
        ASSERT_TRUE(declared.usable()) << declared.failure;
        EXPECT_EQ(declared.coarser != nullptr, refine);
        if (!refine) continue;
        EXPECT_EQ(declared.setup.mesh.resolution_m, 2.0 * setup.mesh.resolution_m);
        EXPECT_NE(declared.notes.front().find("mm, whose error is taken off"), std::string::npos);
        Diagnosis diagnosis;
        diagnosis.coarser = declared.coarser;
        diagnosis.step_factors = declared.step_factors;
        const setup::Setup again = as_diagnosed(diagnosis, setup);
        EXPECT_EQ(again.body->dofs(), declared.setup.body->dofs());
        EXPECT_EQ(again.trials[0].options.h_s, declared.setup.trials[0].options.h_s);
    }
}

/// Where the declared model leaves much, cells and steps follow from a rough fit; both lead back from the result.
TEST(CoarserCells, GoWithLongerStepsWhereTheDeclaredModelLeavesMuch) {
    for (const double cell_change : {100.0, 1e-9}) {
        const test::Folder folder("cells_and_steps");
        setup::Setup setup = finer_beam(folder);
        // The noise allows longer steps, the residual still longer ones.
        setup.noise_m.setConstant(4e-5);
        for (setup::PreparedTrial& trial : setup.trials) trial.options.h_s = 0.000625;
        prediction::ParameterValues truth = prediction::declared_values(setup);
        truth.effects.push_back({"quadratic_drag", {{"coefficient_kg_m3", 5000.0}}});
        for (std::size_t t = 0; t < setup.trials.size(); ++t)
            test::record(setup, t, truth, prediction::predict_trial(setup, t, truth).trace);
        DiagnoseSettings settings;
        settings.policy.numerics.max_cell_change = cell_change;
        settings.policy.numerics.max_step_change = 0.2;
        PhaseLog log{Progress()};
        FitStore store;
        const DeclaredFit declared = fit_declared(prepared_setup(setup, settings), settings, store, log);
        ASSERT_TRUE(declared.usable()) << declared.failure;
        EXPECT_TRUE(declared.coarser) << "by the noise, or by what is left";
        EXPECT_GT(declared.step_factors.at(0), 1.0);
        EXPECT_NEAR(declared.setup.trials[0].options.h_s, declared.step_factors[0] * 0.000625, 1e-12) << cell_change;
    }
}

}  // namespace
}  // namespace myo::diagnosis::coarser_cells_test
