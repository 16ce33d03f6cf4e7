#include "sensitivity/run_tape.hpp"

#include <cassert>

#include "dynamics/creep.hpp"
#include "dynamics/softening.hpp"
#include "sensitivity/softening_adjoint.hpp"
#include "sensitivity/step_coefficients.hpp"

namespace myo::sensitivity {

using Eigen::Matrix3Xd;
using Eigen::VectorXd;

void RunTape::record(dynamics::RunObserver& observer) {
    observer.stepped = [this](dynamics::StageSolver&, const dynamics::TimeScheme& scheme, double t, double h,
                              const std::vector<dynamics::SolvedStage>& solved) {
        Block& block = blocks_.back();
        block.steps.push_back({scheme, t, h, {}, {}});
        const auto size = static_cast<std::size_t>(solved.front().solution.x.size());
        // One reservation per block avoids reallocation of large arrays during the run.
        if (block.positions.empty())
            block.positions.reserve(static_cast<std::size_t>(points_every_) * solved.size() * size);
        for (const dynamics::SolvedStage& s : solved) {
            block.steps.back().stages.push_back({s.stage.time_s, s.stage.before_jump});
            block.positions.insert(block.positions.end(), s.solution.x.data(), s.solution.x.data() + size);
        }
    };
    observer.jumped = [this](dynamics::StageSolver& solver, const dynamics::Kinematics& state, double t) {
        if (blocks_.empty()) {
            start_ = {t, state, {}};
            if (solver.model().softening) dynamics::raise_peaks(solver.model(), state.x, start_->peak_energy_J_m3);
        } else {
            blocks_.back().steps.back().jump_s = t;
        }
    };
    observer.reached = [this](const dynamics::RunPoint& point) {
        // A new block starts with a whole state once the current block is full.
        if (!blocks_.empty() && static_cast<int>(blocks_.back().steps.size()) < points_every_) return;
        blocks_.push_back({{}, {}, point.state, point.peak_energy_J_m3});
        if (with_strains_) return;
        dynamics::Kinematics& start = blocks_.back().start;
        // Strains act through viscous forces only; without damping they need no memory.
        for (VectorXd* strain : {&start.strain, &start.rate, &start.rate_lag}) strain->resize(0);
    };
}

StepRecord RunTape::replay(dynamics::StageSolver& solver, const TapedStep& step, const double* positions,
                           dynamics::Kinematics& state, VectorXd& peak) const {
    const model::Model& model = solver.model();
    StepRecord record;
    record.scheme = step.scheme;
    record.time_s = step.time_s;
    record.h_s = step.h_s;
    record.peak_energy_J_m3 = peak;
    // Repeats the step with recorded stage solutions in place of solves.
    const auto solve = [&](dynamics::Stage& stage, dynamics::StageSolution& solution) {
        const TapedStage& taped = step.stages[record.solved.size()];
        stage.time_s = taped.time_s;
        stage.before_jump = taped.before_jump;
        solution.x = Eigen::Map<const Matrix3Xd>(
            positions + static_cast<Eigen::Index>(record.solved.size()) * state.x.size(), 3, state.x.cols());
        record.solved.push_back({stage, {solution.x, {}}});
        if (with_strains_) solution.strain = model::strains(model, solution.x);
        if (model.creep)
            solution.strain = dynamics::with_dashpots(*model.creep, stage.rate_factor_1_s, solution.strain,
                                                      stage.rate_history);
        return true;
    };
    const dynamics::StepProblem<decltype(solve)> problem{solver.mass(step.time_s + 0.5 * step.h_s), step.time_s,
                                                         step.h_s, model.velocity_force_1_s, solve};
    dynamics::Kinematics next;
    dynamics::take_step(step.scheme, problem, state, next);
    record.start = std::move(state);  // state before the step; strains are not needed by the transposition
    for (VectorXd* strain : {&record.start.strain, &record.start.rate, &record.start.rate_lag}) strain->resize(0);
    state = std::move(next);
    if (model.softening) dynamics::raise_peaks(model, state.x, peak);
    if (step.jump_s) {
        if (model.softening) PeakAdjoint::soften(solver, peak);
        dynamics::set_jump_force(solver, *step.jump_s, state);
        record.jump = {*step.jump_s, state, peak};
    }
    return record;
}

std::vector<StepRecord> RunTape::take_last(dynamics::StageSolver& solver) {
    assert(!empty());
    Block block = std::move(blocks_.back());
    blocks_.pop_back();
    dynamics::Kinematics state = block.start;
    const double* positions = block.positions.data();
    std::vector<StepRecord> records;
    for (const TapedStep& step : block.steps) {
        records.push_back(replay(solver, step, positions, state, block.peak));
        positions += static_cast<std::ptrdiff_t>(step.stages.size()) * state.x.size();
    }
    return records;
}

TapeBytes tape_bytes(const model::Model& model, const dynamics::TimeScheme& scheme, bool with_strains) {
    // Multi-step schemes store v_lag, force_lag and rate_lag besides x, v, force, strain and rate.
    // A scheme has memory if the row of v_lag is not zero.
    const StepCoefficients steps = step_coefficients(scheme, 1.0, 1.0, 0.0);
    // 3 doubles per node, 1 double per strain measure.
    const double nodal = 24.0 * model.body->node_count(),
                 strain = with_strains ? (model.creep ? 16.0 : 8.0) * model.body->strain_count() : 0.0,
                 peaks = model.softening ? 8.0 * model.body->point_count() : 0.0;
    const bool remembers = steps.nodal.row(v_lag_field).any();
    const double stages = steps.stages(), fields = remembers ? 5.0 : 3.0;
    return {stages * nodal, fields * nodal + (remembers ? 3.0 : 2.0) * strain + peaks,
            fields * nodal + stages * (3.0 * nodal + strain) + peaks};
}

}  // namespace myo::sensitivity
