#pragma once

#include <vector>

namespace myo::effect {

/// A section of a beam of unit length that is bent in a plane: how far it has turned, what it bends by, where its
/// centre is.
struct BeamSection {
    double turn_rad = 0.0;
    double curvature = 0.0;
    double along = 0.0, across = 0.0;
};

/// A cantilever that a dead force across its end bends, however far its sections turn. Its axis keeps its length;
/// sections lag behind its slope by the shear, `shear` = E I / (k G A L^2) of a slender one being next to nothing.
///
/// With the turn t of the sections, the load p in E I / L^2 and g = p shear cos t: t'' = -p x', x' = cos t - g sin t,
/// y' = sin t + g cos t, and no moment at the end. Source: Reissner 1972; without shear Bisshopp & Drucker 1945.
struct BentCantilever {
    double load = 0.0, shear = 0.0;
    std::vector<BeamSection> sections;  // evenly from the clamp to the end

    /// s: from 0 at the clamp to 1 at the end.
    BeamSection at(double s) const;
};

/// The largest deflection of the end, of its length: a force across it cannot bend it all the way.
inline constexpr double most_deflection = 0.9;

/// The one whose end has moved by `deflection` of its length, 0 ... most_deflection; more is taken for the most. Smooth
/// below.
BentCantilever bent_cantilever(double deflection, double shear);

}  // namespace myo::effect
