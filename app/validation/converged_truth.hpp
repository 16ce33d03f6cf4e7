#pragma once

#include <vector>

#include "base/progress.hpp"
#include "prediction/prediction.hpp"
#include "validation/synthetic_case.hpp"

namespace myo::validation {

/// When a truth is called converged.
struct ConvergencePolicy {
    double most_change = 3e-3;  // of the first frequencies by the last refinement of the mesh
    /// Change of the path by extrapolation over the step, as a share of the motion's rms: with phases that differ by d
    /// and d/4 the extrapolated path errs by d^2/8, 0.3 % where the phase error grows evenly.
    double most_path_change = 0.03;
    double coarse_enough = 1e-3;   // change of the frequencies, below which the coarser of the last two meshes does
    double mesh_order = 2.0;       // of the frequencies' error
    int frequencies = 2;           // bending in both planes, or the twist of a plate
    int first_layers_of_tets = 2;  // across the thickness: so many, and two more each time
    int first_layers_of_hexes = 4;
    int most_layers = 8;
    double length_aspect = 2.5;  // of cells, along the body over across it
    double width_aspect = 2.0;
    double steps_per_period = 40.0;  // of the first vibration, of the longest step
    int most_halvings = 3;           // of the step
};
inline constexpr ConvergencePolicy convergence_policy;

/// Motions that no longer change with mesh and step.
struct ConvergedTruth {
    std::vector<std::vector<Eigen::Matrix3Xd>> positions_m;  // per trial and marker 3 x samples, mesh frame
    int dofs = 0;
    double frequency_Hz = 0.0;      // of the first vibration about the straight body
    double modulus_factor = 1.0;    // with which these cells vibrate as infinitely small ones
    double frequency_change = 0.0;  // by the last refinement of the mesh, of the first ones the largest
    double path_change = 0.0;       // by which extrapolation over the step moves the finer path
};

/// The motions of a case as it truly is, by another element than its experiment's default: tet10 in boxes, hex8 that
/// follow the taper in fingers. Frequencies are extrapolated from the last two meshes by Richardson's rule: the mesh
/// moves with the modulus that gives it the first one. Positions are extrapolated from the last two steps.
///
/// @param experiment  of the folder of the true experiment, traces of the right times in it
/// Errors: those of prepare_setup; a trial that does not run; numbers that do not settle; cancelled.
Result<ConvergedTruth> converged_truth(const SyntheticCase& c, const experiment::Experiment& experiment,
                                       const Progress& progress = {});

}  // namespace myo::validation
