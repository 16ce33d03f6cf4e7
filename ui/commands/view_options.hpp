#pragma once

#include <array>
#include <map>
#include <string>

#include "commands/clip_plane.hpp"

namespace myo::ui::commands {

/// What the 3D view shows.
struct ViewOptions {
    bool edges = true;
    bool grid = true;
    bool measured = true;
    bool simulated = true;
    bool trails = true;
    bool errors = true;  // lines from simulated to measured
    bool labels = true;
    bool clamp = true;
    std::string field;      // id of the quantity that colours the body; empty: none
    std::string color_map;  // id of the colours of values without a sign; empty: the usual ones
    std::map<std::string, std::array<double, 2>>
        field_ranges;          // fixed by hand, by the field's id [SI]; the others follow the run
    bool fibres = true;        // muscles: colours and lines
    bool effect_force = true;  // arrows of the chosen effect's force, once there is a diagnosis
    double opacity = 1.0;
    ClipPlane clip;

    bool operator==(const ViewOptions&) const = default;
};

}  // namespace myo::ui::commands
