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

/// Settings of a diagnosis.
struct DiagnoseSettings {
    double alpha = 0.01;               // false-alarm rate of all significance tests together
    int refits = 10;                   // number of candidates that are fitted after the score tests
    int pairs = 5;                     // number of second effects that are fitted together with the best one
    bool refine_mesh = true;           // estimate and remove the mesh error
    std::vector<std::string> without;  // effects that may not be named
    /// File of finished fits, read at the start and kept up to date; a stopped diagnosis resumes from it.
    std::optional<std::filesystem::path> fits;
    DiagnosisPolicy policy = {};
};

/// Fit with its assessment.
struct JudgedFit {
    JointFit fit;
    double rms_m = 0.0;         // over the fit trials
    double held_out_rms = 0.0;  // [noise levels] each trial predicted from the others (linearised); a single trial:
                                // blocks of time
    double held_out_in_time_rms = 0.0;  // [noise levels] blocks of time of all trials predicted from the others
    int single_trial_directions = 0;    // directions of the parameters that a single trial determines; they keep the
                                        // fitted values when it is held out
    double criterion = 0.0;             // order of fits; lower is better
    double weight = 0.0;                // share of the evidence among all fits
    statistics::ResidualTests tests;
    statistics::IndependenceTest independence;  // computed for residuals that are significant and not large
    std::optional<NumericalError> numerics;     // error of this fit, removed; empty: that of the declared fit was

    bool usable() const { return fit.usable(); }
    /// The systematic residual is measurement drift: uncorrelated between markers.
    bool drifts() const { return independence.is_drift(); }
};

/// Effect that was tried.
struct Candidate {
    EffectScore score;                // of its best probe
    double adjusted_p = 1.0;          // of the score, over all probes (Holm)
    std::optional<JudgedFit> judged;  // empty: not fitted
    std::vector<std::string> like;    // confounded effects: this experiment cannot separate them from this one
};

/// Two effects that this experiment cannot separate, with the cosine of their changes of the residual.
struct Confusion {
    std::string first, second;
    double cosine = 0.0;
    std::string next_experiment;  // one that would separate them
};

enum class VerdictKind { none, effects, unknown };

/// Answer of a diagnosis, with confidence and reason.
struct Verdict {
    VerdictKind kind = VerdictKind::unknown;
    std::vector<effect::EffectDeclaration> effects = {};
    double confidence = 0.0;
    std::string because = {};               // one or two sentences for the user
    std::vector<std::string> ranking = {};  // ids by decreasing credibility, including none and unknown
    std::string but = {};                   // cautions at the end of `because`
    std::string rule = {};                  // name of the rule, see verdict_rules()
};

/// Cost of one phase of a diagnosis.
struct StageCost {
    std::string stage;
    double seconds = 0.0;
    int runs = 0;  // trial runs, tangents included
};

/// Result of a diagnosis: what the declared model lacks, and the evidence.
struct Diagnosis {
    DiagnoseSettings settings;
    FitData data;          // of the fit trials
    double noise_m = 0.0;  // rms residual of a correct model
    NumericalError numerics;
    std::vector<double> step_factors;  // per trial: steps of all fits over those of the setup; empty: 1. The shift
                                       // belongs to these steps
    double modulus_factor = 1.0;       // of the cells, in all fits after the first declared fit
    JudgedFit declared;
    std::vector<Candidate> candidates;  // most credible first
    std::vector<JudgedFit> pairs;       // best first
    std::vector<Confusion> confusions;
    Verdict verdict;
    JudgedFit augmented;                 // declared fit if the verdict is none, best attempt if it is unknown
    prediction::SetupRun before, after;  // all trials, numerical error removed
    std::vector<StageCost> cost;
    std::vector<std::string> notes;
    double seconds = 0.0;
    bool stopped = false;                       // by the user; completed parts are valid
    std::string failure;                        // reason why the declared model could not be fitted
    std::optional<MissingForce> missing_force;  // computed if the verdict is unknown, see whole_diagnosis()

    bool complete() const { return !stopped && failure.empty(); }
};

/// Whether a verdict may name this effect: not excluded by the settings.
bool may_be_named(const DiagnoseSettings& settings, const std::string& effect);

/// Setup with an element that resolves every effect that may be named. All fits of a diagnosis use it: two elements
/// differ by more than small effects do.
setup::Setup for_candidates(setup::Setup setup, const DiagnoseSettings& settings);

/// Setup with the element, steps and effective modulus that a diagnosis used.
setup::Setup as_diagnosed(const Diagnosis& diagnosis, setup::Setup setup);

/// Declared fit, numerical error, significance, scores, candidate fits, pairs, verdict, prediction of all trials.
///
/// Trials with role `validate` are only predicted at the end: a verdict with which their prediction is worse keeps half
/// its confidence. The result does not depend on the number of threads. Progress is reported by phase, each in its own
/// unit.
/// @param live  called with the intermediate result after every phase, from the calling thread; may be null
/// Source: Rao 1948 (score test); Hastie et al. 2009, ch. 7 (selection by held-out data).
Diagnosis diagnose(const setup::Setup& setup, const DiagnoseSettings& settings, const Progress& progress = {},
                   const std::function<void(const Diagnosis&)>& live = {});

}  // namespace myo::diagnosis
