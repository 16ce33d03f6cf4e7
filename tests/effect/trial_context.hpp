#pragma once

#include "effect/catalogue.hpp"
#include "support/beam.hpp"

namespace myo::test {

/// A beam along x that is held over the first sixth of its length, with two muscles, as effects see it.
struct HeldBeam {
    BeamSpec spec;
    effect::TrialContext context;
    effect::Affected affected;
};

inline HeldBeam held_beam(Eigen::Vector3i cells = {12, 2, 2}, fem::ElementKind kind = fem::ElementKind::hex8) {
    HeldBeam beam;
    beam.spec.kind = kind;
    beam.spec.cells = cells;
    beam.spec.size = {0.12, 0.03, 0.03};
    beam.spec.poissons_ratio = 0.45;
    beam.spec.gravity_m_s2 = 9.81;
    beam.spec.damping_s = 0.003;
    model::Model model = make_beam(beam.spec);
    const Box held{{-1.0, -1.0, -1.0}, {0.02 + 1e-9, 1.0, 1.0}};
    model.body = model::make_body(model.body->mesh, beam.spec.kind, mesh::nodes_in_box(model.body->mesh, held));
    auto fibres = std::make_shared<std::vector<fibre::FibreGroup>>();
    for (const double low : {0.0, 0.015})
        fibres->push_back(fibre::fibres_in_box(model.body->mesh, {{0.02, low, 0.0}, {0.12, low + 0.015, 0.03}},
                                               Eigen::Vector3d::UnitX(), 5e4, low > 0.0 ? "left" : "right"));
    model.fibres = fibres;
    model.activation = {fibre::Signal{{0.0, 0.05}, {1.0, 0.8}}, fibre::Signal::constant(1.0)};
    model.forces.push_back({tip_share(model, beam.spec), Eigen::Vector3d(0.0, 0.0, -0.2)});
    beam.context.body = model.body;
    beam.context.held = held;
    beam.context.marker_names = {"tip", "side"};
    beam.context.marker_rest_m = {{0.12, 0.015, 0.015}, {0.08, 0.0, 0.015}};
    beam.context.actuator_names = {"right", "left"};
    beam.context.trial = "drop";
    beam.context.session_time_s = 100.0;
    beam.context.end_s = 0.1;
    beam.affected.model = std::move(model);
    beam.affected.options.h_s = 0.005;
    beam.affected.options.end_s = 0.1;
    return beam;
}

inline effect::Affected with_effect(const HeldBeam& beam, const std::string& id,
                                    const effect::EffectParameters& parameters) {
    effect::Affected affected = beam.affected;
    effect::apply_effects(beam.context, {{id, parameters}}, affected);
    return affected;
}

}  // namespace myo::test
