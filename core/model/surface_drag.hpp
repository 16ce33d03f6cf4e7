#pragma once

#include <vector>

#include "model/force_element.hpp"

namespace myo::model {

/// Drag of a resting fluid on part of the surface: traction -(linear v + quadratic |v| v) per rest area.
///
/// Dissipation potential per rest area: linear |v|^2 / 2 + quadratic |v|^3 / 3.
/// The area stays that at rest, and at rest nothing acts.
/// @param faces            faces of the body's boundary
/// @param linear_Pa_s_m    >= 0, parameter
/// @param quadratic_kg_m3  >= 0, parameter
ForceElementPointer surface_drag(const Body& body, const std::vector<int>& faces, double linear_Pa_s_m,
                                 double quadratic_kg_m3);

}  // namespace myo::model
