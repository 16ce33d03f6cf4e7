#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "inverse/least_squares.hpp"
#include "prediction/marker_places.hpp"
#include "prediction/run_trials.hpp"

namespace myo::calibration {

/// One evaluation of a running calibration.
struct CalibrationStep {
    const prediction::ParameterValues& values;
    double cost;   // |r|^2 / 2, residuals in units of the noise; infinite if the model could not be run
    double rms_m;  // over the compared coordinates of the fit trials; NaN if the model could not be run
    /// |J'r| over the parameters in their scales, with the last computed J; NaN before the first one.
    double gradient_norm;
    /// Predictions of the fit trials with traces if this is the best evaluation so far, else null.
    const std::vector<prediction::TrialPrediction>* best;
};

/// Which parameters are fitted and how many starts and evaluations are allowed.
struct CalibrationSettings {
    /// Material parameters to fit (youngs_modulus, damping, those of the law); empty: material.calibrate.
    std::vector<std::string> names;
    std::map<std::string, double> from;  // first start by parameter name, SI; absent: declared value
    int starts = 1;                      // the first is `from`, the others are random, see calibrate()
    std::uint64_t seed = 1;              // of the random starts
    int max_evaluations = inverse::LeastSquaresOptions{}.max_evaluations;  // per start
    /// Called for every evaluation on the caller's thread; may be empty.
    std::function<void(const CalibrationStep&)> evaluated = {};
};

/// Outcome of one start.
struct CalibrationStart {
    inverse::FitStatus status = inverse::FitStatus::not_run;
    std::string message;                         // why the start ended, for people
    Eigen::VectorXd start, values;               // per parameter
    double cost_before = 0.0, cost_after = 0.0;  // see FitIterate; both 0 if nothing could be run
    std::vector<inverse::FitIterate> history;
};

/// Standard deviation of each fitted parameter due to mesh and time step, see numerical_deviations().
struct NumericalDeviations {
    Eigen::VectorXd mesh, step;        // in units of the parameters; empty: unknown
    double motion_noise_levels = 0.0;  // error in the marker motion that a fit does not absorb: rms over noise
    std::string message;               // why a part is unknown; empty if both are known or were not requested
    double seconds = 0.0;              // wall-clock time
};

/// Result of a calibration: the unknowns of the experiment, fitted to its fit trials.
struct Calibration {
    std::vector<prediction::ModelParameter> parameters;
    CalibrationSettings settings;
    inverse::LeastSquaresReport fit;  // of the start with the lowest cost
    std::vector<CalibrationStart> starts;
    std::vector<prediction::FoundPlace> places = {};  // per marker; empty: exact, or nothing was fitted
    NumericalDeviations numerical;                    // set by calibrate_with_chosen_steps()
    int earlier_evaluations = 0;                      // of fits that this one continues
    prediction::SetupRun before;                      // with the declared values; markers only, no node positions
    prediction::SetupRun after;                       // with the fitted values
    double seconds = 0.0;
    bool stopped = false;               // cancelled by the user; trials not run by then are missing in before and after
    std::vector<std::string> warnings;  // readable sentences

    /// Whether fitted values exist, with runs of the fit trials before and after. A validation trial may be missing.
    bool usable() const { return fit.usable(); }
    int evaluations() const;  // over all starts
    /// Standard deviation of a parameter from noise, mesh and step, as far as known; NaN or 0 as in fit.deviations.
    double deviation(std::size_t parameter) const;
    /// Why the data do not determine a parameter, as a clause, see undetermined_reason(); empty if they do.
    std::string undetermined_reason(std::size_t parameter) const;
};

/// Among Calibration::warnings where starts ended apart.
inline constexpr const char* several_minima =
    "starts converged to different values: there are several minima, of which the one with the least cost is given";

/// Fits the unknowns to the fit trials (weighted least squares), then predicts the validation trials with declared
/// and with fitted values.
///
/// Random starts lie within the bounds and three scales of the declared values (Parameter::scale; for parameters over
/// decades a factor of seven). Parameters without influence on the data keep the value of the first start.
/// Errors: none; see Calibration::fit for the status. Cancelled, it returns the best values so far, which are unusable
/// if no evaluation was complete.
Calibration calibrate(const setup::Setup& setup, const CalibrationSettings& settings = {},
                      const Progress& progress = {});

/// calibrate() with time steps suited to the fitted values. If the steps chosen for the declared values are too long
/// for the fitted ones, shorter steps are set in the setup and the fit continues. Steps that are not choosable() are
/// kept. Evaluations of all fits but the last count as earlier ones, unless there were several starts: then the ends of
/// these and of each fit after them are listed. Also sets Calibration::numerical.
///
/// @param setup  receives the final time steps
Calibration calibrate_with_chosen_steps(setup::Setup& setup, CalibrationSettings settings = {},
                                        const Progress& progress = {});

/// State of an earlier calibration, read from its calibrate.json.
struct EarlierCalibration {
    std::map<std::string, double> values;  // by parameter name, SI
    int evaluations = 0;                   // in all
    std::vector<std::string> notes;        // what was written by an earlier version and read differently
};
/// Reads the state of an earlier calibration from calibrate.json.
///
/// @param folder  output folder of the earlier call
/// Errors: the file is missing or is not of the form calibrate/1; its parameters differ from those to be fitted now.
Result<EarlierCalibration> read_calibration(const std::filesystem::path& folder, const setup::Setup& setup,
                                            const CalibrationSettings& settings);

}  // namespace myo::calibration
