#pragma once

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "inverse/actuation_signals.hpp"
#include "inverse/best_placement.hpp"
#include "inverse/least_squares.hpp"
#include "inverse/marker_target.hpp"

namespace myo::inverse {

/// Signals that make the markers of a model follow a target.
struct ActuationProblem {
    model::Model model;  // its activation is replaced
    dynamics::SimulationOptions options;
    MarkerTarget target;
    SoughtSignals sought;
    /// So many metres of rms error a signal that changes by 1 per second is worth: loss = mean square residual +
    /// (smoothness)^2 times the mean square rate of the signals.
    double smoothness_m_s = 1e-4;
    /// How the cameras stand is sought within these, too: the target is then placed best for every motion. Empty: it
    /// stands as it does.
    std::optional<PlacementBounds> placement_bounds;
};

/// The loss at some values.
struct ActuationEvaluation {
    dynamics::RunStatus status = dynamics::RunStatus::not_run;
    std::string message;
    double loss_m2 = 0.0;
    double rms_m = 0.0;              // of the residuals alone
    MarkerPlacement placement;       // of the target
    Eigen::MatrixXd gradient;        // signals x knots [m2]
    sensitivity::NodeMotion motion;  // of the markers' nodes
    int steps = 0;

    bool ok() const { return status == dynamics::RunStatus::complete; }
};
ActuationEvaluation evaluate_actuation(const ActuationProblem& problem, const Eigen::MatrixXd& values,
                                       const Progress& progress = {});

/// A line of the log.
struct ActuationIterate {
    bool ok = false;  // false: the model could not be run there
    double loss_m2 = 0.0;
    double rms_m = 0.0;
    double gradient_norm_m2 = 0.0;  // of the part that the bounds do not stop
    double seconds = 0.0;           // of the evaluation
};

struct ActuationFit;

struct ActuationFitOptions {
    int max_evaluations = 100;
    /// Of the loss in an iteration, below which it has converged. A thirtieth of it lowered the rms error of a noisy
    /// trace by 0.15 %, for a third as many evaluations again.
    double relative_decrease = 3e-4;
    /// A start whose loss is at most the square of this is what is sought: the search ends there. 0: it goes on.
    double met_rms_m = 0.0;
    /// Gets what is known after every evaluation, on the search's thread. May be empty.
    std::function<void(const ActuationFit&)> evaluated = {};
};

struct ActuationFit {
    FitStatus status = FitStatus::not_run;
    std::string message;
    Eigen::MatrixXd start, values;  // signals x knots; values: of the evaluation with the least loss
    ActuationEvaluation first, best;
    double gradient_norm_m2 = 0.0;      // at the best
    std::vector<ActuationIterate> log;  // every evaluation, in order
    double seconds = 0.0;

    bool converged() const { return status == FitStatus::converged; }
    /// There are values of at least one evaluation, though the fit may have been stopped or not have converged.
    bool usable() const { return first.ok(); }
};

/// Minimises the loss within the bounds, by NLopt's limited-memory quasi-Newton method on the exact gradient of the run
/// (Luksan's variable metric; Liu & Nocedal 1989), one run forwards and backwards per evaluation. It took 34 where MMA
/// took more than 100 (two antagonists, 80 values).
///
/// Cancelled or not converged, it gives the best values so far; failed: the model could not be run at the start. Where
/// it cannot be run elsewhere the search steps back. Progress counts evaluations, with the running one as a fraction.
/// Asserts that something is sought.
ActuationFit fit_actuation(const ActuationProblem& problem, const Eigen::MatrixXd& start,
                           const ActuationFitOptions& options = {}, const Progress& progress = {});

}  // namespace myo::inverse
