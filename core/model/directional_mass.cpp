#include "model/directional_mass.hpp"

#include <Eigen/Geometry>

#include <cassert>

#include "mesh/face_quadrature.hpp"
#include "mesh/face_shape.hpp"

namespace myo::model {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

using Entries = std::vector<Eigen::Triplet<double>>;

/// Adds a 3 x 3 block for nodes a, b as triplets.
void add_block(Index a, Index b, const Matrix3d& block, Entries& entries) {
    for (Index s = 0; s < 3; ++s)
        for (Index r = 0; r < 3; ++r)
            entries.emplace_back(static_cast<int>(3 * a + r), static_cast<int>(3 * b + s), block(r, s));
}

/// Inertia that acts at all times, from triplets of a 3 n x 3 n matrix.
DirectionalMass from_entries(Index nodes, const Entries& entries) {
    DirectionalMass mass;
    mass.inertia_kg.resize(3 * nodes, 3 * nodes);
    mass.inertia_kg.setFromTriplets(entries.begin(), entries.end());
    return mass;
}

}  // namespace

DirectionalMass added_mass(const Body& body, const std::vector<int>& faces, double surface_density_kg_m2) {
    assert(surface_density_kg_m2 >= 0.0);
    const int count = static_cast<int>(body.boundary.nodes.rows());
    Entries entries;
    for (const int f : faces) {
        const auto nodes = body.boundary.nodes.col(f);
        const Eigen::Matrix3Xd X = body.mesh.nodes(Eigen::all, nodes);
        for (const mesh::FacePoint& point : mesh::face_quadrature(count)) {
            const VectorXd N = mesh::face_shape(count, point.uv);
            const Eigen::Matrix<double, 3, 2> T = X * mesh::face_shape_gradient(count, point.uv);
            // Integral of N_a N_b n n' over the rest area: the area vector enters squared, divided once by its length.
            const Vector3d area = T.col(0).cross(T.col(1));
            const Matrix3d normals = surface_density_kg_m2 * point.weight / area.norm() * area * area.transpose();
            for (Index b = 0; b < count; ++b)
                for (Index a = 0; a < count; ++a) add_block(nodes(a), nodes(b), N(a) * N(b) * normals, entries);
        }
    }
    return from_entries(body.node_count(), entries);
}

DirectionalMass line_mass(const VectorXd& share, const Vector3d& direction, double mass_kg) {
    assert(direction.norm() > 0.0 && mass_kg >= 0.0);
    // Inertia m d d' per node: no mass perpendicular to the thread.
    const Vector3d d = direction.normalized();
    Entries entries;
    for (Index i = 0; i < share.size(); ++i)
        // Lumped: each node carries its share.
        if (share(i) != 0.0) add_block(i, i, share(i) * mass_kg * d * d.transpose(), entries);
    return from_entries(share.size(), entries);
}

}  // namespace myo::model
