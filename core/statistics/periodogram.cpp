#include "statistics/periodogram.hpp"

#include <unsupported/Eigen/FFT>

#include <cmath>
#include <complex>

namespace myo::statistics {
namespace {

Eigen::VectorXcd transform(const Eigen::VectorXd& values) {
    Eigen::FFT<double> fft;
    Eigen::VectorXcd result;
    fft.fwd(result, values);
    return result;
}

Eigen::Index frequencies_of(Eigen::Index length) { return (length + 1) / 2; }

}  // namespace

Eigen::VectorXd energy_shares(const GriddedSeries& series) {
    const Eigen::Index length = series.values.size();
    Eigen::VectorXd shares = Eigen::VectorXd::Zero(frequencies_of(length));
    const double energy = series.values.squaredNorm();
    if (!(energy > 0.0)) return shares;
    const double n = series.seen.sum();
    shares(0) = std::pow(series.values.sum(), 2) / (n * energy);
    if (length < 3) return shares;
    const Eigen::VectorXcd of_values = transform(series.values);
    const Eigen::VectorXcd of_seen = transform(series.seen);
    for (Eigen::Index k = 1; k < shares.size(); ++k) {
        // Normal equations of a cos + b sin over the seen samples. The sums of cos^2, sin^2 and sin cos follow from the
        // transform of the mask at 2 k.
        const std::complex<double> twice = of_seen(2 * k % length);
        const double c = of_values(k).real(), s = -of_values(k).imag();
        const double cc = 0.5 * (n + twice.real()), ss = 0.5 * (n - twice.real()), cs = -0.5 * twice.imag();
        const double determinant = cc * ss - cs * cs;
        // Near-singular: the gaps make cosine and sine indistinguishable at this frequency.
        if (determinant > 1e-9 * n * n)
            shares(k) = (c * c * ss - 2.0 * c * s * cs + s * s * cc) / (determinant * energy);
    }
    return shares;
}

Spectrum mean_spectrum(const Eigen::VectorXd& r, const ResidualLayout& layout, int trial) {
    Spectrum spectrum;
    const GriddedTrial grid = gridded_trial(r, layout, trial);
    const Eigen::Index length = grid.values.cols();
    if (length < 3) return spectrum;
    // L samples last L sample intervals, one more than between the first and the last sample.
    const double duration = (grid.time_s(length - 1) - grid.time_s(0)) * static_cast<double>(length) /
                            static_cast<double>(length - 1);
    const Eigen::Index count = frequencies_of(length);
    spectrum.frequency_Hz = Eigen::VectorXd::LinSpaced(count, 0.0, static_cast<double>(count - 1) / duration);
    spectrum.power.setZero(count);
    double samples = 0.0;
    for (std::size_t row = 0; row < grid.series.size(); ++row) {
        spectrum.power += transform(grid.values.row(static_cast<Eigen::Index>(row))).head(count).cwiseAbs2();
        samples += static_cast<double>(layout.series[static_cast<std::size_t>(grid.series[row])].size());
    }
    spectrum.power /= samples;
    return spectrum;
}

}  // namespace myo::statistics
