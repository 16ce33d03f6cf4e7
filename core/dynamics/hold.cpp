#include "dynamics/hold.hpp"

#include <algorithm>

#include "dynamics/extrapolation.hpp"
#include "dynamics/newton.hpp"
#include "dynamics/statics.hpp"
#include "model/force_element.hpp"

namespace myo::dynamics {
namespace {

using Eigen::Matrix3Xd;

/// Equilibria of a model under any part of its commands. All share one factor.
class CommandPath {
public:
    CommandPath(const model::Model& model, const SolverOptions& options, double time_s, StageReport& report)
        : whole_(model),
          part_(model),
          stage_(static_stage(*model.body, time_s)),
          options_(options),
          constants_(stage_constants(part_)),
          factor_(options.max_factor_entries),
          report_(report) {
        options_.max_newton_iterations = hold_policy.max_iterations;
    }

    /// Newton's method under `part` of the commands; x changes only if it converges.
    ///
    /// @return  number of iterations; 0 if it did not converge
    int solve(double part, Matrix3Xd& x) {
        const SolverOptions options = set(part);
        const StageProblem problem(constants_, stage_, &report_.times);
        Matrix3Xd found = x;
        const int before = report_.newton_iterations;
        if (!mixed_newton(problem, options, problem.force_scale(x, options.tolerance), factor_, found, report_) ||
            !found.allFinite()) {
            factor_.mark_stale();
            return 0;
        }
        x = std::move(found);
        return std::max(1, report_.newton_iterations - before);
    }

    /// Raises the commands in steps from x, the pose without them, as far as there are poses.
    ///
    /// @return  part of the commands that was reached; x is the pose under it
    double follow(Matrix3Xd& x) {
        Extrapolation past;
        past.restart(0.0, x);
        double reached = 0.0, step = hold_policy.first_step;
        while (reached < 1.0) {
            const double next = reached + step > 0.999 ? 1.0 : reached + step;
            Matrix3Xd there = past.parabola_at(next);
            int iterations = solve(next, there);
            if (iterations == 0 && 0.5 * step >= hold_policy.least_step) {
                step *= 0.5;
                continue;
            }
            // The pose may have lost its stability to another one beside it.
            if (iterations == 0 && !fall(next, there = x)) return reached;
            reached = next;
            x = std::move(there);
            past.add(reached, x);
            if (iterations > 0 && iterations <= hold_policy.easy_iterations) step *= hold_policy.growth;
        }
        return reached;
    }

private:
    /// Sets the commands; moduli and masses are those of the whole model, so the constants stay valid.
    SolverOptions set(double part) {
        part_.force_elements = part == 1.0 ? whole_.force_elements
                                           : model::with_constant_commands(whole_, part, stage_.time_s).force_elements;
        SolverOptions options = options_;
        if (part != 1.0) options.tolerance = std::max(options.tolerance, hold_policy.way_tolerance);
        return options;
    }

    /// Descends on the potential to a stable pose under `part` of the commands; returns whether there is one near.
    bool fall(double part, Matrix3Xd& x) {
        const SolverOptions options = set(part);
        const StageProblem problem(constants_, stage_, &report_.times);
        factor_.mark_stale();
        const bool found = energy_newton(problem, options, problem.force_scale(x, options.tolerance), factor_, x,
                                         report_);
        factor_.mark_stale();
        return found && x.allFinite();
    }

    const model::Model& whole_;
    model::Model part_;
    Stage stage_;
    SolverOptions options_;
    StageConstants constants_;
    LaggedFactor factor_;
    StageReport& report_;
};

}  // namespace

StageReport solve_hold(StageSolver& solver, double time_s, const Matrix3Xd* similar, Matrix3Xd& x) {
    const model::Model& model = solver.model();
    // The factors of a softening body depend on its way, which solve_equilibrium() iterates.
    if (model.softening) return solve_equilibrium(solver, time_s, x);
    StageReport report;
    CommandPath path(model, solver.options(), time_s, report);
    Matrix3Xd found = similar ? *similar : x;
    double reached = similar && path.solve(1.0, found) > 0 ? 1.0 : 0.0;
    if (reached == 0.0) {
        found = x;
        if (path.solve(0.0, found) == 0) {
            const StageReport tried = report;
            report = solve_equilibrium(solver, time_s, x);
            add_work(tried, report);
            return report;
        }
        reached = path.follow(found);
    }
    x = std::move(found);
    report.status = reached == 1.0 ? SolveStatus::converged : SolveStatus::not_converged;
    report.message = reached == 1.0 ? std::string()
                                    : collapse_words(model, std::min(1.0, reached + hold_policy.least_step), time_s);
    return report;
}

}  // namespace myo::dynamics
