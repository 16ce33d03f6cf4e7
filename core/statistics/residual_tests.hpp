#pragma once

#include <Eigen/Core>

#include <vector>

#include "statistics/residual_layout.hpp"

namespace myo::statistics {

/// Is there more in a residual than white noise of variance 1? Three independent signs.

/// chi^2 of |r|^2.
struct VarianceTest {
    double ratio = 0.0;    // |r|^2 / (N - p)
    double freedom = 0.0;  // N - p
    double p = 1.0;        // chance of more, for noise (1 + tolerance) times the stated one
};
/// @param parameters  number that were fitted to the data
/// @param tolerance   relative error of the stated noise that shall not count as misfit
VarianceTest variance_test(const Eigen::VectorXd& r, int parameters, double tolerance);

/// Colour: Ljung-Box over the first lags, summed over series. Independent of the noise's variance.
struct LjungBoxTest {
    double statistic = 0.0;
    double lags = 0.0;  // tested, all series together: expectation for Gaussian white noise
    double p = 1.0;
};
/// chi^2 is too narrow for it on short series; random signs of the entries give mean and variance, and a gamma
/// distribution through them the tail. Holds for noise of any size and shape that is symmetric, and may vary in time.
/// @param lags  per series, at most a quarter of its samples
/// Source: Ljung & Box 1978, Biometrika 65, 297, about zero and with the pairs that gaps leave.
LjungBoxTest ljung_box_test(const Eigen::VectorXd& r, const ResidualLayout& layout, int lags, int draws = 199,
                            unsigned seed = 1);

/// Colour: the largest share of one frequency, Bonferroni over frequencies and series. Independent of the noise's
/// variance.
struct PeriodicityTest {
    double share = 0.0;         // of the energy of the series
    int series = -1;            // index into the layout; -1: none is long enough
    double frequency_Hz = 0.0;  // 0: a constant
    double p = 1.0;
};
/// Source: Fisher 1929, Proc. Roy. Soc. A 125, 54; its first term, which bounds the p-value from above.
PeriodicityTest periodicity_test(const Eigen::VectorXd& r, const ResidualLayout& layout);

/// Space: the largest singular value of the (series x samples) matrix of each trial against random signs of the
/// entries.
struct SpaceTest {
    struct Trial {
        int trial = 0;
        double share = 0.0;           // of the trial's energy in the first pattern
        double expected_share = 0.0;  // mean over random signs
        double p = 1.0;
        std::vector<int> series;  // indices into the layout
        Eigen::VectorXd pattern;  // per series, length 1, largest entry positive
    };
    std::vector<Trial> trials;
    double p = 1.0;  // Bonferroni over trials
};
/// The null distribution is a shifted gamma with mean and deviation of the draws and their skewness, at least that of
/// the Tracy-Widom law, so that p goes below one over the number of draws. Source: Chiani 2014, J. Multivariate
/// Analysis 129, 69 (the gamma).
SpaceTest space_test(const Eigen::VectorXd& r, const ResidualLayout& layout, int draws = 199, unsigned seed = 1);

/// Root mean square of what is not white noise.
struct SystematicRms {
    double rms = 0.0;          // in units of the noise; 0 when the estimate of the square is negative
    double deviation = 0.0;    // of the rms
    double mean_square = 0.0;  // may be negative
    double mean_square_deviation = 0.0;
};
/// Autocovariance at lags 1 and 2, extrapolated to 0 as an even parabola: white noise drops out, whatever its variance,
/// and what changes slowly against two samples stays. Motion faster than about a tenth of the frame rate is seen too
/// small.
SystematicRms systematic_rms(const Eigen::VectorXd& r, const ResidualLayout& layout);

struct ResidualTestOptions {
    double alpha = 0.01;            // false-alarm rate of the family of all four p-values
    double noise_tolerance = 0.05;  // relative error of the stated noise
    int lags = 20;
    int draws = 199;
    unsigned seed = 1;
};

struct ResidualTests {
    Eigen::Index samples = 0;
    VarianceTest variance;
    LjungBoxTest ljung_box;
    PeriodicityTest periodicity;
    SpaceTest space;
    SystematicRms systematic;
    double alpha = 0.0;
    double threshold = 0.0;  // of each p: alpha / 4

    bool variance_fired() const { return variance.p < threshold; }
    bool colour_fired() const { return ljung_box.p < threshold || periodicity.p < threshold; }
    bool space_fired() const { return space.p < threshold; }
    bool significant() const { return variance_fired() || colour_fired() || space_fired(); }
};

/// All of them. An empty residual is not significant.
/// @param r           N, see ResidualLayout
/// @param parameters  number that were fitted to the data
ResidualTests test_residuals(const Eigen::VectorXd& r, const ResidualLayout& layout, int parameters,
                             const ResidualTestOptions& options = {});

}  // namespace myo::statistics
