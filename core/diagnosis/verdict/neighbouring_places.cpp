#include "diagnosis/verdict/neighbouring_places.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include "diagnosis/fit/stored_fit.hpp"

namespace myo::diagnosis {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Indices of the components of a fitted place among the parameters of a fit.
using PlaceOfEffect = std::array<std::size_t, 3>;

/// Fitted places on the surface.
std::vector<PlaceOfEffect> fitted_places(const JointFit& fit) {
    std::vector<PlaceOfEffect> places;
    // The components of a vector stand side by side.
    for (std::size_t i = 0; i + 2 < fit.parameters.size(); ++i)
        if (fit.parameters[i].of_effect == "position_m" && fit.parameters[i].component == 0)
            places.push_back({i, i + 1, i + 2});
    return places;
}

/// Position in a fit [m].
Vector3d position_of(const PlaceOfEffect& place, const JointFit& fit, const prediction::ParameterValues& values) {
    Vector3d x;
    for (Index k = 0; k < 3; ++k) x(k) = value_of(fit.parameters[place[static_cast<std::size_t>(k)]], values);
    return x;
}

/// Change of predictions by a place, and of the other parameters that follow it.
struct PlaceSlopes {
    Matrix3d normal;                  // normal matrix after the others have been fitted [noise squares per m^2]
    MatrixXd following;               // others x 3: least-squares change of the others [units per m]
    std::vector<std::size_t> others;  // their indices
};

PlaceSlopes slopes_of(const PlaceOfEffect& place, const JointFit& fit) {
    const MatrixXd J = all_slopes(fit);
    PlaceSlopes slopes;
    for (std::size_t i = 0; i < fit.parameters.size(); ++i)
        if (std::find(place.begin(), place.end(), i) == place.end()) slopes.others.push_back(i);
    MatrixXd of_place(J.rows(), 3), of_others(J.rows(), static_cast<Index>(slopes.others.size()));
    for (Index k = 0; k < 3; ++k) of_place.col(k) = J.col(static_cast<Index>(place[static_cast<std::size_t>(k)]));
    // In units of their scales, so that the rank does not depend on units.
    VectorXd scale(of_others.cols());
    for (Index k = 0; k < of_others.cols(); ++k) {
        const std::size_t i = slopes.others[static_cast<std::size_t>(k)];
        scale(k) = fit.parameters[i].parameter.scale;
        of_others.col(k) = scale(k) * J.col(static_cast<Index>(i));
    }
    const MatrixXd follow = -of_others.completeOrthogonalDecomposition().solve(of_place);
    const MatrixXd left = of_place + of_others * follow;
    slopes.normal = left.transpose() * left;
    slopes.following = scale.asDiagonal() * follow;
    return slopes;
}

/// Values with the place moved and the others following, within the bounds.
prediction::ParameterValues moved(const JointFit& fit, const PlaceOfEffect& place, const PlaceSlopes& slopes,
                                  const Vector3d& step_m) {
    prediction::ParameterValues values = fit.values;
    const auto move = [&](std::size_t i, double change) {
        const prediction::ModelParameter& p = fit.parameters[i];
        set_value(p, std::clamp(value_of(p, fit.values) + change, p.parameter.lower, p.parameter.upper), values);
    };
    const VectorXd follow = slopes.following * step_m;
    for (std::size_t k = 0; k < 3; ++k) move(place[k], step_m(static_cast<Index>(k)));
    for (std::size_t k = 0; k < slopes.others.size(); ++k) move(slopes.others[k], follow(static_cast<Index>(k)));
    return values;
}

/// Places of all effects that were fitted from, so that no fit goes back [m].
using TriedPlaces = std::vector<std::vector<Vector3d>>;

/// Positions of all fitted places [m].
std::vector<Vector3d> positions_of(const JointFit& fit, const prediction::ParameterValues& values) {
    std::vector<Vector3d> positions;
    for (const PlaceOfEffect& place : fitted_places(fit)) positions.push_back(position_of(place, fit, values));
    return positions;
}

/// Whether every place is nearer than `least_m` to that of an earlier fit.
bool is_tried(const std::vector<Vector3d>& positions, const TriedPlaces& tried, double least_m) {
    return std::any_of(tried.begin(), tried.end(), [&](const std::vector<Vector3d>& other) {
        return std::equal(positions.begin(), positions.end(), other.begin(), other.end(),
                          [&](const Vector3d& a, const Vector3d& b) { return (a - b).norm() < least_m; });
    });
}

/// The best of the fits from untried neighbouring places, if it leaves less; empty if none does.
std::optional<JointFit> better_neighbour(const DiagnosisContext& context, const FitData& data, const JointFit& fit,
                                         TriedPlaces& tried, FitStore& store, PhaseLog& log) {
    const PlacePolicy& policy = context.policy().places;
    const double cell_m = context.setup.mesh.resolution_m;
    std::optional<JointFit> best;
    for (const prediction::ParameterValues& start : neighbouring_places(fit, cell_m, policy)) {
        if (is_tried(positions_of(fit, start), tried, policy.min_step * cell_m)) continue;
        tried.push_back(positions_of(fit, start));
        JointFit other = logged_fit(
            "last fit", {context.setup, data, start, context.policy(), EffectFreedom::all, policy.effort}, store, log);
        if (log.cancelled()) return {};
        if (other.usable() && other.squares() < (best ? best->squares() : fit.squares())) best = std::move(other);
    }
    return best;
}

}  // namespace

std::vector<prediction::ParameterValues> neighbouring_places(const JointFit& fit, double cell_m,
                                                             const PlacePolicy& policy) {
    std::vector<prediction::ParameterValues> starts;
    if (fit.jacobian.cols() != static_cast<Index>(fit.parameters.size())) return starts;
    for (const PlaceOfEffect& place : fitted_places(fit)) {
        const PlaceSlopes slopes = slopes_of(place, fit);
        const Eigen::SelfAdjointEigenSolver<Matrix3d> directions(slopes.normal);
        const Vector3d here = position_of(place, fit, fit.values);
        for (Index k = 0; k < 3; ++k) {
            const double deviations = cell_m * std::sqrt(std::max(0.0, directions.eigenvalues()(k)));
            if (deviations < policy.min_deviations || deviations > policy.max_deviations) continue;
            for (const double sense : {1.0, -1.0}) {
                prediction::ParameterValues start = moved(fit, place, slopes,
                                                          sense * cell_m * directions.eigenvectors().col(k));
                if ((position_of(place, fit, start) - here).norm() >= policy.min_step * cell_m)
                    starts.push_back(std::move(start));
            }
        }
    }
    return starts;
}

JudgedFit with_best_place(const DiagnosisContext& context, const FitData& data, JudgedFit fit, FitStore& store,
                          PhaseLog& log) {
    TriedPlaces tried{positions_of(fit.fit, fit.fit.values)};
    std::optional<JointFit> best;
    for (int step = 0; step < context.policy().places.max_steps; ++step) {
        std::optional<JointFit> better = better_neighbour(context, data, best ? *best : fit.fit, tried, store, log);
        if (!better) break;
        best = std::move(better);
    }
    if (!best || log.cancelled()) return fit;
    JudgedFit result = judged(data, std::move(*best), context.settings);
    result.weight = fit.weight;
    result.criterion = fit.criterion;
    return result;
}

}  // namespace myo::diagnosis
