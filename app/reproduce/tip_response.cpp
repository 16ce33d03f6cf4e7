#include "reproduce/tip_response.hpp"

#include <cassert>
#include <cmath>
#include <limits>

#include "dynamics/statics.hpp"
#include "sensitivity/model_tangent.hpp"

namespace myo::reproduce {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::VectorXd;

MuscleConfiguration one_muscle() { return {"AC1", {{0, 1.0}}, 1, -5.0, 5.0}; }
MuscleConfiguration tied_muscles() { return {"AC2", {{0, 1.0}, {0, -0.5}}, 1, 1.0, 5.0}; }
MuscleConfiguration free_muscles() { return {"two signals", {{0, 1.0}, {1, 1.0}}, 2, -5.0, 5.0}; }

TipResponse::TipResponse(MuscleBody body, MuscleConfiguration configuration)
    : body_(std::move(body)), configuration_(std::move(configuration)) {
    assert(body_.model.fibres->size() == configuration_.muscles.size());
    // at() subtracts the origin, which is zero for the first call, so that it then gives positions.
    origin_m_.setZero(3, static_cast<Index>(body_.points.bindings.size()));
    rest_ = at(VectorXd::Ones(configuration_.signals));
    if (rest_.ok) origin_m_ = rest_.displacement_m;
    rest_.displacement_m.setZero();
}

TipPose TipResponse::at(const VectorXd& signals, const Matrix3Xd& near) const {
    model::Model model = body_.model;
    for (std::size_t m = 0; m < configuration_.muscles.size(); ++m) {
        const inverse::SignalShare& share = configuration_.muscles[m];
        model.activation[m] = fibre::Signal::constant(1.0 +
                                                      share.factor * (signals(static_cast<Index>(share.signal)) - 1.0));
    }
    TipPose pose;
    dynamics::StageSolver solver(model);
    // Newton starts from the nearest known equilibrium: large bending has several branches.
    pose.x = near.size() > 0 ? near : rest_.x.size() > 0 ? rest_.x : model.body->mesh.nodes;
    const dynamics::StageReport report = dynamics::solve_equilibrium(solver, 0.0, pose.x);
    if (!report.ok()) {
        pose.message = report.message;
        return pose;
    }
    const std::vector<measurement::MarkerBinding>& points = body_.points.bindings;
    pose.displacement_m.resize(3, static_cast<Index>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i)
        pose.displacement_m.col(static_cast<Index>(i)) = measurement::marker_position(
                                                             points[i], pose.x(Eigen::all, points[i].nodes)) -
                                                         origin_m_.col(static_cast<Index>(i));
    // Derivatives share the stiffness at the equilibrium: one factorisation for all signals.
    const dynamics::Stage stage = dynamics::static_stage(*model.body, 0.0);
    const model::BlockPattern& pattern = model.body->pattern;
    const solver::SymmetricSparse H = solver.hessian(stage, pose.x);
    for (Index s = 0; s < configuration_.signals; ++s) {
        sensitivity::ModelTangent tangent;
        for (const inverse::SignalShare& share : configuration_.muscles)
            tangent.activation.push_back(
                fibre::Signal::constant(static_cast<Index>(share.signal) == s ? share.factor : 0.0));
        // Implicit differentiation: K dx/ds = -df/ds, with the factor of the converged stiffness.
        const Matrix3Xd load = sensitivity::gradient_tangent(model, tangent, pose.x, stage.rate_history, 0.0, true);
        const Matrix3Xd dx = model::scatter(pattern,
                                            -solver.solve_linear(H, stage, pose.x, model::gather(pattern, load)));
        Matrix3Xd slope(3, pose.displacement_m.cols());
        for (std::size_t i = 0; i < points.size(); ++i)
            slope.col(static_cast<Index>(i)) = measurement::marker_tangent(
                points[i], pose.x(Eigen::all, points[i].nodes), dx(Eigen::all, points[i].nodes));
        pose.by_signal_m.push_back(slope);
    }
    pose.ok = pose.displacement_m.allFinite();
    return pose;
}

PoseFit unmoved(const TipResponse& response) {
    return {VectorXd::Ones(response.configuration().signals), response.rest(), 0};
}

Result<PoseFit> fit_pose(const TipResponse& response, const Matrix3Xd& goal_m, const PoseFit& start,
                         const Progress& progress) {
    // Coordinates with a goal, as positions in the storage of the matrix (columns are points).
    std::vector<Index> wanted;
    for (Index i = 0; i < goal_m.size(); ++i)
        if (std::isfinite(goal_m.data()[i])) wanted.push_back(i);
    const MuscleConfiguration& configuration = response.configuration();
    std::vector<inverse::Parameter> parameters;
    for (Index s = 0; s < start.signals.size(); ++s)
        parameters.push_back({.name = "signal " + std::to_string(s + 1),
                              .value = start.signals(s),
                              .lower = configuration.lower,
                              .upper = configuration.upper,
                              .scale = 0.1});
    // Kept apart from the optimiser, which does not return the pose of its best values.
    PoseFit best = start;
    double least = std::numeric_limits<double>::infinity();
    const auto residuals = [&](const VectorXd& signals, const Progress&) {
        inverse::ResidualEvaluation evaluation;
        // The best pose so far is the initial guess of every evaluation.
        TipPose pose = response.at(signals, best.pose.x);
        evaluation.ok = pose.ok;
        evaluation.message = pose.message;
        if (!pose.ok) return evaluation;
        evaluation.residuals.resize(static_cast<Index>(wanted.size()));
        evaluation.jacobian.resize(static_cast<Index>(wanted.size()), signals.size());
        for (std::size_t r = 0; r < wanted.size(); ++r) {
            const auto row = static_cast<Index>(r);
            evaluation.residuals(row) = 1e3 * (pose.displacement_m.data()[wanted[r]] - goal_m.data()[wanted[r]]);
            for (Index s = 0; s < signals.size(); ++s)
                evaluation.jacobian(row, s) = 1e3 * pose.by_signal_m[static_cast<std::size_t>(s)].data()[wanted[r]];
        }
        if (const double cost = evaluation.residuals.squaredNorm(); cost < least) {
            least = cost;
            best.signals = signals;
            best.pose = std::move(pose);
        }
        return evaluation;
    };
    inverse::LeastSquaresOptions options;
    options.max_evaluations = 30;
    options.relative_decrease = 1e-5;
    options.relative_step = 1e-5;
    const inverse::LeastSquaresReport fit = inverse::fit_least_squares(parameters, residuals, options,
                                                                       progress.with_sink({}));
    if (progress.cancelled()) return Error{"stopped", ""};
    if (!fit.usable()) return Error{fit.message, "pose of " + configuration.name};
    best.simulations = fit.evaluations;
    return best;
}

}  // namespace myo::reproduce
