#include "sensitivity/tangent_run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "dynamics/creep.hpp"
#include "dynamics/start_state.hpp"
#include "dynamics/statics.hpp"
#include "sensitivity/explicit_changes.hpp"
#include "sensitivity/step_coefficients.hpp"
#include "sensitivity/tangent_columns.hpp"
#include "solver/conjugate_gradient.hpp"

namespace myo::sensitivity {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct TangentRunPolicy {
    int max_softening_rounds = 200;
    double softening_tolerance = 1e-9;
    /// Width of the difference quotients at the start, relative to the size of the body. Strains are nearly quadratic
    /// in the positions: the error consists of a term of width squared and of rounding over width.
    double start_difference = 1e-5;
};
constexpr TangentRunPolicy tangent_run_policy;

/// Propagates d(Kinematics)/d(parameter) along a run, all parameters together. A step is linear apart from the solves
/// of its stages (see StepCoefficients).
class TangentFollower {
public:
    TangentFollower(const model::Model& model, const dynamics::SimulationOptions& options,
                    const std::vector<ModelTangent>& parameters, const std::vector<int>& nodes)
        : model_(model),
          options_(options),
          parameters_(parameters),
          nodes_(nodes),
          explicit_(model, parameters),
          kept_(parameters.size()) {}

    void start(dynamics::StageSolver& solver, const dynamics::Kinematics& state) {
        if (parameters_.empty()) return;
        const model::Body& body = *model_.body;
        nodal_[x_field] = model::NodalColumns::Zero(3 * static_cast<Index>(parameters_.size()), body.node_count());
        nodal_[v_field] = nodal_[x_field];
        if (options_.starts_at_equilibrium()) {
            rest(solver, state);
        } else {
            for (std::size_t p = 0; p < parameters_.size(); ++p)
                if (parameters_[p].start_m.size() > 0)
                    model::nodal_column(nodal_[x_field], static_cast<Index>(p)) = parameters_[p].start_m;
        }
        if (explicit_.with_strains()) start_strains(state);
        explicit_.soften(state.x, nodal_[x_field], true);
        keep();
    }

    void jump(dynamics::StageSolver& solver, const dynamics::Kinematics& state, double t) {
        if (parameters_.empty()) return;
        const model::BlockPattern& pattern = model_.body->pattern;
        // Derivative of set_jump_force(): force = -dW/dx(x) + ... with x, v and rate changing.
        const dynamics::Stage stage = dynamics::jump_stage(state, t);
        const solver::SymmetricSparse K = solver.hessian(stage, state.x);
        const MatrixXd held = explicit_.residuals(solver, stage, state.x, state.rate, strain_[rate_field],
                                                  nodal_[v_field]);
        nodal_[force_field] = scatter_columns(
            pattern, -solver.stiffness_product(K, stage, state.x, gather_columns(pattern, nodal_[x_field])) - held);
        const double lambda = model_.velocity_force_1_s;
        if (lambda == 0.0) return;
        nodal_[force_field] += lambda * mass_times(nodal_[v_field], solver.mass(t));
        explicit_.add_mass_changes(t, {{lambda, &state.v}}, nodal_[force_field]);
        clear_clamped();
    }

    void step(dynamics::StageSolver& solver, const dynamics::TimeScheme& scheme, double t, double h,
              const std::vector<dynamics::SolvedStage>& solved) {
        if (parameters_.empty()) return;
        const model::Body& body = *model_.body;
        const double middle_s = t + 0.5 * h;  // instant of the mass
        const StepCoefficients step = step_coefficients(scheme, h, step_before_s_, model_.velocity_force_1_s);
        std::vector<model::NodalColumns> solutions(solved.size());
        std::vector<MatrixXd> strains(solved.size());
        // Row of the step map: derivative of a field after the step or of a stage constant.
        const auto nodal_row = [&](int row) {
            FieldTerms plain, through_mass;
            for (int c = 0; c < step.nodal.cols(); ++c) {
                const MatrixXd* field = c < nodal_fields ? &nodal_[static_cast<std::size_t>(c)]
                                                         : &solutions[static_cast<std::size_t>(c - nodal_fields)];
                (is_momentum_row(row) && is_motion_column(c) ? through_mass : plain)
                    .emplace_back(step.nodal(row, c), field);
            }
            model::NodalColumns momentum = mass_times(sum_of(through_mass), solver.mass(middle_s));
            if (is_momentum_row(row)) explicit_.add_mass_changes(middle_s, moved_of(step, row, solved), momentum);
            plain.emplace_back(1.0, &momentum);
            return sum_of(plain);
        };
        // Strains do not involve the mass.
        const auto strain_row = [&](int row) {
            FieldTerms terms;
            for (int c = 0; c < step.strain.cols(); ++c)
                terms.emplace_back(step.strain(row, c), c < strain_fields
                                                            ? &strain_[static_cast<std::size_t>(c)]
                                                            : &strains[static_cast<std::size_t>(c - strain_fields)]);
            return sum_of(terms);
        };

        // Stage velocities depend on motions with the same coefficients as strain rates on strains.
        const auto velocity_row = [&](int row) {
            FieldTerms terms;
            if (!model::depends_on_velocity(model_)) return model::NodalColumns();
            for (int c = 0; c < step.strain.cols(); ++c)
                terms.emplace_back(step.strain(row, c), c < strain_fields
                                                            ? &nodal_[static_cast<std::size_t>(c)]
                                                            : &solutions[static_cast<std::size_t>(c - strain_fields)]);
            return sum_of(terms);
        };

        guesses_.resize(solved.size());
        // Differentiated stage equation: H dx = d constant - explicit change of the residual at fixed x.
        for (std::size_t k = 0; k < solved.size(); ++k) {
            const auto& [stage, solution] = solved[k];
            const VectorXd rate = stage.rate_factor_1_s * solution.strain + stage.rate_history;
            const auto stage_number = static_cast<int>(k);
            MatrixXd B = gather_columns(body.pattern, nodal_row(nodal_fields + stage_number));
            MatrixXd histories = strain_row(strain_fields + stage_number);
            if (model_.creep && histories.size() == 0)
                histories = MatrixXd::Zero(rate.size(), static_cast<Index>(parameters_.size()));
            B -= explicit_.residuals(solver, stage, solution.x, rate, histories,
                                     velocity_row(strain_fields + stage_number));
            const MatrixXd X = solver.solve_linear(solver.hessian(stage, solution.x), stage, solution.x, B,
                                                   guesses_[k].next());
            guesses_[k].add(X);
            solutions[k] = scatter_columns(body.pattern, X);
            if (explicit_.with_strains()) strains[k] = model::strain_tangents(model_, solution.x, solutions[k]);
            if (model_.creep)
                strains[k] = dynamics::with_dashpots(*model_.creep, stage.rate_factor_1_s, strains[k], histories);
            if (explicit_.with_strains()) explicit_.add_strain_changes(stage, solution.x, strains[k]);
        }
        std::array<model::NodalColumns, nodal_fields> nodal;
        std::array<MatrixXd, strain_fields> strain;
        for (int field = 0; field < nodal_fields; ++field) nodal[static_cast<std::size_t>(field)] = nodal_row(field);
        for (int field = 0; field < strain_fields; ++field) strain[static_cast<std::size_t>(field)] = strain_row(field);
        nodal_ = std::move(nodal);
        strain_ = std::move(strain);
        clear_clamped();
        step_before_s_ = step.nodal.row(v_lag_field).any() ? h : 0.0;  // zero for schemes without memory
        explicit_.soften(solved.back().solution.x, nodal_[x_field], false);
        keep();
    }

    /// Stores the state from which the next step starts.
    void reached(const dynamics::Kinematics& state) {
        if (explicit_.change_masses()) before_ = {state.x, state.v, state.v_lag};
    }

    std::vector<NodeTangent> take() { return std::move(kept_); }

private:
    /// Initial guess of the linear solves: extrapolation of the last four solutions with a polynomial, for steps of
    /// equal length.
    struct Guess {
        std::vector<MatrixXd> last;  // latest first
        MatrixXd next() const {
            // Rows: constant, linear, quadratic and cubic extrapolation by one interval.
            constexpr std::array<std::array<double, 4>, 4> weights{
                {{1.0}, {2.0, -1.0}, {3.0, -3.0, 1.0}, {4.0, -6.0, 4.0, -1.0}}};
            if (last.empty()) return {};
            MatrixXd sum = MatrixXd::Zero(last.front().rows(), last.front().cols());
            for (std::size_t k = 0; k < last.size(); ++k) sum += weights[last.size() - 1][k] * last[k];
            return sum;
        }
        void add(MatrixXd X) {
            if (last.size() == 4) last.pop_back();
            last.insert(last.begin(), std::move(X));
        }
    };

    /// Motion fields of the run with their factors in a momentum row.
    ExplicitChanges::MotionTerms moved_of(const StepCoefficients& step, int row,
                                          const std::vector<dynamics::SolvedStage>& solved) const {
        ExplicitChanges::MotionTerms terms;
        for (int c = 0; c < step.nodal.cols(); ++c)
            if (is_motion_column(c))
                terms.emplace_back(step.nodal(row, c),
                                   c < nodal_fields ? &before_[static_cast<std::size_t>(c)]
                                                    : &solved[static_cast<std::size_t>(c - nodal_fields)].solution.x);
        return terms;
    }

    /// Derivative of the start equilibrium. For a softening body the equilibrium is a fixed point (see
    /// solve_equilibrium()), and its derivative is found by the same iteration.
    void rest(dynamics::StageSolver& solver, const dynamics::Kinematics& state) {
        const Matrix3Xd& x = state.x;
        const model::BlockPattern& pattern = model_.body->pattern;
        const dynamics::Stage stage = dynamics::static_stage(*model_.body, 0.0);
        const solver::SymmetricSparse K = solver.hessian(stage, x);
        for (int iteration = 0; iteration < tangent_run_policy.max_softening_rounds; ++iteration) {
            explicit_.soften(x, nodal_[x_field], true);
            const MatrixXd B = -explicit_.residuals(solver, stage, x, state.rate, {}, {});
            const model::NodalColumns before = nodal_[x_field];
            nodal_[x_field] = scatter_columns(pattern, solver.solve_linear(K, stage, x, B));
            // Without softening one solve is exact.
            if (!model_.softening ||
                (nodal_[x_field] - before).norm() <= tangent_run_policy.softening_tolerance * before.norm())
                return;
        }
    }

    /// Derivatives of the start strains and rates, by central differences of the positions and models.
    void start_strains(const dynamics::Kinematics& state) {
        for (MatrixXd* field : {&strain_[strain_field], &strain_[rate_field]})
            *field = MatrixXd::Zero(state.strain.size(), static_cast<Index>(parameters_.size()));
        for (std::size_t p = 0; p < parameters_.size(); ++p) {
            const auto column = static_cast<Index>(p);
            const Matrix3Xd moved = model::nodal_column(nodal_[x_field], column);
            const double most = moved.cwiseAbs().maxCoeff(), size = std::cbrt(model_.body->volume_m3);
            const ModelPair* const pair = explicit_.pair(p);
            const double width = pair         ? pair->width
                                 : most > 0.0 ? tangent_run_policy.start_difference * size / most
                                              : 1.0;
            const auto at = [&](const model::Model& model, double side) {
                dynamics::Kinematics beside;
                beside.x = dynamics::held_by(*model.body, state.x + 0.5 * side * width * moved);
                beside.v = state.v;
                dynamics::set_start_strains(model, options_.start, beside);
                return beside;
            };
            const dynamics::Kinematics over = at(pair ? pair->over : model_, 1.0),
                                       under = at(pair ? pair->under : model_, -1.0);
            strain_[strain_field].col(column) = (over.strain - under.strain) / width;
            strain_[rate_field].col(column) = (over.rate - under.rate) / width;
        }
    }

    /// Held axes of nodes: the mass couples them to free neighbours, but forces on them are reactions and not part of
    /// the state.
    void clear_clamped() {
        for (int i = 0; i < model_.body->node_count(); ++i)
            if (model_.body->clamped[static_cast<std::size_t>(i)] && nodal_[force_field].size() > 0)
                nodal_[force_field].col(i).setZero();
        for (const model::GuidedNode& guided : model_.body->guided)
            for (Index row = 0; row < nodal_[force_field].rows(); ++row)
                if (guided.held[static_cast<std::size_t>(row % 3)]) nodal_[force_field](row, guided.node) = 0.0;
    }

    /// Stores the derivatives of the chosen nodes.
    void keep() {
        for (std::size_t p = 0; p < parameters_.size(); ++p) {
            const auto of_nodes = [&](NodalField field) {
                return Matrix3Xd(model::nodal_column(nodal_[field], static_cast<Index>(p))(Eigen::all, nodes_));
            };
            kept_[p].positions.push_back(of_nodes(x_field));
            kept_[p].velocities.push_back(of_nodes(v_field));
        }
    }

    const model::Model& model_;
    const dynamics::SimulationOptions& options_;
    const std::vector<ModelTangent>& parameters_;
    const std::vector<int>& nodes_;
    ExplicitChanges explicit_;
    std::array<Matrix3Xd, 3> before_;  // x, v and v_lag of the run before a step; used if masses depend on a parameter
    std::array<model::NodalColumns, nodal_fields> nodal_;  // derivatives of the state; empty: zero
    std::array<MatrixXd, strain_fields> strain_;           // one column per parameter; empty: zero
    double step_before_s_ = 0.0;                           // see Kinematics
    std::vector<Guess> guesses_;                           // one per stage of a step
    std::vector<NodeTangent> kept_;
};

}  // namespace

SensitiveTrace simulate_with_tangents(const model::Model& model, const dynamics::SimulationOptions& options,
                                      const std::vector<ModelTangent>& parameters, const std::vector<int>& nodes,
                                      const Progress& progress) {
    TangentFollower follower(model, options, parameters, nodes);
    dynamics::RunObserver observer;
    observer.started = [&](dynamics::StageSolver& solver, const dynamics::Kinematics& state) {
        follower.start(solver, state);
    };
    observer.jumped = [&](dynamics::StageSolver& solver, const dynamics::Kinematics& state, double t) {
        follower.jump(solver, state, t);
    };
    observer.stepped = [&](dynamics::StageSolver& solver, const dynamics::TimeScheme& scheme, double t, double h,
                           const std::vector<dynamics::SolvedStage>& solved) {
        follower.step(solver, scheme, t, h, solved);
    };
    observer.reached = [&](const dynamics::RunPoint& point) { follower.reached(point.state); };
    SensitiveTrace result;
    result.trace = dynamics::simulate(model, options, progress, observer);
    result.tangents = follower.take();
    return result;
}

}  // namespace myo::sensitivity
