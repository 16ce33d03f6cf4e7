#pragma once

#include <cstddef>
#include <vector>

namespace myo::statistics {

/// Bayesian information criterion with unknown noise variance: N_eff ln(|r|^2 / N) + k ln N_eff.
///
/// @param squared_norm       |r|^2 at the optimum
/// @param samples            N, the same for all compared models
/// @param effective_samples  N_eff, the same for all compared models: that of the best residual, see
///                           effective_samples()
/// @param parameters         k, number of fitted parameters
/// Source: Schwarz 1978, Ann. Statistics 6, 461.
double information_criterion(double squared_norm, double samples, double effective_samples, int parameters);

/// Bayesian information criterion for noise of variance 1: |r|^2 N_eff / N + k ln N_eff. Parameters as above.
double information_criterion_known_noise(double squared_norm, double samples, double effective_samples, int parameters);

/// Model weights exp(-(c - min c) / (2 temperature)), normalised to sum 1.
///
/// @param criteria     information criteria; non-finite entries get weight 0
/// @param temperature  > 0. 1: weights as the criteria state. Above 1: less decisive weights, to account for errors
///                     that all models share
/// @return             one weight per criterion; all 0 if no criterion is finite
/// Source: Burnham & Anderson 2002, ch. 2.9; temperature: Guo et al. 2017, ICML 70, 1321.
std::vector<double> evidence_weights(const std::vector<double>& criteria, double temperature = 1.0);

/// Model comparison with known true model, for the calibration of the temperature.
struct JudgedComparison {
    std::vector<double> criteria;  // information criteria of the compared models
    std::size_t truth = 0;         // index of the true model
};

/// Temperature in [0.05, 1000] that maximises the likelihood of the true models; 1 without comparisons.
double calibrated_temperature(const std::vector<JudgedComparison>& comparisons);

}  // namespace myo::statistics
