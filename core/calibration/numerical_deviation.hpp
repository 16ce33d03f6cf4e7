#pragma once

#include <array>

#include "calibration/calibrate.hpp"

namespace myo::calibration {

/// How the errors are estimated that mesh and time step make in fitted values.
///
/// Measured on twelve bodies (bars, strips, plates, columns, a stub, fingers) whose motions were made with another
/// element on finer meshes: errors of the modulus of 0.01 to 2.3 %, in units of these deviations of rms 0.8; of the
/// damping 0.05 to 1.0 %, rms 0.6.
struct NumericalDeviationPolicy {
    /// Edges of the other mesh over those of the setup: the first that can be made and afforded. Two layers become
    /// three; tetrahedra may be finer already than they were asked to be.
    std::array<double, 3> edges{2.0 / 3.0, 0.45, 1.5};
    double another = 1.1;     // ratio of the edges of meshes that tell something
    double mesh_order = 2.0;  // of the values' error: thin walls have 3, corners of clamps 1
    /// Least error of the modulus on cells of the default edge length: corners of the clamp err by the first power of
    /// the edge, which two meshes hardly show. Errors of 22 bodies that showed nothing else were 0.1 to 0.95 %, of rms
    /// 0.7.
    double least_mesh_error = 0.006;
    double longer_steps = 2.0;   // times the steps
    int most_runs = 3;           // of all trials on another mesh or with other steps
    double settled = 0.3;        // a correction of so small a share of the whole change ends them
    double most_share = 0.6;     // of the calibration's time, for all of it ...
    double always_s = 1.0;       // ... but no less than this
    double time_exponent = 1.3;  // of a run's time over its unknowns
};
inline constexpr NumericalDeviationPolicy numerical_deviation_policy;

/// What the fitted values would be with longer steps, and on a finer mesh with these, tells their numerical errors, by
/// Richardson's rule. They are found by Gauss-Newton steps with the fit's own Jacobian, from runs without derivatives.
///
/// Where a part cannot be found, because its runs fail, take too long or are cancelled, it is empty and the message is
/// a sentence that says why. Progress is that of the runs.
/// @param setup  with the steps that the calibration ended with
/// Source: Roache 1997, Annu. Rev. Fluid Mech. 29, 123.
NumericalDeviations numerical_deviations(const setup::Setup& setup, const Calibration& calibration,
                                         const Progress& progress = {},
                                         const NumericalDeviationPolicy& policy = numerical_deviation_policy);

}  // namespace myo::calibration
