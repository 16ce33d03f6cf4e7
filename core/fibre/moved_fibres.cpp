#include "fibre/moved_fibres.hpp"

#include <Eigen/LU>

#include <cassert>
#include <utility>

namespace myo::fibre {

FibreGroup moved_fibres(const mesh::VolumeMesh& from, const mesh::VolumeMesh& to, FibreGroup group) {
    assert(from.cells.cols() == to.cells.cols() && group.gradients.size() == group.points.size());
    for (std::size_t k = 0; k < group.points.size(); ++k) {
        FibrePoint& point = group.points[k];
        const auto cell = from.cells.col(point.cell);
        if (to.nodes(Eigen::all, cell) == from.nodes(Eigen::all, cell)) continue;
        auto& gradient = group.gradients[k];
        const Eigen::Matrix3Xd X = to.nodes(Eigen::all, cell);
        const Eigen::Matrix3d moved = X * gradient;  // dX' / dX, deformation of the rest shape
        // F m transforms the direction; normalised, because a fibre direction is a unit vector.
        const Eigen::Vector3d direction = (X * point.shape).normalized();
        gradient = (gradient * moved.inverse()).eval();
        point.shape = gradient * direction;
        point.volume *= moved.determinant();
    }
    return group;
}

}  // namespace myo::fibre
