#include "mesh/surface_parts.hpp"

#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

#include "base/text.hpp"
#include "mesh/surface_check.hpp"
#include "mesh/surface_distance.hpp"
#include "mesh/surface_topology.hpp"
#include "mesh/winding_number.hpp"

namespace myo::mesh {
namespace {

/// Closed part of a surface.
struct ClosedPart {
    SurfaceMesh surface;  // with the vertices of the whole
    Box bounds;
    double volume = 0.0;  // [m3], negative if it faces inward
    int depth = 0;        // number of parts around it
};

/// Bounding box of the vertices that a part uses [m].
Box bounds_of(const SurfaceMesh& part) {
    Box box{part.vertices.col(part.triangles(0, 0)), part.vertices.col(part.triangles(0, 0))};
    for (const int v : part.triangles.reshaped()) {
        box.lowest = box.lowest.cwiseMin(part.vertices.col(v));
        box.highest = box.highest.cwiseMax(part.vertices.col(v));
    }
    return box;
}

/// Whether a box lies in another without touching it; a necessary condition that spares winding numbers.
bool lies_within(const Box& inner, const Box& outer) {
    return (inner.lowest.array() > outer.lowest.array()).all() && (inner.highest.array() < outer.highest.array()).all();
}

/// Parts in the order of SurfaceTopology::part, each with the number of parts around it.
std::vector<ClosedPart> closed_parts_of(const SurfaceMesh& surface, const SurfaceTopology& topology) {
    std::vector<std::vector<Eigen::Index>> own(static_cast<std::size_t>(topology.parts));
    for (std::size_t t = 0; t < topology.part.size(); ++t)
        own[static_cast<std::size_t>(topology.part[t])].push_back(static_cast<Eigen::Index>(t));
    std::vector<ClosedPart> parts;
    for (const auto& triangles : own) {
        ClosedPart part{{surface.vertices, surface.triangles(Eigen::all, triangles)}, {}};
        part.bounds = bounds_of(part.surface);
        part.volume = enclosed_volume(part.surface);
        parts.push_back(std::move(part));
    }
    for (ClosedPart& inner : parts) {
        const Eigen::Vector3d
            point = inner.surface.vertices(Eigen::all, inner.surface.triangles.col(0)).rowwise().mean();
        for (const ClosedPart& outer : parts)
            if (lies_within(inner.bounds, outer.bounds) && std::abs(winding_number(outer.surface, point)) > 0.5)
                ++inner.depth;
    }
    return parts;
}

/// "part 2, from (10, 5, 5) to (50, 15, 15) mm"
std::string name_of(std::size_t part, const Box& bounds) {
    const auto corner = [](const Eigen::Vector3d& x) {
        return "(" + format_number(1e3 * x[0], 4) + ", " + format_number(1e3 * x[1], 4) + ", " +
               format_number(1e3 * x[2], 4) + ")";
    };
    return "part " + std::to_string(part + 1) + ", from " + corner(bounds.lowest) + " to " + corner(bounds.highest) +
           " mm";
}

struct OverlapPolicy {
    double step = 1e-4;            // beyond a crossing, of the diagonal of the surface
    double depth = 1e-6;           // that counts as inside, of the same; parts that touch have less
    std::size_t most_pairs = 200;  // of triangles that are looked at; parts that touch can have thousands
};
constexpr OverlapPolicy overlap_policy;

/// True if a side of triangle `a`, where it crosses the plane of `b`, enters the part of `b`.
bool enters(const SurfaceMesh& surface, int a, int b, const ClosedPart& part, const SurfaceDistance& distance,
            double diagonal) {
    const Eigen::Matrix3d X = surface.vertices(Eigen::all, surface.triangles.col(a)),
                          Y = surface.vertices(Eigen::all, surface.triangles.col(b));
    const Eigen::Vector3d normal = (Y.col(1) - Y.col(0)).cross(Y.col(2) - Y.col(0));
    for (int i = 0; i < 3; ++i) {
        const Eigen::Vector3d p = X.col(i), along = X.col((i + 1) % 3) - p;
        // Points on the side of `a` a little before and behind the crossing: one of them lies in the part, unless the
        // parts only touch.
        const double slope = normal.dot(along);
        if (slope == 0.0) continue;
        const double at = normal.dot(Y.col(0) - p) / slope;
        for (const double step : {-overlap_policy.step, overlap_policy.step}) {
            const double place = at + step * diagonal / along.norm();
            if (place < 0.0 || place > 1.0) continue;
            const Eigen::Vector3d x = p + place * along;
            if (std::abs(winding_number(part.surface, x)) > 0.5 &&
                distance.nearest(x).distance > overlap_policy.depth * diagonal)
                return true;
        }
    }
    return false;
}

/// Two parts of which one reaches into the other; parts that touch do not.
std::optional<std::pair<std::size_t, std::size_t>> overlapping(const SurfaceMesh& surface,
                                                               const SurfaceTopology& topology,
                                                               const std::vector<ClosedPart>& parts) {
    const double diagonal = bounding_box(surface.vertices).size().norm();
    std::map<std::size_t, SurfaceDistance> distances;
    const auto reaches = [&](int a, int b) {
        const auto other = static_cast<std::size_t>(topology.part[static_cast<std::size_t>(b)]);
        const auto& distance = distances.try_emplace(other, parts[other].surface).first->second;
        return enters(surface, a, b, parts[other], distance, diagonal);
    };
    std::size_t looked_at = 0;
    for (const auto& [a, b] : self_intersections(surface, 1e-8 * diagonal)) {
        const int first = topology.part[static_cast<std::size_t>(a)],
                  second = topology.part[static_cast<std::size_t>(b)];
        // A part that intersects itself is reported by check_surface().
        if (first == second) continue;
        if (++looked_at > overlap_policy.most_pairs) break;
        if (reaches(a, b) || reaches(b, a))
            return std::pair(static_cast<std::size_t>(first), static_cast<std::size_t>(second));
    }
    return std::nullopt;
}

/// Note on a part that was turned, with what it has become.
std::string turned(std::size_t i, const ClosedPart& part) {
    const std::string name = name_of(i, part.bounds), volume = format_number(1e6 * std::abs(part.volume), 3) + " ml";
    if (part.depth % 2 == 1)
        return name + ", lies inside the body and faces outward: it was turned and is now a cavity of " + volume +
               "; delete it from the file if the body is solid there";
    return name + ", faces inward but lies in no solid: it was turned and is now solid, " + volume;
}

}  // namespace

Result<FacingParts> facing_parts(const SurfaceMesh& surface) {
    FacingParts result{surface, {}};
    const SurfaceTopology topology = surface_topology(surface);
    if (topology.parts < 2 || !topology.closed || !topology.oriented) return result;
    const std::vector<ClosedPart> parts = closed_parts_of(surface, topology);
    if (const auto both = overlapping(surface, topology, parts))
        return Error{"two closed parts of the surface overlap: " + name_of(both->first, parts[both->first].bounds) +
                         ", and " + name_of(both->second, parts[both->second].bounds) +
                         "; unite them in the program that drew them (Boolean union), or move them apart",
                     ""};
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const bool outward = parts[i].volume > 0.0;
        // Solids face outward, cavities inward; depth counts the parts around.
        if (outward == (parts[i].depth % 2 == 0)) continue;
        for (std::size_t t = 0; t < topology.part.size(); ++t)
            if (topology.part[t] == static_cast<int>(i)) {
                const auto column = static_cast<Eigen::Index>(t);
                std::swap(result.surface.triangles(1, column), result.surface.triangles(2, column));
            }
        result.notes.push_back(turned(i, parts[i]));
    }
    return result;
}

}  // namespace myo::mesh
