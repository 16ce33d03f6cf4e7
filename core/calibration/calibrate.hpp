#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "inverse/least_squares.hpp"
#include "prediction/run_trials.hpp"

namespace myo::calibration {

/// One evaluation of a calibration, while it goes on.
struct CalibrationStep {
    const prediction::ParameterValues& values;
    double cost;   // |r|^2 / 2, residuals in units of the noise; infinite where the model could not be run
    double rms_m;  // over the compared coordinates of the fit trials; NaN likewise
    /// |J'r| of the parameters, each in its scale, with the last J that was worked out; NaN before there is one.
    double gradient_norm;
    /// Where it is the best so far: of the fit trials, in their order, with their traces. Else null.
    const std::vector<prediction::TrialPrediction>* best;
};

struct CalibrationSettings {
    /// Which material parameters are moved (youngs_modulus, damping); empty: what the experiment says.
    std::vector<std::string> names;
    std::map<std::string, double> from;  // where the first start begins, by parameter; absent: as declared
    int starts = 1;                      // the others are random, see calibrate()
    std::uint64_t seed = 1;
    int max_evaluations = inverse::LeastSquaresOptions{}.max_evaluations;  // of each start
    /// Gets every evaluation, on the caller's thread. May be empty.
    std::function<void(const CalibrationStep&)> evaluated = {};
};

/// How one of several starts ended.
struct CalibrationStart {
    inverse::FitStatus status = inverse::FitStatus::not_run;
    std::string message;
    Eigen::VectorXd start, values;               // per parameter
    double cost_before = 0.0, cost_after = 0.0;  // see FitIterate; both 0 where nothing could be run
    std::vector<inverse::FitIterate> history;
};

/// What mesh and time step make wrong in fitted values, one standard deviation per parameter: see
/// numerical_deviations().
struct NumericalDeviations {
    Eigen::VectorXd mesh, step;        // empty: not known
    double motion_noise_levels = 0.0;  // of the markers' motion, what a fit does not take up: rms in noise levels
    std::string message;               // why a part is not known; empty where both are, or nobody asked
    double seconds = 0.0;
};

/// The declared fit: what the experiment leaves unknown, from its fit trials.
struct Calibration {
    std::vector<prediction::ModelParameter> parameters;
    CalibrationSettings settings;
    inverse::LeastSquaresReport fit;  // of the start that ended with the least cost
    std::vector<CalibrationStart> starts;
    NumericalDeviations numerical;  // of calibrate_with_chosen_steps()
    int earlier_evaluations = 0;    // of the calls that this one resumes
    prediction::SetupRun before;    // with the declared values; markers only, no node positions
    prediction::SetupRun after;     // with the fitted values
    double seconds = 0.0;
    bool stopped = false;  // by the user: trials that had not run by then are missing from before and after
    std::vector<std::string> warnings;

    /// The fit trials are there, before and after. A validation trial may be missing: the runs say why.
    bool usable() const { return fit.usable(); }
    int evaluations() const;  // of all starts
    /// Standard deviation of a parameter by noise, mesh and step together, as far as they are known; NaN or 0 as in
    /// fit.deviations.
    double deviation(std::size_t parameter) const;
    /// Why the data do not determine a parameter, as a clause, see undetermined_reason(); empty for one that they
    /// determine.
    std::string undetermined_reason(std::size_t parameter) const;
};

/// Fits on the fit trials, then predicts the validation trials with the declared and with the fitted values.
///
/// Random starts lie within the bounds and three scales of the declared values (Parameter::scale; over decades: a
/// factor of seven), except of parameters without influence on the data, which keep the value of the first start.
/// Cancelled, it runs nothing more and gives the best values so far; unusable when no evaluation was complete.
Calibration calibrate(const setup::Setup& setup, const CalibrationSettings& settings = {},
                      const Progress& progress = {});

/// calibrate() with steps that suit the values it ends with: where those that were chosen for the declared ones
/// are too long by then, shorter ones are set in the setup and the fit goes on from where it was. Steps that are not
/// choosable() stay. The evaluations of fits before the last count as earlier ones.
Calibration calibrate_with_chosen_steps(setup::Setup& setup, CalibrationSettings settings = {},
                                        const Progress& progress = {});

/// Where an earlier call has left off: the values in its calibrate.json.
struct EarlierCalibration {
    std::map<std::string, double> values;  // by parameter
    int evaluations = 0;
};
/// Errors: no such file or not of this form; other parameters than those that would be fitted now.
Result<EarlierCalibration> read_calibration(const std::filesystem::path& folder, const setup::Setup& setup,
                                            const CalibrationSettings& settings);

}  // namespace myo::calibration
