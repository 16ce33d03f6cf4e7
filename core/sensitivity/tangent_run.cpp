#include "sensitivity/tangent_run.hpp"

#include <array>
#include <utility>

#include "base/parallel.hpp"
#include "dynamics/creep.hpp"
#include "dynamics/statics.hpp"
#include "model/force_columns.hpp"
#include "sensitivity/step_coefficients.hpp"
#include "solver/conjugate_gradient.hpp"

namespace myo {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd gather_columns(const BlockPattern& pattern, const NodalColumns& fields) {
    MatrixXd result(pattern.unknowns(), fields.rows() / 3);
    for (Index p = 0; p < result.cols(); ++p)
        for (int i = 0; i < pattern.free_count; ++i)
            result.col(p).segment<3>(3 * i) = fields.col(pattern.free_nodes[static_cast<std::size_t>(i)]).segment<3>(3 * p);
    return result;
}

NodalColumns scatter_columns(const BlockPattern& pattern, const MatrixXd& unknowns) {
    NodalColumns result = NodalColumns::Zero(3 * unknowns.cols(), static_cast<Index>(pattern.free_index.size()));
    for (Index p = 0; p < unknowns.cols(); ++p)
        for (int i = 0; i < pattern.free_count; ++i)
            result.col(pattern.free_nodes[static_cast<std::size_t>(i)]).segment<3>(3 * p) = unknowns.col(p).segment<3>(3 * i);
    return result;
}

/// times_mass() of all fields.
NodalColumns mass_times(const NodalColumns& fields, const MassMatrix& mass) {
    if (fields.size() == 0) return {};
    NodalColumns result(fields.rows(), fields.cols());
    parallel_ranges(static_cast<int>(mass.isotropic.outerSize()), 50, [&](int first, int end) {
        for (int j = first; j < end; ++j) {
            result.col(j).setZero();
            for (Eigen::SparseMatrix<double>::InnerIterator entry(mass.isotropic, j); entry; ++entry) result.col(j) += entry.value() * fields.col(entry.row());
        }
    });
    if (mass.has_directional()) add_directional(mass.directional, fields, result);
    return result;
}

/// The sum of factor times field, where empty fields are zero; a few columns at a time, so that the sum stays in the cache.
using Terms = std::vector<std::pair<double, const MatrixXd*>>;
MatrixXd sum_of(const Terms& terms) {
    MatrixXd result;
    for (const auto& [factor, field] : terms)
        if (factor != 0.0 && field->size() > 0) result.resizeLike(*field);
    constexpr Index entries_at_once = 2048;
    for (Index start = 0; start < result.size(); start += entries_at_once) {
        const Index count = std::min(entries_at_once, result.size() - start);
        Eigen::Map<VectorXd> part(result.data() + start, count);
        part.setZero();
        for (const auto& [factor, field] : terms)
            if (factor != 0.0 && field->size() > 0) part += factor * Eigen::Map<const VectorXd>(field->data() + start, count);
    }
    return result;
}

/// Carries d(Kinematics)/d(parameter) along a run, all parameters side by side. A step is linear but for the solves of its stages (see
/// StepCoefficients).
class TangentFollower {
public:
    TangentFollower(const Model& model, const SimulationOptions& options, const std::vector<ModelTangent>& parameters,
                    const std::vector<int>& nodes)
        : model_(model), options_(options), parameters_(parameters), nodes_(nodes), kept_(parameters.size()) {
        for (const ModelTangent& parameter : parameters) stiffness_.push_back(stiffness_tangent(model, parameter));
    }

    void start(StageSolver& solver, const Kinematics& state) {
        if (parameters_.empty()) return;
        const Body& body = *model_.body;
        nodal_[x_field] = NodalColumns::Zero(3 * static_cast<Index>(parameters_.size()), body.node_count());
        nodal_[v_field] = nodal_[x_field];
        if (options_.starts_at_equilibrium()) {
            const Stage stage = static_stage(body, 0.0);
            const MatrixXd B = -gather_columns(body.pattern, gradient(solver, stage, state.x, state.rate, {}, {}));
            nodal_[x_field] = scatter_columns(body.pattern, solver.solve_linear(solver.hessian(stage, state.x), stage, state.x, B));
            if (with_strains()) strain_[strain_field] = strain_tangents(body, state.x, nodal_[x_field]);
            if (model_.creep) strain_[strain_field] = strain_[strain_field].replicate(2, 1).eval();
        }
        keep();
    }

    void jump(StageSolver& solver, const Kinematics& state, double t) {
        if (parameters_.empty()) return;
        const BlockPattern& pattern = model_.body->pattern;
        const Stage stage = jump_stage(state, t);
        const SymmetricSparse K = solver.hessian(stage, state.x);
        NodalColumns pushed = gradient(solver, stage, state.x, state.rate, strain_[rate_field], nodal_[v_field]);
        if (model_.velocity_force_1_s != 0.0) pushed -= model_.velocity_force_1_s * mass_times(nodal_[v_field], solver.mass());
        nodal_[force_field] = scatter_columns(pattern, -symmetric_product(K, gather_columns(pattern, nodal_[x_field])) - gather_columns(pattern, pushed));
    }

    void step(StageSolver& solver, const TimeScheme& scheme, double, double h, const std::vector<SolvedStage>& solved) {
        if (parameters_.empty()) return;
        const Body& body = *model_.body;
        const StepCoefficients step = step_coefficients(scheme, h, step_before_s_, model_.velocity_force_1_s);
        std::vector<NodalColumns> solutions(solved.size());
        std::vector<MatrixXd> strains(solved.size());
        const auto nodal_row = [&](int row) {
            Terms plain, through_mass;
            for (int c = 0; c < step.nodal.cols(); ++c) {
                const MatrixXd* field = c < nodal_fields ? &nodal_[static_cast<std::size_t>(c)] : &solutions[static_cast<std::size_t>(c - nodal_fields)];
                (is_momentum_row(row) && is_motion_column(c) ? through_mass : plain).emplace_back(step.nodal(row, c), field);
            }
            const NodalColumns momentum = mass_times(sum_of(through_mass), solver.mass());
            plain.emplace_back(1.0, &momentum);
            return sum_of(plain);
        };
        const auto strain_row = [&](int row) {
            Terms terms;
            for (int c = 0; c < step.strain.cols(); ++c)
                terms.emplace_back(step.strain(row, c), c < strain_fields ? &strain_[static_cast<std::size_t>(c)] : &strains[static_cast<std::size_t>(c - strain_fields)]);
            return sum_of(terms);
        };

        // Velocities of a stage depend on motions as rates of strain on strains.
        const auto velocity_row = [&](int row) {
            Terms terms;
            if (!depends_on_velocity(model_)) return NodalColumns();
            for (int c = 0; c < step.strain.cols(); ++c)
                terms.emplace_back(step.strain(row, c), c < strain_fields ? &nodal_[static_cast<std::size_t>(c)] : &solutions[static_cast<std::size_t>(c - strain_fields)]);
            return sum_of(terms);
        };

        guesses_.resize(solved.size());
        for (std::size_t k = 0; k < solved.size(); ++k) {
            const auto& [stage, solution] = solved[k];
            const VectorXd rate = stage.rate_factor_1_s * solution.strain + stage.rate_history;
            const auto stage_number = static_cast<int>(k);
            MatrixXd B = gather_columns(body.pattern, nodal_row(nodal_fields + stage_number));
            MatrixXd histories = strain_row(strain_fields + stage_number);
            if (model_.creep && histories.size() == 0) histories = MatrixXd::Zero(rate.size(), static_cast<Index>(parameters_.size()));
            B -= gather_columns(body.pattern, gradient(solver, stage, solution.x, rate, histories, velocity_row(strain_fields + stage_number)));
            const MatrixXd X = solver.solve_linear(solver.hessian(stage, solution.x), stage, solution.x, B, guesses_[k].next());
            guesses_[k].add(X);
            solutions[k] = scatter_columns(body.pattern, X);
            if (with_strains()) strains[k] = strain_tangents(body, solution.x, solutions[k]);
            if (model_.creep) strains[k] = with_dashpots(*model_.creep, stage.rate_factor_1_s, strains[k], histories);
        }
        std::array<NodalColumns, nodal_fields> nodal;
        std::array<MatrixXd, strain_fields> strain;
        for (int field = 0; field < nodal_fields; ++field) nodal[static_cast<std::size_t>(field)] = nodal_row(field);
        for (int field = 0; field < strain_fields; ++field) strain[static_cast<std::size_t>(field)] = strain_row(field);
        nodal_ = std::move(nodal);
        strain_ = std::move(strain);
        // The mass couples clamped nodes to their free neighbours; forces on them are reactions.
        for (int i = 0; i < body.node_count(); ++i)
            if (body.clamped[static_cast<std::size_t>(i)] && nodal_[force_field].size() > 0) nodal_[force_field].col(i).setZero();
        step_before_s_ = step.nodal.row(v_lag_field).any() ? h : 0.0;   // of schemes that look back
        keep();
    }

    std::vector<NodeTangent> take() { return std::move(kept_); }

private:
    /// Where to start the linear solves: the solutions of the last two steps, continued.
    struct Guess {
        MatrixXd last, before_last;
        MatrixXd next() const { return before_last.size() > 0 ? MatrixXd(2.0 * last - before_last) : last; }
        void add(const MatrixXd& X) {
            before_last = std::move(last);
            last = X;
        }
    };

    /// Strains act through viscous forces alone.
    bool with_strains() const { return model_.damping_s > 0.0 || model_.creep; }

    /// Of a creeping body: the change of what viscous stresses are made of, positions held, along the parameters and the changes of its
    /// strain rates (of both, see creep.hpp).
    MatrixXd viscous_changes(const Stage& stage, const VectorXd& rates, const MatrixXd& d_rates) const {
        const Index count = rates.size() / 2;
        MatrixXd result = d_rates.size() > 0 ? viscous_history(model_, stage.rate_factor_1_s, d_rates) : MatrixXd::Zero(count, static_cast<Index>(parameters_.size()));
        for (std::size_t p = 0; p < parameters_.size(); ++p)
            if (parameters_[p].damping_s != 0.0) result.col(static_cast<Index>(p)) += parameters_[p].damping_s * rates.head(count);
        return result;
    }

    /// Derivatives of dW/dx at x with the positions held: along the parameters, and along those of the strain rates and of the velocities.
    NodalColumns gradient(const StageSolver& solver, const Stage& stage, const Matrix3Xd& x, const VectorXd& rates, const MatrixXd& d_rates,
                          const NodalColumns& d_velocities) const {
        bool elastic = false, viscous = false;
        for (const Stiffness& s : stiffness_) {
            elastic = elastic || !s.elastic.empty();
            viscous = viscous || !s.viscous.empty();
        }
        UnitForces forces;
        if (elastic || viscous) forces = unit_forces(model_, x, !viscous ? VectorXd() : model_.creep ? VectorXd(viscous_history(model_, 0.0, rates)) : rates);
        std::vector<Stiffness> of_softened;   // the factors held
        if (solver.softening().size() > 0) {
            of_softened = stiffness_;
            for (Stiffness& s : of_softened)
                if (!s.elastic.empty()) s.elastic = softened(std::move(s.elastic), solver.softening());
        }
        const MatrixXd changes = model_.creep ? viscous_changes(stage, rates, d_rates) : with_strains() ? d_rates : MatrixXd();
        NodalColumns result = gradient_columns(model_, x, forces, of_softened.empty() ? stiffness_ : of_softened, changes);
        for (std::size_t g = 0; g < model_.fibres->size(); ++g) {
            Matrix3Xd of_group;   // per unit of its activation
            for (std::size_t p = 0; p < parameters_.size(); ++p) {
                const std::vector<double> d = activation_tangent(parameters_[p], stage.time_s, stage.before_jump);
                if (d.empty() || d[g] == 0.0) continue;
                if (of_group.size() == 0) {
                    std::vector<double> unit(model_.fibres->size(), 0.0);
                    unit[g] = 1.0;
                    of_group = activation_gradient(model_, x, unit);
                }
                nodal_column(result, static_cast<Index>(p)) += d[g] * of_group;
            }
        }
        if (!model_.force_elements.empty()) add_force_elements(stage, x, d_velocities, result);
        return result;
    }

    void add_force_elements(const Stage& stage, const Matrix3Xd& x, const NodalColumns& d_velocities, NodalColumns& result) const {
        const Matrix3Xd v = stage_velocities(stage, x);
        const ForceState at = force_state(stage, x, v);
        for (std::size_t p = 0; p < parameters_.size(); ++p) {
            auto column = nodal_column(result, static_cast<Index>(p));
            column += force_element_tangent(model_, parameters_[p], at);
            if (d_velocities.size() > 0) column += velocity_tangent(model_, at, nodal_column(d_velocities, static_cast<Index>(p)));
        }
    }

    void keep() {
        for (std::size_t p = 0; p < parameters_.size(); ++p) {
            const auto of_nodes = [&](NodalField field) { return Matrix3Xd(nodal_column(nodal_[field], static_cast<Index>(p))(Eigen::all, nodes_)); };
            kept_[p].positions.push_back(of_nodes(x_field));
            kept_[p].velocities.push_back(of_nodes(v_field));
        }
    }

    const Model& model_;
    const SimulationOptions& options_;
    const std::vector<ModelTangent>& parameters_;
    const std::vector<int>& nodes_;
    std::vector<Stiffness> stiffness_;                  // its derivatives, per parameter
    std::array<NodalColumns, nodal_fields> nodal_;      // derivatives of the state; empty: zero
    std::array<MatrixXd, strain_fields> strain_;        // a column per parameter; empty: zero
    double step_before_s_ = 0.0;                        // see Kinematics
    std::vector<Guess> guesses_;                        // per stage of a step
    std::vector<NodeTangent> kept_;
};

}  // namespace

SensitiveTrace simulate_with_tangents(const Model& model, const SimulationOptions& options, const std::vector<ModelTangent>& parameters,
                                      const std::vector<int>& nodes, const Progress& progress) {
    TangentFollower follower(model, options, parameters, nodes);
    RunObserver observer;
    observer.started = [&](StageSolver& solver, const Kinematics& state) { follower.start(solver, state); };
    observer.jumped = [&](StageSolver& solver, const Kinematics& state, double t) { follower.jump(solver, state, t); };
    observer.stepped = [&](StageSolver& solver, const TimeScheme& scheme, double t, double h, const std::vector<SolvedStage>& solved) {
        follower.step(solver, scheme, t, h, solved);
    };
    SensitiveTrace result;
    result.trace = simulate(model, options, progress, observer);
    result.tangents = follower.take();
    return result;
}

}  // namespace myo
