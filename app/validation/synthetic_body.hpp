#pragma once

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

#include "mesh/surface_mesh.hpp"
#include "validation/random_stream.hpp"

namespace myo::validation {

enum class BodyFamily {
    beam,   // a box held at one end, declared by its size
    plate,  // a wide, thin box, declared by its size
    ell,    // an L of two legs in an upright plane, declared as STL
    tail,   // a bar that tapers in both directions, declared as STL
};
std::string to_string(BodyFamily family);
std::vector<std::string> body_family_ids();
bool parse_body_family(const std::string& id, BodyFamily& family);

/// A body that stands out of its clamp at x = 0 along +x. Mesh frame, metres.
struct SyntheticBody {
    BodyFamily family = BodyFamily::beam;
    mesh::SurfaceMesh surface;
    Box bounds;
    double thickness_m = 0.0;             // against gravity
    double held_m = 0.0;                  // depth of the clamp; 0: the face x = 0
    Box clamp, end;                       // boxes of the clamp and of the face that is loaded
    double taper_y = 1.0, taper_z = 1.0;  // size of the far end over the root's, tail
    double metres_per_unit = 1.0;         // of the STL

    double length_m() const { return bounds.size()(0); }
    bool is_declared_box() const { return family == BodyFamily::beam || family == BodyFamily::plate; }
    /// From the root's box to the body.
    Eigen::Vector3d tapered(const Eigen::Vector3d& point) const;
};

/// @param deep_clamp  held over a part of its length instead of at its face
SyntheticBody drawn_body(BodyFamily family, bool deep_clamp, RandomStream& random);

/// Points of the free surface, some near the end, none near the clamp, none close to another [m].
std::vector<Eigen::Vector3d> drawn_markers(const SyntheticBody& body, int count, RandomStream& random);

/// ASCII STL in the body's unit.
std::string stl_text(const SyntheticBody& body);

}  // namespace myo::validation
