#include "diagnosis/search/search_beginnings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "diagnosis/diagnosis.hpp"
#include "diagnosis/recorded_beam.hpp"
#include "support/figures.hpp"

// Search on the beginnings of recordings, on a swung beam that goes out of phase with its declared model.

namespace myo::diagnosis::search_beginnings_test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using testing::UnorderedElementsAre;

const effect::EffectDeclaration compliance{"clamp_compliance", {{"stiffness_Pa_per_m", 8e6}}, false};
const effect::EffectDeclaration creep{
    "viscoelastic_creep", {{"modulus_ratio", 0.2}, {"relaxation_time_s", 0.1}}, false};

/// Compliant clamp and creep change the frequency, so that the declared model ends in another phase.
TEST(SearchBeginnings, FindTwoEffectsFarFromTheDeclaredModel) {
    const test::Folder folder("search_beginnings");
    const setup::Setup setup = test::recorded_with(folder, {compliance, creep}, 0.2);
    const Diagnosis d = diagnose(setup, test::among({compliance.id, creep.id, "linear_drag", "stiffness_gradient"}));
    ASSERT_TRUE(d.complete()) << d.failure;
    test::record("systematic residual [noise levels]", d.declared.tests.systematic.rms);
    ASSERT_GT(d.declared.tests.systematic.rms, d.settings.policy.beginnings.min_residual);
    ASSERT_THAT(test::ids_of(d.verdict.effects), UnorderedElementsAre(compliance.id, creep.id)) << d.verdict.reason;
    EXPECT_THAT(d.notes, Contains(HasSubstr("of every recording")));
    for (const effect::EffectDeclaration& found : d.verdict.effects)
        if (found.id == compliance.id) {
            const double ratio = effect::number(found.parameters, "stiffness_Pa_per_m") / 8e6;
            test::record("clamp stiffness, found over true", ratio);
            EXPECT_NEAR(ratio, 1.0, 0.05);
        }
}

/// A small residual follows the derivatives: the whole recordings are used at once.
TEST(SearchBeginnings, AreNotUsedForASmallResidual) {
    const test::Folder folder("search_beginnings_small");
    const effect::EffectDeclaration drag{"quadratic_drag", {{"coefficient_kg_m3", 300.0}}, false};
    const Diagnosis d = diagnose(test::recorded_with(folder, {drag}), test::among({drag.id}));
    ASSERT_TRUE(d.complete()) << d.failure;
    EXPECT_LT(d.declared.tests.systematic.rms, d.settings.policy.beginnings.min_residual);
    EXPECT_THAT(d.notes, Not(Contains(HasSubstr("of every recording"))));
}

}  // namespace
}  // namespace myo::diagnosis::search_beginnings_test
