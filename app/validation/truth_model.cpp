#include "validation/truth_model.hpp"

#include <algorithm>
#include <cmath>

#include "effect/catalogue.hpp"
#include "experiment/check_body.hpp"
#include "mesh/box_mesh.hpp"
#include "mesh/region.hpp"
#include "setup/muscle_groups.hpp"

namespace myo::validation {
namespace {

/// Edge lengths of the truth over the default ones for cells of this type.
constexpr double finer_tets = 0.75, finer_hexes = 0.7;
/// Layers through the thickness. One layer of quadratic tetrahedra bends up to 5 % too far, two are off by 1 % (test
/// SmallLoad.LayersOfQuadraticCells); the mesh error of the truth would be detected as an effect. Fully integrated
/// hexahedra lock in bending, less with the square of the layers.
constexpr double min_layers_of_tets = 2.0, min_layers_of_hexes = 5.0;

/// Hexahedra of the untapered box, mapped to the taper.
setup::BodyMesh tapered_hexes(const SyntheticBody& body, double edge) {
    mesh::GridPlanes planes;
    if (body.held_m > 0.0) planes[0].push_back(body.held_m);
    setup::BodyMesh mesh;
    mesh.element = fem::ElementKind::hex8;
    mesh.resolution_m = edge;
    mesh.mesh = mesh::hex_mesh(mesh::grid_lines(body.bounds, edge, planes));
    for (Eigen::Index i = 0; i < mesh.mesh.nodes.cols(); ++i)
        mesh.mesh.nodes.col(i) = body.tapered(mesh.mesh.nodes.col(i));
    return mesh;
}

/// Parameter by which an effect shortens the clamp; empty: it leaves the clamp.
std::string clamp_shortening(const effect::EffectDeclaration& effect) {
    return effect::find_effect(effect.id)->clamp_shortening;
}

/// True support: a shortened clamp ends earlier, and the cells conform to its end.
experiment::Experiment as_held(const SyntheticCase& c, experiment::Experiment experiment) {
    for (const effect::EffectDeclaration& effect : c.effects)
        if (const std::string parameter = clamp_shortening(effect); !parameter.empty())
            experiment.clamp_box_m.highest(0) -= effect::number(effect.parameters, parameter);
    return experiment;
}

}  // namespace

Result<setup::Setup> on_mesh(setup::Setup setup, setup::BodyMesh mesh) {
    const experiment::Experiment& experiment = setup.experiment;
    setup.mesh = std::move(mesh);
    // Clamp of the experiment, which may already be the shortened one, see as_held().
    const Box held = setup::held_part(experiment.clamp_box_m, mesh::bounding_box(setup.surface.vertices));
    setup.body = model::make_body(setup.mesh.mesh, setup.mesh.element, mesh::nodes_in_box(setup.mesh.mesh, held));
    std::vector<Eigen::Vector3d> rest;
    for (const experiment::MarkerDeclaration& marker : experiment.markers.on_body) rest.push_back(marker.rest_m);
    setup.markers = measurement::marker_set(setup.mesh.mesh, rest);
    Result<std::vector<fibre::FibreGroup>> groups = setup::muscle_groups(experiment, setup.mesh);
    if (!groups) return groups.error();
    const auto fibres = std::make_shared<const std::vector<fibre::FibreGroup>>(std::move(*groups));
    for (std::size_t t = 0; t < setup.trials.size(); ++t) {
        model::Model& model = setup.trials[t].model;
        model.body = setup.body;
        model.moduli = model::uniform_moduli(setup.body->cell_count(), experiment.material.youngs_modulus_Pa,
                                             experiment.material.poissons_ratio);
        model.fibres = fibres;
        // Fibres and loads depend on the mesh and are rebuilt; everything else of the trials is kept.
        model.masses.clear();
        model.forces.clear();
        for (const experiment::LoadDeclaration& load : experiment.trials[t].loads) {
            // A load is spread over its part of the surface by area, as prepare_setup() does.
            const mesh::SurfaceIntegral integral = mesh::surface_weights(setup.body->mesh, setup.body->boundary,
                                                                         load.box_m);
            const Eigen::VectorXd share = integral.weight / integral.weight.sum();
            if (load.kind == experiment::LoadKind::mass)
                model.masses.push_back({share, load.mass_kg});
            else
                model.forces.push_back({share, load.force_N, load.from_s, load.until_s,
                                        load.curve.value_or(fibre::Signal::constant(1.0))});
        }
    }
    return setup;
}

Result<setup::Setup> truth_setup(const SyntheticCase& c, const experiment::Experiment& declared,
                                 const Progress& progress) {
    const experiment::Experiment experiment = as_held(c, declared);
    const bool tapered = c.body.family == BodyFamily::tail;
    const Result<mesh::SurfaceMesh> surface = experiment::read_body_surface(experiment);
    if (!surface) return surface.error();
    setup::SetupSettings settings;
    settings.integrator = c.truth.scheme.integrator;
    settings.spectral_radius = c.truth.scheme.rho_inf;
    // Steps that meet every sample.
    settings.h_s = 1.0 / (c.rate_Hz * c.truth.steps_per_sample);
    settings.fine_element = effect::any_varies_within_cells(c.effects);
    // Element and edge length by family; always different from the default of the diagnosis.
    const bool deep = c.body.held_m > 0.0;
    settings.mesh.element = deep ? fem::ElementKind::hex8_mean_dilatation : fem::ElementKind::tet10;
    if (deep)
        settings.mesh.resolution_m = std::min(finer_hexes * setup::automatic_resolution(*surface, mesh::CellType::hex8),
                                              c.body.thickness_m / min_layers_of_hexes);
    else if (!tapered)
        settings.mesh.resolution_m = std::min(finer_tets * setup::automatic_resolution(*surface, mesh::CellType::tet10),
                                              c.body.thickness_m / min_layers_of_tets);
    Result<setup::Setup> setup = setup::prepare_setup(experiment, settings, progress);
    if (!setup || !tapered) return setup;
    // Tetrahedra are the default of a tail, so its truth has hexahedra that follow the taper.
    return on_mesh(std::move(*setup),
                   tapered_hexes(c.body, finer_hexes * setup::automatic_resolution(*surface, mesh::CellType::hex8)));
}

prediction::ParameterValues true_values(const SyntheticCase& c, const setup::Setup& setup) {
    prediction::ParameterValues values = prediction::declared_values(setup);
    values.youngs_modulus_Pa = c.material.youngs_modulus_Pa;
    values.damping_s = c.material.damping_s;
    values.translation_m = c.translation_m;
    values.rotation_rad = c.rotation_rad;
    values.effects.clear();
    // A shortened clamp is part of the mesh here, see as_held().
    for (const effect::EffectDeclaration& effect : c.effects)
        if (clamp_shortening(effect).empty()) values.effects.push_back(effect);
    return values;
}

}  // namespace myo::validation
