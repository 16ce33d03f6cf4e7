#include "dynamics/stepper.hpp"

#include <cmath>
#include <utility>

#include "dynamics/creep.hpp"
#include "dynamics/start_state.hpp"
#include "dynamics/undeformed.hpp"

namespace myo::dynamics {

using Eigen::Matrix3Xd;

Stepper::Stepper(StageSolver& solver, std::shared_ptr<const StagePath> similar, double h_s, bool whole_stages)
    : solver_(solver), similar_(std::move(similar)), h_s_(h_s), whole_stages_(whole_stages) {}

const Matrix3Xd* Stepper::similar_at(double time_s) const { return similar_ ? similar_->at(time_s, h_s_) : nullptr; }

void Stepper::restart(double time_s, const Matrix3Xd& x) {
    past_.restart(time_s, x);
    difference_.clear();
    if (const Matrix3Xd* similar = similar_at(time_s)) difference_.add(time_s, x - *similar);
}

SolvedStep Stepper::solve(const TimeScheme& scheme, double time_s, const Kinematics& start, double end_s,
                          bool jump_at_end, Trace& counts) {
    SolvedStep step;
    step.scheme = scheme;
    step.end_s = end_s;
    step.jump_at_end = jump_at_end;
    const double h = end_s - time_s;
    const auto solve = [&](Stage& stage, StageSolution& solution) {
        // Exact comparison with the end is needed below; stage times carry rounding.
        if (std::abs(stage.time_s - end_s) < 1e-9 * h) stage.time_s = end_s;
        stage.before_jump = jump_at_end && stage.time_s == end_s;
        return solve_stage(stage, time_s, start, step, solution, counts);
    };
    const StepProblem<decltype(solve)> problem{solver_.mass(time_s + 0.5 * h), time_s, h,
                                               solver_.model().velocity_force_1_s, solve};
    step.taken = take_step(step.scheme, problem, start, step.next) && step.next.v.allFinite();
    return step;
}

Matrix3Xd Stepper::guess(int attempt, double stage_s, double time_s, const Kinematics& start, const SolvedStep& step,
                         const std::optional<Matrix3Xd>& continued) const {
    if (attempt == 1) return start.x;
    if (attempt == 2) return undeformed_near(*solver_.model().body, start.x);
    if (const Matrix3Xd* similar = similar_at(stage_s); similar && difference_.known())
        return *similar + difference_.parabola_at(stage_s);
    if (continued) return *continued;
    return step.solved.empty() ? Matrix3Xd(start.x + (stage_s - time_s) * start.v) : step.solved.back().solution.x;
}

bool Stepper::solve_stage(const Stage& stage, double time_s, const Kinematics& start, SolvedStep& step,
                          StageSolution& solution, Trace& counts) {
    const model::Model& model = solver_.model();
    const std::optional<Matrix3Xd> continued = past_.at(stage.time_s);
    const auto solve = [&]() {
        step.last = solver_.solve(stage, solution.x);
        count(step.last, counts);
        return step.last.ok();
    };
    // A poor prediction may contain inverted cells; the fallbacks are the last position and the undeformed body. The
    // force scale is taken at the guess: for a distant guess it is large and the relative residual is lenient, so the
    // last attempt is solved twice.
    bool found = false;
    for (int attempt = 0; attempt < 3 && !found; ++attempt) {
        solution.x = held_by(*model.body, guess(attempt, stage.time_s, time_s, start, step, continued));
        found = solve() && (attempt < 2 || solve());
    }
    if (!found) return false;
    // Resolved: the prediction error is less than 10 % of the displacement since the start of the step.
    step.resolved = step.resolved && continued &&
                    (solution.x - *continued).norm() < 0.1 * (solution.x - start.x).norm();
    solution.strain = model::strains(model, solution.x);
    if (model.creep)
        solution.strain = with_dashpots(*model.creep, stage.rate_factor_1_s, solution.strain, stage.rate_history);
    past_.add(stage.time_s, solution.x);
    if (const Matrix3Xd* similar = similar_at(stage.time_s))
        difference_.add(stage.time_s, solution.x - *similar);
    else
        difference_.clear();
    SolvedStage& solved = step.solved.emplace_back();
    if (whole_stages_) {
        solved = {stage, solution};
    } else {
        solved.stage.time_s = stage.time_s;
        solved.solution.x = solution.x;
    }
    return true;
}

}  // namespace myo::dynamics
