#include "trust/truth_model.hpp"

#include <algorithm>
#include <cmath>

#include "effect/catalogue.hpp"
#include "mesh/box_mesh.hpp"
#include "mesh/region.hpp"
#include "project/check_body.hpp"
#include "project/muscle_groups.hpp"

namespace myo {
namespace {

/// Edges of the truth's cells over those that the diagnosis would choose for cells of this type.
constexpr double finer_tets = 0.75, finer_hexes = 0.7;
/// Through the thickness: one layer of quadratic tetrahedra bends up to 5 % too far, two are off by 1 % (test SmallLoad.LayersOfQuadraticCells), and what a truth's own
/// cells add would be found as an effect. Hexahedra with all their points lock in bending, less with the square of the layers.
constexpr double least_layers_of_tets = 2.0, least_layers_of_hexes = 5.0;

/// Hexahedra of the root's box, tapered.
StudyMesh tapered_hexes(const SyntheticBody& body, double edge) {
    GridPlanes planes;
    if (body.held_m > 0.0) planes[0].push_back(body.held_m);
    StudyMesh mesh;
    mesh.element = ElementKind::hex8;
    mesh.resolution_m = edge;
    mesh.mesh = hex_mesh(grid_lines(body.bounds, edge, planes));
    for (Eigen::Index i = 0; i < mesh.mesh.nodes.cols(); ++i) mesh.mesh.nodes.col(i) = body.tapered(mesh.mesh.nodes.col(i));
    return mesh;
}

bool is_slipped_clamp(const SyntheticCase& c) { return c.effect && c.effect->id == "clamp_slip"; }

/// What holds the body in truth: a clamp that has slipped is one that ends earlier, whose end its cells meet.
Experiment as_held(const SyntheticCase& c, Experiment experiment) {
    if (is_slipped_clamp(c)) experiment.clamp_box_m.highest(0) -= number(c.effect->parameters, "free_length_m");
    return experiment;
}

}  // namespace

Result<Study> on_mesh(Study study, StudyMesh mesh) {
    const Experiment& experiment = study.experiment;
    study.mesh = std::move(mesh);
    const Box held = held_part(experiment.clamp_box_m, bounding_box(study.surface.vertices));
    study.body = make_body(study.mesh.mesh, study.mesh.element, nodes_in_box(study.mesh.mesh, held));
    std::vector<Eigen::Vector3d> rest;
    for (const MarkerDeclaration& marker : experiment.markers.on_body) rest.push_back(marker.rest_m);
    study.markers = marker_set(study.mesh.mesh, rest);
    Result<std::vector<FibreGroup>> groups = muscle_groups(experiment, study.mesh);
    if (!groups) return groups.error();
    const auto fibres = std::make_shared<const std::vector<FibreGroup>>(std::move(*groups));
    for (std::size_t t = 0; t < study.trials.size(); ++t) {
        Model& model = study.trials[t].model;
        model.body = study.body;
        model.moduli = uniform_moduli(study.body->cell_count(), experiment.material.youngs_modulus_Pa, experiment.material.poissons_ratio);
        model.fibres = fibres;
        model.masses.clear();
        model.forces.clear();
        for (const LoadDeclaration& load : experiment.trials[t].loads) {
            const SurfaceIntegral integral = surface_weights(study.body->mesh, study.body->boundary, load.box_m);
            const Eigen::VectorXd share = integral.weight / integral.weight.sum();
            if (load.kind == LoadKind::mass) model.masses.push_back({share, load.mass_kg});
            else model.forces.push_back({share, load.force_N, load.from_s, load.until_s});
        }
    }
    return study;
}

Result<Study> truth_study(const SyntheticCase& c, const Experiment& declared, const Progress& progress) {
    const Experiment experiment = as_held(c, declared);
    const bool tapered = c.body.family == BodyFamily::tail;
    const Result<SurfaceMesh> surface = read_body_surface(experiment);
    if (!surface) return surface.error();
    StudySettings settings;
    settings.integrator = c.truth.scheme.integrator;
    settings.spectral_radius = c.truth.scheme.rho_inf;
    settings.h_s = 1.0 / (c.rate_Hz * c.truth.steps_per_sample);
    settings.fine_element = c.effect && any_varies_within_cells({*c.effect});
    const bool deep = c.body.held_m > 0.0;
    settings.mesh.element = deep ? ElementKind::hex8_mean_dilatation : ElementKind::tet10;
    if (deep) settings.mesh.resolution_m = std::min(finer_hexes * automatic_resolution(*surface, CellType::hex8), c.body.thickness_m / least_layers_of_hexes);
    else if (!tapered) settings.mesh.resolution_m = std::min(finer_tets * automatic_resolution(*surface, CellType::tet10), c.body.thickness_m / least_layers_of_tets);
    Result<Study> study = prepare_study(experiment, settings, progress);
    if (!study || !tapered) return study;
    return on_mesh(std::move(*study), tapered_hexes(c.body, finer_hexes * automatic_resolution(*surface, CellType::hex8)));
}

StudyValues true_values(const SyntheticCase& c, const Study& study) {
    StudyValues values = declared_values(study);
    values.youngs_modulus_Pa = c.material.youngs_modulus_Pa;
    values.damping_s = c.material.damping_s;
    values.translation_m = c.translation_m;
    values.rotation_rad = c.rotation_rad;
    values.effects.clear();
    if (c.effect && !is_slipped_clamp(c)) values.effects.push_back(*c.effect);
    return values;
}

}  // namespace myo
