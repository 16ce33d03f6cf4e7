#include "sensitivity/adjoint_step.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <limits>
#include <utility>

#include "dynamics/statics.hpp"
#include "model/point_energy.hpp"
#include "sensitivity/creep_adjoint.hpp"
#include "solver/conjugate_gradient.hpp"

namespace myo::sensitivity {
namespace {

using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct AdjointStepPolicy {
    /// Iterations per solve to 1e-6 on the beam with 4, 8, 12 solutions: 1.5, 1.0, 0.9 (Euler), 3.1, 2.1, 1.7
    /// (TR-BDF2); with cubic extrapolation of four: 2.9, 3.9.
    Eigen::Index most = 8;
    /// The derivative of the start equilibrium of a softening body is a fixed point, as in TangentRunPolicy.
    int max_softening_rounds = 200;
    double softening_tolerance = 1e-12;
};
constexpr AdjointStepPolicy adjoint_step_policy;

/// to += factor * from; an empty field counts as zero.
template <class Field>
void add_to(Field& to, double factor, const Field& from) {
    if (factor == 0.0 || from.size() == 0) return;
    if (to.size() == 0)
        to = factor * from;
    else
        to += factor * from;
}

/// The motion field of a column: state before the step, or stage solution.
const Matrix3Xd& motion(const StepRecord& record, int column) {
    switch (column) {
        case x_field: return record.start.x;
        case v_field: return record.start.v;
        case v_lag_field: return record.start.v_lag;
        default: return record.solved[static_cast<std::size_t>(column - nodal_fields)].solution.x;
    }
}

/// The motion that M multiplies in a momentum row. A stage row also has -inertia x, from the left side of its equation.
Matrix3Xd accelerations(const StepCoefficients& coefficients, const StepRecord& record, int row) {
    Matrix3Xd u = Matrix3Xd::Zero(3, record.start.x.cols());
    for (int c = 0; c < coefficients.nodal.cols(); ++c)
        if (is_motion_column(c)) add_to(u, coefficients.nodal(row, c), motion(record, c));
    if (row >= nodal_fields) {
        const int stage = row - nodal_fields;
        u -= coefficients.inertia_1_s2[static_cast<std::size_t>(stage)] * motion(record, row);
    }
    return u;
}

}  // namespace

VectorXd AdjointFollower::Guess::next(const solver::SymmetricSparse& H, const VectorXd& b) const {
    const Eigen::Index size = last_.cols();
    if (size == 0) return {};
    // The differences of successive solutions span the same space but are far from parallel.
    MatrixXd D = last_;
    for (Eigen::Index order = 1; order < size; ++order)
        for (Eigen::Index k = size - 1; k >= order; --k) D.col(k) = D.col(k - 1) - D.col(k);
    for (Eigen::Index k = 0; k < size; ++k) D.col(k) /= std::max(D.col(k).norm(), std::numeric_limits<double>::min());
    // Galerkin projection: minimise the energy norm of the error within the span of D.
    const MatrixXd G = D.transpose() * solver::symmetric_product(H, D);
    return D * G.ldlt().solve(D.transpose() * b);
}

void AdjointFollower::Guess::add(const VectorXd& solution) {
    if (solution.isZero(0.0)) return;
    MatrixXd next(solution.size(), std::min(last_.cols() + 1, adjoint_step_policy.most));
    next.col(0) = solution;
    next.rightCols(next.cols() - 1) = last_.leftCols(next.cols() - 1);
    last_ = std::move(next);
}

AdjointFollower::AdjointFollower(const model::Model& model, bool with_strains, bool fibre_points)
    : model_(model), with_strains_(with_strains), gradient_(model, fibre_points) {}

const AdjointFollower::Known& AdjointFollower::coefficients(const dynamics::TimeScheme& scheme, double h,
                                                            double step_before) {
    const auto same = [&](const Known& known) {
        return known.scheme == scheme && known.h == h && known.step_before == step_before;
    };
    const auto found = std::find_if(known_.begin(), known_.end(), same);
    if (found != known_.end()) return *found;
    if (known_.size() > 16) known_.clear();  // step lengths that differ by rounding fill the cache
    const double lambda = model_.velocity_force_1_s;
    known_.push_back({scheme, h, step_before, step_coefficients(scheme, h, step_before, lambda),
                      step_coefficients_by_velocity_force(scheme, h, step_before, lambda)});
    return known_.back();
}

void AdjointFollower::jump(dynamics::StageSolver& solver, const JumpRecord& at) {
    const dynamics::Kinematics& s = at.state;
    const model::BlockPattern& pattern = model_.body->pattern;
    Matrix3Xd& adjoint = state_.nodal[force_field];
    if (adjoint.size() == 0) return;
    if (model_.softening) PeakAdjoint::soften(solver, at.peak_energy_J_m3);
    // Transpose of force = f(x, rate, v, loads) + Lambda M v, see set_jump_force(). The force adjoint becomes adjoints
    // of x, v and rate, and is then zero: the force before the jump is overwritten.
    const Matrix3Xd times_M = model::times_mass(adjoint, solver.mass(at.time_s));
    const dynamics::Stage stage = dynamics::jump_stage(s, at.time_s);
    const solver::SymmetricSparse K = solver.hessian(stage, s.x);
    add_to(state_.nodal[x_field], -1.0,
           model::scatter(pattern, solver.stiffness_product(K, stage, s.x, model::gather(pattern, adjoint),
                                                            model::StiffnessForm::transposed)));
    add_to(state_.nodal[v_field], model_.velocity_force_1_s, times_M);
    if (model::is_viscous(model_) || model_.creep)
        add_to(state_.strain[rate_field], -1.0,
               history_adjoint(model_, stage.rate_factor_1_s, model::strain_tangent(model_, s.x, adjoint), {}));
    if (model_.softening) peaks_.use(model_, at.peak_energy_J_m3, s.x, adjoint);
    if (model::depends_on_velocity(model_))
        add_to(state_.nodal[v_field], -1.0,
               model::velocity_pull(model_, dynamics::force_state(stage, s.x, s.v), adjoint));
    const Matrix3Xd u = model_.velocity_force_1_s * s.v;
    gradient_.add({s.x,
                   &s.v,
                   {0.0, with_strains_ ? &s.rate : nullptr},
                   at.time_s,
                   false,
                   at.time_s,
                   &u,
                   &s.v,
                   &solver.softening()},
                  adjoint, times_M);
    adjoint.resize(3, 0);
}

Matrix3Xd AdjointFollower::stage_adjoint(dynamics::StageSolver& solver, const dynamics::Stage& stage,
                                         const Matrix3Xd& x, const Matrix3Xd& load, Guess& guess) const {
    const model::BlockPattern& pattern = model_.body->pattern;
    const solver::SymmetricSparse H = solver.hessian(stage, x);
    const VectorXd b = model::gather(pattern, load);
    const VectorXd p = solver.solve_linear(H, stage, x, b, guess.next(H, b), model::StiffnessForm::transposed);
    if (!p.allFinite()) return {3, 0};
    guess.add(p);
    return model::scatter(pattern, p);
}

/// A step backwards: the adjoints of the rows of its map, and the transposed map.
struct AdjointFollower::StepAdjoint {
    const Known& known;
    const StepRecord& record;
    double middle_s;
    const model::MassMatrix& mass;
    // Adjoints of the fields after the step and of the stage constants; momentum rows also multiplied by the mass.
    std::vector<Matrix3Xd> rows, mass_rows;
    std::vector<VectorXd> strain_rows;
    std::vector<Matrix3Xd> velocity_rows;  // adjoints of the stages' velocity histories

    /// Takes the adjoints of the fields after the step.
    StepAdjoint(const dynamics::StageSolver& solver, const Known& step, const StepRecord& run, KinematicsAdjoint& after)
        : known(step),
          record(run),
          middle_s(run.time_s + 0.5 * step.h),
          mass(solver.mass(middle_s)),
          rows(static_cast<std::size_t>(nodal_fields + stages())),
          mass_rows(rows.size()),
          strain_rows(static_cast<std::size_t>(strain_fields + stages())),
          velocity_rows(static_cast<std::size_t>(stages())) {
        std::move(after.nodal.begin(), after.nodal.end(), rows.begin());
        std::move(after.strain.begin(), after.strain.end(), strain_rows.begin());
    }

    int stages() const { return known.plain.stages(); }
    const dynamics::SolvedStage& solved(int stage) const { return record.solved[static_cast<std::size_t>(stage)]; }

    /// Column of the transposed map: adjoint of a field before the step or of a stage solution.
    Matrix3Xd column(int c) const {
        const StepCoefficients& map = known.plain;
        Matrix3Xd sum;
        for (int row = 0; row < map.nodal.rows(); ++row) {
            const auto r = static_cast<std::size_t>(row);
            add_to(sum, map.nodal(row, c), is_momentum_row(row) && is_motion_column(c) ? mass_rows[r] : rows[r]);
        }
        // Stage velocities depend on motions with the same coefficients as strain rates on strains.
        const int beside = c < strain_fields ? c : c - nodal_fields + strain_fields;
        if (c < strain_fields || c >= nodal_fields)
            for (int k = 0; k < stages(); ++k)
                add_to(sum, map.strain(strain_fields + k, beside), velocity_rows[static_cast<std::size_t>(k)]);
        return sum;
    }
    /// Likewise of a strain field.
    VectorXd strain_column(int c) const {
        const StepCoefficients& map = known.plain;
        VectorXd sum;
        for (int row = 0; row < map.strain.rows(); ++row)
            add_to(sum, map.strain(row, c), strain_rows[static_cast<std::size_t>(row)]);
        return sum;
    }
};

void AdjointFollower::add_momenta(StepAdjoint& at) {
    for (const int row : {force_field, force_lag_field}) {
        const auto r = static_cast<std::size_t>(row);
        if (at.rows[r].size() == 0) continue;
        at.mass_rows[r] = model::times_mass(at.rows[r], at.mass);
        const Matrix3Xd by_velocity_force = accelerations(at.known.by_velocity_force, at.record, row);
        gradient_.add_momentum(at.middle_s, at.rows[r], at.mass_rows[r], accelerations(at.known.plain, at.record, row),
                               &by_velocity_force);
    }
}

Matrix3Xd AdjointFollower::solution_adjoint(const StepAdjoint& at, int k, const VectorXd& strain_load) const {
    const auto& [stage, solution] = at.solved(k);
    Matrix3Xd load = at.column(nodal_fields + k);
    if (strain_load.size() > 0)
        add_to(load, 1.0,
               model::viscous_gradient(model_, solution.x,
                                       body_strain_adjoint(model_, stage.rate_factor_1_s, strain_load)));
    if (load.size() == 0) load = Matrix3Xd::Zero(3, model_.body->node_count());
    return load;
}

bool AdjointFollower::transpose_stage(dynamics::StageSolver& solver, int k, StepAdjoint& at) {
    const auto& [stage, solution] = at.solved(k);
    const auto row = static_cast<std::size_t>(nodal_fields + k);
    const VectorXd strain_load = at.strain_column(strain_fields + k);
    Matrix3Xd &p = at.rows[row], &p_times_mass = at.mass_rows[row];
    p = stage_adjoint(solver, stage, solution.x, solution_adjoint(at, k, strain_load),
                      guesses_[static_cast<std::size_t>(k)]);
    if (p.size() == 0) return false;
    p_times_mass = model::times_mass(p, at.mass);
    if (model::is_viscous(model_) || model_.creep)
        at.strain_rows[static_cast<std::size_t>(strain_fields + k)] = history_adjoint(
            model_, stage.rate_factor_1_s, -model::strain_tangent(model_, solution.x, p), strain_load);
    if (model_.softening) peaks_.use(model_, at.record.peak_energy_J_m3, solution.x, p);
    const Matrix3Xd v = model::depends_on_velocity(model_) ? dynamics::stage_velocities(stage, solution.x)
                                                           : Matrix3Xd();  // only force elements use it
    if (model::depends_on_velocity(model_))
        at.velocity_rows[static_cast<std::size_t>(k)] = -model::velocity_pull(
            model_, dynamics::force_state(stage, solution.x, v), p);
    const Matrix3Xd u = accelerations(at.known.plain, at.record, nodal_fields + k),
                    by_velocity_force = accelerations(at.known.by_velocity_force, at.record, nodal_fields + k);
    const model::StrainRate rate{stage.rate_factor_1_s, with_strains_ ? &stage.rate_history : nullptr};
    gradient_.add({solution.x, v.size() > 0 ? &v : nullptr, rate, stage.time_s, stage.before_jump, stage.inertia_at_s,
                   &u, &by_velocity_force, &solver.softening()},
                  p, p_times_mass);
    return true;
}

bool AdjointFollower::step(dynamics::StageSolver& solver, const StepRecord& record) {
    if (model_.softening) {
        lower_peaks(record.peak_energy_J_m3, record.solved.back().solution.x);
        PeakAdjoint::soften(solver, record.peak_energy_J_m3);
    }
    StepAdjoint at(solver, coefficients(record.scheme, record.h_s, record.start.step_before_s), record, state_);
    add_momenta(at);
    guesses_.resize(static_cast<std::size_t>(at.stages()));
    for (int k = at.stages() - 1; k >= 0; --k)
        if (!transpose_stage(solver, k, at)) return false;
    for (int field = 0; field < nodal_fields; ++field) state_.nodal[static_cast<std::size_t>(field)] = at.column(field);
    for (int field = 0; field < strain_fields; ++field)
        state_.strain[static_cast<std::size_t>(field)] = at.strain_column(field);
    return true;
}

void AdjointFollower::lower_peaks(const VectorXd& before, const Matrix3Xd& x) {
    const VectorXd weights = peaks_.take_raised(model_, before, x);
    if (weights.isZero(0.0)) return;
    add_to(state_.nodal[x_field], 1.0, model::isochoric_energy_gradient(model_, x, weights));
    gradient_.add_energies(x, weights);
}

Matrix3Xd AdjointFollower::equilibrium_adjoint(dynamics::StageSolver& solver, const dynamics::Stage& stage,
                                               const Matrix3Xd& x, const Matrix3Xd& load, const VectorXd& peak) {
    const model::BlockPattern& pattern = model_.body->pattern;
    const solver::SymmetricSparse K = solver.hessian(stage, x);
    Matrix3Xd p = Matrix3Xd::Zero(3, x.cols()), sum = load;
    VectorXd weights;
    for (int round = 0; round < adjoint_step_policy.max_softening_rounds; ++round) {
        const MatrixXd solved = solver.solve_linear(K, stage, x, model::gather(pattern, sum), {},
                                                    model::StiffnessForm::transposed);
        if (!solved.allFinite()) return {3, 0};
        const Matrix3Xd before = std::exchange(p, model::scatter(pattern, solved));
        // Without softening one solve is exact.
        if (!model_.softening || (p - before).norm() <= adjoint_step_policy.softening_tolerance * p.norm()) break;
        // The forces of the equilibrium depend on its own energies.
        PeakAdjoint own;
        own.use(model_, peak, x, p);
        weights = own.take_raised(model_, {}, x);
        sum = load + model::isochoric_energy_gradient(model_, x, weights);
    }
    if (weights.size() > 0) gradient_.add_energies(x, weights);
    return p;
}

bool AdjointFollower::start(dynamics::StageSolver& solver, const dynamics::SimulationOptions& options,
                            const JumpRecord& start) {
    const dynamics::Kinematics& at = start.state;
    const model::Body& body = *model_.body;
    if (model_.softening) {
        PeakAdjoint::soften(solver, start.peak_energy_J_m3);
        lower_peaks({}, at.x);
    }
    const auto free_part = [&](const Matrix3Xd& X) {
        return X.size() == 0 ? Matrix3Xd(Matrix3Xd::Zero(3, body.node_count())) : model::free_part(body, X);
    };
    Matrix3Xd& x = state_.nodal[x_field];
    const auto [strain, rate] = start_strain_adjoint(model_, options.start == dynamics::StartKind::equilibrium,
                                                     state_.strain[strain_field], state_.strain[rate_field]);
    if (strain.size() > 0) add_to(x, 1.0, model::viscous_gradient(model_, at.x, strain));
    if (rate.size() > 0) {
        // Transpose of rate = strain_tangent(x, v). Its derivative with respect to x is the geometric stiffness of the
        // viscous potential with `rate` as strain rate.
        add_to(state_.nodal[v_field], 1.0, model::viscous_gradient(model_, at.x, rate));
        if (!at.v.isZero(0.0)) {
            model::Stiffness viscous_only = model::stiffness(model_);
            viscous_only.elastic.clear();
            viscous_only.fibres = false;
            model::InternalInput input;
            input.stiffness = &viscous_only;
            input.rate = {0.0, &rate};
            const solver::SymmetricSparse K = model::internal_energy(model_, at.x, input, model::HessianKind::exact)
                                                  .hessian;
            add_to(x, 1.0,
                   model::scatter(body.pattern, K.selfadjointView<Eigen::Lower>() * model::gather(body.pattern, at.v)));
        }
    }
    initial_.initial_positions = free_part(x);
    initial_.initial_velocities = free_part(state_.nodal[v_field]);
    if (!options.starts_at_equilibrium() || x.size() == 0) return true;
    // Implicit function theorem for the start equilibrium: its positions are determined by the model, not given.
    const dynamics::Stage stage = dynamics::static_stage(body, 0.0);
    const Matrix3Xd p = equilibrium_adjoint(solver, stage, at.x, initial_.initial_positions, start.peak_energy_J_m3);
    if (p.size() == 0) return false;
    gradient_.add(
        {at.x, nullptr, {}, stage.time_s, stage.before_jump, stage.inertia_at_s, nullptr, nullptr, &solver.softening()},
        p, model::times_mass(p, solver.mass(stage.inertia_at_s)));
    initial_.initial_positions.setZero();
    return true;
}

ModelGradient AdjointFollower::take() {
    ModelGradient gradient = gradient_.take();
    gradient.initial_positions = std::move(initial_.initial_positions);
    gradient.initial_velocities = std::move(initial_.initial_velocities);
    return gradient;
}

}  // namespace myo::sensitivity
