#include "inverse/damped_cosine.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cassert>
#include <complex>

#include "inverse/least_squares.hpp"

namespace myo::inverse {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Basis functions exp(-rate t) (cos, sin) and 1, multiplied by the amplitudes and the offset.
MatrixXd basis(const VectorXd& t, double rate, double omega) {
    const Eigen::ArrayXd decay = (-rate * t.array()).exp();
    MatrixXd B(t.size(), 3);
    B.col(0) = decay * (omega * t.array()).cos();
    B.col(1) = decay * (omega * t.array()).sin();
    B.col(2).setOnes();
    return B;
}

/// Exponent of the recurrence y(n + k) = a y(n) + b y(n - k) + c. Samples a fortieth of a second apart determine a
/// vibration of some hertz best.
std::complex<double> recurrence_exponent(const VectorXd& t, const VectorXd& y) {
    const double h = (t(t.size() - 1) - t(0)) / static_cast<double>(t.size() - 1);
    const Eigen::Index k = std::clamp<Eigen::Index>(std::lround(0.025 / h), 1, std::max<Eigen::Index>(1, t.size() / 6));
    const Eigen::Index n = y.size() - 2 * k;
    MatrixXd A(n, 3);
    A << y.segment(k, n), y.head(n), VectorXd::Ones(n);
    const Eigen::Vector3d c = A.colPivHouseholderQr().solve(y.tail(n));
    // Root z of z² = a z + b; z = exp(s k h) for the exponent s.
    const std::complex<double> z = 0.5 * (c(0) + std::sqrt(std::complex<double>(c(0) * c(0) + 4.0 * c(1))));
    return std::log(z) / (static_cast<double>(k) * h);
}

}  // namespace

DampedCosine fit_damped_cosine(const VectorXd& times_s, const VectorXd& values) {
    assert(times_s.size() == values.size() && times_s.size() >= 8);
    DampedCosine result;
    const VectorXd t = times_s.array() - times_s(0);
    const std::complex<double> s = recurrence_exponent(t, values);
    if (!std::isfinite(s.real()) || std::abs(s.imag()) < 1e-9) return result;
    const Eigen::Vector3d start = basis(t, -s.real(), std::abs(s.imag())).colPivHouseholderQr().solve(values);
    const double size = std::max(start.head<2>().norm(), 1e-12);
    const std::vector<Parameter> parameters{{.name = "rate", .value = -s.real(), .scale = 1.0},
                                            {.name = "omega", .value = std::abs(s.imag()), .scale = 1.0},
                                            {.name = "cos", .value = start(0) / size},
                                            {.name = "sin", .value = start(1) / size},
                                            {.name = "offset", .value = start(2) / size}};
    // Amplitudes and offset relative to the initial amplitude: all unknowns are of order 1.
    const auto residuals = [&](const VectorXd& p, const Progress&) {
        const MatrixXd B = basis(t, p(0), p(1));
        ResidualEvaluation evaluation{
            .ok = true, .message = {}, .residuals = B * p.tail(3) - values / size, .jacobian = MatrixXd(t.size(), 5)};
        const VectorXd wave = B.leftCols(2) * p.segment(2, 2);
        evaluation.jacobian << -t.cwiseProduct(wave), t.cwiseProduct(p(3) * B.col(0) - p(2) * B.col(1)), B;
        return evaluation;
    };
    LeastSquaresOptions options;
    options.relative_decrease = 1e-12;
    options.relative_step = 1e-10;
    const LeastSquaresReport fit = fit_least_squares(parameters, residuals, options);
    if (!fit.usable()) return result;
    const VectorXd& p = fit.values;
    result.ok = true;
    result.rate_1_s = p(0);
    result.omega_rad_s = p(1);
    // Amplitude at t = 0 of the caller's time axis.
    result.amplitude = size * std::hypot(p(2), p(3)) * std::exp(p(0) * times_s(0));
    result.offset = size * p(4);
    result.rms = size * std::sqrt(2.0 * fit.cost_after / static_cast<double>(t.size()));
    return result;
}

}  // namespace myo::inverse
