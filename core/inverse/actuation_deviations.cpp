#include "inverse/actuation_deviations.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "base/decompositions.hpp"
#include "base/stopwatch.hpp"
#include "base/text.hpp"
#include "measurement/rigid_motion.hpp"
#include "sensitivity/tangent_run.hpp"

namespace myo::inverse {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Schur complement: information about the values alone, after eliminating the last six parameters. These are the
/// placement, with a prior that is uniform within its bounds.
MatrixXd without_placement(const MatrixXd& information, const PlacementBounds& bounds, double noise_m) {
    const Index n = information.rows() - 6;
    MatrixXd placement = information.bottomRightCorner(6, 6);
    // Variance of a uniform distribution over [-b, b].
    const double translation = bounds.translation_m * bounds.translation_m / 3.0,
                 rotation = bounds.rotation_rad * bounds.rotation_rad / 3.0;
    for (Index i = 0; i < 6; ++i)
        placement(i, i) += noise_m * noise_m / std::max(i < 3 ? translation : rotation, 1e-300);
    return information.topLeftCorner(n, n) -
           information.topRightCorner(n, 6) * placement.ldlt().solve(information.bottomLeftCorner(6, n));
}

/// J'J over the compared coordinates, by the values over their scales, and the sum of squared residuals.
struct NormalEquations {
    MatrixXd information;
    double squares = 0.0;
    double count = 0.0;
};

NormalEquations normal_equations(const ActuationProblem& problem, const sensitivity::SensitiveTrace& run) {
    const SensitiveResiduals seen = target_residuals(problem.target, run);
    const std::size_t count = seen.tangents.size();
    const Index columns = static_cast<Index>(count) + (problem.placement_bounds ? 6 : 0);
    const MarkerPlacement& placement = problem.target.placement;
    const Eigen::Matrix3d back = measurement::small_rotation(-placement.rotation_rad);
    const VectorXd scales = signal_scales(problem.sought);
    NormalEquations equations{MatrixXd::Zero(columns, columns)};
    for (std::size_t m = 0; m < seen.residuals_m.size(); ++m) {
        const Matrix3Xd& residual = seen.residuals_m[m];
        std::vector<Index> compared;
        for (Index k = 0; k < residual.size(); ++k)
            if (std::isfinite(residual(k))) compared.push_back(k);
        MatrixXd J(static_cast<Index>(compared.size()), columns);
        for (std::size_t p = 0; p < count; ++p)
            J.col(static_cast<Index>(p)) = scales(static_cast<Index>(p) % scales.size()) *
                                           seen.tangents[p][m].reshaped()(compared);
        for (Index row = 0; problem.placement_bounds && row < J.rows(); ++row) {
            const Index k = compared[static_cast<std::size_t>(row)];
            const Eigen::Vector3d placed = residual.col(k / 3) + problem.target.positions_m[m].col(k / 3);
            J.row(row).tail<6>() = placement_tangent(placement, back * (placed - placement.translation_m)).row(k % 3);
        }
        equations.information += J.transpose() * J;
        equations.squares += residual.reshaped()(compared).squaredNorm();
        equations.count += static_cast<double>(compared.size());
    }
    return equations;
}

/// Pseudo-inverse of the normal equations.
struct Weighing {
    MatrixXd inverse;          // over the determined directions
    Eigen::ArrayX<bool> open;  // values with a component along an undetermined direction
};

Weighing weigh(const MatrixXd& precision) {
    const Index n = precision.rows();
    const SymmetricEigen eigen = symmetric_eigen(precision);
    const double least = actuation_deviations_policy.not_seen * eigen.values(n - 1);
    Weighing weighed{MatrixXd::Zero(n, n), {}};
    VectorXd share = VectorXd::Zero(n);
    for (Index i = 0; i < n; ++i) {
        const VectorXd v = eigen.vectors.col(i);
        if (eigen.values(i) > least)
            weighed.inverse += v * v.transpose() / eigen.values(i);
        else
            share += v.cwiseAbs2();
    }
    weighed.open = share.array() > 1e-6;
    return weighed;
}

/// Warnings: values determined less by the target than by the smoothness, values not determined at all, and pairs of
/// signals that can replace each other.
std::vector<std::string> undetermined_words(const SoughtSignals& sought, const Weighing& weighed,
                                            const ActuationDeviations& found) {
    std::vector<std::string> warnings;
    const Index signals = found.deviations.rows(), knots = found.deviations.cols();
    const auto of_all = [&](Index count) { return std::to_string(count) + " of " + std::to_string(knots) + " values"; };
    for (Index s = 0; s < signals; ++s) {
        const SoughtSignal& signal = sought.signals[static_cast<std::size_t>(s)];
        Index unknown = 0, smooth = 0;
        for (Index k = 0; k < knots; ++k) {
            if (weighed.open(k * signals + s))
                ++unknown;
            else if (found.from_target(s, k) < actuation_deviations_policy.measured_share)
                ++smooth;
        }
        const Index wide = (found.deviations.row(s).array() > 0.5 * (signal.upper - signal.lower)).count();
        if (unknown > 0)
            warnings.push_back("signal " + signal.name + ": the markers do not determine " + of_all(unknown));
        if (smooth > 0)
            warnings.push_back(
                "signal " + signal.name + ": " + of_all(smooth) +
                " come from the smoothness more than from the markers, so they have no standard deviation");
        if (wide > 0)
            warnings.push_back("signal " + signal.name + ": the markers determine less of " + of_all(wide) +
                               " than the bounds do");
        for (Index other = 0; other < s; ++other) {
            Index alike = 0;
            for (Index k = 0; k < knots; ++k) {
                const double correlation = std::abs(found.correlation(k * signals + s, k * signals + other));
                // Values with little information come from the smoothness, which does not correlate different signals:
                // a lower correlation is significant there.
                const bool told_badly = std::min(found.from_target(s, k), found.from_target(other, k)) < 0.75;
                alike += correlation > (told_badly ? 0.95 : 0.999) ? 1 : 0;
            }
            if (2 * alike > knots)
                warnings.push_back("signals " + sought.signals[static_cast<std::size_t>(other)].name + " and " +
                                   signal.name + ": these markers cannot separate them at " + std::to_string(alike) +
                                   " of " + std::to_string(knots) + " times");
        }
    }
    return warnings;
}

/// Largest rate of each signal, over its scale, over the knots that the target measures [1/s]. A rate counts as
/// measured by the smaller information of its two ends.
VectorXd own_rates(const SoughtSignals& sought, const MatrixXd& values, const VectorXd& from_target,
                   const MatrixXd& D) {
    const Index signals = values.rows();
    // Rates are affine in the values and vanish if all values equal `before`.
    VectorXd before(values.size());
    for (Index i = 0; i < before.size(); ++i) before(i) = sought.signals[static_cast<std::size_t>(i % signals)].before;
    const VectorXd scales = signal_scales(sought).replicate(values.cols(), 1);
    const VectorXd rates = D * (values.reshaped() - before).cwiseQuotient(scales);
    VectorXd largest = VectorXd::Zero(signals);
    for (Index r = 0; r < rates.size(); ++r) {
        double seen = 1.0;
        for (Index i = 0; i < D.cols(); ++i)
            if (D(r, i) != 0.0) seen = std::min(seen, from_target(i));
        if (seen >= actuation_deviations_policy.measured_share)
            largest(r % signals) = std::max(largest(r % signals), std::abs(rates(r)));
    }
    return largest;
}

/// Standard deviations of an estimate whose loss contains the smoothness: effect of the noise, and possible bias.
///
/// With the parts A (target) and P = w D'D (smoothness) of the normal equations, the estimate is (A + P)^-1 A times the
/// truth plus noise. The noise gives the covariance sigma^2 (A + P)^-1 A (A + P)^-1. The true rates D a give a bias of
/// (A + P)^-1 w D' (D a), bounded by the sum of the absolute entries of a row times the largest rate. Interpreting the
/// smoothness as prior information about the rates would imply a prior of sigma / sqrt(w), which becomes tighter with
/// every marker; with this interpretation values in a gap were up to 13 of their deviations off.
void set_deviations(const ActuationProblem& problem, const NormalEquations& equations, const MatrixXd& values,
                    double noise_m, ActuationDeviations& found) {
    const Index n = equations.information.rows(), rows = values.rows(), columns = values.cols();
    const MatrixXd D = rate_matrix(problem.sought, columns);
    const double count = static_cast<double>(std::max<Index>(1, D.rows()));
    const double w = equations.count * problem.smoothness_m_s * problem.smoothness_m_s / count;
    const Weighing weighed = weigh(equations.information + w * D.transpose() * D);
    const MatrixXd& inverse = weighed.inverse;
    const MatrixXd resolution = inverse * equations.information;
    const double freedom = std::max(1.0, equations.count - resolution.trace());
    found.noise_m = std::max(noise_m, std::sqrt(equations.squares / freedom));
    const VectorXd posterior = inverse.diagonal().cwiseMax(0.0).cwiseSqrt();
    found.correlation = MatrixXd::Identity(n, n);
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < i; ++j) {
            const double product = posterior(i) * posterior(j);
            if (product > 0.0) found.correlation(i, j) = found.correlation(j, i) = inverse(i, j) / product;
        }
    const VectorXd from_target = resolution.diagonal().cwiseMax(0.0).cwiseMin(1.0);
    const VectorXd by_noise = found.noise_m * (resolution * inverse).diagonal().cwiseMax(0.0).cwiseSqrt();
    const VectorXd rates = own_rates(problem.sought, values, from_target, D);
    const VectorXd hidden = (w * inverse * D.transpose()).cwiseAbs() * rates.replicate(D.rows() / rows, 1);
    VectorXd deviation = (by_noise.cwiseAbs2() + hidden.cwiseAbs2()).cwiseSqrt();
    for (Index i = 0; i < n; ++i)
        if (weighed.open(i) || !(deviation(i) > 0.0) || from_target(i) < actuation_deviations_policy.measured_share)
            deviation(i) = std::numeric_limits<double>::quiet_NaN();
    found.deviations = signal_scales(problem.sought).asDiagonal() * deviation.reshaped(rows, columns);
    found.from_target = from_target.reshaped(rows, columns);
    found.found = true;
    found.warnings = undetermined_words(problem.sought, weighed, found);
}

}  // namespace

ActuationDeviations actuation_deviations(const ActuationProblem& problem, const MatrixXd& values, double noise_m,
                                         const Progress& progress) {
    assert(values.size() > 0 && noise_m >= 0.0);
    const Stopwatch watch;
    ActuationDeviations result;
    if (values.size() > actuation_deviations_policy.max_deviations) {
        result.reason = "not looked for: " + std::to_string(values.size()) + " values are more than " +
                        std::to_string(actuation_deviations_policy.max_deviations);
        return result;
    }
    const model::Model model = driven_model(problem.model, acting_commands(problem.sought, problem.acting, values));
    const sensitivity::SensitiveTrace run = sensitivity::simulate_with_tangents(
        model, problem.options, value_tangents(problem.sought, problem.acting, values, model),
        problem.target.markers.nodes, progress);
    if (!run.trace.complete()) {
        result.reason = run.trace.status == dynamics::RunStatus::cancelled ? "not found: stopped by the user"
                                                                           : "not found: " + run.trace.message;
        return result;
    }
    NormalEquations equations = normal_equations(problem, run);
    if (problem.placement_bounds)
        equations.information = without_placement(equations.information, *problem.placement_bounds, noise_m);
    set_deviations(problem, equations, values, noise_m, result);
    result.seconds = watch.seconds();
    return result;
}

}  // namespace myo::inverse
