#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "dynamics/extrapolation.hpp"
#include "dynamics/simulate.hpp"

namespace myo::dynamics {

/// A step as it was solved.
struct SolvedStep {
    TimeScheme scheme;
    double end_s = 0.0;
    bool jump_at_end = false;
    std::vector<SolvedStage> solved;  // stage and strains only where they are asked for, see Stepper
    StageReport last;                 // of the stage that was solved last
    bool resolved = true;             // all stage solutions were close to the extrapolated motion
    bool taken = false;
    Kinematics next;  // state at the end; valid if taken
};

/// Solves the steps of one run, one after the other. Remembers the motion before, from which the solution of a stage is
/// guessed; restart() forgets it where the motion does not continue smoothly, as at a jump of the loads.
class Stepper {
public:
    /// @param similar  run whose stage solutions are near, see SimulationOptions::warm_start; may be null
    /// @param h_s  length of a step of that run
    /// @param whole_stages  store the stages with their strains and histories, which are large
    /// The solver must outlive the stepper.
    Stepper(StageSolver& solver, std::shared_ptr<const StagePath> similar, double h_s, bool whole_stages);

    /// Discards the prediction history; the motion goes on from x, 3 x n [m].
    void restart(double time_s, const Eigen::Matrix3Xd& x);

    /// Solves the step from `start` without changing it, so that the step can be rejected.
    ///
    /// @param jump_at_end  loads and signals jump at the end: their left limit holds in the step
    /// @param counts  solves are added to its counts and times
    SolvedStep solve(const TimeScheme& scheme, double time_s, const Kinematics& start, double end_s, bool jump_at_end,
                     Trace& counts);

private:
    /// Solution of the similar run at this time; null if there is none.
    const Eigen::Matrix3Xd* similar_at(double time_s) const;
    /// Initial guess: 0 prediction (similar run, extrapolation, or constant velocity), 1 last position, 2 undeformed.
    Eigen::Matrix3Xd guess(int attempt, double stage_s, double time_s, const Kinematics& start, const SolvedStep& step,
                           const std::optional<Eigen::Matrix3Xd>& continued) const;
    bool solve_stage(const Stage& stage, double time_s, const Kinematics& start, SolvedStep& step,
                     StageSolution& solution, Trace& counts);

    StageSolver& solver_;
    std::shared_ptr<const StagePath> similar_;
    double h_s_;
    bool whole_stages_;
    Extrapolation past_;
    Extrapolation difference_;  // history of the difference to the similar run
};

}  // namespace myo::dynamics
