#pragma once

#include "prediction/prediction.hpp"
#include "validation/synthetic_case.hpp"

namespace myo::validation {

/// The experiment as its truth is simulated: no cell, step or scheme of the diagnosis's defaults.
///
/// Boxes and the L: tet10 (their default is hex8), or hex8_mean_dilatation where they are held deep, for only hexahedra
/// meet that plane; the tail: hex8 that follow its taper (its default is tet10). Edges of 0.7 to 0.75 of the default
/// for that cell, or shorter ones so that a thin body has several layers; steps of its own scheme. A clamp that has
/// slipped ends where it still holds.
/// @param declared  of the case's folder, traces of the right times in it
/// Errors: those of prepare_setup.
Result<setup::Setup> truth_setup(const SyntheticCase& c, const experiment::Experiment& declared,
                                 const Progress& progress = {});

/// A prepared study with another mesh of the same body. Errors: muscles without cells.
Result<setup::Setup> on_mesh(setup::Setup setup, setup::BodyMesh mesh);

/// What is true, as values of a truth_setup().
prediction::ParameterValues true_values(const SyntheticCase& c, const setup::Setup& setup);

}  // namespace myo::validation
