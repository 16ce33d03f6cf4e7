#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

#include "dynamics/simulate.hpp"

namespace myo {

/// A state whose force is set anew at a jump.
struct JumpRecord {
    double time_s = 0.0;
    Kinematics state;
};

/// One step of a run with all that its transposition needs.
struct StepRecord {
    TimeScheme scheme;
    double time_s = 0.0, h_s = 0.0;
    Kinematics start;                    // nodal fields only
    std::vector<SolvedStage> solved;     // their solutions without strain
    std::optional<JumpRecord> jump;      // at the end of the step, if there is one
};

/// The stage solutions of some consecutive steps of a run, and whole states every few steps. The states between are made again by
/// taking the steps with the solutions at hand, which solves nothing and gives the same bits.
class RunTape {
public:
    /// with_strains: rates of strain are followed, too.
    RunTape(int points_every, bool with_strains) : points_every_(points_every), with_strains_(with_strains) {}

    /// Hangs the tape to a run.
    void record(RunObserver& observer);

    /// The start of the run, if the tape begins there.
    const std::optional<JumpRecord>& start() const { return start_; }

    int step_count() const { return static_cast<int>(steps_.size()); }

    /// The last `points_every` steps or fewer, taken off the tape. The solver makes the forces of jumps.
    std::vector<StepRecord> take_last(StageSolver& solver);

private:
    struct TapedStage {
        double time_s;
        bool before_jump;
        Eigen::Matrix3Xd x;
    };
    struct TapedStep {
        TimeScheme scheme;
        double time_s, h_s;
        std::vector<TapedStage> stages;
        std::optional<double> jump_s;
    };
    StepRecord replay(StageSolver& solver, const TapedStep& step, Kinematics& state) const;

    int points_every_;
    bool with_strains_;
    std::optional<JumpRecord> start_;
    std::vector<TapedStep> steps_;
    std::vector<Kinematics> points_;   // before the steps 0, points_every, ...
};

/// What a tape takes [bytes]: per step, and per whole state.
struct TapeBytes {
    double per_step = 0.0;     // of stage solutions
    double per_state = 0.0;
    double per_record = 0.0;   // of StepRecord
};
TapeBytes tape_bytes(const Model& model, const TimeScheme& scheme, bool with_strains);

}  // namespace myo
