#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

#include "fibre/cell_paint.hpp"

namespace myo::fibre {

/// Symmetry plane of the brush: strokes are mirrored to the other half of the body.
struct MirrorPlane {
    Eigen::Vector3d point_m = Eigen::Vector3d::Zero();  // any point on the plane
    Eigen::Vector3d normal = Eigen::Vector3d::UnitX();  // unit vector
};

/// Settings of a painting stroke.
struct Brush {
    double radius_m = 0.01;               // radius on the surface
    double depth_m = 0.005;               // reach below the surface, along its normal; infinite: through the body
    double falloff = 0.0;                 // 0 ... 1: share of the radius over which the weight falls to 0; 0: hard edge
    double strength = 1.0;                // weight at the centre, 0 ... 1
    bool erase = false;                   // reduce weights instead of increasing them
    std::optional<Eigen::Vector3d> axis;  // unit direction of the fibres; none: along the stroke
    std::optional<MirrorPlane> mirror;    // also paint the mirror image

    /// Weight at a distance [m] from the centre line of the stroke: cubic (smoothstep) decay over the falloff.
    double weight(double distance_m) const;
};

/// Cell centres and size of a mesh, computed once for all strokes.
struct CellPlaces {
    Eigen::Matrix3Xd centre_m;  // 3 x cells, rest frame
    double edge_m = 0.0;        // mean distance between centres of neighbouring cells
};
/// Cell centres of a mesh.
/// @param neighbours  pairs of neighbouring cells, 2 x k, from neighbouring_cells()
CellPlaces cell_places(const mesh::VolumeMesh& mesh, const Eigen::Matrix2Xi& neighbours);

/// Stroke over the surface, extended point by point. `places` must outlive it. over() does not change the stroke, so it
/// can be called for a preview at any time.
class Stroke {
public:
    /// @param places  cells of the mesh, kept by reference
    /// @param brush   settings; asserts radius > 0 and 0 <= falloff <= 1
    Stroke(const CellPlaces& places, const Brush& brush);

    /// Extends the stroke to a point on the surface.
    /// @param position_m  on the surface, rest frame
    /// @param outward     unit surface normal at the point
    void add(const Eigen::Vector3d& position_m, const Eigen::Vector3d& outward);

    /// Paint after the stroke.
    ///
    /// Fibres follow the stroke, averaged over the brush, in the tangent plane of the surface. A single touch without
    /// an axis changes only the weights of painted cells.
    /// @param before     paint before the stroke
    /// @param otherwise  unit direction for unpainted cells at a touch without direction
    CellPaint over(const CellPaint& before, const Eigen::Vector3d& otherwise) const;

private:
    struct Point {
        Eigen::Vector3d position_m, outward;
    };
    /// Applies one segment of the stroke to all cells in reach.
    void press(const Point& from, const Point& to);

    const CellPlaces& places_;
    Brush brush_;
    std::vector<Point> points_;
    Eigen::VectorXd weights_;             // per cell: maximum over all parts of the stroke
    std::vector<Eigen::Matrix3d> dyads_;  // per cell: sum of weight x length x t t' with stroke direction t
};

}  // namespace myo::fibre
