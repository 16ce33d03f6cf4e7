#include "support/pulled_block.hpp"

namespace myo::test {

BeamSpec light_cube() {
    BeamSpec spec;
    spec.cells = {1, 1, 1};
    spec.size = {0.01, 0.01, 0.01};
    spec.youngs_modulus_Pa = 1e5;
    spec.poissons_ratio = 0.3;
    // About a thousandth of silicone: inertia is negligible.
    spec.density_kg_m3 = 1.0;
    spec.clamped = false;
    return spec;
}

Eigen::VectorXd root_share(const model::Model& model, const BeamSpec& spec) {
    const Eigen::Vector3d outside = Eigen::Vector3d::Constant(1e-6 * spec.size(0));
    const Box root{-outside, Eigen::Vector3d(0.0, spec.size(1), spec.size(2)) + outside};
    const mesh::SurfaceIntegral integral = mesh::surface_weights(model.body->mesh, model.body->boundary, root);
    return integral.weight / integral.weight.sum();
}

/// Equal and opposite forces, so that the free cube is not accelerated.
void pull(model::Model& model, const BeamSpec& spec, double stress_Pa, double from_s, double until_s) {
    const Eigen::Vector3d force(stress_Pa * section_area(spec), 0.0, 0.0);
    model.forces.push_back({tip_share(model, spec), force, from_s, until_s});
    model.forces.push_back({root_share(model, spec), -force, from_s, until_s});
}

double stretch_of(const model::Model& model, const BeamSpec& spec, const Eigen::Matrix3Xd& x) {
    return x.row(0).dot(tip_share(model, spec) - root_share(model, spec)) / spec.size(0) - 1.0;
}

}  // namespace myo::test
