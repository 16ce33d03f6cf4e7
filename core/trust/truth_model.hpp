#pragma once

#include "project/prediction.hpp"
#include "trust/synthetic_case.hpp"

namespace myo {

/// The experiment as its truth is simulated: no cell, step or scheme of the diagnosis's defaults.
///
/// Boxes and the L: tet10 (their default is hex8), or hex8_mean_dilatation where they are held deep, for only hexahedra meet that plane; the
/// tail: hex8 that follow its taper (its default is tet10). Edges of 0.7 to 0.75 of the default for that cell, or shorter ones so that a
/// thin body has several layers; steps of its own scheme. A clamp that has slipped ends where it still holds.
/// @param declared  of the case's folder, traces of the right times in it
/// Errors: those of prepare_study.
Result<Study> truth_study(const SyntheticCase& c, const Experiment& declared, const Progress& progress = {});

/// A prepared study with another mesh of the same body. Errors: muscles without cells.
Result<Study> on_mesh(Study study, StudyMesh mesh);

/// What is true, as values of a truth_study().
StudyValues true_values(const SyntheticCase& c, const Study& study);

}  // namespace myo
