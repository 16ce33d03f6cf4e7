#include "diagnosis/verdict/verdict.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "diagnosis/made_fits.hpp"
#include "diagnosis/selection/ranking.hpp"

namespace myo::diagnosis {
namespace {

using namespace test;

TEST(Verdict, NamesWhatExplainsTheResidual) {
    Diagnosis d = with_candidate(0.3);
    decided(d);
    EXPECT_EQ(d.verdict.kind, VerdictKind::effects);
    ASSERT_EQ(d.verdict.effects.size(), 1u);
    EXPECT_EQ(d.verdict.effects[0].id, "quadratic_drag");
    EXPECT_GT(d.verdict.confidence, 0.8);
    EXPECT_EQ(d.verdict.ranking, (std::vector<std::string>{"quadratic_drag", "unknown", "none"}));
}

/// The fit with the numerical error found anew is the one that all numbers are of; the evidence it was chosen by stays.
TEST(Verdict, TakesOverTheFinalFit) {
    Diagnosis d = with_candidate(0.3);
    d.augmented = decided(d);
    d.augmented.fit.effects[0].parameters["coefficient_kg_m3"] = 910.0;
    d.augmented.tests.systematic.rms = 0.2;
    d.augmented.weight = 0.0;
    d.verdict.cautions = " Beware.";
    d = with_final_fit(d);
    EXPECT_EQ(effect::number(d.verdict.effects[0].parameters, "coefficient_kg_m3"), 910.0);
    EXPECT_EQ(d.verdict.reason,
              "with quadratic_drag (coefficient_kg_m3 = 910) the systematic part falls from 10 times the noise to 0.2 "
              "times the noise. Beware.");
    EXPECT_EQ(d.candidates[0].judged->tests.systematic.rms, 0.2);
    EXPECT_EQ(d.candidates[0].judged->weight, 0.9);
}

/// Data that took no part choose nothing; where they speak against the answer it is trusted half. Small differences and
/// good predictions do not matter.
TEST(Verdict, StandsWherePredictionsGetWorseAtHalfItsConfidence) {
    for (const auto& [before, after, told] :
         {std::tuple{7.0, 1.0, false}, {7.0, 7.2, false}, {1.0, 1.25, false}, {7.0, 8.0, true}}) {
        Diagnosis d = with_candidate(0.3);
        decided(d);
        const double confidence = d.verdict.confidence;
        d.before.validation_rms_m = before * noise_m;
        d.after.validation_rms_m = after * noise_m;
        d = with_tested_confidence(d);
        EXPECT_EQ(d.verdict.kind, VerdictKind::effects);
        EXPECT_EQ(d.verdict.confidence, told ? 0.5 * confidence : confidence);
        EXPECT_EQ(!d.notes.empty() && d.notes.back().find("predicted worse") != std::string::npos, told) << after;
    }
    Diagnosis alone = with_candidate(0.3);  // no such trials
    decided(alone);
    alone = with_tested_confidence(alone);
    EXPECT_TRUE(alone.notes.empty());
}

TEST(Verdict, IsNoneWhereNothingNeedsExplaining) {
    Diagnosis d = with_candidate(0.3);
    d.declared = fit_that_leaves(0.1);
    decided(d);
    EXPECT_EQ(d.verdict.kind, VerdictKind::none);
}

/// An error that was extrapolated may really be twice as large.
TEST(Verdict, TwiceWhatTheMeshMayLeaveIsNoMissingEffect) {
    for (const double doubt : {0.1, 0.3}) {
        Diagnosis d = with_candidate(0.1);
        d.declared = fit_that_leaves(0.55);
        d.declared.tests.variance.p = 0.0;
        d.numerics.left_rms_m = doubt * noise_m;
        decided(d);
        EXPECT_EQ(d.verdict.kind, doubt > 0.2 ? VerdictKind::none : VerdictKind::effects) << doubt;
    }
}

/// A mesh whose doubt is as large as the noise does not make an explanation of what takes away a tenth.
TEST(Verdict, WhatLeavesNearlyAllExplainsNothing) {
    Diagnosis d = with_candidate(1.25);
    d.declared = fit_that_leaves(1.4);
    d.numerics.left_rms_m = noise_m;
    decided(d);
    EXPECT_EQ(d.verdict.kind, VerdictKind::unknown);
    d = with_candidate(1.25);
    d.declared = fit_that_leaves(3.0);
    d.numerics.left_rms_m = noise_m;
    decided(d);
    EXPECT_EQ(d.verdict.kind, VerdictKind::effects);
}

/// What thin plates were told of a thread that tugs: two simulators of one model differ by as much, and a cable took
/// away a third of it.
TEST(Verdict, AFaintResidualIsNoEffectUnlessOneTakesHalfOfItAway) {
    for (const double left : {0.1, 0.29}) {
        Diagnosis d = with_candidate(left);
        d.candidates[0].judged->tests.variance.p = 1.0;  // the tests are silent with the effect
        d.declared = fit_that_leaves(0.47);
        d.declared.tests.variance.p = 0.0;
        decided(d);
        EXPECT_EQ(d.verdict.kind, left < 0.2 ? VerdictKind::effects : VerdictKind::none);
        EXPECT_EQ(d.verdict.confidence<0.5, left> 0.2);
    }
    Diagnosis d = with_candidate(0.45);
    d.candidates[0].judged->tests.variance.p = 0.0;
    d.declared = fit_that_leaves(0.7);
    d.declared.tests.variance.p = 0.0;
    decided(d);
    EXPECT_EQ(d.verdict.kind, VerdictKind::unknown) << "that much is not put down to simulators";
}

/// A second effect that finds little left to do is not named; the first one is where it leaves next to nothing.
/// What each marker does by itself is the measurement's: nothing is missing, and an effect that leaves nothing else
/// explains the rest.
TEST(Verdict, WanderOfTheMeasurementNeedsNoEffect) {
    const statistics::IndependenceTest all_by_themselves{0.5, 1.0, 0.0};
    Diagnosis d = with_candidate(5.0);
    d.declared.independence = all_by_themselves;
    decided(d);
    EXPECT_EQ(d.verdict.kind, VerdictKind::none);
    EXPECT_LT(d.verdict.confidence, 0.7);
    EXPECT_NE(d.verdict.reason.find("measurement drift"), std::string::npos);
    Diagnosis beside = with_candidate(5.0);
    decided(beside);
    EXPECT_EQ(beside.verdict.kind, VerdictKind::unknown) << "half is left";
    beside = with_candidate(5.0);
    beside.candidates.front().judged->independence = all_by_themselves;
    decided(beside);
    ASSERT_EQ(beside.verdict.kind, VerdictKind::effects);
    EXPECT_NE(beside.verdict.reason.find("uncorrelated between markers"), std::string::npos);
}

TEST(Verdict, ASecondEffectHasToDoSomething) {
    for (const double pair_leaves : {0.2, 0.9}) {
        Diagnosis d = with_candidate(1.25);
        d.numerics.left_rms_m = 0.65 * noise_m;  // 0.98 noise levels are excused, 1.25 are not
        d.sets.push_back(pair_that_leaves(pair_leaves));
        decided(d);
        EXPECT_EQ(d.verdict.kind, VerdictKind::effects);
        EXPECT_EQ(d.verdict.effects.size(), pair_leaves < 0.5 ? 2u : 1u);
        EXPECT_LT(d.verdict.confidence, 0.6) << "two may stand in for one that acts in another form";
        EXPECT_GT(d.verdict.confidence, 0.45);
    }
}

/// What one trial alone tells of two effects no other tests; that of an effect which acts in one trial cannot be
/// tested.
TEST(Verdict, TwoEffectsHaveToBeTestedByOtherTrials) {
    for (const int single_trial_directions : {0, 1})
        for (const bool of_one_trial : {false, true}) {
            Diagnosis d = with_candidate(5.0);
            d.sets.push_back(pair_that_leaves(0.2));
            d.sets[0].single_trial_directions = single_trial_directions;
            if (of_one_trial) d.sets[0].fit.effects[1] = {"held_pose", {{"trial", std::string("release")}}};
            decided(d);
            const bool untested = single_trial_directions > 0 && !of_one_trial;
            EXPECT_EQ(d.verdict.kind, untested ? VerdictKind::unknown : VerdictKind::effects);
            EXPECT_EQ(d.notes.size(), untested ? 1u : 0u) << "a person is told what a further trial would test";
        }
}

/// Small rests, of the mesh say, are taken away by many second effects: the first one is named alone where they are
/// about as good.
TEST(Verdict, ASecondEffectIsNamedOnlyWhereItIsLikelierThanTheOthers) {
    for (const double weight : {0.45, 0.95}) {
        Diagnosis d = with_candidate(1.25);
        d.candidates[0].judged->weight = 0.0;
        for (const double share : {weight, 1.0 - weight}) {
            d.sets.push_back(pair_that_leaves(0.2));
            d.sets.back().weight = share;
        }
        d.sets.back().fit.effects[1].id = "gravity_tilt";
        decided(d);
        EXPECT_EQ(d.verdict.kind, VerdictKind::effects);
        EXPECT_EQ(d.verdict.effects.size(), weight > 0.5 ? 2u : 1u);
        EXPECT_EQ(d.verdict.reason.find("too small to identify") == std::string::npos, weight > 0.5);
    }
}

/// With a declared noise an effect that takes away half of the residual is the nearest name, not the answer. Where the
/// noise is that of still markers, which nothing comes down to, it is named with less confidence.
TEST(Verdict, APartOfTheResidualIsNamedOnlyWhereNobodySaysHowGoodAModelCouldBe) {
    Diagnosis d = with_candidate(5.0);
    decided(d);
    EXPECT_EQ(d.verdict.kind, VerdictKind::unknown);
    EXPECT_TRUE(d.verdict.effects.empty());

    d = with_candidate(5.0);
    d.data.noise_declared = false;
    decided(d);
    EXPECT_EQ(d.verdict.kind, VerdictKind::effects);
    EXPECT_LT(d.verdict.confidence, 0.75);
    EXPECT_NE(d.verdict.reason.find("unexplained"), std::string::npos);

    for (const auto& [left, left_held_out, named] :
         {std::tuple{8.0, 4.0, false}, {4.0, 8.0, false}, {4.0, 6.5, true}}) {
        d = with_candidate(left);
        d.data.noise_declared = false;
        d.candidates[0].judged->held_out_rms = left_held_out;
        decided(d);
        EXPECT_EQ(d.verdict.kind, named ? VerdictKind::effects : VerdictKind::unknown) << left << " " << left_held_out;
    }

    // Holding out trials does not test numbers of which one trial alone tells: blocks of time have to be predicted,
    // too.
    d = with_candidate(5.0);
    d.data.noise_declared = false;
    d.candidates[0].judged->single_trial_directions = 1;
    d.candidates[0].judged->held_out_in_time_rms = 9.0;
    decided(d);
    EXPECT_EQ(d.verdict.kind, VerdictKind::unknown);
}

/// Of what is only partly explained the pair is named where it does much more than its first effect; the first one is
/// as sure as the pairs it is in.
TEST(Verdict, APairThatExplainsMuchMoreOfARealBodyIsNamed) {
    for (const double pair_leaves : {1.0, 4.0}) {
        Diagnosis d = with_candidate(5.0);
        d.data.noise_declared = false;
        d.candidates[0].judged->weight = 0.0;
        d.sets.push_back(pair_that_leaves(pair_leaves));
        d.sets[0].tests.variance.p = 0.0;
        decided(d);
        EXPECT_EQ(d.verdict.kind, VerdictKind::effects);
        EXPECT_EQ(d.verdict.effects.size(), pair_leaves < 2.0 ? 2u : 1u);
        EXPECT_GT(d.verdict.confidence, 0.4);
    }
}

/// A fit with one number, which ends at a value between 1 and 100.
void end_at(JudgedFit& fit, prediction::ModelParameter::Kind kind, double value) {
    prediction::ModelParameter p;
    p.kind = kind;
    p.parameter.lower = 1.0;
    p.parameter.upper = 100.0;
    if (kind == prediction::ModelParameter::Kind::effect) p.of_effect = "coefficient_kg_m3";
    fit.fit.parameters = {p};
    fit.fit.values.youngs_modulus_Pa = value;
    fit.fit.values.effects = {{"quadratic_drag", {{"coefficient_kg_m3", value}}, false}};
}

/// Two ways of being too good: a modulus driven out of its tolerance explains nothing, and an effect as large as it may
/// be is trusted less.
TEST(Verdict, BoundsThatAFitEndsAtCastDoubt) {
    Diagnosis d = with_candidate(0.3);
    end_at(*d.candidates[0].judged, prediction::ModelParameter::Kind::youngs_modulus, 50.0);
    decided(d);
    EXPECT_EQ(d.verdict.kind, VerdictKind::effects);
    d = with_candidate(0.3);
    end_at(*d.candidates[0].judged, prediction::ModelParameter::Kind::youngs_modulus, 100.0);
    decided(d);
    EXPECT_EQ(d.verdict.kind, VerdictKind::unknown);

    d = with_candidate(5.0);
    d.data.noise_declared = false;  // the same with less to be explained
    end_at(*d.candidates[0].judged, prediction::ModelParameter::Kind::youngs_modulus, 100.0);
    decided(d);
    EXPECT_EQ(d.verdict.kind, VerdictKind::unknown);

    for (const double leaves : {0.3, 5.0}) {
        double confidence[2];
        for (const bool at_bound : {false, true}) {
            d = with_candidate(leaves);
            d.data.noise_declared = leaves < 1.0;
            end_at(*d.candidates[0].judged, prediction::ModelParameter::Kind::effect, at_bound ? 100.0 : 50.0);
            decided(d);
            EXPECT_EQ(d.verdict.kind, VerdictKind::effects);
            EXPECT_EQ(d.verdict.reason.find("Its size reached its limit") != std::string::npos, at_bound);
            confidence[at_bound] = d.verdict.confidence;
        }
        EXPECT_NEAR(confidence[1] / confidence[0], 0.5, 1e-12);
    }
}

/// Where the data leave the modulus open, as of a real body with muscles at unknown levels, its bound says nothing
/// against an effect that takes most away.
TEST(Verdict, AModulusThatWasAtABoundBeforeDoesNotDenyAnEffect) {
    double confidence[2];
    for (const bool at_bound : {false, true}) {
        Diagnosis d = with_candidate(5.0);
        d.data.noise_declared = false;
        end_at(d.declared, prediction::ModelParameter::Kind::youngs_modulus, at_bound ? 1.0 : 50.0);
        end_at(*d.candidates[0].judged, prediction::ModelParameter::Kind::youngs_modulus, at_bound ? 100.0 : 50.0);
        decided(d);
        EXPECT_EQ(d.verdict.kind, VerdictKind::effects);
        EXPECT_EQ(d.verdict.reason.find("The modulus ends at a bound") != std::string::npos, at_bound);
        confidence[at_bound] = d.verdict.confidence;
    }
    EXPECT_NEAR(confidence[1] / confidence[0], 0.5, 1e-12);
}

/// A fit of an effect and its place may take a residual away, and the amount be anything: that is a name for noise.
TEST(Verdict, AnAmountThatIsNotToldFromNothingExplainsNothing) {
    for (const bool noise_declared : {true, false})
        for (const double deviation : {1.0, 30.0}) {
            Diagnosis d = with_candidate(noise_declared ? 0.3 : 5.0);
            d.data.noise_declared = noise_declared;
            JudgedFit& fit = *d.candidates[0].judged;
            end_at(fit, prediction::ModelParameter::Kind::effect, 50.0);
            fit.fit.report.deviations = Eigen::VectorXd::Constant(1, deviation);
            decided(d);
            EXPECT_EQ(d.verdict.kind, deviation > 20.0 ? VerdictKind::unknown : VerdictKind::effects);
            fit.fit.report.deviations(0) = std::numeric_limits<double>::quiet_NaN();  // the data do not determine it
            decided(d);
            EXPECT_EQ(d.verdict.kind, VerdictKind::unknown);
        }
}

/// Fits of two trials may follow both, and tell nothing of the one that was left out.
TEST(Verdict, WhatPredictsNoHeldOutDataExplainsNothing) {
    for (const bool by_time : {false, true})
        for (const double held_out : {1.3, 1.05}) {
            Diagnosis d = with_candidate(0.3);
            d.declared.held_out_rms = d.declared.held_out_in_time_rms = 1.4;
            JudgedFit& fit = *d.candidates[0].judged;
            fit.single_trial_directions = by_time ? 1 : 0;  // then other times test it
            fit.held_out_rms = by_time ? 1.4 : held_out;
            fit.held_out_in_time_rms = by_time ? held_out : 1.4;
            decided(d);
            EXPECT_EQ(d.verdict.kind, held_out > 1.2 ? VerdictKind::unknown : VerdictKind::effects);
        }
}

/// A residual that is less than two thirds of the mesh's error, which was taken off, may be what was taken off wrongly.
TEST(Verdict, APartOfTheMeshErrorIsNoMissingEffect) {
    for (const double mesh : {0.3, 1.2}) {
        Diagnosis d = with_candidate(0.6);
        d.candidates[0].judged->tests.variance.p = 0.0;
        d.declared = fit_that_leaves(0.7);
        d.declared.tests.variance.p = 0.0;
        d.numerics.mesh_rms_m = mesh * noise_m;
        decided(d);
        EXPECT_EQ(d.verdict.kind, mesh > 1.0 ? VerdictKind::none : VerdictKind::unknown);
        EXPECT_TRUE(mesh < 1.0 || d.verdict.confidence < 0.5);
    }
}

/// Where a mesh is wrong by more than the noise, what is extrapolated of that is uncertain: it may leave a part of what
/// an effect explains well.
TEST(Verdict, AMeshThatIsFarOffExcusesAPartOfWhatIsLeft) {
    for (const auto& [mesh, was, named] : {std::tuple{0.5, 3.0, false}, {1.5, 3.0, true}, {1.5, 0.9, false}}) {
        Diagnosis d = with_candidate(0.48);
        d.candidates[0].judged->tests.variance.p = 0.0;
        d.declared = fit_that_leaves(was);
        d.declared.tests.variance.p = 0.0;
        d.numerics.mesh_rms_m = mesh * noise_m;
        decided(d);
        EXPECT_EQ(d.verdict.kind, named ? VerdictKind::effects : VerdictKind::unknown) << mesh << " " << was;
    }
}

/// What is left is an estimate: an effect is denied where it is surely above what another form may leave.
TEST(Verdict, ChanceMayAddToWhatIsLeft) {
    for (const double deviation : {0.01, 0.03}) {
        Diagnosis d = with_candidate(0.54);  // 0.5 is a twentieth of what was there
        d.candidates[0].judged->tests.variance.p = 0.0;
        d.candidates[0].judged->tests.systematic.deviation = deviation;
        EXPECT_EQ(explained(d.candidates, d.baseline()), deviation > 0.02) << "1.64 deviations";
        EXPECT_FALSE(explained(d.candidates, d.baseline(), Leniency::strict)) << "the search goes on";
    }
}

/// What predicts held-out trials a little better and leaves a part unexplained comes after what explains the residual.
TEST(Verdict, WhatExplainsTheResidualComesFirst) {
    Diagnosis d = with_candidate(0.6);
    d.data.layout.series = {{0, 0, 0, 0, 100}};
    for (int k = 0; k < 100; ++k) {
        d.data.layout.sample.push_back(k);
        d.data.layout.time_s.push_back(0.01 * k);
    }
    d.candidates[0].judged->tests.variance.p = 0.0;
    Candidate other;
    other.score.id = "gravity_tilt";
    other.judged = fit_that_leaves(0.2, "gravity_tilt");
    other.judged->held_out_rms = 3.0;
    d.candidates.push_back(other);
    d.candidates = with_ranked_candidates({{}, d.candidates, {}}, d.baseline()).candidates;
    ASSERT_LT(d.candidates[1].judged->criterion, d.candidates[0].judged->criterion) << "or nothing is tested";
    EXPECT_EQ(d.candidates[0].score.id, "gravity_tilt");
    decided(d);
    ASSERT_EQ(d.verdict.effects.size(), 1u);
    EXPECT_EQ(d.verdict.effects[0].id, "gravity_tilt");
    EXPECT_GT(d.verdict.confidence, 0.3);
    EXPECT_LT(d.verdict.confidence, 0.7);
}

/// Another program's form of an effect leaves a share of what was there, and a coarse mesh more than was found; not so
/// where the effect could not be larger.
TEST(Verdict, WhatAnEffectAtItsBoundLeavesIsNotExcused) {
    for (const bool of_mesh : {false, true})
        for (const bool at_bound : {false, true}) {
            Diagnosis d = with_candidate(1.2);
            d.candidates[0].judged->tests.variance.p = 0.0;
            if (of_mesh)
                d.numerics.left_rms_m = 0.9 * noise_m;
            else
                d.declared = fit_that_leaves(30.0);
            end_at(*d.candidates[0].judged, prediction::ModelParameter::Kind::effect, at_bound ? 100.0 : 50.0);
            decided(d);
            EXPECT_EQ(d.verdict.kind, at_bound ? VerdictKind::unknown : VerdictKind::effects);
        }
}

/// An effect that explains the residual alone, with which pairs fit better still, acts as surely as the pairs it is in;
/// that it is all is less sure.
TEST(Verdict, BetterPairsDoNotDenyWhatExplainsTheResidualAlone) {
    Diagnosis d = with_candidate(0.3);
    decided(d);
    const double undisputed = d.verdict.confidence;
    d = with_candidate(0.3);
    d.candidates[0].judged->weight = 1e-6;
    d.sets.push_back(pair_that_leaves(0.25));
    decided(d);
    EXPECT_EQ(d.verdict.effects.size(), 1u);
    EXPECT_GT(d.verdict.confidence, 0.4);
    EXPECT_LT(d.verdict.confidence, 0.7 * undisputed);
}

/// A mesh error of a tenth of the noise is not above it: what is left over by the step may be.
TEST(Verdict, SaysWhichErrorIsAboveTheNoise) {
    NumericalError numerics;
    numerics.mesh_rms_m = 1.2e-5;
    numerics.step_rms_m = 5e-4;
    numerics.left_rms_m = 2e-4;
    const std::string by_step = above_noise_note(numerics, 1e-4);
    EXPECT_NE(by_step.find(
                  "2 times the noise, is above the noise (mesh 0.12 times the noise, step 5 times the noise): choose "
                  "a smaller --dt"),
              std::string::npos)
        << by_step;
    numerics.mesh_rms_m = 1e-3;
    EXPECT_NE(above_noise_note(numerics, 1e-4).find("choose a finer --resolution"), std::string::npos);
}

}  // namespace
}  // namespace myo::diagnosis
