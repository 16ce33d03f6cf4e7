#pragma once

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/progress.hpp"
#include "inverse/acting_signals.hpp"
#include "inverse/actuation_signals.hpp"
#include "inverse/best_placement.hpp"
#include "inverse/design.hpp"
#include "inverse/least_squares.hpp"
#include "inverse/marker_target.hpp"

namespace myo::inverse {

/// Inverse problem: find signals, and values of design variables, such that the markers of a model follow a target.
struct ActuationProblem {
    model::Model model;  // its activation and the commands of its first force elements are replaced
    dynamics::SimulationOptions options;
    MarkerTarget target;
    SoughtSignals sought;
    ActingSignals acting{};  // what the actuators make of the sought signals
    /// Weight of the smoothness: loss = mean square residual + (smoothness)^2 times the mean square rate of the
    /// signals over their scales. A rate of one scale per second costs as much as this rms error.
    double smoothness_m_s = 1e-4;
    /// If set, the placement of the target (camera frame) is optimised for every motion within these bounds. Otherwise
    /// the placement of the target is used.
    std::optional<PlacementBounds> placement_bounds;
    Design design{};  // what is sought of the body; may be empty, as may be the sought signals
    /// Weight of the roughness of the design: loss gains (design_smoothness)^2 times design_roughness().
    double design_smoothness_m = 1e-4;
};

/// Loss and gradient at given values.
struct ActuationEvaluation {
    dynamics::RunStatus status = dynamics::RunStatus::not_run;
    std::string message;
    double loss_m2 = 0.0;
    double rms_m = 0.0;               // root mean square of the residuals, without smoothness
    MarkerPlacement placement;        // of the target: given or optimised
    Eigen::MatrixXd gradient;         // signals x knots [m2 per unit of the signal]
    Eigen::VectorXd design_gradient;  // per value of the design [m2]
    sensitivity::NodeMotion motion;   // of the marker nodes
    int steps = 0;                    // of the run

    /// Whether the run completed and loss and gradient are finite.
    bool ok() const { return status == dynamics::RunStatus::complete; }
};
/// Runs the model forwards and backwards.
///
/// @param values  signals x knots
/// @param design  values of problem.design
ActuationEvaluation evaluate_actuation(const ActuationProblem& problem, const Eigen::MatrixXd& values,
                                       const Eigen::VectorXd& design, const Progress& progress = {});
/// Runs the model with the declared design, see above.
ActuationEvaluation evaluate_actuation(const ActuationProblem& problem, const Eigen::MatrixXd& values,
                                       const Progress& progress = {});

/// One line of the optimisation log.
struct ActuationIterate {
    bool ok = false;  // false: the run failed at these values
    double loss_m2 = 0.0;
    double rms_m = 0.0;
    double gradient_norm_m2 = 0.0;  // of the projected gradient by values over their scales: without components that
                                    // the bounds block
    double seconds = 0.0;           // duration of the evaluation
};

struct ActuationFit;

/// Options of fit_actuation().
struct ActuationFitOptions {
    int max_evaluations = 100;
    /// Convergence criterion: relative decrease of the loss per iteration. With a thirtieth of this value the rms error
    /// of a noisy trace decreased by 0.15 %, for a third more evaluations.
    double relative_decrease = 3e-4;
    /// If the rms error at the start is at most this, the start is accepted without search. 0: always search.
    double met_rms_m = 0.0;
    /// Called with the present state after every evaluation, on the thread of the search. May be empty.
    std::function<void(const ActuationFit&)> evaluated = {};
};

/// Result of fit_actuation().
struct ActuationFit {
    FitStatus status = FitStatus::not_run;
    std::string message;
    Eigen::MatrixXd start, values;      // signals x knots; `values` has the least loss
    Eigen::VectorXd design;             // values of problem.design with the least loss
    ActuationEvaluation first, best;    // evaluations at the start and at `values`
    double gradient_norm_m2 = 0.0;      // projected, at `values`
    std::vector<ActuationIterate> log;  // every evaluation, in order
    double seconds = 0.0;

    /// Whether the convergence criterion was met.
    bool converged() const { return status == FitStatus::converged; }
    /// Whether at least one evaluation succeeded. The fit may have been stopped or not have converged.
    bool usable() const { return first.ok(); }
};

/// Values at which a search starts.
struct ActuationStart {
    Eigen::MatrixXd values;       // signals x knots
    Eigen::VectorXd design = {};  // values of the design; empty: as declared

    ActuationStart(Eigen::MatrixXd signals, Eigen::VectorXd body = {})
        : values(std::move(signals)), design(std::move(body)) {}
};

/// Minimises the loss within the bounds.
///
/// Uses the limited-memory quasi-Newton method of NLopt (Luksan's variable metric; Liu & Nocedal 1989) with the exact
/// gradient; each evaluation is one run forwards and backwards. It needed 34 evaluations where MMA needed more than 100
/// (two antagonists, 80 values). If the model cannot be run at some values, the search retreats.
///
/// @param start  moved into the bounds
/// Errors: cancelled or not_converged with the best values so far; failed if the run fails at the start. Asserts that
/// the problem has values and a target. Progress counts evaluations, the running one as a fraction.
ActuationFit fit_actuation(const ActuationProblem& problem, const ActuationStart& start,
                           const ActuationFitOptions& options = {}, const Progress& progress = {});

}  // namespace myo::inverse
