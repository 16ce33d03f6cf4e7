#include "backend/body_actuators.hpp"

#include <utility>

#include "experiment/actuators.hpp"
#include "model/body.hpp"

namespace myo::backend {

Result<ui::commands::BodyActuators> body_actuators(const experiment::Experiment& experiment,
                                                   const mesh::SurfaceMesh& surface, const setup::BodyMesh& mesh,
                                                   const mesh::BoundaryFaces& boundary) {
    ui::commands::BodyActuators shown;
    // Cavities need the mesh and its boundary only, not the element data of a whole body.
    model::Body body;
    body.mesh = mesh.mesh;
    body.boundary = boundary;
    const Result<std::vector<setup::Chamber>> chambers = setup::find_chambers(experiment, surface, mesh, body);
    if (!chambers) return chambers.error();
    for (const setup::Chamber& chamber : *chambers)
        shown.chambers.push_back({chamber.name, chamber.walls, chamber.volume_m3, chamber.wall_area_m2});
    // find_tendons() keeps the order of declaration, so names and routes share an index.
    const std::vector<setup::Tendon> tendons = setup::find_tendons(experiment, surface, mesh);
    for (std::size_t i = 0; i < tendons.size(); ++i) {
        ui::commands::ShownTendon& tendon = shown.tendons.emplace_back();
        tendon.name = experiment.tendons[i].name;
        for (std::size_t g = 0; g < tendons[i].route.guides.size(); ++g) {
            const model::TendonGuide& guide = tendons[i].route.guides[g];
            ui::commands::ThreadGuide& place = tendon.guides.emplace_back();
            place.declared = tendons[i].declared[g];
            place.rest_m = guide.rest_m;
            if (guide.on_body) place.nodes = guide.on_body->nodes, place.weights = guide.on_body->weights;
        }
    }
    return shown;
}

std::map<std::string, ui::commands::ShownCommand> shown_commands(const setup::Setup& setup,
                                                                 const setup::PreparedTrial& trial) {
    std::map<std::string, ui::commands::ShownCommand> commands;
    // `recorded_commands` has no entries of muscles; those of chambers, then tendons, follow the order of actuators().
    std::size_t next = 0;
    for (const experiment::Actuator& actuator : experiment::actuators(setup.experiment)) {
        if (actuator.kind == experiment::ActuatorKind::muscle || next >= trial.recorded_commands.size()) continue;
        ui::commands::ShownCommand& command = commands[actuator.name] = shown_unit(actuator);
        command.signal = trial.recorded_commands[next++];
    }
    return commands;
}

ui::commands::ShownCommand shown_unit(const experiment::Actuator& actuator) {
    if (actuator.unit == "Pa") return {{}, "kPa", 1e3};
    if (actuator.unit == "m") return {{}, "mm", 1e-3};
    return {{}, actuator.unit, 1.0};
}

}  // namespace myo::backend
