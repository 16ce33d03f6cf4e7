#include "diagnosis/search/search_sets.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "diagnosis/diagnosis.hpp"
#include "diagnosis/made_problem.hpp"
#include "diagnosis/recorded_beam.hpp"
#include "diagnosis/verdict/probabilities.hpp"
#include "support/figures.hpp"

// Sets of effects, on a swung beam whose motion was simulated with them.

namespace myo::diagnosis::search_sets_test {
namespace {

using testing::UnorderedElementsAre;

const effect::EffectDeclaration drag{"quadratic_drag", {{"coefficient_kg_m3", 900.0}}, false};
const effect::EffectDeclaration compliance{"clamp_compliance", {{"stiffness_Pa_per_m", 1.5e7}}, false};

TEST(SearchSets, FindsTwoEffectsThatActTogether) {
    const test::Folder folder("search_sets");
    const setup::Setup setup = test::recorded_with(folder, {drag, compliance});
    const Diagnosis d = diagnose(setup, test::among({drag.id, compliance.id, "linear_drag", "soft_patch"}));
    ASSERT_TRUE(d.complete()) << d.failure;
    ASSERT_THAT(test::ids_of(d.verdict.effects), UnorderedElementsAre(drag.id, compliance.id)) << d.verdict.reason;
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
    const Diagnosis d = diagnose(test::recorded_with(folder, {drag}),
                                 test::among({drag.id, compliance.id, "linear_drag"}));
    ASSERT_TRUE(d.complete()) << d.failure;
    EXPECT_THAT(test::ids_of(d.verdict.effects), UnorderedElementsAre(drag.id)) << d.verdict.reason;
}

}  // namespace
}  // namespace myo::diagnosis::search_sets_test
