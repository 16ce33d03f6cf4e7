#include "diagnosis/search/search_sets.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "diagnosis/diagnosis.hpp"
#include "diagnosis/made_problem.hpp"
#include "diagnosis/verdict/probabilities.hpp"
#include "effect/catalogue.hpp"
#include "prediction/predict_trials.hpp"
#include "support/figures.hpp"
#include "support/swung_beam.hpp"

// Sets of effects, on a swung beam whose motion was simulated with them.

namespace myo::diagnosis::search_sets_test {
namespace {

using testing::UnorderedElementsAre;

const effect::EffectDeclaration drag{"quadratic_drag", {{"coefficient_kg_m3", 900.0}}, false};
const effect::EffectDeclaration compliance{"clamp_compliance", {{"stiffness_Pa_per_m", 1.5e7}}, false};

/// The beam whose traces hold a motion with the effects, and noise.
setup::Setup recorded_with(const test::Folder& folder, const std::vector<effect::EffectDeclaration>& effects) {
    setup::Setup setup = test::swung_beam(folder);
    prediction::ParameterValues truth = prediction::declared_values(setup);
    truth.youngs_modulus_Pa *= 1.08;
    truth.effects = effects;
    std::mt19937_64 random(3);
    std::normal_distribution<double> noise;
    for (std::size_t t = 0; t < setup.trials.size(); ++t) {
        const prediction::TrialPrediction made = prediction::predict_trial(setup, t, truth);
        EXPECT_TRUE(made.ok()) << made.message;
        for (std::size_t m = 0; m < setup.marker_names.size(); ++m) {
            Eigen::Matrix3Xd& track = setup.trials[t].measured.tracks[m];
            track += made.residual_m[m];
            for (double& x : track.reshaped()) x += setup.noise_m(static_cast<Eigen::Index>(m)) * noise(random);
        }
    }
    return setup;
}

/// Few effects may be named, so that the test is short; the same simulator made the motion, on the same mesh.
DiagnoseSettings among(const std::vector<std::string>& allowed) {
    DiagnoseSettings settings;
    settings.refine_mesh = false;
    for (const effect::Effect& effect : effect::effect_catalogue())
        if (std::find(allowed.begin(), allowed.end(), effect.id) == allowed.end())
            settings.without.push_back(effect.id);
    return settings;
}

std::vector<std::string> ids_of(const std::vector<effect::EffectDeclaration>& effects) {
    std::vector<std::string> ids;
    for (const effect::EffectDeclaration& effect : effects) ids.push_back(effect.id);
    return ids;
}

TEST(SearchSets, FindsTwoEffectsThatActTogether) {
    const test::Folder folder("search_sets");
    const setup::Setup setup = recorded_with(folder, {drag, compliance});
    const Diagnosis d = diagnose(setup, among({drag.id, compliance.id, "linear_drag", "soft_patch"}));
    ASSERT_TRUE(d.complete()) << d.failure;
    ASSERT_THAT(ids_of(d.verdict.effects), UnorderedElementsAre(drag.id, compliance.id)) << d.verdict.reason;
    for (const effect::EffectDeclaration& found : d.verdict.effects) {
        const effect::EffectDeclaration& truth = found.id == drag.id ? drag : compliance;
        const std::string name = truth.parameters.begin()->first;
        const double ratio = effect::number(found.parameters, name) / effect::number(truth.parameters, name);
        test::record(found.id, ratio);
        EXPECT_NEAR(ratio, 1.0, 0.1) << found.id;
        EXPECT_GT(effect_probabilities(d).at(found.id), 0.5);
    }
    EXPECT_LT(effect_probabilities(d).at("soft_patch"), 0.5);
    EXPECT_LT(d.after.validation_rms_m, 1.1 * test::made_noise_m);
    EXPECT_GT(d.before.validation_rms_m, 2.0 * test::made_noise_m);
}

/// One effect alone is not given a companion.
TEST(SearchSets, LeavesASingleEffectAlone) {
    const test::Folder folder("search_sets_single");
    const Diagnosis d = diagnose(recorded_with(folder, {drag}), among({drag.id, compliance.id, "linear_drag"}));
    ASSERT_TRUE(d.complete()) << d.failure;
    EXPECT_THAT(ids_of(d.verdict.effects), UnorderedElementsAre(drag.id)) << d.verdict.reason;
}

}  // namespace
}  // namespace myo::diagnosis::search_sets_test
