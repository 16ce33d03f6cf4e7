#include "backend/scene_setup.hpp"

#include "effect/catalogue.hpp"
#include "experiment/actuators.hpp"
#include "experiment/new_effect.hpp"
#include "mesh/surface_mesh.hpp"
#include "setup/parts.hpp"

namespace myo::backend {
namespace {

/// Declared effects, and every effect that can be added with start values; `lacking` says what one needs first.
ui::commands::SceneEffects shown_effects(const experiment::Experiment& experiment, const Box& body, double time_s) {
    ui::commands::SceneEffects shown;
    shown.declared = experiment.effects;
    for (const effect::Effect* const entry : effect::all_effects(experiment.laws)) {
        shown.offered.push_back(experiment::new_effect(*entry, experiment, {body, time_s}));
        shown.lacking.push_back(experiment::lacking_for(*entry, experiment));
    }
    for (const experiment::Actuator& actuator : experiment::actuators(experiment))
        shown.actuators.push_back(actuator.name);
    return shown;
}

/// Shape [m] and friction coefficient of an obstacle.
ui::commands::SceneObstacle shown_obstacle(const experiment::ObstacleDeclaration& declared) {
    using Declared = experiment::ObstacleDeclaration;
    ui::commands::SceneObstacle shown;
    shown.friction = declared.friction;
    if (const auto* plane = std::get_if<Declared::Plane>(&declared.shape))
        shown.shape = ui::commands::ScenePlane{plane->point_m, plane->normal};
    else if (const auto* sphere = std::get_if<Declared::Sphere>(&declared.shape))
        shown.shape = ui::commands::SceneSphere{sphere->centre_m, sphere->radius_m};
    else
        shown.shape = std::get<Box>(declared.shape);
    return shown;
}

/// A part with its declared values. An empty damping time is that of the body.
ui::commands::ScenePart shown_part(const experiment::PartDeclaration& declared) {
    ui::commands::ScenePart shown;
    shown.name = declared.name;
    if (const Box* box = std::get_if<Box>(&declared.place)) shown.box_m = *box;
    if (const auto* file = std::get_if<std::filesystem::path>(&declared.place)) shown.file = *file;
    if (const auto* region = std::get_if<experiment::PartDeclaration::Region>(&declared.place))
        shown.region = region->number;
    if (const auto* painted = std::get_if<experiment::PartDeclaration::Painted>(&declared.place)) {
        const auto* const file = std::get_if<std::filesystem::path>(&painted->mask);
        if (!file)
            shown.mask = std::get<1>(painted->mask);
        else if (Result<fibre::PaintedMask> mask = fibre::read_painted_mask(*file))
            shown.mask = std::make_shared<const fibre::PaintedMask>(std::move(*mask));
    }
    shown.youngs_modulus_Pa = declared.youngs_modulus_Pa;
    shown.youngs_modulus_tolerance = declared.youngs_modulus_tolerance;
    shown.poissons_ratio = declared.poissons_ratio;
    shown.density_kg_m3 = declared.density_kg_m3;
    shown.damping_s = declared.damping_s;
    shown.calibrated = declared.calibrate;
    return shown;
}

}  // namespace

Eigen::MatrixXd shown_part_shares(const experiment::Experiment& experiment, const setup::BodyMesh& mesh) {
    std::vector<std::string> ignored;
    const Result<Eigen::MatrixXd> shares = setup::part_shares(experiment, mesh, ignored);
    return shares ? *shares : Eigen::MatrixXd();
}

void show_declared(const experiment::Experiment& experiment, const mesh::SurfaceMesh& surface, double time_s,
                   ui::commands::Scene& scene) {
    scene.effects = shown_effects(experiment, mesh::bounding_box(surface.vertices), time_s);
    scene.obstacles.clear();
    for (const experiment::ObstacleDeclaration& obstacle : experiment.obstacles)
        scene.obstacles.push_back(shown_obstacle(obstacle));
    scene.parts.clear();
    for (const experiment::PartDeclaration& part : experiment.parts) scene.parts.push_back(shown_part(part));
}

}  // namespace myo::backend
