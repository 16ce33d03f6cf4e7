#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/fit/repeatability.hpp"
#include "diagnosis/missing_force/missing_force.hpp"
#include "diagnosis/phase_log.hpp"
#include "diagnosis/screening/confusion.hpp"
#include "diagnosis/selection/judged_fit.hpp"
#include "prediction/run_trials.hpp"

namespace myo::diagnosis {

/// `none`: the declared model explains the recordings. `effects`: with these it does. `unknown`: something is missing
/// that no admitted effect explains.
enum class VerdictKind { none, effects, unknown };

/// Answer of a diagnosis, with confidence and reason.
struct Verdict {
    VerdictKind kind = VerdictKind::unknown;
    std::vector<effect::EffectDeclaration> effects = {};
    double confidence = 0.0;                // of the whole answer
    std::string reason = {};                // one or two sentences for the user
    std::vector<std::string> ranking = {};  // ids by decreasing credibility, including none and unknown
    std::string cautions = {};              // at the end of the reason
    std::string rule = {};                  // name of the rule, see verdict_rules()
    double trust = 1.0;                     // in the evidence for named effects: by the tests of the fit alone
    std::vector<std::vector<std::string>> twins =
        {};  // named effects with those that move the body alike, see twins_of()
};

/// Result of a diagnosis: what the declared model lacks, and the evidence.
/// A part is complete from the phase on that computes it, and has its default until then, or if a stop prevents it.
struct Diagnosis {
    DiagnoseSettings settings;
    FitData data;          // of the fit trials
    double noise_m = 0.0;  // rms residual of a correct model
    NumericalError numerics;
    Repeatability repeatability;
    std::vector<double> step_factors;  // per trial: steps of all fits over those of the setup; empty: 1. The shift
                                       // belongs to these steps
    std::shared_ptr<const setup::Setup> coarser;  // the setup on the cells of all fits; null: on those that were given
    double modulus_factor = 1.0;                  // of the cells, in all fits after the first declared fit
    JudgedFit declared;
    std::vector<Candidate> candidates;  // most credible first
    std::vector<JudgedFit> sets;        // of two and more effects, best first
    std::vector<Confusion> confusions;
    Verdict verdict;
    JudgedFit augmented;                 // declared fit if the verdict is none, best attempt if it is unknown
    prediction::SetupRun before, after;  // all trials, numerical error removed
    std::vector<PhaseCost> cost;
    std::vector<std::string> notes;
    double seconds = 0.0;
    bool stopped = false;                       // by the user; completed parts are valid
    bool search_complete = true;                // false: the search ended at its limit of time
    std::string failure;                        // reason why the declared model could not be fitted
    std::optional<MissingForce> missing_force;  // computed if the verdict is unknown, see whole_diagnosis()

    bool complete() const { return !stopped && failure.empty(); }
    /// Declared fit, data and policy, against which other fits are judged.
    Baseline baseline() const { return {declared, data, numerics, settings}; }
};

/// Setup with the cells, element, steps and effective modulus that a diagnosis used: runs of it compare with its fits.
///
/// @param setup  the setup that was given to diagnose(), unchanged
setup::Setup as_diagnosed(const Diagnosis& diagnosis, const setup::Setup& setup);

/// Declared fit, numerical error, significance, scores, candidate fits, sets, verdict, prediction of all trials.
///
/// Trials with role `validate` are only predicted at the end: a verdict with which their prediction is worse keeps half
/// its confidence. The result does not depend on the number of threads. Progress is reported by phase, each in its own
/// unit.
/// @param setup     without a compared sample in a fit trial the result has a `failure`
/// @param settings  the file of fits is read and written if one is given
/// @param live  called with the intermediate result after every phase, from the calling thread; may be null
/// @return  nothing is thrown: `failure` has the reason if the declared model cannot be run, `stopped` a cancellation
/// Source: Rao 1948 (score test); Hastie et al. 2009, ch. 7 (selection by held-out data).
Diagnosis diagnose(const setup::Setup& setup, const DiagnoseSettings& settings, const Progress& progress = {},
                   const std::function<void(const Diagnosis&)>& live = {});

}  // namespace myo::diagnosis
