#pragma once

#include <Eigen/Core>

#include <vector>

#include "statistics/residual_layout.hpp"

namespace myo::statistics {

// Tests of a residual against white noise of variance 1: variance, autocorrelation and spatial pattern.

/// Chi-squared test of |r|^2.
struct VarianceTest {
    double ratio = 0.0;    // |r|^2 / (N - p)
    double freedom = 0.0;  // N - p
    double p = 1.0;        // for noise of (1 + tolerance) times the stated standard deviation
};
/// Variance test.
/// @param parameters  number fitted to the data
/// @param tolerance   relative error of the stated noise that does not count as misfit
VarianceTest variance_test(const Eigen::VectorXd& r, int parameters, double tolerance);

/// Ljung-Box test of autocorrelation over the first lags, summed over series. Independent of the noise variance.
struct LjungBoxTest {
    double statistic = 0.0;  // sum over series and lags
    double lags = 0.0;       // tested lags of all series: expectation of the statistic for Gaussian white noise
    double p = 1.0;
};
/// On short series the chi^2 distribution is too narrow. Mean and variance of the statistic come from random sign
/// flips, and a gamma distribution with these moments gives the tail. Valid for independent symmetric noise of any
/// distribution, also if its variance changes in time.
/// @param lags   largest lag per series, at most a quarter of its samples
/// @param draws  number of sign flips; `seed` fixes them
/// Source: Ljung & Box 1978, Biometrika 65, 297, about zero and with the pairs that gaps leave.
LjungBoxTest ljung_box_test(const Eigen::VectorXd& r, const ResidualLayout& layout, int lags, int draws = 199,
                            unsigned seed = 1);

/// Test for one dominant frequency; Bonferroni over frequencies and series. Independent of the noise variance.
struct PeriodicityTest {
    double share = 0.0;         // of the energy of the series
    int series = -1;            // index into the layout; -1: all series are too short
    double frequency_Hz = 0.0;  // 0: a constant
    double p = 1.0;
};
/// Periodicity test of all series.
/// Source: Fisher 1929, Proc. Roy. Soc. A 125, 54; first term of the series, an upper bound of the p-value.
PeriodicityTest periodicity_test(const Eigen::VectorXd& r, const ResidualLayout& layout);

/// Test for a spatial pattern: largest singular value of the (series x samples) matrix of each trial, compared with
/// random sign flips of the entries.
struct SpaceTest {
    /// Result of one trial.
    struct Trial {
        int trial = 0;
        double share = 0.0;           // of the trial's energy in the first singular mode
        double expected_share = 0.0;  // mean over random sign flips
        double p = 1.0;
        std::vector<int> series;  // rows: indices into the layout
        Eigen::VectorXd pattern;  // per row: first left singular vector, length 1, largest entry positive
    };
    std::vector<Trial> trials;
    double p = 1.0;  // Bonferroni over trials
};
/// Spatial test of all trials.
///
/// The null distribution is a shifted gamma with mean, deviation and skewness of the draws; the skewness is at least
/// that of the Tracy-Widom law. p-values below 1 / draws are thus possible.
/// Source: Chiani 2014, J. Multivariate Analysis 129, 69 (gamma approximation).
SpaceTest space_test(const Eigen::VectorXd& r, const ResidualLayout& layout, int draws = 199, unsigned seed = 1);

/// Root mean square of the part of the residual that is not white noise.
struct SystematicRms {
    double rms = 0.0;                    // in units of the noise; 0 if mean_square is negative
    double deviation = 0.0;              // standard deviation of rms
    double mean_square = 0.0;            // unbiased estimate; may be negative
    double mean_square_deviation = 0.0;  // standard deviation of mean_square
};
/// Extrapolates the autocovariance at lags 1 and 2 to lag 0 by an even parabola. White noise drops out regardless of
/// its variance; components slow compared with two samples remain. Components faster than about a tenth of the frame
/// rate are underestimated.
///
/// Series of a single sample, such as the mean measurement of a pose at rest, have no lags: their mean square beyond
/// that of the stated noise counts. Both estimates are weighted by their entries.
SystematicRms systematic_rms(const Eigen::VectorXd& r, const ResidualLayout& layout);

/// Settings of test_residuals().
struct ResidualTestOptions {
    double alpha = 0.01;            // family-wise false-alarm rate of the four p-values
    double noise_tolerance = 0.05;  // relative error of the stated noise
    int lags = 20;                  // largest lag of the Ljung-Box test
    int draws = 199;                // sign flips per null distribution
    unsigned seed = 1;              // of the sign flips
};

/// All residual tests of one fit.
struct ResidualTests {
    Eigen::Index samples = 0;  // N
    VarianceTest variance;
    LjungBoxTest ljung_box;
    PeriodicityTest periodicity;
    SpaceTest space;
    SystematicRms systematic;
    double alpha = 0.0;      // family-wise level
    double threshold = 0.0;  // level of each p-value: alpha / 4 (Bonferroni)

    /// Variance larger than the stated noise.
    bool variance_fired() const { return variance.p < threshold; }
    /// Autocorrelation or a dominant frequency.
    bool colour_fired() const { return ljung_box.p < threshold || periodicity.p < threshold; }
    /// A spatial pattern.
    bool space_fired() const { return space.p < threshold; }
    /// Any of the tests rejects white noise.
    bool significant() const { return variance_fired() || colour_fired() || space_fired(); }
};

/// Runs all tests. An empty residual is not significant.
///
/// @param r           N, see ResidualLayout
/// @param parameters  number fitted to the data
ResidualTests test_residuals(const Eigen::VectorXd& r, const ResidualLayout& layout, int parameters,
                             const ResidualTestOptions& options = {});

}  // namespace myo::statistics
