#pragma once

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

#include "base/random_stream.hpp"
#include "mesh/surface_mesh.hpp"

namespace myo::validation {

/// Standard acceleration of gravity, rounded.
inline constexpr double gravity_m_s2 = 9.81;

/// Families of synthetic bodies.
enum class BodyFamily {
    beam,      // box clamped at one end, declared by its size
    plate,     // wide, thin box, declared by its size
    ell,       // L of two legs in a vertical plane, declared as STL
    tail,      // bar tapered in both directions, declared as STL
    threaded,  // beam with a tendon above its middle, for effects that need one
};
/// Id of a family, as --geometry takes it.
std::string to_string(BodyFamily family);
/// All ids.
std::vector<std::string> body_family_ids();
/// Family of an id; false if there is none.
bool parse_body_family(const std::string& id, BodyFamily& family);

/// A body that extends from its clamp at x = 0 along +x. Mesh frame [m].
struct SyntheticBody {
    BodyFamily family = BodyFamily::beam;
    mesh::SurfaceMesh surface;
    // Bounding box of the untapered body.
    Box bounds;
    double thickness_m = 0.0;             // in the bending direction under gravity
    double held_m = 0.0;                  // depth of the clamp; 0: the face x = 0
    Box clamp, end;                       // clamp box and box of the loaded face
    double taper_y = 1.0, taper_z = 1.0;  // size of the far end over that of the root, for tail
    double metres_per_unit = 1.0;         // unit of the STL

    double length_m() const { return bounds.size()(0); }
    bool is_declared_box() const {
        return family == BodyFamily::beam || family == BodyFamily::plate || family == BodyFamily::threaded;
    }
    /// Maps a point of the untapered box to the body: cross sections shrink linearly along x about the axis y = z = 0.
    Eigen::Vector3d tapered(const Eigen::Vector3d& point) const;
};

/// Random body of a family.
///
/// @param deep_clamp  clamped over a part of its length instead of at its face
SyntheticBody drawn_body(BodyFamily family, bool deep_clamp, RandomStream& random);

/// Random points on the free surface [m]: two near the end, none near the clamp, with a minimum distance of 15 % of the
/// length, or less where they do not fit.
std::vector<Eigen::Vector3d> drawn_markers(const SyntheticBody& body, int count, RandomStream& random);

/// ASCII STL in the unit of the body.
std::string stl_text(const SyntheticBody& body);

}  // namespace myo::validation
