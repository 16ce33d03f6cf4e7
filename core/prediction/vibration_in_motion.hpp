#pragma once

#include <vector>

#include "dynamics/simulate.hpp"
#include "measurement/observe.hpp"

namespace myo::prediction {

/// Which natural vibrations are searched for in a motion.
struct VibrationPolicy {
    int modes = 6;                   // number of modes, the slowest ones
    double max_damping_ratio = 0.5;  // of an oscillating mode: 16 % of an amplitude is left after half a period
};

/// A natural vibration that is visible in a motion.
struct Vibration {
    double omega_rad_s = 0.0;    // natural angular frequency
    double damping_ratio = 0.0;  // of the material in this mode [-]
    double amplitude_m = 0.0;    // rms over markers and time
};

/// Natural vibrations about the last pose of a run, sorted by amplitude at the markers, largest first.
///
/// The amplitude of each modal coordinate is its third derivative over omega^3, which suppresses motion slower than the
/// mode. Empty if the pose has no modes (a body without support) or the motion has fewer than three steps.
std::vector<Vibration> vibrations_in(const model::Model& model, const measurement::MarkerSet& markers,
                                     const dynamics::Trace& trace);

}  // namespace myo::prediction
