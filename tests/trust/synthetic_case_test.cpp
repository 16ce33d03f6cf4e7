#include <gtest/gtest.h>

#include <map>
#include <set>

#include "effect/catalogue.hpp"
#include "mesh/surface_check.hpp"
#include "trust/synthetic_effects.hpp"
#include "trust/synthetic_experiment.hpp"
#include "trust/synthetic_folder.hpp"

namespace myo::test {
namespace {

TEST(SyntheticCase, EveryEffectOfTheCatalogueCanBeDrawn) {
    for (const Effect& effect : effect_catalogue()) {
        const EffectDraw* const draw = find_effect_draw(effect.id);
        ASSERT_NE(draw, nullptr) << effect.id;
        if (draw->amount.empty()) continue;
        const EffectParameterEntry* const entry = effect.parameter(draw->amount);
        ASSERT_NE(entry, nullptr) << effect.id;
        EXPECT_LT(draw->lowest, draw->highest) << effect.id;
        EXPECT_LE(draw->highest, entry->highest) << effect.id;
    }
}

TEST(SyntheticCase, IsTheSameWheneverItIsDrawn) {
    const CaseChoice choice{.seed = 5, .families = {}, .effects = {}};
    const SyntheticCase a = drawn_case(choice, 17), b = drawn_case(choice, 17);
    EXPECT_EQ(experiment_text(a), experiment_text(b));
    EXPECT_NE(experiment_text(a), experiment_text(drawn_case(choice, 18)));
    EXPECT_NE(experiment_text(a), experiment_text(drawn_case(choice, 17, 1)));
    EXPECT_NE(experiment_text(a), experiment_text(drawn_case({.seed = 6, .families = {}, .effects = {}}, 17)));
}

TEST(SyntheticCase, ASixthHasNoEffectAndASixthADeletedOne) {
    std::map<CaseKind, int> kinds;
    std::map<std::string, int> named, deleted;
    const int cases = 6 * 28;
    for (int k = 0; k < cases; ++k) {
        const SyntheticCase c = drawn_case({}, k);
        ++kinds[c.kind];
        EXPECT_EQ(c.effect.has_value(), c.kind != CaseKind::none);
        if (c.effect) ++(c.kind == CaseKind::named ? named : deleted)[c.effect->id];
    }
    EXPECT_EQ(kinds[CaseKind::none], cases / 6);
    EXPECT_EQ(kinds[CaseKind::deleted], cases / 6);
    // Four rounds of the catalogue named, one deleted: none more often than another.
    for (const std::string& id : effect_ids()) {
        EXPECT_EQ(named[id], 4) << id;
        EXPECT_EQ(deleted[id], 1) << id;
    }
}

TEST(SyntheticCase, HasWhatItsEffectNeedsToShow) {
    for (int k = 0; k < 168; ++k) {
        const SyntheticCase c = drawn_case({.seed = 2, .families = {}, .effects = {}}, k);
        if (!c.effect) continue;
        const EffectNeeds& needs = find_effect_draw(c.effect->id)->needs;
        if (needs.muscles) {
            EXPECT_FALSE(c.muscles.empty()) << k;
        }
        EXPECT_EQ(c.body.held_m > 0.0, needs.deep_clamp) << k;
        if (needs.known_damping) {
            EXPECT_TRUE(c.material.damping_is_known) << k;
        }
        bool straight = false, hangs = false;
        for (const SyntheticTrial& trial : c.trials) {
            if (trial.role != TrialRole::fit) continue;
            straight = straight || trial.start == StartState::straight;
            for (const LoadDeclaration& load : trial.loads) hangs = hangs || (load.kind == LoadKind::force && load.until_s > trial.end_s);
        }
        if (needs.straight_start) {
            EXPECT_TRUE(straight) << k;
        }
        if (needs.hung_weight) {
            EXPECT_TRUE(hangs) << k;
        }
    }
}

TEST(SyntheticCase, BodiesAreClosedAndPointOutwards) {
    for (const std::string& id : body_family_ids()) {
        BodyFamily family{};
        ASSERT_TRUE(parse_body_family(id, family));
        RandomStream random{3, static_cast<std::uint64_t>(family)};
        const SyntheticBody body = drawn_body(family, false, random);
        const SurfaceReport report = check_surface(body.surface);
        EXPECT_TRUE(report.outward && report.meshable()) << id;
        EXPECT_LE(enclosed_volume(body.surface), body.bounds.size().prod() * (1.0 + 1e-12)) << id;
    }
}

TEST(SyntheticCase, TheDeclaredModulusIsOffWithinItsTolerance) {
    double most = 0.0;
    for (int k = 0; k < 60; ++k) {
        const SyntheticMaterial m = drawn_case({}, k).material;
        const double off = std::abs(m.declared_modulus_Pa / m.youngs_modulus_Pa - 1.0);
        EXPECT_LT(off, 0.16);
        most = std::max(most, off);
    }
    EXPECT_GT(most, 0.1);
}

}  // namespace
}  // namespace myo::test
