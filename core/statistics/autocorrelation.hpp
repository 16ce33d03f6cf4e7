#pragma once

#include <Eigen/Core>

#include "statistics/residual_layout.hpp"

namespace myo::statistics {

/// Autocovariance of one series about zero. The mean is not removed: a constant residual is misfit.
struct Autocovariance {
    Eigen::VectorXd sums;   // lags 0 ... L: sum of r(t) r(t + lag) over the pairs with both samples seen
    Eigen::VectorXd pairs;  // lags 0 ... L: number of these pairs

    /// Autocorrelation: sums / pairs divided by the mean square. Lag 0 is 1; 0 at lags without pairs.
    Eigen::VectorXd correlation() const;
};

/// Autocovariance of one series.
/// @param lags  largest lag [samples]; cut to the length of the series
Autocovariance autocovariance(const GriddedSeries& series, int lags);

/// Autocovariance summed over all series of a trial, for plots.
/// @param lags   largest lag L [samples]; result has L + 1 entries
/// @param trial  trial number; negative: all trials
Autocovariance pooled_autocovariance(const Eigen::VectorXd& r, const ResidualLayout& layout, int lags, int trial = -1);

/// Variance inflation of sum r(t) s(t) for two independent stationary series: 1 + 2 sum_k w(k) rho_r(k) rho_s(k).
///
/// w is the triangular window up to a third of the series. Pooled over series, each weighted by the energy of s and by
/// the variance of r.
/// @return  >= 1; 1 for white r
/// Source: Bartlett 1935, J. Roy. Stat. Soc. 98, 536.
double variance_inflation(const Eigen::VectorXd& r, const Eigen::VectorXd& s, const ResidualLayout& layout);
/// The same for one pair of series.
double variance_inflation(const GriddedSeries& r, const GriddedSeries& s);

/// Effective number of samples of a residual: sum over series of n / (1 + 2 sum_k w(k) rho(k)^2).
///
/// This number of independent samples carries the same information about a signal with the autocorrelation of the
/// residual. The squares rho^2 are corrected for their expectation under chance.
/// @return  between 1 per series and N
double effective_samples(const Eigen::VectorXd& r, const ResidualLayout& layout);

}  // namespace myo::statistics
