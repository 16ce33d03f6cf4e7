#pragma once

#include <string>
#include <vector>

#include "diagnosis/selection/judged_fit.hpp"

namespace myo::diagnosis {

struct Diagnosis;

/// Two effects that this experiment cannot separate, with the cosine of their changes of the residual.
struct Confusion {
    std::string first, second;
    // Magnitude, 0 ... 1; 1: one replaces the other exactly.
    double cosine = 0.0;
    std::string next_experiment;  // one that would separate them
};

/// Candidates that explain the residual in the same way, according to scores or fits, and the experiment that would
/// separate them.
/// Pairs with a cosine from ConfusionPolicy::min_cosine on, each once, the more credible effect first.
std::vector<Confusion> find_confusions(const std::vector<Candidate>& candidates, const JointFit& declared,
                                       const ConfusionPolicy& policy);

/// The candidates with the names of the effects that they are confounded with.
std::vector<Candidate> with_confusions(std::vector<Candidate> candidates, const std::vector<Confusion>& confusions);

/// Confusions that concern the verdict: those with a named effect, or all if it names none.
std::vector<Confusion> confusions_of_verdict(const Diagnosis& diagnosis);

/// Whether the fits decide between two confounded effects: one is in the verdict, the other was fitted and has
/// negligible weight.
bool is_decided(const Diagnosis& diagnosis, const Confusion& confusion);

}  // namespace myo::diagnosis
