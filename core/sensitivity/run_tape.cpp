#include "sensitivity/run_tape.hpp"

#include <cassert>

#include "sensitivity/step_coefficients.hpp"

namespace myo {

using Eigen::Matrix3Xd;
using Eigen::VectorXd;

void RunTape::record(RunObserver& observer) {
    observer.stepped = [this](StageSolver&, const TimeScheme& scheme, double t, double h, const std::vector<SolvedStage>& solved) {
        TapedStep step{scheme, t, h, {}, {}};
        for (const SolvedStage& s : solved) step.stages.push_back({s.stage.time_s, s.stage.before_jump, s.solution.x});
        steps_.push_back(std::move(step));
    };
    observer.jumped = [this](StageSolver&, const Kinematics& state, double t) {
        if (steps_.empty()) start_ = {t, state};
        else steps_.back().jump_s = t;
    };
    observer.stood = [this](const RunPoint& point) {
        if (step_count() % points_every_ != 0) return;
        points_.push_back(point.state);
        if (with_strains_) return;
        for (VectorXd* strain : {&points_.back().strain, &points_.back().rate, &points_.back().rate_lag}) strain->resize(0);
    };
}

StepRecord RunTape::replay(StageSolver& solver, const TapedStep& step, Kinematics& state) const {
    const Model& model = solver.model();
    StepRecord record;
    record.scheme = step.scheme;
    record.time_s = step.time_s;
    record.h_s = step.h_s;
    const auto solve = [&](Stage& stage, StageSolution& solution) {
        const TapedStage& taped = step.stages[record.solved.size()];
        stage.time_s = taped.time_s;
        stage.before_jump = taped.before_jump;
        solution.x = taped.x;
        record.solved.push_back({stage, {taped.x, {}}});
        if (with_strains_) solution.strain = strains(*model.body, taped.x);
        return true;
    };
    const StepProblem<decltype(solve)> problem{solver.mass(), step.time_s, step.h_s, model.velocity_force_1_s, solve};
    Kinematics next;
    take_step(step.scheme, problem, state, next);
    record.start = std::move(state);
    for (VectorXd* strain : {&record.start.strain, &record.start.rate, &record.start.rate_lag}) strain->resize(0);
    state = std::move(next);
    if (step.jump_s) {
        set_jump_force(solver, *step.jump_s, state);
        record.jump = {*step.jump_s, state};
    }
    return record;
}

std::vector<StepRecord> RunTape::take_last(StageSolver& solver) {
    assert(!steps_.empty());
    const std::size_t first = (steps_.size() - 1) / static_cast<std::size_t>(points_every_) * static_cast<std::size_t>(points_every_);
    points_.resize(first / static_cast<std::size_t>(points_every_) + 1);
    Kinematics state = std::move(points_.back());
    points_.pop_back();
    std::vector<StepRecord> records;
    for (std::size_t k = first; k < steps_.size(); ++k) records.push_back(replay(solver, steps_[k], state));
    steps_.resize(first);
    return records;
}

TapeBytes tape_bytes(const Model& model, const TimeScheme& scheme, bool with_strains) {
    const StepCoefficients steps = step_coefficients(scheme, 1.0, 1.0, 0.0);
    const double nodal = 24.0 * model.body->node_count(), strain = with_strains ? 8.0 * model.body->strain_count() : 0.0;
    const bool remembers = steps.nodal.row(v_lag_field).any();
    const double stages = steps.stages(), fields = remembers ? 5.0 : 3.0;
    return {stages * nodal, fields * nodal + (remembers ? 3.0 : 2.0) * strain, fields * nodal + stages * (2.0 * nodal + strain)};
}

}  // namespace myo
