#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

#include "dynamics/simulate.hpp"

namespace myo::sensitivity {

/// A state whose force is set anew at a jump.
struct JumpRecord {
    double time_s = 0.0;
    dynamics::Kinematics state;
};

/// One step of a run with all that its transposition needs.
struct StepRecord {
    dynamics::TimeScheme scheme;
    double time_s = 0.0, h_s = 0.0;
    dynamics::Kinematics start;                 // nodal fields only
    std::vector<dynamics::SolvedStage> solved;  // their solutions without strain
    std::optional<JumpRecord> jump;             // at the end of the step, if there is one
};

/// The stage solutions of some consecutive steps of a run, and whole states every few steps. The states between are
/// made again by taking the steps with the solutions at hand, which solves nothing and gives the same bits.
class RunTape {
public:
    /// with_strains: rates of strain are followed, too.
    RunTape(int points_every, bool with_strains) : points_every_(points_every), with_strains_(with_strains) {}

    /// Hangs the tape to a run.
    void record(dynamics::RunObserver& observer);

    /// The start of the run, if the tape begins there.
    const std::optional<JumpRecord>& start() const { return start_; }

    bool empty() const { return blocks_.empty(); }

    /// The last `points_every` steps or fewer, taken off the tape. The solver makes the forces of jumps.
    std::vector<StepRecord> take_last(dynamics::StageSolver& solver);

private:
    struct TapedStage {
        double time_s;
        bool before_jump;
    };
    struct TapedStep {
        dynamics::TimeScheme scheme;
        double time_s, h_s;
        std::vector<TapedStage> stages;
        std::optional<double> jump_s;
    };
    /// Taped steps between two whole states. Their stage positions stand in one array: thousands of small ones that
    /// live long would keep the heap from giving back what lies between them.
    struct Block {
        std::vector<TapedStep> steps;
        std::vector<double> positions;
        dynamics::Kinematics start;
    };
    StepRecord replay(dynamics::StageSolver& solver, const TapedStep& step, const double* positions,
                      dynamics::Kinematics& state) const;

    int points_every_;
    bool with_strains_;
    std::optional<JumpRecord> start_;
    std::vector<Block> blocks_;
};

/// What a tape takes [bytes]: per step, and per whole state.
struct TapeBytes {
    double per_step = 0.0;  // of stage solutions
    double per_state = 0.0;
    double per_record = 0.0;  // of StepRecord
};
TapeBytes tape_bytes(const model::Model& model, const dynamics::TimeScheme& scheme, bool with_strains);

}  // namespace myo::sensitivity
