#include "sensitivity/tangent_run.hpp"

#include "dynamics/statics.hpp"

namespace myo {
namespace {

using Eigen::Matrix3Xd;
using Eigen::VectorXd;

/// Carries d(Kinematics)/d(parameter) along a run.
class TangentFollower {
public:
    TangentFollower(const Model& model, const SimulationOptions& options, const std::vector<ModelTangent>& parameters,
                    const std::vector<int>& nodes)
        : model_(model), options_(options), parameters_(parameters), nodes_(nodes), state_(parameters.size()), kept_(parameters.size()) {}

    void start(StageSolver& solver, const Kinematics& state) {
        const Body& body = *model_.body;
        SymmetricSparse K;
        const Stage stage = static_stage(body, 0.0);
        if (options_.starts_at_equilibrium()) K = solver.hessian(stage, state.x);
        for (std::size_t p = 0; p < parameters_.size(); ++p) {
            Kinematics& d = state_[p];
            d.x = d.v = d.force = Matrix3Xd::Zero(3, body.node_count());
            if (options_.starts_at_equilibrium()) {
                const Matrix3Xd g = gradient_tangent(model_, parameters_[p], state.x, state.rate, 0.0, true) + element_tangent(p, stage, state.x, {});
                d.x = scatter(body.pattern, solver.solve_linear(K, stage, state.x, gather(body.pattern, -g)));
            }
            d.strain = strain_tangent(body, state.x, d.x);
            d.rate = VectorXd::Zero(d.strain.size());
            keep(p);
        }
    }

    void jump(StageSolver& solver, const Kinematics& state, double t) {
        const BlockPattern& pattern = model_.body->pattern;
        const Stage stage = jump_stage(state, t);
        const SymmetricSparse K = solver.hessian(stage, state.x);
        for (std::size_t p = 0; p < parameters_.size(); ++p) {
            Kinematics& d = state_[p];
            Matrix3Xd g = gradient_tangent(model_, parameters_[p], state.x, state.rate, t, false) + element_tangent(p, stage, state.x, d.v);
            if (model_.damping_s > 0.0) g += viscous_gradient(model_, state.x, d.rate);
            const Matrix3Xd velocity_force = model_.velocity_force_1_s * times_mass(d.v, solver.mass());
            d.force = scatter(pattern, -(K.selfadjointView<Eigen::Lower>() * gather(pattern, d.x)) - gather(pattern, g - velocity_force));
        }
    }

    void step(StageSolver& solver, const TimeScheme& scheme, double t, double h, const std::vector<SolvedStage>& solved) {
        const Body& body = *model_.body;
        // Every parameter's step runs up to stage k, leaves its right-hand side there and is run again once all of them are solved
        // together: the passes over matrix and factor are what costs.
        std::vector<std::vector<StageSolution>> d_solved(parameters_.size());
        for (std::size_t k = 0; k < solved.size(); ++k) {
            const Stage& stage = solved[k].stage;
            const StageSolution& solution = solved[k].solution;
            const VectorXd rate = stage.rate_factor_1_s * solution.strain + stage.rate_history;
            Eigen::MatrixXd B(body.pattern.unknowns(), static_cast<Eigen::Index>(parameters_.size()));
            for (std::size_t p = 0; p < parameters_.size(); ++p)
                run_step(solver, scheme, t, h, p, d_solved[p], [&](const Stage& d_stage) {
                    Matrix3Xd g = gradient_tangent(model_, parameters_[p], solution.x, rate, stage.time_s, stage.before_jump);
                    if (model_.damping_s > 0.0) g += viscous_gradient(model_, solution.x, d_stage.rate_history);
                    if (!model_.force_elements.empty()) g += element_tangent(p, stage, solution.x, d_stage.velocity_history);
                    B.col(static_cast<Eigen::Index>(p)) = gather(body.pattern, d_stage.constant - g);
                });
            if (guesses_.size() <= k) guesses_.resize(k + 1);
            const Eigen::MatrixXd X = solver.solve_linear(solver.hessian(stage, solution.x), stage, solution.x, B, guesses_[k].next());
            guesses_[k].add(X);
            for (std::size_t p = 0; p < parameters_.size(); ++p) {
                StageSolution d_solution;
                d_solution.x = scatter(body.pattern, X.col(static_cast<Eigen::Index>(p)));
                d_solution.strain = strain_tangent(body, solution.x, d_solution.x);
                d_solved[p].push_back(std::move(d_solution));
            }
        }
        for (std::size_t p = 0; p < parameters_.size(); ++p) {
            Kinematics next = run_step(solver, scheme, t, h, p, d_solved[p], [](const Stage&) {});
            // The mass couples clamped nodes to their free neighbours; forces on them are reactions.
            for (int i = 0; i < body.node_count(); ++i)
                if (body.clamped[static_cast<std::size_t>(i)]) next.force.col(i).setZero();
            state_[p] = std::move(next);
            keep(p);
        }
    }

    std::vector<NodeTangent> take() { return std::move(kept_); }

private:
    /// Where to start the linear solves: the solutions of the last two steps, continued.
    struct Guess {
        Eigen::MatrixXd last, before_last;
        Eigen::MatrixXd next() const { return before_last.size() > 0 ? Eigen::MatrixXd(2.0 * last - before_last) : last; }
        void add(const Eigen::MatrixXd& X) {
            before_last = std::move(last);
            last = X;
        }
    };

    /// One parameter's step with the stage solutions at hand; at the first stage without one, its derivative goes to `stop`.
    template <class Stop>
    Kinematics run_step(StageSolver& solver, const TimeScheme& scheme, double t, double h, std::size_t p, const std::vector<StageSolution>& d_solved,
                        const Stop& stop) const {
        std::size_t k = 0;
        const auto solve = [&](const Stage& d_stage, StageSolution& d_solution) {
            if (k == d_solved.size()) {
                stop(d_stage);
                return false;
            }
            d_solution = d_solved[k++];
            return true;
        };
        Kinematics next;
        const StepProblem<decltype(solve)> problem{solver.mass(), t, h, model_.velocity_force_1_s, solve};
        take_step(scheme, problem, state_[p], next);
        return next;
    }

    /// What the parameter and a change of the velocities change in the gradient of the force elements.
    Matrix3Xd element_tangent(std::size_t p, const Stage& stage, const Matrix3Xd& x, const Matrix3Xd& dv) const {
        const Matrix3Xd v = stage_velocities(stage, x);
        const ForceState at = force_state(stage, x, v);
        Matrix3Xd g = force_element_tangent(model_, parameters_[p], at);
        if (dv.size() > 0 && depends_on_velocity(model_)) g += velocity_tangent(model_, at, dv);
        return g;
    }

    void keep(std::size_t p) {
        kept_[p].positions.emplace_back(state_[p].x(Eigen::all, nodes_));
        kept_[p].velocities.emplace_back(state_[p].v(Eigen::all, nodes_));
    }

    const Model& model_;
    const SimulationOptions& options_;
    const std::vector<ModelTangent>& parameters_;
    const std::vector<int>& nodes_;
    std::vector<Kinematics> state_;   // derivatives, per parameter
    std::vector<Guess> guesses_;      // per stage of a step
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
