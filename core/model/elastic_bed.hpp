#pragma once

#include <vector>

#include "model/force_element.hpp"

namespace myo::model {

/// An elastic bed under part of the surface, the same stiffness normal and tangential: traction -k (x - X) per rest
/// area.
///
/// `faces` of the body's boundary sit on it; their nodes are not to be clamped. Parameter: stiffness_Pa_per_m,
/// positive. Source: Winkler's foundation (Timoshenko & Woinowsky-Krieger 1959, ch. 8), isotropic.
ForceElementPointer elastic_bed(const Body& body, const std::vector<int>& faces, double stiffness_Pa_per_m);

}  // namespace myo::model
