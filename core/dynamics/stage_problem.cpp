#include "dynamics/stage_problem.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "base/stopwatch.hpp"
#include "dynamics/creep.hpp"
#include "model/fibre_forces.hpp"

namespace myo::dynamics {
namespace {

using Eigen::Matrix3Xd;
using Eigen::VectorXd;

/// Mass matrix of the free unknowns, lower triangle, in the sparsity pattern of the body.
solver::SymmetricSparse inertia_in_pattern(const model::Body& body, const model::MassMatrix& mass) {
    solver::SymmetricSparse inertia = body.pattern.zero;
    // Isotropic part: the same entry for the three coordinates.
    for (int column = 0; column < mass.isotropic.outerSize(); ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(mass.isotropic, column); entry; ++entry) {
            const int i = body.pattern.free_index[static_cast<std::size_t>(entry.row())];
            const int j = body.pattern.free_index[static_cast<std::size_t>(column)];
            if (j < 0 || i < j) continue;
            for (int r = 0; r < 3; ++r) inertia.coeffRef(3 * i + r, 3 * j + r) += entry.value();
        }
    // Directional part, e.g. of masses that act along one direction only: full 3 x 3 blocks.
    for (int column = 0; column < mass.directional.outerSize(); ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(mass.directional, column); entry; ++entry) {
            const auto row = static_cast<int>(entry.row());
            const int i = body.pattern.free_index[static_cast<std::size_t>(row / 3)];
            const int j = body.pattern.free_index[static_cast<std::size_t>(column / 3)];
            if (i < 0 || j < 0 || 3 * i + row % 3 < 3 * j + column % 3) continue;
            inertia.coeffRef(3 * i + row % 3, 3 * j + column % 3) += entry.value();
        }
    assert(inertia.nonZeros() == body.pattern.zero.nonZeros());  // masses couple only nodes that share a cell
    body.pattern.hold(inertia);
    return inertia;
}

}  // namespace

Matrix3Xd stage_velocities(const Stage& stage, const Matrix3Xd& x) {
    if (stage.velocity_history.size() == 0) return {};
    return stage.rate_factor_1_s * x + stage.velocity_history;
}

model::ForceState force_state(const Stage& stage, const Matrix3Xd& x, const Matrix3Xd& v) {
    return {x, v.size() > 0 ? &v : nullptr, stage.rate_factor_1_s, stage.time_s, stage.before_jump};
}

StageConstants stage_constants(const model::Model& model) {
    StageConstants constants{&model, model::mass_spans(model), {}, model::stiffness(model)};
    for (const model::MassSpan& span : constants.masses)
        constants.inertia.push_back(inertia_in_pattern(*model.body, span.mass));
    return constants;
}

StageProblem::StageProblem(const StageConstants& constants, const Stage& stage, SolverTimes* times,
                           const Progress* cancellation)
    : constants_(constants),
      stage_(stage),
      times_(times),
      cancellation_(cancellation),
      span_(model::span_at(constants.masses, stage.inertia_at_s)),
      activation_(model::activations(*constants.model, stage.time_s, stage.before_jump)),
      dead_(stage.constant +
            model::external_forces(*constants.model, constants.masses[span_].mass, stage.time_s, stage.before_jump)) {
    if (model().creep && stage.rate_history.size() > 0)
        viscous_history_ = viscous_history(model(), stage.rate_factor_1_s, stage.rate_history);
}

StageProblem::Evaluation StageProblem::evaluate(const Matrix3Xd& x, model::HessianKind kind,
                                                const VectorXd* pressure) const {
    // NaN makes every iteration that uses this evaluation stop.
    if (cancellation_ && cancellation_->cancelled()) {
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        return {none, VectorXd::Constant(inertia().cols(), none), inertia()};
    }
    double untimed = 0.0;
    const TimedScope scope(!times_                            ? untimed
                           : kind == model::HessianKind::none ? times_->forces_s
                                                              : times_->stiffness_s);
    model::InternalInput input;
    input.stiffness = &constants_.stiffness;
    input.activation = &activation_;
    // With creep, the effective rate F E + H of creep.hpp replaces the strain rate.
    if (viscous_history_.size() > 0)
        input.rate = {viscous_factor(model(), stage_.rate_factor_1_s), &viscous_history_};
    else if (stage_.rate_history.size() > 0)
        input.rate = {stage_.rate_factor_1_s, &stage_.rate_history};
    input.pressure = pressure;
    model::InternalEnergy internal = model::internal_energy(model(), x, input, kind);
    if (!model().force_elements.empty()) {
        const Matrix3Xd v = model::depends_on_velocity(model()) ? stage_velocities(stage_, x) : Matrix3Xd();
        model::add_force_elements(model(), force_state(stage_, x, v), kind, internal);
    }

    Evaluation result;
    // Incremental potential: internal energy + 1/2 inertia x'Mx - dead forces x; its gradient is the residual.
    result.potential = internal.energy - dead_.cwiseProduct(x).sum();
    internal.gradient -= dead_;
    if (stage_.inertia_1_s2 != 0.0) {
        const Matrix3Xd momentum = stage_.inertia_1_s2 * model::times_mass(x, mass_span().mass);
        result.potential += 0.5 * momentum.cwiseProduct(x).sum();
        internal.gradient += momentum;
    }
    result.residual = model::gather(pattern(), internal.gradient);
    if (kind != model::HessianKind::none) {
        result.hessian.swap(internal.hessian);  // Eigen's sparse matrices cannot be moved
        result.hessian.coeffs() += stage_.inertia_1_s2 * inertia().coeffs();
        pattern().hold(result.hessian);
    }
    return result;
}

VectorXd StageProblem::unsymmetric_product(const Matrix3Xd& x, const VectorXd& vector,
                                           model::StiffnessForm form) const {
    const Matrix3Xd v = model::depends_on_velocity(model()) ? stage_velocities(stage_, x) : Matrix3Xd();
    return model::gather(pattern(), model::unsymmetric_product(model(), force_state(stage_, x, v),
                                                               model::scatter(pattern(), vector), form));
}

double StageProblem::force_scale(const Matrix3Xd& start, double tolerance) const {
    const double external = model::gather(pattern(), dead_ - stage_.constant).norm();
    const double inertial = model::gather(pattern(), stage_.constant - stage_.inertia_1_s2 *
                                                                           model::times_mass(start, mass_span().mass))
                                .norm();
    // A body at rest without forces also needs a scale: 1e-6 of the elastic force at unit strain.
    const double volume = model().body->volume_m3;
    const double elastic = 1e-6 * model().moduli.front().mu * std::cbrt(volume * volume);
    model::InternalEnergy
        at_rest;  // forces of muscles and force elements in the rest shape; at a strained guess they could be huge
    at_rest.gradient = Matrix3Xd::Zero(3, start.cols());
    const Matrix3Xd& X = model().body->mesh.nodes;
    model::add_fibres(model(), X, activation_, model::HessianKind::none, at_rest);
    model::add_force_elements(model(), {X, nullptr, 0.0, stage_.time_s, stage_.before_jump}, model::HessianKind::none,
                              at_rest);
    const double active = model::gather(pattern(), at_rest.gradient).norm();
    return std::max({external + inertial + active, elastic, rounding_of_forces(start) / tolerance, 1e-30});
}

/// Norm below which the residual is rounding noise.
///
/// F has an error of eps |x| / edge. The bulk modulus turns it into a nodal force, times edge^2; the inertia of a short
/// step adds its own multiple of eps |x|; n nodes add as sqrt(n). Without this bound free vibrations at nu = 0.499
/// stall at tolerances of 1e-8 (implicit Euler, whose first force after a release is small) and 1e-9.
double StageProblem::rounding_of_forces(const Matrix3Xd& x) const {
    const model::Body& body = *model().body;
    const double extent = (x.rowwise().maxCoeff() - x.rowwise().minCoeff()).maxCoeff() + x.rowwise().mean().norm();
    const double edge = std::cbrt(body.volume_m3 / body.cell_count());
    double stiffest = 0.0;
    for (const material::Moduli& m : model().moduli) stiffest = std::max({stiffest, m.kappa, m.mu});
    const model::MassMatrix& mass = mass_span().mass;
    const double largest_mass = mass.nodal_kg.sum() +
                                (mass.has_directional() ? mass.directional.diagonal().sum() : 0.0);
    const double inertia = std::abs(stage_.inertia_1_s2) * largest_mass / body.node_count();
    return std::numeric_limits<double>::epsilon() * extent * (stiffest * edge + inertia) *
           std::sqrt(static_cast<double>(body.node_count()));
}

}  // namespace myo::dynamics
