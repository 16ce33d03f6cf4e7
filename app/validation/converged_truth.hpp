#pragma once

#include <vector>

#include "base/progress.hpp"
#include "prediction/prediction.hpp"
#include "validation/synthetic_case.hpp"

namespace myo::validation {

/// Criteria for a converged truth. Shares and aspects have no unit.
struct ConvergencePolicy {
    double max_change = 3e-3;  // of the first frequencies by the last refinement
    /// Change of the path by extrapolation over the step, as a share of the motion's rms: with phase errors d and d/4
    /// the extrapolated path errs by d^2/8, 0.3 % if the phase error grows uniformly.
    double max_path_change = 0.03;
    double coarse_enough = 1e-3;   // change of the frequencies below which the coarser of the last two meshes suffices
    double mesh_order = 2.0;       // order of the frequency error
    int frequencies = 2;           // bending in both planes, or torsion of a plate
    int first_layers_of_tets = 2;  // through the thickness, increased by two per refinement
    int first_layers_of_hexes = 4;
    int max_layers = 8;              // limit of the refinement
    double length_aspect = 2.5;      // of cells: length over thickness
    double width_aspect = 2.0;       // width over thickness
    double steps_per_period = 40.0;  // of the first vibration, for the longest step
    int max_halvings = 3;            // of the time step
};
inline constexpr ConvergencePolicy convergence_policy;

/// Motions that no longer depend on mesh and time step.
struct ConvergedTruth {
    std::vector<std::vector<Eigen::Matrix3Xd>> positions_m;  // per trial and marker, 3 x samples, mesh frame
    int dofs = 0;                                            // of the mesh used
    double frequency_Hz = 0.0;                               // first natural frequency of the straight body
    double modulus_factor = 1.0;    // factor on the modulus that gives these cells the extrapolated frequency
    double frequency_change = 0.0;  // largest relative change of the first frequencies by the last refinement
    double path_change = 0.0;       // relative change of the finer path by extrapolation over the step
};

/// True motions of a case, by another element than the default for its body: tet10 in boxes, hex8 that follow the taper
/// in fingers. The frequency is extrapolated from the last two meshes (Richardson), and the mesh runs with the modulus
/// that gives it this frequency. Positions are extrapolated from the last two time steps.
///
/// @param experiment  read from the folder of the true experiment, whose traces have the right times
/// Errors: those of prepare_setup; a trial that does not run; no convergence; cancelled.
Result<ConvergedTruth> converged_truth(const SyntheticCase& c, const experiment::Experiment& experiment,
                                       const Progress& progress = {});

}  // namespace myo::validation
