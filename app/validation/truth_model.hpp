#pragma once

#include "prediction/prediction.hpp"
#include "validation/synthetic_case.hpp"

namespace myo::validation {

/// The experiment as its truth is simulated: other cells, steps and scheme than the defaults of the diagnosis.
///
/// Boxes and the L: tet10 (default hex8), or hex8_mean_dilatation if clamped deep, as only hexahedra conform to that
/// plane. Tail: hex8 that follow the taper (default tet10). Edges of 0.7 to 0.75 of the default for that cell, or
/// shorter so that a thin body has several layers; steps of its own scheme. A slipped clamp ends where it still holds.
///
/// @param declared  read from the folder of the case, whose traces have the right times
/// Errors: those of prepare_setup.
Result<setup::Setup> truth_setup(const SyntheticCase& c, const experiment::Experiment& declared,
                                 const Progress& progress = {});

/// A setup with another mesh of the same body: body, markers, fibres, moduli and loads belong to it. Force elements
/// such as those of a tendon stay on the former mesh, so the experiment must have none.
///
/// Errors: muscles without cells.
Result<setup::Setup> on_mesh(setup::Setup setup, setup::BodyMesh mesh);

/// True parameter values for a truth_setup(), the effect of the case among them unless it is part of the mesh.
prediction::ParameterValues true_values(const SyntheticCase& c, const setup::Setup& setup);

}  // namespace myo::validation
