#include "model/rest_points.hpp"

#include <algorithm>

#include "fem/reference_points.hpp"

namespace myo::model {

Eigen::Matrix3Xd rest_points(const Body& body) {
    // Reference points of an element are those of all its cells.
    const std::vector<Eigen::VectorXd> values = fem::shape_values_at_points(body.kind);
    Eigen::Matrix3Xd points(3, body.point_count());
    // The lanes past the last cell repeat it.
    for (int entry = 0; entry < body.pack_count() * pack_width; ++entry) {
        const Eigen::Matrix3Xd nodes = body.mesh.nodes(Eigen::all,
                                                       body.mesh.cells.col(std::min(entry, body.cell_count() - 1)));
        for (int q = 0; q < body.points_per_cell; ++q)
            points.col(body.point_entry(entry, q)) = nodes * values[static_cast<std::size_t>(q)];
    }
    return points;
}

}  // namespace myo::model
