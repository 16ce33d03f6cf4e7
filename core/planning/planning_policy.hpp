#pragma once

#include <cstddef>

namespace myo::planning {

/// How surely an effect, or the difference of two rivals, is seen.
struct DetectionPolicy {
    double alpha = 0.01;  // false-alarm rate of a test; that of a diagnosis
    double wanted = 0.8;  // probability from which something counts as detected. Source: Cohen 1988, ch. 1
    /// Deviation of the numerical error of predictions [noise levels, rms]: 0.3, by which two simulators of one model
    /// differ at most (JudgementPolicy::min_systematic), as 99 % quantile.
    double numerical_error = 0.12;
    int bisections = 60;              // for the noncentrality of a probability
    double most_noncentrality = 1e4;  // at which every test is sure
    double least_kept = 1e-3;         // share of a response that recalibration must leave for a statement
    double indistinguishable = 0.97;  // cosine; ConfusionPolicy::min_cosine
};

/// Power map of an experiment.
struct PowerPolicy {
    int sizes = 3;               // of each effect over its range, equal ratios
    std::size_t most_forms = 4;  // of an effect, evenly chosen among its places: enough for a median
};

/// Family of trials for the next experiment.
struct FamilyPolicy {
    double beyond_seen = 1.5;      // limit of an amount over the largest of the trials, where no limit is declared
    double force_of_weight = 0.5;  // limit of a force over the body's weight, where no trial has one: as `validate`
    double mass_of_body = 0.4;     // limit of a mass over the body's, likewise
    double smaller = 0.4;          // of the limit, the other size of forces and masses
    double moderate = 0.5;         // of the range of an actuator, the lower step
    double end_depth = 0.01;       // of the free end on which a new load acts, over the body's length
    double planned_s = 1.0;        // of a trial where none moves, and of a force's release
    double ramp_up = 0.8;          // share of a ramp's trial until its peak
    double sine_periods = 6.0;     // in a trial
    double sample_s = 0.01;        // of a written signal
    double lead_s = 0.05;          // before a signal begins
    std::size_t max_places = 2;    // of loads
    std::size_t max_trials = 40;   // of the family
};

/// Choice of the next experiment.
struct ProposalPolicy {
    /// Within `diagnose`: share of its time that the choice may take, and the fewest trials worth a choice.
    double most_time = 0.2;
    std::size_t fewest_trials = 4;
    std::size_t most_groups = 1;  // of effects for which a trial is sought
    int runners_up = 5;           // that are listed
};

/// Numbers of all plans.
struct PlanningPolicy {
    DetectionPolicy detection;
    PowerPolicy power;
    FamilyPolicy family;
    ProposalPolicy proposal;
};

}  // namespace myo::planning
