#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

#include "fibre/cell_paint.hpp"

namespace myo::fibre {

/// Two halves of a body that are painted alike.
struct MirrorPlane {
    Eigen::Vector3d point_m = Eigen::Vector3d::Zero();
    Eigen::Vector3d normal = Eigen::Vector3d::UnitX();  // unit
};

/// What a stroke does to the cells below it.
struct Brush {
    double radius_m = 0.01;
    double depth_m = 0.005;  // below the surface, along its normal; infinite: through the body
    double falloff = 0.0;    // 0 ... 1: the share of the radius over which the weight falls to nothing; 0: a hard edge
    double strength = 1.0;   // weight at the middle, 0 ... 1
    bool erase = false;
    std::optional<Eigen::Vector3d> axis;  // fibres along it, unit; none: along the stroke
    std::optional<MirrorPlane> mirror;

    /// Weight at a distance from the middle of the stroke.
    double weight(double distance_m) const;
};

/// Where the cells of a mesh are: made once, for all strokes.
struct CellPlaces {
    Eigen::Matrix3Xd centre_m;  // 3 x cells
    double edge_m = 0.0;        // mean distance from a cell to its neighbours
};
/// @param neighbours  as neighbouring_cells() gives them, 2 x k
CellPlaces cell_places(const mesh::VolumeMesh& mesh, const Eigen::Matrix2Xi& neighbours);

/// A stroke over the surface, point by point as the hand moves; the places stay with the caller. What it has done does
/// not depend on how often it was asked.
class Stroke {
public:
    Stroke(const CellPlaces& places, const Brush& brush);

    /// @param position_m  on the surface, rest frame
    /// @param outward     its normal there, unit
    void add(const Eigen::Vector3d& position_m, const Eigen::Vector3d& outward);

    /// The paint with the stroke on it. Fibres follow the stroke, smoothed over the brush, in the plane of the surface;
    /// a single touch without an axis changes weights alone where there is paint, and runs along `otherwise` where
    /// there is none.
    CellPaint over(const CellPaint& before, const Eigen::Vector3d& otherwise) const;

private:
    struct Point {
        Eigen::Vector3d position_m, outward;
    };
    void press(const Point& from, const Point& to);

    const CellPlaces& places_;
    Brush brush_;
    std::vector<Point> points_;
    Eigen::VectorXd weights_;             // per cell: the most that any part of the stroke gave
    std::vector<Eigen::Matrix3d> dyads_;  // per cell: sum of weight x length x t t'
};

}  // namespace myo::fibre
