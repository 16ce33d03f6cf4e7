#pragma once

#include <array>
#include <map>
#include <string>

#include "commands/clip_plane.hpp"

namespace myo::ui::commands {

/// What the 3D view shows. Saved with the project; not part of undo.
struct ViewOptions {
    bool edges = true;      // element edges
    bool grid = true;       // ground grid
    bool measured = true;   // measured markers
    bool simulated = true;  // simulated markers
    bool trails = true;     // path of the markers over the last half second
    bool errors = true;     // lines between measured and simulated markers
    bool labels = true;     // names of the markers
    bool clamp = true;      // box that holds the body
    bool loads = true;      // gravity, and forces and masses of the trial
    bool obstacles = true;  // obstacles, and parts of another material
    std::string field;      // id of the field that colours the body; empty: none
    std::string color_map;  // id of the colour map for unsigned fields; empty: the default
    // Ranges fixed by the user, by the field's id [SI]; other fields use the range of the trial.
    std::map<std::string, std::array<double, 2>> field_ranges;
    bool fibres = true;         // muscle colours and fibre lines
    bool actuators = true;      // walls of chambers, and tendons
    bool effect_force = true;   // force arrows of the selected diagnosis row
    bool undeformed = false;    // outline of the body at rest
    bool side_by_side = false;  // the newest compared run next to the shown one
    double opacity = 1.0;       // of the body, 0 to 1
    ClipPlane clip;
    // Item of a panel that is open to be edited, highlighted in the view: "obstacle/0", "trial/load/1"; not saved.
    std::string edited;

    bool operator==(const ViewOptions&) const = default;
};

}  // namespace myo::ui::commands
