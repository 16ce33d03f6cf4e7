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

/// Start of a run: the undeformed shape, or the static equilibrium under the loads of t = 0.
enum class StartKind { straight, equilibrium };

/// Given start values. Clamped nodes stay at rest whatever is given for them.
struct InitialState {
    Eigen::Matrix3Xd positions;   // 3 x n [m]; empty: as StartKind says
    Eigen::Matrix3Xd velocities;  // 3 x n [m/s]; empty: at rest
};

/// Options of a run.
struct SimulationOptions {
    StartKind start = StartKind::straight;  // creeping body: unstrained or relaxed dashpots, also with
                                            // given initial positions
    InitialState initial;
    TimeScheme integrator;
    double h_s = 0.005;  // length of a step
    double end_s = 1.0;  // the run covers [0, end_s]
    SolverOptions solver;
    int max_iterations = std::numeric_limits<int>::max();  // Newton iterations of the whole run; the run fails
                                                           // when it exceeds them
    std::shared_ptr<const StagePath> warm_start;  // similar run whose stage solutions start ours: fewer iterations,
                                                  // same results within the tolerance
    bool keep_path = false;                       // store the stage solutions in Trace::path, for use as `warm_start`

    /// Given positions take precedence over StartKind::equilibrium.
    bool starts_at_equilibrium() const { return start == StartKind::equilibrium && initial.positions.size() == 0; }
};

/// Outcome of a run.
enum class RunStatus { not_run, complete, cancelled, failed };

/// Result of a run: the start state and the state after every step. A failed or cancelled run keeps the part before.
struct Trace {
    RunStatus status = RunStatus::not_run;
    std::string message;                       // reason of a failure
    std::vector<double> times_s;               // ascending, the start first
    std::vector<Eigen::Matrix3Xd> positions;   // 3 x n [m]
    std::vector<Eigen::Matrix3Xd> velocities;  // 3 x n [m/s]
    int newton_iterations = 0;                 // over all stages
    int linear_iterations = 0;                 // of conjugate gradients
    int factorisations = 0;
    int stages = 0;                   // solved stages, repeated attempts included
    double factor_bytes = 0.0;        // memory of the factor (single precision)
    std::shared_ptr<StagePath> path;  // null unless SimulationOptions::keep_path
    SolverTimes times;

    bool complete() const { return status == RunStatus::complete; }
};

/// State of a run between two steps, sufficient to continue it.
struct RunPoint {
    std::size_t step = 0;  // number of step_ends() reached
    double time_s = 0.0;
    Kinematics state;
    Eigen::VectorXd peak_energy_J_m3;  // per quadrature point, softening bodies only: see raise_peaks()
};

/// Part of a run: from a point (null: the start) until `until_step` of the step_ends() have been reached.
struct RunPart {
    const RunPoint* from = nullptr;
    std::size_t until_step = std::numeric_limits<std::size_t>::max();
    bool keep_motion = true;  // store positions and velocities in the trace
};

/// A stage with its solution, as passed to observers.
struct SolvedStage {
    Stage stage;
    StageSolution solution;
};
/// Callbacks of a run at the start, at jumps and after each step. Sensitivities use them to follow the run.
struct RunObserver {
    std::function<void(StageSolver&, const Kinematics&)> started;           // start state; force not yet set
    std::function<void(StageSolver&, const Kinematics&, double t)> jumped;  // force was recomputed at the jump at t
    std::function<void(StageSolver&, const TimeScheme&, double t, double h, const std::vector<SolvedStage>&)>
        stepped;                                   // a step of length h from t was taken
    std::function<void(const RunPoint&)> reached;  // at the start and after every step, jumps included
};

/// Simulates a model from its start state.
///
/// Steps have length h. They are shortened to end at jumps of loads and signals, and halved once or twice if a stage
/// solve fails or if an unresolved step gains energy that no load supplied. The trace contains all of them.
///
/// Every run starts with virgin cells: only its start state softens them. The first step is one of implicit Euler,
/// which uses no initial force, in two cases: the start state has no finite energy (inverted cells), or the body is
/// viscous and its initial velocities would strain a cell by more than half within the step.
///
/// @param progress  reports simulated time; cancelling ends the run
/// @param observer  callbacks; any may be empty
/// Errors: in Trace::status and Trace::message.
Trace simulate(const model::Model& model, const SimulationOptions& options, const Progress& progress = {},
               const RunObserver& observer = {});

/// Simulates a part of the run of the solver's model. Options and errors as for simulate().
///
/// With a new solver the result is identical to the last bit to that part of the whole run. The cached factor of a used
/// solver changes the result within the solver tolerance.
Trace simulate_part(StageSolver& solver, const SimulationOptions& options, const RunPart& part,
                    const Progress& progress = {}, const RunObserver& observer = {});

/// Recomputes the force of a state from the loads and activations right of a jump.
void set_jump_force(StageSolver& solver, double time_s, Kinematics& state);

/// Stage whose total forces are those after a jump: velocities and strain rates of the state, loads from the right.
Stage jump_stage(const Kinematics& state, double time_s);

}  // namespace myo::dynamics
