#pragma once

#include <array>

#include "calibration/calibrate.hpp"

namespace myo::calibration {

/// How the errors of fitted values due to mesh and time step are estimated.
///
/// Measured on twelve bodies (bars, strips, plates, columns, a stub, fingers) whose motions were simulated with another
/// element on finer meshes: errors of the modulus of 0.01 to 2.3 %, in units of these deviations of rms 0.8; of the
/// damping 0.05 to 1.0 %, rms 0.6.
struct NumericalDeviationPolicy {
    /// Edge lengths of the second mesh over those of the setup, in order of preference: the first that can be meshed
    /// and run in time. 2/3 turns two layers into three; tetrahedra may already be finer than requested.
    std::array<double, 3> edges{2.0 / 3.0, 0.45, 1.5};
    double another = 1.1;     // smallest usable ratio of edge lengths
    double mesh_order = 2.0;  // order of the error in the values: thin walls have 3, corners of clamps 1
    /// Least relative error of the modulus at the default edge length: corners of the clamp have a first-order error
    /// that two meshes hardly reveal. Errors of 22 bodies that showed nothing else were 0.1 to 0.95 %, of rms 0.7.
    double min_mesh_error = 0.006;
    double longer_steps = 2.0;   // factor on the time steps of the second run
    int max_runs = 3;            // of all trials per mesh or step
    double settled = 0.3;        // a correction below this share of the total change ends the iteration
    double max_share = 0.6;      // of the calibration's wall-clock time, for all runs ...
    double always_s = 1.0;       // ... but at least this
    double time_exponent = 1.3;  // of run time as a power of the number of unknowns
};
inline constexpr NumericalDeviationPolicy numerical_deviation_policy;

/// Errors of the fitted values due to time step and mesh, by Richardson extrapolation.
///
/// The values are refitted with longer steps, and with these on another mesh, by Gauss-Newton iterations with the
/// Jacobian of the fit, so no derivatives are simulated.
///
/// @param setup     with the time steps that the calibration ended with
/// @param progress  that of the runs
/// Errors: none. A part whose runs fail, take too long or are cancelled is empty, and the message says why.
/// Source: Roache 1997, Annu. Rev. Fluid Mech. 29, 123.
NumericalDeviations numerical_deviations(const setup::Setup& setup, const Calibration& calibration,
                                         const Progress& progress = {},
                                         const NumericalDeviationPolicy& policy = numerical_deviation_policy);

}  // namespace myo::calibration
