#include "experiment/actuators.hpp"

#include <algorithm>

namespace myo::experiment {

std::vector<Actuator> actuators(const Experiment& experiment) {
    std::vector<Actuator> all;
    for (std::size_t i = 0; i < experiment.muscles.size(); ++i) {
        const std::string& name = experiment.muscles[i].name;
        all.push_back({ActuatorKind::muscle, i, name, name, "", 1.0, experiment.muscles[i].sought});
    }
    for (std::size_t i = 0; i < experiment.chambers.size(); ++i) {
        const std::string& name = experiment.chambers[i].name;
        all.push_back({ActuatorKind::chamber, i, name, name + "_Pa", "Pa", 0.0, experiment.chambers[i].sought});
    }
    for (std::size_t i = 0; i < experiment.tendons.size(); ++i) {
        const std::string& name = experiment.tendons[i].name;
        const bool sought = experiment.tendons[i].sought;
        if (experiment.tendons[i].drive == TendonDrive::tension)
            all.push_back({ActuatorKind::tendon_tension, i, name, name + "_N", "N", 0.0, sought});
        else
            all.push_back({ActuatorKind::tendon_shortening, i, name, name + "_m", "m", 0.0, sought});
    }
    return all;
}

std::optional<std::size_t> find_actuator(const Experiment& experiment, const std::string& name) {
    const std::vector<Actuator> all = actuators(experiment);
    const auto found = std::find_if(all.begin(), all.end(), [&](const Actuator& a) { return a.name == name; });
    if (found == all.end()) return std::nullopt;
    return static_cast<std::size_t>(found - all.begin());
}

std::string constant_key(ActuatorKind kind) {
    switch (kind) {
        case ActuatorKind::muscle: return "activation";
        case ActuatorKind::chamber: return "pressure_Pa";
        case ActuatorKind::tendon_tension: return "tension_N";
        case ActuatorKind::tendon_shortening: return "shortening_m";
    }
    return {};
}

std::string quantity_word(ActuatorKind kind) {
    const std::string key = constant_key(kind);  // with its unit behind a dash
    return key.substr(0, key.find('_'));
}

}  // namespace myo::experiment
