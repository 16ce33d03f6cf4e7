#pragma once

#include "mesh/clipping.hpp"
#include "mesh/surface_mesh.hpp"

namespace myo::experiment {

/// Overlap and distance queries between declared boxes or points and the closed surface of the body. Lengths in m.
class BodyQueries {
public:
    /// @param body  closed, outward; must outlive the queries
    explicit BodyQueries(const mesh::SurfaceMesh& body);

    /// True if the box and the body have a point in common, up to the tolerance; contact along an edge or at a corner
    /// alone does not count.
    bool holds_material(const Box& box) const;
    /// True if the box and the body have a common volume, not only touching faces.
    bool holds_volume(Box box) const;
    /// True if the body lies in the box, up to the tolerance.
    bool lies_in(const Box& box) const;
    /// True if the box contains an area of the surface, not only an edge or a point.
    bool holds_surface(const Box& box) const;
    /// True for points in the material, not on the surface.
    /// Assumes the surface closed and outward; parts that face inward bound cavities, which hold no material.
    bool in_material(const Eigen::Vector3d& point) const;
    /// Distance of a point from the surface, from inside or outside.
    double distance_to_surface(const Eigen::Vector3d& point) const;

    const mesh::SurfaceMesh& surface() const { return body_; }
    /// Distance below which two points count as one.
    /// Lengths shorter than it are rounding of the surface file: 1e-7 of the largest extent [m].
    double tolerance() const { return tolerance_; }

private:
    // Part of a triangle inside a box; empty if they do not meet.
    mesh::Polygon part_in(const Box& box, Eigen::Index triangle) const;

    const mesh::SurfaceMesh& body_;
    double tolerance_;
};

}  // namespace myo::experiment
