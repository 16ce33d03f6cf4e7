#include <gtest/gtest.h>

#include "effect/effect.hpp"
#include "experiment/law_file.hpp"
#include "prediction/parameter_tangent.hpp"
#include "prediction/prediction.hpp"
#include "support/chambered_beam.hpp"
#include "support/figures.hpp"
#include "support/law_texts.hpp"

namespace myo::prediction {
namespace {

using effect::EffectDeclaration;
using Eigen::Vector3d;
using Eigen::VectorXd;

EffectDeclaration of_law(const std::string& text, const effect::EffectParameters& parameters) {
    const Result<effect::LawPointer> law = experiment::read_law_text(text, "law.toml");
    EXPECT_TRUE(law) << law.error().text();
    return {(*law)->id, parameters, false, *law};
}

TrialPrediction predicted(setup::Setup setup, const std::vector<EffectDeclaration>& effects, double tolerance = 1e-8) {
    for (setup::PreparedTrial& trial : setup.trials) trial.options.solver.tolerance = tolerance;
    setup.experiment.effects = effects;
    TrialPrediction prediction = predict_trial(setup, 0, declared_values(setup));
    EXPECT_TRUE(prediction.ok()) << prediction.message;
    return prediction;
}

/// Largest difference of any marker over the largest displacement that the effect makes.
double difference(const setup::Setup& setup, const EffectDeclaration& built_in, const EffectDeclaration& law) {
    const TrialPrediction without = predicted(setup, {}), own = predicted(setup, {law}),
                          other = predicted(setup, {built_in});
    double largest = 0.0, made = 0.0;
    for (std::size_t m = 0; m < own.positions_m.size(); ++m) {
        largest = std::max(largest, (own.positions_m[m] - other.positions_m[m]).cwiseAbs().maxCoeff());
        made = std::max(made, (other.positions_m[m] - without.positions_m[m]).cwiseAbs().maxCoeff());
    }
    EXPECT_GT(made, 1e-5) << built_in.id << " does too little";
    return largest / made;
}

TEST(LawEffects, AreThoseOfTheCatalogueThatTheyRepeat) {
    const test::Folder folder("law_effects");
    const setup::Setup beam = test::swung_beam(folder, 0.3);
    const VectorXd place = Vector3d(0.1, 0.015, 0.03), anchor = Vector3d(0.12, 0.1, 0.2);
    const std::vector<std::pair<EffectDeclaration, EffectDeclaration>> pairs{
        {{"quadratic_drag", {{"coefficient_kg_m3", 3000.0}}}, of_law(test::drag_law, {{"coefficient_kg_m3", 3000.0}})},
        {{"cable_tug", {{"stiffness_N_m", 3.0}, {"position_m", place}, {"anchor_m", anchor}}},
         of_law(test::cable_law, {{"stiffness_N_m", 3.0}, {"position_m", place}, {"anchor_m", anchor}})},
        {{"clamp_compliance", {{"stiffness_Pa_per_m", 2e7}}}, of_law(test::bed_law, {{"stiffness_Pa_per_m", 2e7}})},
        {{"scale_error", {{"relative_error", 0.02}}}, of_law(test::scale_law, {{"relative_error", 0.02}})}};
    std::vector<double> differences;
    for (const auto& [built_in, law] : pairs) {
        differences.push_back(difference(beam, built_in, law));
        EXPECT_LT(differences.back(), 1e-6) << built_in.id;
    }
    test::record("differences", differences);
}

TEST(LawEffects, LagAsTheActuationLagDoes) {
    const test::Folder folder("law_lag");
    const setup::Setup beam = test::chambered_beam(folder, 0.2, [](experiment::Experiment& e) {
        e.trials[0].actuation_steps = {{"upper", 5000.0}};
    });
    for (const double tau : {0.002, 0.03}) {
        const double miss = difference(beam, {"actuation_lag", {{"time_constant_s", tau}}},
                                       of_law(test::lag_law, {{"time_constant_s", tau}}));
        EXPECT_LT(miss, 1e-6) << tau;
    }
}

/// Drag alone has a potential, which the solver sees by its symmetry; a pressure along the normal has none.
TEST(LawEffects, HaveExactDerivativesByTheirNumbers) {
    const test::Folder folder("law_tangents");
    setup::Setup beam = test::swung_beam(folder, 0.1);
    const VectorXd place = Vector3d(0.1, 0.015, 0.03), anchor = Vector3d(0.12, 0.1, 0.2);
    beam.experiment.effects = {
        of_law(test::cable_law, {{"stiffness_N_m", 3.0}, {"position_m", place}, {"anchor_m", anchor}}),
        of_law(test::drag_law, {{"coefficient_kg_m3", 3000.0}})};
    const ParameterValues values = declared_values(beam);
    int closed = 0;
    for (std::size_t e = 0; e < values.effects.size(); ++e)
        for (const ModelParameter& parameter : effect_parameters(beam, values.effects[e], e)) {
            const auto tangent = parameter_tangent(beam, 0, values, parameter);
            ASSERT_TRUE(tangent) << parameter.parameter.name;
            const bool is_placed = parameter.of_effect == "position_m";
            EXPECT_EQ(tangent->between == nullptr, !is_placed) << parameter.parameter.name;
            closed += is_placed ? 0 : 1;
        }
    EXPECT_EQ(closed, 5);
    // Two equal declarations cannot be told apart in a model: a difference of models is taken.
    beam.experiment.effects.push_back(beam.experiment.effects.back());
    const ParameterValues twice = declared_values(beam);
    const ModelParameter last = effect_parameters(beam, twice.effects[2], 2).front();
    EXPECT_NE(parameter_tangent(beam, 0, twice, last)->between, nullptr);
}

}  // namespace
}  // namespace myo::prediction
