#pragma once

#include <string>

#include "toml/toml_path.hpp"

namespace myo::ui::panels {

/// What clicks in the view set at present. Switched on by panels, ended by them, by Escape, and with the scene. While
/// it is on, the body is drawn at rest, as places are declared there.
struct Placing {
    enum class Kind {
        none,
        markers,  // markers and probes on the body
        guides,   // guides of a tendon
        box,      // a face, around which a box is declared
        cavity    // the wall of a cavity, which becomes a chamber
    };
    Kind kind = Kind::none;  // none: clicks set nothing
    std::string next_name;   // of markers: name of the next one; empty: the next free one
    int tendon = -1;         // of guides: index of the tendon whose guides are moved; -1: a new one is drawn
    double depth_m = 0.0;    // of guides: of new ones below the surface
    toml::TomlPath box;      // of a box: where it is declared
    bool adds = false;       // of a box: `box` is an array of tables, to which one with the key box_m is added
    std::string item;        // of a box: name of the edit
    std::string what;        // of a box: "the face that is held"

    /// Whether clicks in the view set anything.
    bool on() const { return kind != Kind::none; }
    /// Whether clicks set this kind of thing.
    bool sets(Kind other) const { return kind == other; }
    /// Whether clicks set the box at this place of the declaration.
    bool sets_box(const toml::TomlPath& path) const { return kind == Kind::box && box == path; }
};

}  // namespace myo::ui::panels
