#pragma once

#include <optional>
#include <string>

#include "base/progress.hpp"
#include "base/result.hpp"
#include "loop/fit_data.hpp"

namespace myo {

/// How much of a residual is the program's own doing: what a finer step and a finer mesh change in the predictions.
struct NumericalError {
    double step_rms_m = 0.0;            // half the step against the step
    double mesh_rms_m = 0.0;            // the finer mesh against the mesh
    double step_ratio = 0.0;            // finer over coarser
    double mesh_ratio = 0.0;
    double left_rms_m = 0.0;            // of what extrapolation takes off, the share it may be wrong by and a fit cannot take up
    double numerical_damping = 0.0;     // damping ratio that the time scheme adds to the first vibration
    std::string message;                // why a part of it is unknown
    PredictionShift shift;              // extrapolated to zero step and edge, to be added to predictions; empty where unknown
    PredictionShift step_shift;         // the step's part of it
};

/// The study with the same trials on cells of `ratio` times the edge. Errors: those of meshing.
Result<Study> refined_study(const Study& study, double ratio, const Progress& progress);

/// Runs these trials with these values on half the step and on the refined study (null: not on a finer mesh) and extrapolates both by
/// Richardson's rule for second order. Shifts of other trials stay empty.
///
/// @param base   the study's predictions with these values, one per trial of `trials`, with their traces or without; failed ones are left alone
/// @param known  the error with values near these, null: none. What the step changes there is taken over where that is far below the noise
/// Source: Roache 1997, Annu. Rev. Fluid Mech. 29, 123.
NumericalError numerical_error(const Study& study, const Study* refined, const StudyValues& values, const std::vector<std::size_t>& trials,
                               const std::vector<TrialPrediction>& base, const NumericalError* known, const Progress& progress);

/// Takes over the shifts of trials that have none yet.
void complete(NumericalError& error, const NumericalError& of_other_trials);

/// What the extrapolation data.shift may be wrong by, each trial on its own, where parameters of a fit cannot take it up: a stiffer mesh
/// is a lower modulus. Rms over the data [m].
///
/// @param jacobian  N x parameters of the fit
double extrapolation_left_m(const FitData& data, const Eigen::MatrixXd& jacobian);

}  // namespace myo
