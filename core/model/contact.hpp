#pragma once

#include <vector>

#include "model/distance_field.hpp"
#include "model/force_element.hpp"

namespace myo::model {

/// How a surface rests on a rigid obstacle.
struct ContactLaw {
    double stiffness_Pa_m = 0.0;   // pressure per penetration beyond the onset; positive
    double onset_m = 0.0;          // penetration over which the stiffness sets in; positive
    double friction = 0.0;         // Coulomb coefficient, not negative
    double v0_m_s = 0.0;           // speed below which friction is nearly linear in the velocity; positive
    double static_slip_m = 0.0;    // the same in statics, for the displacement from the rest shape; positive
    double static_bed_Pa_m = 0.0;  // springs to the rest shape in statics, for a body that nothing else holds
};

/// Contact of part of the surface with a rigid obstacle that stands still, by a smooth penalty at the quadrature points
/// of the faces (rest areas).
///
/// The pressure is stiffness times the slope of one_sided(penetration): the potential is as smooth as the obstacle's
/// distance. Friction is -mu p v_t / sqrt(|v_t|^2 + v0^2), v_t the velocity across the obstacle's normal; it has no
/// potential, since p changes with positions, and its tangent is complete. In statics the displacement from the rest
/// shape stands for the velocity: the body was laid down from there, and sticks within Coulomb's limit.
/// Parameter: friction, unless it is 0.
/// @param faces  faces of the body's boundary
ForceElementPointer contact(const Body& body, const std::vector<int>& faces, const DistanceField& obstacle,
                            const ContactLaw& law);

/// Largest depth of a quadrature point of these faces in the obstacle [m]; 0 if none is inside.
double deepest_penetration(const Body& body, const std::vector<int>& faces, const DistanceField& obstacle,
                           const Eigen::Matrix3Xd& x);

}  // namespace myo::model
