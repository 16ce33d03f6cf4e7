#include "commands/rest_outline.hpp"

#include <algorithm>
#include <limits>
#include <set>

namespace myo::ui::commands {

Eigen::Matrix3Xd rest_outline(const MeshedBody& body) {
    const Eigen::MatrixXi& faces = body.boundary.nodes;
    // Faces with mid-side nodes list their three corners first.
    const Eigen::Index corners = faces.rows() == 6 ? 3 : faces.rows();
    // Each edge belongs to two faces; the set keeps it once, whatever its direction.
    std::set<std::pair<int, int>> edges;
    for (Eigen::Index f = 0; f < faces.cols(); ++f)
        for (Eigen::Index i = 0; i < corners; ++i)
            edges.insert(std::minmax({faces(i, f), faces((i + 1) % corners, f)}));
    Eigen::Matrix3Xd points(3, 3 * static_cast<Eigen::Index>(edges.size()));
    Eigen::Index column = 0;
    for (const auto& [a, b] : edges) {
        points.col(column++) = body.mesh.nodes.col(a);
        points.col(column++) = body.mesh.nodes.col(b);
        points.col(column++).setConstant(std::numeric_limits<double>::quiet_NaN());
    }
    return points;
}

}  // namespace myo::ui::commands
