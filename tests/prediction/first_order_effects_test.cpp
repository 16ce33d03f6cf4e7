#include "prediction/first_order_effects.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "support/figures.hpp"
#include "support/swung_beam.hpp"

// Responses of a swung beam to effects, by tangents of the run without them and by runs with them.

namespace myo::prediction::first_order_effects_test {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using Tracks = std::vector<Eigen::Matrix3Xd>;

/// The beam with steps that are solved to the last digits, so that small responses are compared.
setup::Setup exact_beam(const test::Folder& folder) {
    setup::Setup setup = test::swung_beam(folder, 0.2);
    for (setup::PreparedTrial& trial : setup.trials) {
        trial.options.solver.tolerance = 1e-12;
        trial.options.solver.tangent_tolerance = 1e-12;
    }
    return setup;
}

/// Effects whose amount is `share` of a whole one.
std::vector<effect::EffectDeclaration> effects(double share) {
    return {{"point_mass", {{"mass_kg", 2e-3 * share}, {"position_m", VectorXd(Vector3d(0.1, 0.015, 0.03))}}, false},
            {"quadratic_drag", {{"coefficient_kg_m3", 100.0 * share}}, false},
            {"extra_damping", {{"excess_damping_s", 2e-3 * share}}, false},
            {"stiffness_gradient", {{"relative_change", 0.1 * share}, {"axis", 0.0}}, false},
            {"base_vibration",
             {{"amplitude_m", 1e-3 * share},
              {"direction", VectorXd(Vector3d(0.0, 0.6, 0.8))},
              {"frequency_Hz", 4.0},
              {"phase_rad", VectorXd(VectorXd::Zero(2))}},
             false}};
}

double norm(const Tracks& tracks) {
    double squares = 0.0;
    for (const Eigen::Matrix3Xd& track : tracks) squares += track.squaredNorm();
    return std::sqrt(squares);
}

Tracks difference(const Tracks& a, const Tracks& b) {
    Tracks result;
    for (std::size_t m = 0; m < a.size(); ++m) result.emplace_back(a[m] - b[m]);
    return result;
}

/// Difference of the first-order response from that of a run, over the latter, per effect.
std::vector<double> errors(const setup::Setup& setup, double share) {
    const ParameterValues values = declared_values(setup);
    const TrialPrediction without = predict_trial(setup, 0, values);
    const auto changes = first_order_changes(setup, 0, values, effects(share));
    std::vector<double> result;
    for (std::size_t e = 0; e < changes.size(); ++e) {
        ParameterValues with = values;
        with.effects.push_back(effects(share)[e]);
        const TrialPrediction run = predict_trial(setup, 0, with);
        EXPECT_TRUE(changes[e] && run.ok()) << with.effects.back().id;
        if (!changes[e]) continue;
        const Tracks response = difference(run.residual_m, without.residual_m);
        EXPECT_GT(norm(response), 1e-5) << with.effects.back().id;
        result.push_back(norm(difference(*changes[e], response)) / norm(response));
    }
    return result;
}

/// What is left out is of the second order: half the effect halves the relative error.
TEST(FirstOrderEffects, DifferFromRunsBySecondOrderInTheEffect) {
    const test::Folder folder("first_order");
    const setup::Setup setup = exact_beam(folder);
    const std::vector<double> whole = errors(setup, 1.0), half = errors(setup, 0.5);
    ASSERT_EQ(whole.size(), effects(1.0).size());
    for (std::size_t e = 0; e < whole.size(); ++e) {
        const std::string id = effects(1.0)[e].id;
        test::record(id, whole[e]);
        EXPECT_LT(whole[e], 0.2) << id;
        EXPECT_NEAR(whole[e] / half[e], 2.0, 0.2) << id;
    }
}

/// Further unknowns and another support have no tangent of the run without them.
TEST(FirstOrderEffects, AreEmptyWhereOnlyARunShowsTheEffect) {
    const test::Folder folder("no_first_order");
    const setup::Setup setup = test::swung_beam(folder, 0.05);
    const auto changes = first_order_changes(
        setup, 0, declared_values(setup),
        {{"viscoelastic_creep", {{"modulus_ratio", 0.1}, {"relaxation_time_s", 0.1}}, false},
         {"clamp_compliance", {{"stiffness_Pa_per_m", 1e8}}, false},
         {"quadratic_drag", {{"coefficient_kg_m3", 100.0}}, false}});
    ASSERT_EQ(changes.size(), 3u);
    EXPECT_FALSE(changes[0]);
    EXPECT_FALSE(changes[1]);
    EXPECT_TRUE(changes[2]);
}

}  // namespace
}  // namespace myo::prediction::first_order_effects_test
