#include "setup/actuator_signals.hpp"

#include <cassert>

#include "experiment/actuators.hpp"
#include "experiment/read_trial.hpp"
#include "model/force_element.hpp"
#include "setup/setup.hpp"

namespace myo::setup {
namespace {

/// Lowest and highest level, then the change that matters to a fit, in the unit of the signal.
struct LevelPolicy {
    LevelBounds muscle{0.05, 10.0, 0.1};
    double vacuum_Pa = -101325.0;  // lowest gauge pressure
    /// Pressures over the modulus of the body: beyond the largest the body would be torn.
    double largest_pressure_share = 10.0, pressure_scale_share = 0.02;
    LevelBounds tension_N{0.0, 1e4, 1.0};
    LevelBounds shortening_m{0.0, 10.0, 0.005};
};
const LevelPolicy level_policy;

}  // namespace

std::vector<std::string> actuator_names(const experiment::Experiment& experiment) {
    std::vector<std::string> names;
    for (const experiment::Actuator& actuator : experiment::actuators(experiment)) names.push_back(actuator.name);
    return names;
}

std::optional<std::size_t> actuator_element(const experiment::Experiment& experiment, std::size_t actuator) {
    if (actuator < experiment.muscles.size()) return std::nullopt;
    return actuator - experiment.muscles.size();
}

const fibre::Signal& actuator_signal(const experiment::Experiment& experiment, const model::Model& model,
                                     std::size_t actuator) {
    const std::optional<std::size_t> element = actuator_element(experiment, actuator);
    if (!element) return model.activation[actuator];
    assert(*element < model.force_elements.size() && model.force_elements[*element]->command() != nullptr);
    return *model.force_elements[*element]->command();
}

double passive_level(const experiment::Experiment& experiment, std::size_t actuator) {
    return actuator < experiment.muscles.size() ? 1.0 : 0.0;
}

std::string signal_unit(const experiment::Experiment& experiment, std::size_t actuator) {
    return experiment::actuators(experiment)[actuator].unit;
}

void set_level(const experiment::Experiment& experiment, std::size_t actuator, double level, model::Model& model) {
    if (const std::optional<std::size_t> element = actuator_element(experiment, actuator)) {
        model::ForceElementPointer& driven = model.force_elements[*element];
        // Elements are constant and shared between models, so the model gets a new one.
        driven = driven->with_command(fibre::Signal::step(0.0, 0.0, level));
    } else {
        model.activation = with_level(experiment, std::move(model.activation), actuator, level);
    }
}

sensitivity::ModelTangent level_model_tangent(const experiment::Experiment& experiment, std::size_t actuator,
                                              const model::Model& model) {
    sensitivity::ModelTangent tangent;
    const std::optional<std::size_t> element = actuator_element(experiment, actuator);
    if (!element) {
        tangent.activation = level_tangent(experiment, actuator);
        return tangent;
    }
    // The knots of the step are the first parameters of the element; the second one is the level.
    const auto count = static_cast<Eigen::Index>(model.force_elements[*element]->parameters().size());
    tangent.force_elements.resize(model.force_elements.size());
    tangent.force_elements[*element] = Eigen::VectorXd::Unit(count, 1);
    return tangent;
}

LevelBounds level_bounds(const experiment::Experiment& experiment, std::size_t actuator) {
    switch (experiment::actuators(experiment)[actuator].kind) {
        case experiment::ActuatorKind::muscle: return level_policy.muscle;
        case experiment::ActuatorKind::tendon_tension: return level_policy.tension_N;
        case experiment::ActuatorKind::tendon_shortening: return level_policy.shortening_m;
        case experiment::ActuatorKind::chamber: break;
    }
    const double E = experiment.material.youngs_modulus_Pa;
    return {level_policy.vacuum_Pa, level_policy.largest_pressure_share * E, level_policy.pressure_scale_share * E};
}

}  // namespace myo::setup
