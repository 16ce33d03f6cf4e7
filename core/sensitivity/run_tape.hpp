#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

#include "dynamics/simulate.hpp"

namespace myo::sensitivity {

/// A state whose force was recomputed at a jump.
struct JumpRecord {
    double time_s = 0.0;
    dynamics::Kinematics state;
    Eigen::VectorXd peak_energy_J_m3;  // softening bodies: the peaks that soften the forces at the jump
};

/// One step of a run with all data that its transposition needs.
struct StepRecord {
    dynamics::TimeScheme scheme;
    double time_s = 0.0, h_s = 0.0;
    dynamics::Kinematics start;                 // nodal fields only
    std::vector<dynamics::SolvedStage> solved;  // stage solutions, without strains
    std::optional<JumpRecord> jump;             // jump at the end of the step, if any
    Eigen::VectorXd peak_energy_J_m3;           // softening bodies: the peaks that soften the step
};

/// Record of consecutive steps: all stage solutions, and whole states every few steps.
///
/// The states in between are reconstructed by repeating the steps with the recorded solutions. This needs no solves and
/// gives identical bits.
class RunTape {
public:
    /// @param points_every  steps between whole states
    /// @param with_strains  whether strain rates are reconstructed as well
    RunTape(int points_every, bool with_strains) : points_every_(points_every), with_strains_(with_strains) {}

    /// Installs the callbacks that record a run.
    void record(dynamics::RunObserver& observer);

    /// Start of the run, if the tape begins there.
    const std::optional<JumpRecord>& start() const { return start_; }

    /// Whether all steps have been taken off.
    bool empty() const { return blocks_.empty(); }

    /// Removes and returns the last block: up to `points_every` steps. The solver computes the forces at jumps.
    std::vector<StepRecord> take_last(dynamics::StageSolver& solver);

private:
    /// Stage data that cannot be recomputed: loads are evaluated at this time and side.
    struct TapedStage {
        double time_s;
        bool before_jump;
    };
    struct TapedStep {
        dynamics::TimeScheme scheme;
        double time_s, h_s;
        std::vector<TapedStage> stages;
        std::optional<double> jump_s;  // time of the jump at the end, if any
    };
    /// Recorded steps between two whole states. All stage positions share one array: thousands of small, long-lived
    /// allocations would prevent the heap from releasing the memory between them.
    struct Block {
        std::vector<TapedStep> steps;
        std::vector<double> positions;  // 3 n values per stage, in order
        dynamics::Kinematics start;     // state before the first step
        Eigen::VectorXd peak;           // softening bodies: peak energies there
    };
    StepRecord replay(dynamics::StageSolver& solver, const TapedStep& step, const double* positions,
                      dynamics::Kinematics& state, Eigen::VectorXd& peak) const;

    int points_every_;
    bool with_strains_;
    std::optional<JumpRecord> start_;
    std::vector<Block> blocks_;
};

/// Memory of a tape [bytes].
struct TapeBytes {
    double per_step = 0.0;    // stage solutions of a step
    double per_state = 0.0;   // one whole state
    double per_record = 0.0;  // one StepRecord
};
/// Memory of a tape for a model and scheme. `with_strains`: as for RunTape.
TapeBytes tape_bytes(const model::Model& model, const dynamics::TimeScheme& scheme, bool with_strains);

}  // namespace myo::sensitivity
