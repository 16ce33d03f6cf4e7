#pragma once

#include <string>
#include <vector>

#include "inverse/least_squares.hpp"
#include "project/run_study.hpp"

namespace myo {

/// The declared fit: what the experiment leaves unknown, from its fit trials.
struct Calibration {
    std::vector<StudyParameter> parameters;
    LeastSquaresReport fit;
    StudyRun before;                       // with the declared values; markers only, no node positions
    StudyRun after;                        // with the fitted values
    double seconds = 0.0;
    bool stopped = false;                  // by the user: trials that had not run by then are missing from before and after
    std::vector<std::string> warnings;

    /// The fit trials are there, before and after. A validation trial may be missing: the runs say why.
    bool usable() const { return fit.usable(); }
};

/// Fits on the fit trials, then predicts the validation trials with the declared and with the fitted values.
///
/// Cancelled, it runs nothing more and gives the best values so far; unusable when no evaluation was complete.
/// names: restricts which material parameters are moved (youngs_modulus, damping); empty: what the experiment says.
Calibration calibrate_study(const Study& study, const std::vector<std::string>& names = {}, const Progress& progress = {});

}  // namespace myo
