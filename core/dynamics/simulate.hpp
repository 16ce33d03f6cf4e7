#pragma once

#include <Eigen/Core>

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "dynamics/integrator.hpp"
#include "dynamics/stage_path.hpp"
#include "model/model.hpp"

namespace myo::dynamics {

enum class StartKind { straight, equilibrium };

/// A start of one's own. Clamped nodes are held at rest, whatever is given for them.
struct InitialState {
    Eigen::Matrix3Xd positions;   // 3 x n [m]; empty: those of the StartKind
    Eigen::Matrix3Xd velocities;  // 3 x n [m/s]; empty: at rest
};

struct SimulationOptions {
    StartKind start = StartKind::straight;  // of a creeping body: unstrained dashpots, or relaxed ones, also at
                                            // positions of one's own
    InitialState initial;
    TimeScheme integrator;
    double h_s = 0.005;
    double end_s = 1.0;  // the run covers [0, end_s]
    SolverOptions solver;
    int most_iterations = std::numeric_limits<int>::max();  // of Newton, over the whole run: one that takes more is
                                                            // given up as failed
    std::shared_ptr<const StagePath>
        near;                // a run that moves nearly alike: saves iterations, changes results within the tolerance
    bool keep_path = false;  // in the trace, for others to be near to

    bool starts_at_equilibrium() const { return start == StartKind::equilibrium && initial.positions.size() == 0; }
};

enum class RunStatus { not_run, complete, cancelled, failed };

/// A run: the state after every step, the start first. Where it failed or was cancelled, what came before is kept.
struct Trace {
    RunStatus status = RunStatus::not_run;
    std::string message;
    std::vector<double> times_s;
    std::vector<Eigen::Matrix3Xd> positions;   // 3 x n [m]
    std::vector<Eigen::Matrix3Xd> velocities;  // 3 x n [m/s]
    int newton_iterations = 0;
    int linear_iterations = 0;
    int factorisations = 0;
    int stages = 0;
    double factor_bytes = 0.0;        // of the factor in single precision
    std::shared_ptr<StagePath> path;  // where it was asked for
    SolverTimes times;

    bool complete() const { return status == RunStatus::complete; }
};

/// Where a run stands between two steps.
struct RunPoint {
    std::size_t step = 0;  // of step_ends(), those reached
    double time_s = 0.0;
    Kinematics state;
    Eigen::VectorXd peak_energy_J_m3;  // per point, of a body that softens: see raise_peaks()
};

/// Part of a run: from a point of it (null: from the start) until so many of step_ends() are reached.
struct RunPart {
    const RunPoint* from = nullptr;
    std::size_t until_step = std::numeric_limits<std::size_t>::max();
    bool keep_motion = true;  // in the trace
};

/// Called by the run: at the start, at jumps and after each step. Lets sensitivities follow the run in lockstep.
struct SolvedStage {
    Stage stage;
    StageSolution solution;
};
struct RunObserver {
    std::function<void(StageSolver&, const Kinematics&)> started;           // the start state; force not yet set
    std::function<void(StageSolver&, const Kinematics&, double t)> jumped;  // force at t was set anew for this state
    std::function<void(StageSolver&, const TimeScheme&, double t, double h, const std::vector<SolvedStage>&)> stepped;
    std::function<void(const RunPoint&)> stood;  // at the start and after every step, jump included
};

/// Runs a model from its start state. Steps are h, shortened where a load or a signal jumps between them, and halved,
/// once or twice, where a step finds no solution or, too long for the motion, gains energy that nothing gave. The trace
/// holds all of them. Every run starts with virgin cells, softened by no more than its start state. A start without an
/// energy, with cells turned inside out, is left by one step of implicit Euler, which needs no force there; so is that
/// of a viscous body whose initial velocities would tear its cells within the step.
Trace simulate(const model::Model& model, const SimulationOptions& options, const Progress& progress = {},
               const RunObserver& observer = {});

/// A part of the run of the solver's model. From the same point and with a solver that has solved nothing yet it is the
/// same to the last bit; what else a solver remembers changes a run within its tolerance.
Trace simulate_part(StageSolver& solver, const SimulationOptions& options, const RunPart& part,
                    const Progress& progress = {}, const RunObserver& observer = {});

/// Sets the force of a state anew from the loads and activations right of a jump.
void set_jump_force(StageSolver& solver, double time_s, Kinematics& state);

/// The stage that gives the forces at a jump: velocities and strain rates as they are, loads from the right.
Stage jump_stage(const Kinematics& state, double time_s);

}  // namespace myo::dynamics
