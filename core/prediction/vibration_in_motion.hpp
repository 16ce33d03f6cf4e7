#pragma once

#include <vector>

#include "dynamics/simulate.hpp"
#include "measurement/observe.hpp"

namespace myo::prediction {

struct VibrationPolicy {
    int modes = 6;                    // natural vibrations that are looked for, the slowest ones
    double most_damping_ratio = 0.5;  // of one that swings: 16 % of an amplitude is left after half a period
};

/// A natural vibration that a motion shows.
struct Vibration {
    double omega_rad_s = 0.0;
    double damping_ratio = 0.0;
    double amplitude_m = 0.0;  // rms over markers and time
};

/// The natural vibrations about a run's last pose, the one that moves the markers most first.
///
/// The coordinate of each mode is judged by its third derivative over omega^3: a motion slower than the mode counts the
/// less. None where the pose has no modes (a body that is not held) or the motion has fewer than three steps.
std::vector<Vibration> vibrations_in(const model::Model& model, const measurement::MarkerSet& markers,
                                     const dynamics::Trace& trace);

}  // namespace myo::prediction
