#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "planning/rivals.hpp"
#include "planning/trial_family.hpp"

namespace myo::planning {

/// How well a trial would tell two rivals apart.
struct RatedTrial {
    PossibleTrial trial;
    double difference_m = 0.0;   // rms between the rivals in this trial after recalibration; of the harder direction
    double noncentrality = 0.0;  // of the test of the wrong rival
    double probability = 0.0;    // with which the wrong rival is rejected
    std::string failure;         // why it could not be run with both; empty: it could
};

/// Trials of a family, the best first.
struct Proposal {
    // Ids of the effects of both; empty: the declared model.
    std::array<std::vector<std::string>, 2> rivals;
    double alpha = 0.0;
    double noise_m = 0.0, numerical_error_m = 0.0;
    std::vector<RatedTrial> trials;
    int runs = 0;
    double seconds = 0.0;

    /// The best trial; null if none could be run.
    const RatedTrial* best() const {
        return trials.empty() || !trials.front().failure.empty() ? nullptr : &trials.front();
    }
};

/// What is proposed. Refers to values that outlive the call.
struct ProposalTask {
    const setup::Setup& setup;  // of the rivals' fits
    const std::array<Rival, 2>& rivals;
    const std::string& declaration;             // text of experiment.toml, to which the trial is added
    const std::filesystem::path& file;          // its path
    experiment::LimitsDeclaration limits = {};  // instead of the declared ones, value by value
    // Rms; empty: DetectionPolicy::numerical_error times the noise.
    std::optional<double> numerical_error_m = {};
    std::optional<std::size_t> most_trials = {};  // of the family, evenly chosen
    PlanningPolicy policy = {};
};

/// The trial of the experiment's family that best tells two rivals apart.
///
/// Each trial is predicted with the values of both. The other rival may then recalibrate everything that its fit had
/// free: by the linear step that best reproduces the prediction, with what the existing trials know of its parameters
/// kept (their Jacobian stands above that of the trial). What is left over noise and numerical error is the
/// noncentrality of the test that rejects it; of the two directions the smaller one counts (T-optimality).
/// Errors: the declaration with the trials cannot be read; cancelled.
/// Source: Atkinson & Fedorov 1975, Biometrika 62, 57.
Result<Proposal> propose_trial(const ProposalTask& task, const Progress& progress);

/// Noncentrality with which a prediction of a new trial contradicts a rival after its linear recalibration.
///
/// @param known       slopes of the existing trials, rows x parameters
/// @param known_blocks  of their rows
/// @param J           slopes of the new trial, N x parameters
/// @param d           difference of both predictions, N [noise levels]
/// @param blocks      of the N rows
/// @param left        receives |d| after recalibration, of the rows of the new trial
double contradiction(const Eigen::MatrixXd& known, const std::vector<ErrorBlock>& known_blocks,
                     const Eigen::MatrixXd& J, const Eigen::VectorXd& d, const std::vector<ErrorBlock>& blocks,
                     double numerical_error, double& left);

}  // namespace myo::planning
