#include <gtest/gtest.h>

#include <map>
#include <set>

#include "effect/catalogue.hpp"
#include "experiment/read_experiment.hpp"
#include "experiment/read_trial.hpp"
#include "mesh/surface_check.hpp"
#include "support/folder.hpp"
#include "validation/synthetic_effects.hpp"
#include "validation/synthetic_experiment.hpp"
#include "validation/synthetic_folder.hpp"

namespace myo::test {
namespace {

TEST(SyntheticCase, EveryEffectOfTheCatalogueCanBeDrawn) {
    for (const effect::Effect& effect : effect::effect_catalogue()) {
        const effect::EffectDraw& draw = effect.draw;
        // An effect that does not scale has parameters to draw.
        EXPECT_TRUE(!draw.amount.empty() || draw.others != nullptr) << effect.id;
        if (draw.amount.empty()) continue;
        const effect::EffectParameterEntry* const entry = effect.parameter(draw.amount);
        ASSERT_NE(entry, nullptr) << effect.id;
        EXPECT_LT(0.0, draw.lowest) << effect.id;
        EXPECT_LT(draw.lowest, draw.highest) << effect.id;
        EXPECT_LE(draw.highest, entry->highest) << effect.id;
        if (draw.has_sign) {
            EXPECT_LE(entry->lowest, -draw.highest) << effect.id;
        }
    }
}

TEST(SyntheticCase, EveryRequiredParameterIsDrawnWithinItsRange) {
    for (const effect::Effect& effect : effect::effect_catalogue()) {
        if (effect.draw.needs.far_guides) continue;  // none of the bodies shows it
        const validation::SyntheticCase c = validation::drawn_case({.seed = 1, .families = {}, .effects = {effect.id}},
                                                                   1);
        ASSERT_EQ(c.effects.size(), 1u) << effect.id;
        for (const effect::EffectParameterEntry& entry : effect.parameters) {
            EXPECT_TRUE(entry.optional || effect::has(c.effects.front().parameters, entry.name))
                << effect.id << entry.name;
            if (entry.kind != effect::EffectParameterKind::number ||
                !effect::has(c.effects.front().parameters, entry.name))
                continue;
            EXPECT_GE(effect::number(c.effects.front().parameters, entry.name), entry.lowest)
                << effect.id << entry.name;
            EXPECT_LE(effect::number(c.effects.front().parameters, entry.name), entry.highest)
                << effect.id << entry.name;
        }
    }
}

TEST(SyntheticCase, IsTheSameWheneverItIsDrawn) {
    const validation::CaseChoice choice{.seed = 5, .families = {}, .effects = {}};
    const validation::SyntheticCase a = validation::drawn_case(choice, 17), b = validation::drawn_case(choice, 17);
    EXPECT_EQ(validation::experiment_text(a), validation::experiment_text(b));
    EXPECT_NE(validation::experiment_text(a), validation::experiment_text(validation::drawn_case(choice, 18)));
    EXPECT_NE(validation::experiment_text(a), validation::experiment_text(validation::drawn_case(choice, 17, 1)));
    EXPECT_NE(validation::experiment_text(a),
              validation::experiment_text(validation::drawn_case({.seed = 6, .families = {}, .effects = {}}, 17)));
}

TEST(SyntheticCase, ASixthHasNoEffectAndASixthADeletedOne) {
    std::map<validation::CaseKind, int> kinds;
    std::map<std::string, int> named, deleted;
    std::vector<std::string> ids = effect::effect_ids();
    // No body of the families bends far between two guides.
    std::erase_if(ids, [](const std::string& id) { return validation::effect_draw(id).needs.far_guides; });
    ASSERT_EQ(ids.size() + 1, effect::effect_ids().size());
    const Result<void> channel = validation::check_choice({.seed = 1, .families = {}, .effects = {"tendon_channel"}});
    ASSERT_FALSE(channel);
    EXPECT_NE(channel.error().what.find("needs a body that a thread bends far"), std::string::npos);
    const int cases = 6 * static_cast<int>(ids.size());
    for (int k = 0; k < cases; ++k) {
        const validation::SyntheticCase c = validation::drawn_case({}, k);
        ++kinds[c.kind];
        EXPECT_EQ(!c.effects.empty(), c.kind != validation::CaseKind::none);
        if (!c.effects.empty()) ++(c.kind == validation::CaseKind::named ? named : deleted)[c.effects.front().id];
    }
    EXPECT_EQ(kinds[validation::CaseKind::none], cases / 6);
    EXPECT_EQ(kinds[validation::CaseKind::deleted], cases / 6);
    // Four rounds of the catalogue named, one deleted: none more often than another.
    for (const std::string& id : ids) {
        EXPECT_EQ(named[id], 4) << id;
        EXPECT_EQ(deleted[id], 1) << id;
    }
}

TEST(SyntheticCase, HasWhatItsEffectNeedsToShow) {
    for (int k = 0; k < 168; ++k) {
        const validation::SyntheticCase c = validation::drawn_case({.seed = 2, .families = {}, .effects = {}}, k);
        if (c.effects.empty()) continue;
        const effect::EffectNeeds& needs = validation::effect_draw(c.effects.front().id).needs;
        if (needs.muscles) {
            EXPECT_FALSE(c.muscles.empty()) << k;
        }
        EXPECT_EQ(c.tendon.has_value(), needs.tendon) << k;
        EXPECT_EQ(c.body.held_m > 0.0, needs.deep_clamp) << k;
        if (needs.known_damping) {
            EXPECT_TRUE(c.material.damping_is_known) << k;
        }
        bool straight = false, hangs = false;
        for (const validation::SyntheticTrial& trial : c.trials) {
            if (trial.role != experiment::TrialRole::fit) continue;
            straight = straight || trial.start == experiment::StartState::straight;
            for (const experiment::LoadDeclaration& load : trial.loads)
                hangs = hangs || (load.kind == experiment::LoadKind::force && load.until_s > trial.end_s);
        }
        if (needs.straight_start) {
            EXPECT_TRUE(straight) << k;
        }
        if (needs.hung_weight) {
            EXPECT_TRUE(hangs) << k;
        }
    }
}

/// The thread takes in and pays out, and its folder reads as it was drawn.
TEST(SyntheticCase, ATendonPullsInEveryTrial) {
    const Folder folder("threaded");
    const validation::SyntheticCase c = validation::drawn_case(
        {.seed = 4, .families = {}, .effects = {"tendon_friction"}}, 1);
    ASSERT_TRUE(c.tendon && c.muscles.empty());
    ASSERT_TRUE(validation::write_still_experiment(c, folder.path()));
    const Result<experiment::Experiment> read = experiment::read_experiment(folder.path());
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->tendons.size(), 1u);
    EXPECT_LT((read->tendons[0].path_m - c.tendon->path_m).norm(), 1e-9);
    for (const experiment::TrialDeclaration& trial : read->trials) {
        const auto table = experiment::read_trial_actuation(*read, trial);
        ASSERT_TRUE(table) << table.error().text();
        const Eigen::VectorXd tension = table->values.row(0).transpose();
        EXPECT_EQ(tension.minCoeff(), 0.0);
        EXPECT_GT(tension.maxCoeff(), 0.3 * c.tendon->largest_tension_N);
        const Eigen::VectorXd change = tension.tail(tension.size() - 1) - tension.head(tension.size() - 1);
        EXPECT_GT(change.maxCoeff(), 0.0);
        EXPECT_LT(change.minCoeff(), 0.0);
    }
}

TEST(SyntheticCase, BodiesAreClosedAndPointOutwards) {
    for (const std::string& id : validation::body_family_ids()) {
        validation::BodyFamily family{};
        ASSERT_TRUE(validation::parse_body_family(id, family));
        RandomStream random{3, static_cast<std::uint64_t>(family)};
        const validation::SyntheticBody body = validation::drawn_body(family, false, random);
        const mesh::SurfaceReport report = mesh::check_surface(body.surface);
        EXPECT_TRUE(report.outward && report.meshable()) << id;
        EXPECT_LE(mesh::enclosed_volume(body.surface), body.bounds.size().prod() * (1.0 + 1e-12)) << id;
    }
}

TEST(SyntheticCase, TheDeclaredModulusIsOffWithinItsTolerance) {
    double most = 0.0;
    for (int k = 0; k < 60; ++k) {
        const validation::SyntheticMaterial m = validation::drawn_case({}, k).material;
        const double off = std::abs(m.declared_modulus_Pa / m.youngs_modulus_Pa - 1.0);
        EXPECT_LT(off, 0.16);
        most = std::max(most, off);
    }
    EXPECT_GT(most, 0.1);
}

}  // namespace
}  // namespace myo::test
