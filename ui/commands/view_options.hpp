#pragma once

namespace myo {

/// What the 3D view shows.
struct ViewOptions {
    bool edges = true;
    bool grid = true;
    bool measured = true;
    bool simulated = true;
    bool trails = true;
    bool errors = true;             // lines from simulated to measured
    bool labels = true;
    bool clamp = true;
    bool displacement = false;      // colour the body by displacement
    bool fibres = true;             // muscles: colours and lines
    bool effect_force = true;       // arrows of the chosen effect's force, once there is a diagnosis
    double opacity = 1.0;

    bool operator==(const ViewOptions&) const = default;
};

}  // namespace myo
