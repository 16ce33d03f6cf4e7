#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/diagnosis_policy.hpp"
#include "diagnosis/discretisation/numerical_error.hpp"
#include "diagnosis/fit/joint_fit.hpp"
#include "diagnosis/missing_force/missing_force.hpp"
#include "diagnosis/screening/effect_scores.hpp"
#include "prediction/run_trials.hpp"
#include "statistics/independence_test.hpp"
#include "statistics/residual_tests.hpp"

namespace myo::diagnosis {

struct DiagnoseSettings {
    double alpha = 0.01;               // false-alarm rate of the significance tests, all together
    int refits = 10;                   // candidates that are fitted after the score test
    int pairs = 5;                     // seconds that are fitted beside the best one
    bool refine_mesh = true;           // bound and take off the mesh's error
    std::vector<std::string> without;  // effects that may not be named
    std::optional<std::filesystem::path>
        fits;  // file of fits done before, read and kept up to date: to go on where it was stopped
    DiagnosisPolicy policy = {};
};

/// A fit with what decides about it.
struct JudgedFit {
    JointFit fit;
    double rms_m = 0.0;         // over the fit trials
    double held_out_rms = 0.0;  // in units of the noise, each trial predicted from the others (linearised); of one:
                                // blocks of time
    double held_out_in_time_rms = 0.0;  // the same with blocks of time of all trials
    int single_trial_directions = 0;    // directions of the numbers of which one trial alone tells: they stay as fitted
                                        // when it is held out
    double criterion = 0.0;             // what fits are ordered by; lower is better
    double weight = 0.0;                // share of the evidence among all that were fitted
    statistics::ResidualTests tests;
    statistics::IndependenceTest independence;  // of a residual that is significant and not large
    std::optional<NumericalError> numerics;  // found with this fit, and taken off; none: that of the declared fit was

    bool usable() const { return fit.usable(); }
    /// What is systematic is the measurement's: each marker has its own.
    bool drifts() const { return independence.is_drift(); }
};

/// An effect that was tried.
struct Candidate {
    EffectScore score;                // of its best probe
    double adjusted_p = 1.0;          // of the score, over all candidates (Holm)
    std::optional<JudgedFit> judged;  // where it was fitted
    std::vector<std::string> like;    // effects whose part of the residual this experiment cannot tell from its own
};

/// Effects that this experiment cannot tell apart, with the cosine of what they do to the residual.
struct Confusion {
    std::string first, second;
    double cosine = 0.0;
    std::string next_experiment;  // what would tell them apart
};

enum class VerdictKind { none, effects, unknown };

struct Verdict {
    VerdictKind kind = VerdictKind::unknown;
    std::vector<effect::EffectDeclaration> effects = {};
    double confidence = 0.0;
    std::string because = {};               // one or two sentences for a person
    std::vector<std::string> ranking = {};  // ids in falling order of credibility, none and unknown among them
    std::string but = {};                   // what of `because` speaks for care, its end
    std::string rule = {};                  // of verdict_rules()
};

struct StageCost {
    std::string stage;
    double seconds = 0.0;
    int runs = 0;  // of trials, tangents included
};

/// What the declared model lacks, and how it is known.
struct Diagnosis {
    DiagnoseSettings settings;
    FitData data;          // of the fit trials
    double noise_m = 0.0;  // rms a right model would leave
    NumericalError numerics;
    std::vector<double> step_factors;  // steps of all fits over the setup's, per trial; empty: 1.
                                       // The shift belongs to these
    double modulus_factor = 1.0;       // of the cells in all fits after the declared one's first
    JudgedFit declared;
    std::vector<Candidate> candidates;  // most credible first
    std::vector<JudgedFit> pairs;       // best first
    std::vector<Confusion> confusions;
    Verdict verdict;
    JudgedFit augmented;                 // the declared fit where the verdict is none
    prediction::SetupRun before, after;  // all trials, shifted by the numerical error
    std::vector<StageCost> cost;
    std::vector<std::string> notes;
    double seconds = 0.0;
    bool stopped = false;                       // by the user; what is complete is here
    std::string failure;                        // the declared model could not be fitted
    std::optional<MissingForce> missing_force;  // sought where the verdict is unknown, see infer_missing_force()

    bool complete() const { return !stopped && failure.empty(); }
};

/// Whether a verdict may name this effect.
bool may_be_named(const DiagnoseSettings& settings, const std::string& effect);

/// The setup on a body that shows every effect that may be named. All fits of a diagnosis use it, because two elements
/// differ by more than small effects do.
setup::Setup for_candidates(setup::Setup setup, const DiagnoseSettings& settings);

/// The setup with the body, the steps and the cells' modulus that a diagnosis used.
setup::Setup as_diagnosed(const Diagnosis& diagnosis, setup::Setup setup);

/// Declared fit, numerical error, significance, scores, refits, pairs, verdict, prediction of all trials.
///
/// Trials with role `validate` take part in nothing but the last: a verdict with which they are predicted worse stands,
/// at half its confidence. Progress: stage by stage in its own unit. The same result on any number of threads. live:
/// called with what is known after every stage and refit, from the calling thread; may be null. Source: design of the
/// method: Rao 1948 (score test), Hastie et al. 2009, ch. 7 (choice by held-out data).
Diagnosis diagnose(const setup::Setup& setup, const DiagnoseSettings& settings, const Progress& progress = {},
                   const std::function<void(const Diagnosis&)>& live = {});

}  // namespace myo::diagnosis
