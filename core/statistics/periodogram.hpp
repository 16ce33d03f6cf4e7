#pragma once

#include <Eigen/Core>

#include "statistics/residual_layout.hpp"

namespace myo::statistics {

/// Lomb-Scargle periodogram without removal of the mean: share of the energy that a least-squares sinusoid of each
/// frequency explains. Entry 0 is the constant. Without gaps the entries are the periodogram over its sum.
///
/// For white Gaussian noise of n samples, P(share > x) = (1 - x)^((n - 2) / 2) for k > 0, with or without gaps.
///
/// @return  frequencies k / T, k = 0 ... ceil(T / 2) - 1 (below the Nyquist frequency); zeros for a zero series
/// Source: Scargle 1982, Astrophys. J. 263, 835.
Eigen::VectorXd energy_shares(const GriddedSeries& series);

/// Power spectrum averaged over the series of a trial, for plots.
struct Spectrum {
    Eigen::VectorXd frequency_Hz;  // 0 to below the Nyquist frequency
    Eigen::VectorXd power;         // relative to white noise of variance 1, whose expectation is 1 at all frequencies
};
/// Mean spectrum of one trial. Empty for fewer than three samples.
Spectrum mean_spectrum(const Eigen::VectorXd& r, const ResidualLayout& layout, int trial);

}  // namespace myo::statistics
