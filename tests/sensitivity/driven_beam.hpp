#pragma once

#include <cmath>
#include <memory>

#include "model/cavity_pressure.hpp"
#include "model/elastic_bed.hpp"
#include "model/loaded_face.hpp"
#include "model/surface_drag.hpp"
#include "sensitivity/adjoint_run.hpp"
#include "sensitivity/tangent_run.hpp"
#include "support/beam.hpp"
#include "support/hollow.hpp"

namespace myo::test {

/// A beam with all that a model can have: damping, velocity force, fibres with a jumping signal and a smooth one, a
/// force that ends inside a step, an attached mass.
inline model::Model driven_beam(fem::ElementKind kind, const char* material = "neo_hookean") {
    BeamSpec spec;
    spec.kind = kind;
    spec.material = material;
    spec.gravity_m_s2 = 9.81;
    spec.youngs_modulus_Pa = 2.6e5;
    spec.poissons_ratio = 0.49;
    spec.damping_s = 0.003;
    if (fem::cell_type(kind) == mesh::CellType::tet10) spec.cells = {2, 1, 1};
    model::Model model = make_beam(spec);
    auto fibres = std::make_shared<std::vector<fibre::FibreGroup>>();
    fibres->push_back(fibre::fibres_in_box(model.body->mesh, Box{{0.02, 0, 0}, {0.09, 0.03, 0.01}},
                                           Eigen::Vector3d::UnitX(), 8e4, "lower"));
    fibres->push_back(fibre::fibres_in_box(model.body->mesh, Box{{0.0, 0, 0.02}, {0.1, 0.03, 0.03}},
                                           Eigen::Vector3d(1.0, 0.3, 0.0).normalized(), 5e4, "upper"));
    model.fibres = fibres;
    model.activation = {fibre::Signal::held({-0.01, 0.01, 0.0225}, {0.95, 0.9, 1.05}),
                        fibre::Signal{{0.0, 0.02, 0.03}, {1.0, 1.1, 0.95}}};
    push_tip(model, spec, {0.02, 0.05, 0.0});
    model.forces.back().until_s = 0.012;
    model.masses.push_back({tip_share(model, spec), 0.01});
    model.velocity_force_1_s = 3.0;
    return model;
}

/// A hollow block on an elastic bed in a fluid, its chamber under a pressure that rises and jumps.
inline model::Model blown_block(fem::ElementKind kind) {
    model::Model model = hollow_block(kind);
    const model::Body& held = *model.body;
    std::vector<int> clamped;
    for (int i = 0; i < held.node_count(); ++i)
        if (held.clamped[static_cast<std::size_t>(i)]) clamped.push_back(i);
    const std::vector<int> bed = model::faces_of_nodes(held, clamped);
    model.body = model::make_body(held.mesh, kind, {});
    const model::Body& body = *model.body;
    model.gravity_m_s2 = {0.0, 0.0, -9.81};
    model.damping_s = 0.002;
    model.force_elements = {model::elastic_bed(body, bed, 3e7),
                            model::surface_drag(body, model::free_faces(body), 20.0, 3000.0),
                            model::cavity_pressure(body, model::closed_cavities(body).at(0),
                                                   fibre::Signal{{0.0, 0.0125, 0.0125, 0.03}, {4e3, 7e3, 2e3, 6e3}})};
    return model;
}

inline dynamics::SimulationOptions short_run(const dynamics::TimeScheme& integrator, dynamics::StartKind start) {
    dynamics::SimulationOptions options;
    options.integrator = integrator;
    options.start = start;
    options.h_s = 0.005;
    options.end_s = 0.03;
    options.solver.tolerance = 1e-10;
    return options;
}

/// Of positions and velocities of all nodes, with weights that differ from place to place and time to time.
inline sensitivity::LossOfMotion rough_loss(const model::Model& model) {
    sensitivity::LossOfMotion loss;
    for (int i = 0; i < model.body->node_count(); ++i) loss.nodes.push_back(i);
    const Eigen::Matrix3Xd rest = model.body->mesh.nodes;
    loss.evaluate = [rest](const sensitivity::NodeMotion& motion) {
        sensitivity::MotionLoss result;
        for (std::size_t k = 0; k < motion.times_s.size(); ++k) {
            const Eigen::Matrix3Xd weight = 1.0 + 0.5 * rough_field(rest.cols(), static_cast<double>(k)).array();
            const Eigen::Matrix3Xd u = motion.positions[k] - rest, &v = motion.velocities[k];
            result.value += 0.5 * u.cwiseProduct(weight).cwiseProduct(u).sum() +
                            5e-5 * v.cwiseProduct(weight).cwiseProduct(v).sum() + 1e-3 * u.cwiseProduct(weight).sum();
            result.d_positions.push_back(u.cwiseProduct(weight) + 1e-3 * weight);
            result.d_velocities.push_back(1e-4 * v.cwiseProduct(weight));
        }
        return result;
    };
    return loss;
}

/// A loss's derivative along a parameter, from that of the motion.
inline double along(const sensitivity::MotionLoss& derivative, const sensitivity::NodeTangent& tangent) {
    double sum = 0.0;
    for (std::size_t k = 0; k < derivative.d_positions.size(); ++k)
        sum += tangent.positions[k].cwiseProduct(derivative.d_positions[k]).sum() +
               tangent.velocities[k].cwiseProduct(derivative.d_velocities[k]).sum();
    return sum;
}

}  // namespace myo::test
