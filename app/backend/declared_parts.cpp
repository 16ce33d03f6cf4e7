#include "backend/declared_parts.hpp"

#include <utility>

#include "experiment/actuators.hpp"
#include "experiment/cavities.hpp"
#include "mesh/winding_number.hpp"

namespace myo::backend {
namespace {

using ui::commands::DeclaredCommand;
using ui::commands::SceneCavity;

/// Closed cavities of the surface with the names of their chambers; of nested cavities, the smallest around a chamber's
/// point is the chamber.
std::vector<SceneCavity> scene_cavities(const experiment::Experiment& experiment, const mesh::SurfaceMesh& surface) {
    std::vector<SceneCavity> cavities;
    const experiment::BodyQueries body(surface);
    for (experiment::SurfaceCavity& found : experiment::surface_cavities(body))
        cavities.push_back(
            {std::move(found.cavity.wall), found.inside_m, found.cavity.volume_m3, found.cavity.area_m2, ""});
    for (const experiment::ChamberDeclaration& chamber : experiment.chambers) {
        // The wall of a cavity faces inward as seen from the cavity, so its winding number inside is -1.
        SceneCavity* around = nullptr;
        for (SceneCavity& cavity : cavities)
            if (mesh::winding_number(cavity.wall, chamber.inside_m) < -0.5 &&
                (around == nullptr || cavity.volume_m3 < around->volume_m3))
                around = &cavity;
        if (around != nullptr) around->chamber = chamber.name;
    }
    return cavities;
}

/// How a trial declares the command of each chamber and tendon, by name; without an entry: no command.
std::map<std::string, DeclaredCommand> commands_of(const experiment::Experiment& experiment,
                                                   const experiment::TrialDeclaration& trial,
                                                   const setup::PreparedTrial& prepared) {
    std::map<std::string, DeclaredCommand> commands;
    std::size_t next = 0;
    for (const experiment::Actuator& actuator : experiment::actuators(experiment)) {
        if (actuator.kind == experiment::ActuatorKind::muscle || next >= prepared.recorded_commands.size()) continue;
        // Without a key of its own, a command that is not zero all along comes from the file.
        for (const double value : prepared.recorded_commands[next].values)
            if (value != 0.0 && trial.actuation) commands[actuator.name] = {DeclaredCommand::Kind::file, 0.0};
        ++next;
        // A key of the trial for this actuator replaces the guess "file".
        for (const experiment::ConstantCommand& constant : trial.constant_commands)
            if (constant.actuator == actuator.name)
                commands[actuator.name] = constant.curve
                                              ? DeclaredCommand{DeclaredCommand::Kind::curve, constant.value,
                                                                *constant.curve}
                                              : DeclaredCommand{DeclaredCommand::Kind::constant, constant.value};
        for (const experiment::ActuationStep& step : trial.actuation_steps)
            if (step.muscle == actuator.name)
                commands[actuator.name] = {DeclaredCommand::Kind::step, step.level.value_or(0.0)};
    }
    return commands;
}

}  // namespace

ui::commands::DeclaredParts declared_parts(const setup::Setup& setup) {
    const experiment::Experiment& experiment = setup.experiment;
    ui::commands::DeclaredParts parts;
    parts.max_standoff_m = experiment.markers.max_standoff_m;
    const auto limit = [&](const char* key, const std::optional<double>& value) {
        if (value) parts.limits[key] = *value;
    };
    limit("pressure_Pa", experiment.limits.pressure_Pa);
    limit("tension_N", experiment.limits.tension_N);
    limit("shortening_m", experiment.limits.shortening_m);
    for (const experiment::MuscleDeclaration& muscle : experiment.muscles) parts.muscles.push_back(muscle.name);
    for (const experiment::Actuator& actuator : experiment::actuators(experiment))
        if (!actuator.sought) parts.kept.insert(actuator.name);
    for (const experiment::ChamberDeclaration& chamber : experiment.chambers) parts.chambers.push_back(chamber.name);
    for (const experiment::TendonDeclaration& tendon : experiment.tendons)
        parts.tendons.push_back({tendon.name, tendon.path_m, tendon.drive == experiment::TendonDrive::shortening,
                                 tendon.stiffness_N_m, tendon.friction, tendon.channel});
    parts.cavities = scene_cavities(experiment, setup.surface);
    for (std::size_t t = 0; t < setup.trials.size(); ++t)
        parts.commands.push_back(commands_of(experiment, experiment.trials[t], setup.trials[t]));
    return parts;
}

}  // namespace myo::backend
