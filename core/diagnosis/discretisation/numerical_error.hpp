#pragma once

#include <optional>
#include <string>

#include "base/progress.hpp"
#include "base/result.hpp"
#include "diagnosis/diagnosis_policy.hpp"
#include "diagnosis/fit/joint_fit.hpp"

namespace myo::diagnosis {

/// Relative changes of the modulus with which runs on this mesh and on the finer one, with this step and with the finer
/// one, reproduce the limit; see match_modulus().
struct EffectiveModulus {
    double mesh = 0.0, finer_mesh = 0.0;
    double step = 0.0, finer_step = 0.0;

    bool any() const { return mesh != 0.0 || step != 0.0; }
    double factor() const { return 1.0 + mesh + step; }
    double factor_of_finer_mesh() const { return 1.0 + finer_mesh + step; }
    double factor_of_finer_step() const { return 1.0 + mesh + finer_step; }
};

/// Parameter values with which the setup, the run with half the step and the run on finer cells move equally.
struct MatchedValues {
    prediction::ParameterValues setup, finer_step, finer_mesh;
};

/// Numerical error of predictions, from the changes by a finer step and a finer mesh.
struct NumericalError {
    double step_rms_m = 0.0;               // change by half the step, not extrapolated
    double mesh_rms_m = 0.0;               // change by the finer mesh, not extrapolated
    double rest_rms_m = 0.0;               // shift that remains with the effective modulus
    double step_ratio = 0.0;               // fine over coarse
    double mesh_ratio = 0.0;               // of edge lengths, fine over coarse; 0: no finer mesh
    double left_rms_m = 0.0;               // possible error of the extrapolation that the fit cannot compensate, see
                                           // extrapolation_left_m()
    double numerical_damping = 0.0;        // damping ratio that the integrator adds to the first vibration
    std::string message;                   // reason why a part is unknown; empty: none
    PredictionShift shift;                 // extrapolated to zero step and edge, added to predictions; empty: unknown
    PredictionShift step_shift;            // part of the step in `shift`
    PredictionShift mesh_change;           // finer mesh minus mesh
    double mesh_factor = 1.0;              // Richardson factor of mesh_change
    std::optional<MatchedValues> matched;  // values of the runs; empty: equal values in all runs
    EffectiveModulus effective_modulus;    // with which the shift was found
    PredictionShift by_modulus;            // its contribution, removed from the shift, to first order
};

/// Richardson factor of the change by half the step.
double step_extrapolation(const NumericsPolicy& policy);

/// Runs that numerical_error() compares. Refers to values that outlive the call.
struct RefinedRuns {
    const setup::Setup& setup;
    const setup::Setup* refined;                // setup on a finer mesh; null: none
    const MatchedValues& values;                // of the three runs
    const prediction::ParameterValues* fitted;  // to whose predictions the shift applies; null: to values.setup
    const std::vector<std::size_t>& trials;     // those of which a run fails are skipped
    const NumericalError* known;  // with similar values, null: none; its step part is reused if far below the noise
    /// Effective modulus of the setup, whose modulus factor is set accordingly; the refined runs follow it.
    const EffectiveModulus& effective_modulus;
};

/// Runs the trials as they are, with half the step and on the refined setup, all in parallel, and extrapolates both
/// changes by Richardson's rule with their orders. Shifts of other trials stay empty.
/// Source: Roache 1997, Annu. Rev. Fluid Mech. 29, 123.
NumericalError numerical_error(const RefinedRuns& in, const NumericsPolicy& policy, const Progress& progress);

/// finer - coarser of the residuals, per marker 3 x T [m]; 0 where a sample is not compared.
std::vector<Eigen::Matrix3Xd> difference(const prediction::TrialPrediction& finer,
                                         const prediction::TrialPrediction& coarser);

/// sum += factor * tracks; an empty sum is zero.
void add_scaled(const std::vector<Eigen::Matrix3Xd>& tracks, double factor, std::vector<Eigen::Matrix3Xd>& sum);

/// Rms of a shift over all samples of the trials that have one [m].
double shift_rms_m(const PredictionShift& shift);

/// The error with the shifts of trials for which it has none from another one.
NumericalError completed(NumericalError error, const NumericalError& of_other_trials);

/// Possible error of the extrapolation, independent between trials, that the parameters of a fit cannot compensate
/// (they compensate stiffer cells by a lower modulus). Rms over the data [m].
double extrapolation_left_m(const FitData& data, const NumericalError& error, const JointFit& fit,
                            const NumericsPolicy& policy);

}  // namespace myo::diagnosis
