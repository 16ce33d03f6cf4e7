#pragma once

#include <vector>

namespace myo::effect {

/// Cross-section of a beam of unit length, bent in a plane.
struct BeamSection {
    double turn_rad = 0.0;             // rotation of the section
    double curvature = 0.0;            // derivative of the rotation along the axis
    double along = 0.0, across = 0.0;  // position of its centre, in beam lengths
};

/// Cantilever with a transverse dead force at its end, for arbitrarily large rotations.
///
/// The axis is inextensible. Sections lag behind its slope by the shear; `shear` = E I / (k G A L^2), which is close to
/// zero for slender beams. With the rotation t of the sections, the load p in units of E I / L^2 and g = p shear cos t:
/// t'' = -p x', x' = cos t - g sin t, y' = sin t + g cos t, and no moment at the end.
/// Source: Reissner 1972; without shear Bisshopp & Drucker 1945.
struct BentCantilever {
    double load = 0.0, shear = 0.0;     // dimensionless, see above
    std::vector<BeamSection> sections;  // equally spaced from the clamp to the end

    /// Section at arc length s, 0 at the clamp, 1 at the end.
    BeamSection at(double s) const;
};

struct BentCantileverPolicy {
    /// Largest deflection of the end in beam lengths. A transverse force cannot bend the beam by its full length.
    double max_deflection = 0.9;
    /// Intervals along the beam: error of 1e-8 of the length at the largest deflection.
    int parts = 128;
};
inline constexpr BentCantileverPolicy bent_cantilever_policy;

/// Cantilever whose end is deflected by `deflection` beam lengths, 0 ... max_deflection; larger values are truncated.
/// A smooth function of the deflection below this limit.
BentCantilever bent_cantilever(double deflection, double shear);

}  // namespace myo::effect
