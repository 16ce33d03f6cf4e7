#pragma once

#include <vector>

#include "model/force_element.hpp"

namespace myo::model {

/// Elastic foundation under part of the surface with equal normal and tangential stiffness: traction -k (x - X) per
/// rest area.
///
/// @param faces               boundary faces on the foundation; their nodes must not be clamped
/// @param stiffness_Pa_per_m  k > 0; the only parameter
/// Source: Winkler's foundation (Timoshenko & Woinowsky-Krieger 1959, ch. 8), isotropic.
ForceElementPointer elastic_bed(const Body& body, const std::vector<int>& faces, double stiffness_Pa_per_m);

/// Whether a force element is an elastic bed, hence a support of the body.
bool is_elastic_bed(const ForceElement& element);

}  // namespace myo::model
