#include "diagnosis/verdict/verdict_rules.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <set>

#include "base/files.hpp"
#include "diagnosis/made_fits.hpp"
#include "diagnosis/verdict/verdict.hpp"

namespace myo::diagnosis {
namespace {

using namespace test;

std::string rule_of(Diagnosis d, const DiagnosisPolicy& policy = {}) {
    d.settings.policy = policy;
    decided(d);
    return d.verdict.rule;
}

/// A pair beside a candidate that leaves a fifth of the residual.
Diagnosis with_pair(double left_over_noise) {
    Diagnosis d = with_candidate(2.0);
    d.sets.push_back(pair_that_leaves(left_over_noise));
    return d;
}

/// Noise that nobody declared: still cameras are better than models.
Diagnosis with_noise_from_still_markers(Diagnosis d) {
    d.data.noise_declared = false;
    return d;
}

Diagnosis drifting() {
    Diagnosis d = with_candidate(0.3);
    d.declared = fit_that_leaves(2.0);
    d.declared.independence = {.p = 0.5, .typical_share = 1.0, .constant_share = 0.0};
    return d;
}

Diagnosis faint() {
    Diagnosis d = with_candidate(0.45);
    d.declared = fit_that_leaves(0.49);
    d.declared.tests.variance.p = 0.0;
    d.candidates.front().judged->tests.variance.p = 0.0;
    return d;
}

/// One case per rule.
std::map<std::string, std::function<Diagnosis()>> cases() {
    return {
        {"drift", drifting},
        {"nothing_missing",
         [] {
             Diagnosis d = with_candidate(0.3);
             d.declared = fit_that_leaves(0.1);
             return d;
         }},
        {"single_effect", [] { return with_candidate(0.3); }},
        {"set", [] { return with_pair(0.3); }},
        {"nearly_all", [] { return with_candidate(1.23); }},
        {"most_by_set",
         [] {
             Diagnosis d = with_candidate(4.9);
             d.sets.push_back(pair_that_leaves(2.5));
             return with_noise_from_still_markers(d);
         }},
        {"most_by_single", [] { return with_noise_from_still_markers(with_candidate(4.0)); }},
        {"faint", faint},
        {"unexplained", [] { return with_candidate(8.0); }},
    };
}

TEST(VerdictRules, EachAppliesToItsCase) {
    for (const auto& [name, make] : cases()) EXPECT_EQ(rule_of(make()), name);
}

TEST(VerdictRules, NoneIsWithoutACase) {
    std::set<std::string> named, tested;
    for (const VerdictRule& rule : verdict_rules()) named.insert(rule.name);
    for (const auto& [name, make] : cases()) tested.insert(name);
    EXPECT_EQ(named, tested);
    EXPECT_EQ(named.size(), verdict_rules().size());
}

/// The limits are those of the policy: with another one the same evidence falls under another rule.
TEST(VerdictRules, FollowThePolicy) {
    DiagnosisPolicy policy;
    policy.verdict.nearly_all = 0.1;
    EXPECT_EQ(rule_of(with_candidate(1.23), policy), "unexplained");
    policy = {};
    policy.verdict.max_left = 0.3;
    EXPECT_EQ(rule_of(with_noise_from_still_markers(with_candidate(4.0)), policy), "unexplained");
    policy = {};
    policy.verdict.present = 0.95;
    EXPECT_EQ(rule_of(with_candidate(1.23), policy), "unexplained");
    policy = {};
    policy.judgement.most_of_residual = 0.1;
    EXPECT_EQ(rule_of(with_pair(0.3), policy), "unexplained");
    policy = {};
    policy.judgement.min_systematic = 20.0;
    EXPECT_EQ(rule_of(with_candidate(8.0), policy), "nothing_missing");
    policy = {};
    policy.judgement.most_of_residual = 0.01;
    EXPECT_NE(rule_of(with_candidate(0.3), policy), "single_effect");
}

TEST(VerdictRules, ConfidenceFollowsThePolicy) {
    Diagnosis plain = with_candidate(0.3), halved = plain;
    decided(plain);
    halved.settings.policy.verdict.undoubted *= 0.5;
    decided(halved);
    EXPECT_DOUBLE_EQ(halved.verdict.confidence, 0.5 * plain.verdict.confidence);
    Diagnosis drift = drifting();
    decided(drift);
    EXPECT_DOUBLE_EQ(drift.verdict.confidence, VerdictPolicy{}.undoubted * VerdictPolicy{}.drift);
}

TEST(VerdictRules, AreListedInTheManualInTheirOrder) {
    const Result<std::string> manual = read_file(MYOLOOP_SOURCE_DIR "/assets/manual/diagnosis.md");
    ASSERT_TRUE(manual);
    std::size_t last = 0;
    for (const VerdictRule& rule : verdict_rules()) {
        const std::size_t row = manual->find("\n| `" + rule.name + "`: ");
        ASSERT_NE(row, std::string::npos) << rule.name << " has no row in the manual";
        EXPECT_GT(row, last) << rule.name;
        last = row;
    }
}

}  // namespace
}  // namespace myo::diagnosis
