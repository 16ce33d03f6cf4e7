#pragma once

#include <cstddef>
#include <vector>

namespace myo::statistics {

/// Bayesian information criterion of a fit whose noise level is not trusted: N_eff ln(|r|^2 / N) + k ln N_eff.
///
/// Models that are compared need the same N and the same N_eff: that of the best residual among them
/// (effective_samples). Source: Schwarz 1978, Ann. Statistics 6, 461.
double information_criterion(double squared_norm, double samples, double effective_samples, int parameters);

/// The same with noise of variance 1: |r|^2 N_eff / N + k ln N_eff.
double information_criterion_known_noise(double squared_norm, double samples, double effective_samples, int parameters);

/// Weights exp(-(c - min c) / (2 temperature)), summing to 1; 0 for criteria that are not finite. Empty or all not
/// finite: zeros.
///
/// Temperature 1 takes the criteria at their word; above 1 the weights say less, as fits with errors the models share
/// require. Source: Burnham & Anderson 2002, ch. 2.9; temperature: Guo et al. 2017, ICML 70, 1321.
std::vector<double> evidence_weights(const std::vector<double>& criteria, double temperature = 1.0);

/// A comparison of which the truth is known.
struct JudgedComparison {
    std::vector<double> criteria;
    std::size_t truth = 0;
};

/// Temperature in [0.05, 1000] under which the weights of the truth are most likely; 1 without comparisons.
double calibrated_temperature(const std::vector<JudgedComparison>& comparisons);

}  // namespace myo::statistics
