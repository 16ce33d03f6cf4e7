#include "inverse/actuation_deviations.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "base/decompositions.hpp"
#include "base/stopwatch.hpp"
#include "base/text.hpp"
#include "sensitivity/tangent_run.hpp"

namespace myo {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Below this share of the largest eigenvalue a direction is not seen.
constexpr double not_seen = 1e-12;

/// The activations are linear in the values: d activation / d value, per value (signals running fastest).
std::vector<ModelTangent> value_tangents(const SoughtSignals& sought, const MatrixXd& values) {
    std::vector<ModelTangent> tangents;
    const MatrixXd none = MatrixXd::Zero(values.rows(), values.cols());
    const std::vector<Signal> zero = activations_of(sought, none);
    for (Index i = 0; i < values.size(); ++i) {
        MatrixXd unit = none;
        unit(i) = 1.0;
        ModelTangent tangent;
        tangent.activation = activations_of(sought, unit);
        for (std::size_t g = 0; g < zero.size(); ++g)
            for (std::size_t k = 0; k < zero[g].values.size(); ++k) tangent.activation[g].values[k] -= zero[g].values[k];
        tangents.push_back(std::move(tangent));
    }
    return tangents;
}

/// The prior: half the Hessian of the mean square rate, which is quadratic; its gradient's columns, the constant part taken off.
MatrixXd half_rate_hessian(const SoughtSignals& sought, const MatrixXd& values) {
    const MatrixXd none = MatrixXd::Zero(values.rows(), values.cols());
    MatrixXd constant = none, S(values.size(), values.size());
    mean_square_rate(sought, none, 1.0, constant);
    for (Index i = 0; i < values.size(); ++i) {
        MatrixXd unit = none, gradient = none;
        unit(i) = 1.0;
        mean_square_rate(sought, unit, 1.0, gradient);
        S.col(i) = 0.5 * (gradient - constant).reshaped();
    }
    return S;
}

/// J'J of the compared coordinates, and the sum of their squared residuals.
struct NormalEquations {
    MatrixXd information;
    double squares = 0.0;
    double count = 0.0;
};

NormalEquations normal_equations(const ActuationProblem& problem, const SensitiveTrace& run) {
    const SensitiveResiduals seen = target_residuals(problem.target, run);
    const std::size_t count = seen.tangents.size();
    NormalEquations equations{MatrixXd::Zero(static_cast<Index>(count), static_cast<Index>(count))};
    for (std::size_t m = 0; m < seen.residuals_m.size(); ++m) {
        const Matrix3Xd& residual = seen.residuals_m[m];
        std::vector<Index> compared;
        for (Index k = 0; k < residual.size(); ++k)
            if (std::isfinite(residual(k))) compared.push_back(k);
        MatrixXd J(static_cast<Index>(compared.size()), static_cast<Index>(count));
        for (std::size_t p = 0; p < count; ++p) J.col(static_cast<Index>(p)) = seen.tangents[p][m].reshaped()(compared);
        equations.information += J.transpose() * J;
        equations.squares += residual.reshaped()(compared).squaredNorm();
        equations.count += static_cast<double>(compared.size());
    }
    return equations;
}

/// Values that the smoothness says more about than the target, values that nothing says anything about, and pairs of signals that
/// take each other's place.
std::vector<std::string> identifiability(const SoughtSignals& sought, const ActuationDeviations& found) {
    std::vector<std::string> warnings;
    const Index signals = found.deviations.rows(), knots = found.deviations.cols();
    const auto of_all = [&](Index count) { return std::to_string(count) + " of " + std::to_string(knots) + " values "; };
    for (Index s = 0; s < signals; ++s) {
        const SoughtSignal& signal = sought.signals[static_cast<std::size_t>(s)];
        const Index unknown = knots - found.deviations.row(s).array().isFinite().count();
        const Index smooth = (found.deviations.row(s).array().isFinite() && found.from_target.row(s).array() < 0.5).count();
        const Index wide = (found.deviations.row(s).array() > 0.5 * (signal.upper - signal.lower)).count();
        if (unknown > 0) warnings.push_back("signal " + signal.name + ": the markers do not determine " + std::to_string(unknown) + " of " + std::to_string(knots) + " values");
        if (smooth > 0) warnings.push_back("signal " + signal.name + ": " + of_all(smooth) + "come from the smoothness more than from the markers");
        if (wide > 0) warnings.push_back("signal " + signal.name + ": the markers tell less of " + of_all(wide) + "than the bounds do");
        for (Index other = 0; other < s; ++other) {
            Index alike = 0;
            for (Index k = 0; k < knots; ++k) {
                const double correlation = std::abs(found.correlation(k * signals + s, k * signals + other));
                // Markers that say little of a value leave it to the smoothness, which ties nothing between signals.
                const bool told_badly = std::min(found.from_target(s, k), found.from_target(other, k)) < 0.75;
                alike += correlation > (told_badly ? 0.95 : 0.999) ? 1 : 0;
            }
            if (2 * alike > knots)
                warnings.push_back("signals " + sought.signals[static_cast<std::size_t>(other)].name + " and " + signal.name +
                                   ": these markers cannot tell them apart at " + std::to_string(alike) + " of " + std::to_string(knots) + " times");
        }
    }
    return warnings;
}

void set_deviations(const ActuationProblem& problem, const NormalEquations& equations, double noise_m, ActuationDeviations& found) {
    const Index n = equations.information.rows(), rows = found.deviations.rows(), columns = found.deviations.cols();
    const double weight = equations.count * problem.smoothness_m_s * problem.smoothness_m_s;
    const MatrixXd precision = equations.information + weight * half_rate_hessian(problem.sought, found.deviations);
    const SymmetricEigen eigen = symmetric_eigen(precision);
    const double least = not_seen * eigen.values(n - 1);
    // What a direction that nothing sees leaves open, it leaves open in all values that it moves.
    MatrixXd inverse = MatrixXd::Zero(n, n);
    VectorXd open = VectorXd::Zero(n);
    for (Index i = 0; i < n; ++i) {
        const VectorXd v = eigen.vectors.col(i);
        if (eigen.values(i) > least) inverse += v * v.transpose() / eigen.values(i);
        else open += v.cwiseAbs2();
    }
    const MatrixXd resolution = inverse * equations.information;
    const double freedom = std::max(1.0, equations.count - resolution.trace());
    found.noise_m = std::max(noise_m, std::sqrt(equations.squares / freedom));
    VectorXd deviation = found.noise_m * inverse.diagonal().cwiseMax(0.0).cwiseSqrt();
    found.correlation = MatrixXd::Identity(n, n);
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < i; ++j) {
            const double product = deviation(i) * deviation(j);
            if (product > 0.0) found.correlation(i, j) = found.correlation(j, i) = found.noise_m * found.noise_m * inverse(i, j) / product;
        }
    for (Index i = 0; i < n; ++i)
        if (open(i) > 1e-6 || !(deviation(i) > 0.0)) deviation(i) = std::numeric_limits<double>::quiet_NaN();
    found.deviations = deviation.reshaped(rows, columns);
    found.from_target = resolution.diagonal().cwiseMax(0.0).cwiseMin(1.0).reshaped(rows, columns);
    found.found = true;
}

}  // namespace

ActuationDeviations actuation_deviations(const ActuationProblem& problem, const MatrixXd& values, double noise_m, const Progress& progress) {
    assert(values.size() > 0 && noise_m >= 0.0);
    const Stopwatch watch;
    ActuationDeviations result;
    if (values.size() > most_deviations) {
        result.reason = "not looked for: " + std::to_string(values.size()) + " values are more than " + std::to_string(most_deviations);
        return result;
    }
    Model model = problem.model;
    model.activation = activations_of(problem.sought, values);
    const SensitiveTrace run = simulate_with_tangents(model, problem.options, value_tangents(problem.sought, values), problem.target.markers.nodes, progress);
    if (!run.trace.complete()) {
        result.reason = run.trace.status == RunStatus::cancelled ? "not found: stopped by the user" : "not found: " + run.trace.message;
        return result;
    }
    result.deviations = MatrixXd::Zero(values.rows(), values.cols());
    set_deviations(problem, normal_equations(problem, run), noise_m, result);
    result.warnings = identifiability(problem.sought, result);
    result.seconds = watch.seconds();
    return result;
}

}  // namespace myo
