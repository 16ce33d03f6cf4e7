#pragma once

#include <optional>
#include <string>

#include "base/progress.hpp"
#include "base/result.hpp"
#include "diagnosis/fit/joint_fit.hpp"

namespace myo::diagnosis {

/// Relative changes of the modulus that let motions on these cells, and on the finer ones, with this step, and with the
/// finer one, be those of the limit; see match_modulus().
struct EffectiveModulus {
    double mesh = 0.0, finer_mesh = 0.0;
    double step = 0.0, finer_step = 0.0;

    bool any() const { return mesh != 0.0 || step != 0.0; }
    double factor() const { return 1.0 + mesh + step; }
    double factor_of_finer_mesh() const { return 1.0 + finer_mesh + step; }
    double factor_of_finer_step() const { return 1.0 + mesh + finer_step; }
};

/// Values with which a setup moves alike on its cells with its step, with half the step, and on finer cells.
struct MatchedValues {
    prediction::ParameterValues setup, finer_step, finer_mesh;
};

/// How much of a residual is the program's own doing: what a finer step and a finer mesh change in the predictions.
struct NumericalError {
    double step_rms_m = 0.0;  // half the step against the step
    double mesh_rms_m = 0.0;  // the finer mesh against the mesh
    double rest_rms_m = 0.0;  // of the shift, where moduli of .stiffening have taken off most of both
    double step_ratio = 0.0;  // finer over coarser
    double mesh_ratio = 0.0;
    double left_rms_m = 0.0;  // of what extrapolation takes off, the share it may be wrong by and a fit cannot take up
    double numerical_damping = 0.0;  // damping ratio that the time scheme adds to the first vibration
    std::string message;             // why a part of it is unknown
    PredictionShift shift;        // extrapolated to zero step and edge, to be added to predictions; empty where unknown
    PredictionShift step_shift;   // the step's part of it
    PredictionShift mesh_change;  // the finer mesh less the mesh
    double mesh_factor = 1.0;     // from that to its limit
    std::optional<MatchedValues> matched;  // between which the changes were found; none: with the values themselves
    EffectiveModulus effective_modulus;    // with which the shift was found
    PredictionShift by_modulus;            // what that takes off the shift, to first order
};

/// From the change by half the step to its limit.
double step_extrapolation();

/// Runs these trials on half the step and on the refined setup (null: not on a finer mesh) and extrapolates both by
/// Richardson's rule for the order of each. Shifts of other trials stay empty.
///
/// @param base   the setup's predictions with values.setup, one per trial of `trials`, with their traces or without;
/// failed ones are left alone
/// @param refined  gets its modulus factor here
/// @param known  the error with values near these, null: none. What the step changes there is taken over where that is
/// far below the noise
/// @param stiffening  that of the setup, whose modulus factor is set
/// Source: Roache 1997, Annu. Rev. Fluid Mech. 29, 123.
NumericalError numerical_error(const setup::Setup& setup, setup::Setup* refined, const MatchedValues& values,
                               const std::vector<std::size_t>& trials,
                               const std::vector<prediction::TrialPrediction>& base, const NumericalError* known,
                               const EffectiveModulus& effective_modulus, const Progress& progress);

/// finer - coarser of what is compared, per marker; 0 where nothing is.
std::vector<Eigen::Matrix3Xd> difference(const prediction::TrialPrediction& finer,
                                         const prediction::TrialPrediction& coarser);

/// Adds `factor` times the tracks to a sum, which may be empty.
void add_scaled(const std::vector<Eigen::Matrix3Xd>& tracks, double factor, std::vector<Eigen::Matrix3Xd>& sum);

/// Over all samples of the trials that have a shift [m].
double shift_rms_m(const PredictionShift& shift);

/// Takes over the shifts of trials that have none yet.
void complete(NumericalError& error, const NumericalError& of_other_trials);

/// What the error's extrapolation may be wrong by, each trial on its own, where parameters of a fit cannot take it up:
/// a stiffer mesh is a lower modulus. Rms over the data [m].
double extrapolation_left_m(const FitData& data, const NumericalError& error, const JointFit& fit);

}  // namespace myo::diagnosis
