#include "bench/held_bar.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <utility>

#include "dynamics/material_damping.hpp"
#include "dynamics/statics.hpp"
#include "material/catalogue.hpp"
#include "mesh/region.hpp"

namespace myo::bench {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// Face of the bounding box at the lowest x (clamped) or at the highest x (free).
Box end_of(const mesh::VolumeMesh& mesh, bool free) {
    Box box = mesh::bounding_box(mesh.nodes);
    (free ? box.lowest(0) : box.highest(0)) = free ? box.highest(0) : box.lowest(0);
    return box;
}

}  // namespace

model::Model held_bar(const BarShape& bar, fem::ElementKind element, mesh::VolumeMesh mesh) {
    const std::vector<int> held = mesh::nodes_in_box(mesh, end_of(mesh, false));
    model::Model model;
    model.body = model::make_body(std::move(mesh), element, held);
    model.material = material::neo_hookean();
    model.moduli = model::uniform_moduli(model.body->cell_count(), bar.youngs_modulus_Pa, bar.poissons_ratio);
    model.density_kg_m3 = bar.density_kg_m3;
    return model;
}

Eigen::VectorXd free_end_share(const model::Body& body) {
    Box end = end_of(body.mesh, true);
    end.highest(0) += mesh::region_tolerance(body.mesh);  // includes faces that lie in the side of the box
    const mesh::SurfaceIntegral integral = mesh::surface_weights(body.mesh, body.boundary, end);
    return integral.weight / integral.area;
}

Matrix3Xd unit_torque(const model::Body& body) {
    const Eigen::VectorXd share = free_end_share(body);
    const Matrix3Xd& X = body.mesh.nodes;
    const Vector3d centre = X * share;
    Matrix3Xd forces = Matrix3Xd::Zero(3, X.cols());
    double torque = 0.0;
    for (Eigen::Index i = 0; i < X.cols(); ++i) {
        if (share(i) == 0.0) continue;
        const Vector3d arm = X.col(i) - centre;
        forces.col(i) = share(i) * Vector3d::UnitX().cross(arm);
        torque += arm.cross(forces.col(i)).x();
    }
    // Scaled to 1 N m: then work and mean rotation agree.
    return forces / torque;
}

SmallMotions::SmallMotions(const model::Model& model)
    : model_(model),
      solver_(model),
      stage_(dynamics::static_stage(*model.body, 0.0)),
      stiffness_(solver_.hessian(stage_, model.body->mesh.nodes)) {
    Matrix3Xd down = Matrix3Xd::Zero(3, model.body->node_count());
    down.row(2).setConstant(-1.0);
    weight_ = model::times_mass(down, solver_.mass(0.0));
}

Matrix3Xd SmallMotions::under(const Matrix3Xd& forces_N) {
    const model::BlockPattern& pattern = model_.body->pattern;
    return model::scatter(
        pattern, solver_.solve_linear(stiffness_, stage_, model_.body->mesh.nodes, model::gather(pattern, forces_N)));
}

BendingMode SmallMotions::first_bending() {
    dynamics::NaturalMode mode;
    mode.shape = under(weight_);
    double squared = 0.0;
    for (int iteration = 0; iteration < 20; ++iteration) {
        // Inverse iteration with mass-normalised shapes.
        const Matrix3Xd inertia = model::times_mass(mode.shape, solver_.mass(0.0));
        mode.shape = under(inertia);
        const Matrix3Xd next = model::times_mass(mode.shape, solver_.mass(0.0));
        const double mass = mode.shape.cwiseProduct(next).sum(), before = squared;
        // Rayleigh quotient x'Kx / x'Mx: K x = inertia.
        squared = mode.shape.cwiseProduct(inertia).sum() / mass;
        mode.shape /= std::sqrt(mass);
        if (std::abs(squared - before) < 1e-6 * squared) break;
    }
    mode.omega_rad_s = std::sqrt(squared);
    return {mode.omega_rad_s, dynamics::damping_factor(model_, model_.body->mesh.nodes, mode)};
}

}  // namespace myo::bench
