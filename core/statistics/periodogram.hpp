#pragma once

#include <Eigen/Core>

#include "statistics/residual_layout.hpp"

namespace myo::statistics {

/// Share of a series' energy that a sinusoid of each frequency takes away, fitted by least squares (Lomb-Scargle
/// without removing the mean). Entry 0 is the constant. Without gaps the entries are the periodogram over its sum.
/// @return  frequencies k / T, k = 0 ... ceil(T / 2) - 1 (below Nyquist's); zeros for a series that is all zero
/// Under white Gaussian noise of n samples P(share > x) = (1 - x)^((n - 2) / 2) for k > 0, with gaps too.
/// Source: Scargle 1982, Astrophys. J. 263, 835.
Eigen::VectorXd energy_shares(const GriddedSeries& series);

/// Mean power over the series of a trial, for a plot.
struct Spectrum {
    Eigen::VectorXd frequency_Hz;
    Eigen::VectorXd power;  // in units of white noise of variance 1, for which its expectation is 1 everywhere
};
Spectrum mean_spectrum(const Eigen::VectorXd& r, const ResidualLayout& layout, int trial);

}  // namespace myo::statistics
