#include "bench/bar_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "mesh/box_mesh.hpp"

namespace myo::bench {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// Shears the cross sections by a slope of 0.5, that is up to 27 degrees, with ramps of four heights at both ends,
/// which stay upright.
void shear(const BarShape& bar, int axis, Matrix3Xd& nodes) {
    const double extent = axis == 1 ? bar.width_m : bar.height_m, ramp = 4.0 * bar.height_m;
    for (auto X : nodes.colwise())
        X(0) += 0.5 * (X(axis) - 0.5 * extent) * std::min({1.0, X(0) / ramp, (bar.length_m - X(0)) / ramp});
}

/// Moves inner coordinates at random, reproducibly, by up to a fifth of a brick. Nodes stay on the faces that they lie
/// on, so the shape of the bar does not change.
void move_at_random(const Vector3d& size, const Eigen::Vector3i& bricks, Matrix3Xd& nodes) {
    std::mt19937 random(1);
    const Vector3d most = 0.2 * size.cwiseQuotient(bricks.cast<double>());
    for (auto X : nodes.colwise())
        for (int a = 0; a < 3; ++a) {
            // The generator is portable; the distributions of the standard library are not.
            const double shift = 2.0 * static_cast<double>(random()) / static_cast<double>(std::mt19937::max()) - 1.0;
            if (X(a) > 1e-9 * size(a) && X(a) < (1.0 - 1e-9) * size(a)) X(a) += shift * most(a);
        }
}

}  // namespace

mesh::VolumeMesh bar_mesh(const BarShape& bar, fem::ElementKind element, const Eigen::Vector3i& bricks, Skew skew) {
    const Box box{Vector3d::Zero(), {bar.length_m, bar.width_m, bar.height_m}};
    const bool hexahedra = fem::cell_type(element) == mesh::CellType::hex8;
    mesh::VolumeMesh mesh = hexahedra ? mesh::box_hex_mesh(box, bricks) : mesh::tet_box_mesh(box, bricks);
    if (skew == Skew::plan || skew == Skew::side) shear(bar, skew == Skew::plan ? 1 : 2, mesh.nodes);
    if (skew == Skew::nodes) move_at_random(box.size(), bricks, mesh.nodes);
    // Mid-nodes last: they then lie in the middle of the moved edges, which stay straight.
    return fem::cell_type(element) == mesh::CellType::tet10 ? mesh::to_tet10(mesh) : mesh;
}

Eigen::Vector3i bar_bricks(const BarShape& bar, int layers, double aspect) {
    const double bricks = bar.length_m / (aspect * bar.height_m) * layers;
    return {static_cast<int>(std::lround(bricks)), layers, layers};
}

std::string name_of(Skew skew) {
    switch (skew) {
        case Skew::plan: return "sheared in plan";
        case Skew::side: return "sheared in side view";
        case Skew::nodes: return "nodes moved at random";
        default: return "";
    }
}

}  // namespace myo::bench
