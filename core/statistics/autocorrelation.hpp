#pragma once

#include <Eigen/Core>

#include "statistics/residual_layout.hpp"

namespace myo::statistics {

/// Autocovariance of one series about zero: a lasting offset of a residual is misfit, too.
struct Autocovariance {
    Eigen::VectorXd sums;   // lags 0 ... L: sum of r(t) r(t + lag) over the pairs that were seen
    Eigen::VectorXd pairs;  // their number

    /// sums / pairs over the mean square; 0 where there are no pairs. Lag 0 is 1.
    Eigen::VectorXd correlation() const;
};

/// @param lags  largest lag [samples]; cut to the length of the series
Autocovariance autocovariance(const GriddedSeries& series, int lags);

/// Autocorrelation for a plot: pooled over the series of a trial (trial < 0: of all), lags 0 ... `lags`.
Autocovariance pooled_autocovariance(const Eigen::VectorXd& r, const ResidualLayout& layout, int lags, int trial = -1);

/// Bartlett's variance inflation of sum r(t) s(t) of two independent stationary series: 1 + 2 sum_k w(k) rho_r(k)
/// rho_s(k).
///
/// w is the triangular window up to a third of the series. Pooled over series, each with the weight of the energy of s
/// and of the variance of r in it. Never below 1. Source: Bartlett 1935, J. Roy. Stat. Soc. 98, 536.
double variance_inflation(const Eigen::VectorXd& r, const Eigen::VectorXd& s, const ResidualLayout& layout);
double variance_inflation(const GriddedSeries& r, const GriddedSeries& s);

/// Effective number of samples of a residual: sum over series of n / (1 + 2 sum_k w(k) rho(k)^2), with what chance adds
/// to the squares taken off. So many independent samples know as much of a signal that is coloured like the residual
/// itself. Between 1 per series and N.
double effective_samples(const Eigen::VectorXd& r, const ResidualLayout& layout);

}  // namespace myo::statistics
