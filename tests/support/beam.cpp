#include "support/beam.hpp"

namespace myo::test {

Box beam_box(const BeamSpec& spec) { return {Eigen::Vector3d::Zero(), spec.size}; }

model::Model make_beam(const BeamSpec& spec) {
    const mesh::VolumeMesh mesh = box_mesh(spec.kind, beam_box(spec), spec.cells);
    // The clamp reaches a little beyond the end face, so that rounding leaves no node of it outside.
    const double margin = 1e-6 * spec.size(0);
    const Eigen::Vector3d outside = Eigen::Vector3d::Constant(margin);
    const Box clamp{-outside, Eigen::Vector3d(0.0, spec.size(1), spec.size(2)) + outside};
    model::Model model;
    model.body = model::make_body(mesh, spec.kind, spec.clamped ? mesh::nodes_in_box(mesh, clamp) : std::vector<int>{});
    model.material = material::find_material(spec.material);
    model.moduli = model::uniform_moduli(model.body->cell_count(), spec.youngs_modulus_Pa, spec.poissons_ratio);
    model.density_kg_m3 = spec.density_kg_m3;
    model.damping_s = spec.damping_s;
    model.gravity_m_s2 = Eigen::Vector3d(0.0, 0.0, -spec.gravity_m_s2);
    return model;
}

/// Integrals of the shape functions over the end face, divided by its area.
Eigen::VectorXd tip_share(const model::Model& model, const BeamSpec& spec) {
    const Eigen::Vector3d outside = Eigen::Vector3d::Constant(1e-6 * spec.size(0));
    // surface_weights() also counts a face that lies in a side of the box
    const Box tip{Eigen::Vector3d(spec.size(0), 0.0, 0.0), spec.size + outside};
    const mesh::SurfaceIntegral integral = mesh::surface_weights(model.body->mesh, model.body->boundary, tip);
    return integral.weight / integral.weight.sum();
}

Eigen::Vector3d tip_displacement(const model::Model& model, const BeamSpec& spec, const Eigen::Matrix3Xd& x) {
    return (x - model.body->mesh.nodes) * tip_share(model, spec);
}

double second_moment(const BeamSpec& spec) { return spec.size(1) * std::pow(spec.size(2), 3) / 12.0; }

double section_area(const BeamSpec& spec) { return spec.size(1) * spec.size(2); }

/// The share distributes the force like a uniform traction.
void push_tip(model::Model& model, const BeamSpec& spec, const Eigen::Vector3d& force_N) {
    model::DeadForce load;
    load.share = tip_share(model, spec);
    load.force_N = force_N;
    model.forces.push_back(load);
}

}  // namespace myo::test
