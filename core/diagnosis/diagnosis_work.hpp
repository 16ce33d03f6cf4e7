#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/stopwatch.hpp"
#include "diagnosis/diagnosis.hpp"
#include "diagnosis/discretisation/error_finder.hpp"
#include "diagnosis/fit/candidate_fits.hpp"
#include "diagnosis/fit/fit_store.hpp"
#include "diagnosis/fit/stored_fit.hpp"

namespace myo::diagnosis {

/// State of a running diagnosis, shared by its phases.
struct DiagnosisWork {
    DiagnosisWork(const setup::Setup& as_declared, const DiagnoseSettings& settings, const Progress& told,
                  const std::function<void(const Diagnosis&)>& shown);
    DiagnosisWork(const DiagnosisWork&) = delete;  // the error finder refers to `setup`
    DiagnosisWork& operator=(const DiagnosisWork&) = delete;

    setup::Setup setup;   // with the steps of all fits
    setup::Setup serial;  // same setup with one thread per fit, for fits in parallel
    const Progress& progress;
    const std::function<void(const Diagnosis&)>& live;
    std::unique_ptr<FitStore> store;
    ErrorFinder errors;
    Diagnosis result;

    bool allowed(const std::string& effect) const;
    int fit_count() const { return static_cast<int>(result.data.trials.size()); }
    std::vector<std::size_t> all_trials() const;
    void show() const;
    /// Accumulated cost of a phase.
    StageCost& cost_of(const std::string& stage);

    /// Runs a task as a phase: adds its time and trial runs to the table of costs, and reports progress and result.
    template <class Task>
    auto stage(const std::string& name, int runs, const Task& task) {
        const Stopwatch watch;
        progress.report({name, 0.0, 1.0, "stage", {}});
        auto value = task();
        StageCost& cost = cost_of(name);
        cost.seconds += watch.seconds();
        cost.runs += runs;
        show();
        return value;
    }

    /// Phase that fits all parameters, with trials in parallel. Not usable if it failed or was cancelled.
    JointFit fit(const std::string& name, const prediction::ParameterValues& start, const Effort& effort,
                 const Neighbourhood& known = {});

    /// Phase that fits candidates in parallel, see fit_candidates().
    std::vector<JudgedFit> fit_all(const std::string& name, const JointFit& base,
                                   const std::vector<CandidateStart>& starts, double least_so_far,
                                   double pruning_factor);
};

}  // namespace myo::diagnosis
