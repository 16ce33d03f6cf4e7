#pragma once

#include <string>

#include "diagnosis/verdict/verdict.hpp"

// Fits and diagnoses made up for tests of the judgement and the verdict.

namespace myo::test {

inline constexpr double noise_m = 1e-4;

/// A fit whose residual is so many times the noise, all of it systematic.
inline diagnosis::JudgedFit fit_that_leaves(double over_noise, const std::string& effect = {}) {
    diagnosis::JudgedFit fit;
    fit.fit.residual = Eigen::VectorXd::Constant(100, over_noise);
    if (!effect.empty()) fit.fit.effects.push_back({effect, {{"coefficient_kg_m3", 900.0}}});
    fit.rms_m = over_noise * noise_m;
    fit.held_out_rms = fit.held_out_in_time_rms = over_noise;
    fit.criterion = over_noise;
    fit.weight = 0.9;
    fit.tests.systematic.rms = over_noise;
    fit.tests.variance.p = over_noise > 1.2 ? 0.0 : 1.0;
    fit.tests.threshold = 0.0025;
    return fit;
}

/// A declared fit that leaves ten times the noise, and a candidate.
inline diagnosis::Diagnosis with_candidate(double left_over_noise) {
    diagnosis::Diagnosis d;
    d.data.noise_m = Eigen::VectorXd::Constant(100, noise_m);
    d.noise_m = noise_m;
    d.declared = fit_that_leaves(10.0);
    diagnosis::Candidate candidate;
    candidate.score.id = "quadratic_drag";
    candidate.judged = fit_that_leaves(left_over_noise, "quadratic_drag");
    d.candidates.push_back(candidate);
    return d;
}

/// A fit of the candidate's effect and a second one.
inline diagnosis::JudgedFit pair_that_leaves(double over_noise) {
    diagnosis::JudgedFit pair = fit_that_leaves(over_noise, "quadratic_drag");
    pair.fit.effects.push_back({"cable_tug", {}});
    return pair;
}

/// Enters the verdict and its notes into the diagnosis; returns the fit that it rests on.
inline diagnosis::JudgedFit decided(diagnosis::Diagnosis& d) {
    diagnosis::Decision decision = diagnosis::decide(d);
    d.verdict = decision.verdict;
    d.notes.insert(d.notes.end(), decision.notes.begin(), decision.notes.end());
    return decision.fit;
}

}  // namespace myo::test
