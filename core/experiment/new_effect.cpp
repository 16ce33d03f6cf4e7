#include "experiment/new_effect.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include "effect/catalogue.hpp"
#include "experiment/actuators.hpp"

namespace myo::experiment {
namespace {

using effect::EffectParameterEntry;
using effect::EffectParameterKind;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Axis along which the body reaches from its support, and the middle of its end face opposite the clamp [m].
struct FreeEnd {
    int axis = 0;
    Vector3d point_m;
};

/// Estimate from the bounding box of the body alone; supports besides the clamp do not count.
FreeEnd free_end(const Experiment& experiment, const Box& body) {
    const Vector3d middle = 0.5 * (body.lowest + body.highest), size = body.size();
    FreeEnd end;
    end.point_m = middle;
    size.maxCoeff(&end.axis);
    Vector3d held = Vector3d::Zero();
    const Box& clamp = experiment.clamp_box_m;
    // A body that only an obstacle bears has an empty box.
    if ((clamp.lowest.array() <= clamp.highest.array()).all()) {
        held = 0.5 * (clamp.lowest + clamp.highest) - middle;
        // The axis along which the clamp is farthest off the middle, relative to the extent.
        held.cwiseAbs().cwiseQuotient(size).maxCoeff(&end.axis);
    }
    end.point_m(end.axis) = held(end.axis) > 0.0 ? body.lowest(end.axis) : body.highest(end.axis);
    return end;
}

/// Two significant digits, so that fields show short numbers.
double rounded(double value) {
    if (!(std::abs(value) > 0.0)) return 0.0;
    const double last_digit = std::floor(std::log10(std::abs(value))) - 1.0;
    // Division by a whole power of ten gives the double next to the decimal number.
    return last_digit < 0.0 ? std::round(value * std::pow(10.0, -last_digit)) / std::pow(10.0, -last_digit)
                            : std::round(value / std::pow(10.0, last_digit)) * std::pow(10.0, last_digit);
}

/// A plausible amount: the geometric mean of its range.
double plausible(const effect::EffectDraw& draw) { return rounded(std::sqrt(draw.lowest * draw.highest)); }

/// Names that a parameter of this kind may have in this experiment; empty for kinds that are no names.
std::vector<std::string> names_for(EffectParameterKind kind, const Experiment& experiment) {
    std::vector<std::string> names;
    if (kind == EffectParameterKind::trial)
        for (const TrialDeclaration& trial : experiment.trials) names.push_back(trial.name);
    if (kind == EffectParameterKind::actuator)
        for (const Actuator& actuator : actuators(experiment)) names.push_back(actuator.name);
    if (kind == EffectParameterKind::marker || kind == EffectParameterKind::marker_pair)
        for (const MarkerDeclaration& marker : experiment.markers.on_body) names.push_back(marker.name);
    return names;
}

/// Values of the parameters of one effect.
class NewValues {
public:
    NewValues(const effect::Effect& effect, const Experiment& experiment, const NewEffectPlace& place)
        : effect_(effect), experiment_(experiment), place_(place), end_(free_end(experiment, place.body)) {
        const Vector3d& g = experiment.gravity_m_s2;
        if (g.norm() > 0.0) up_ = -g.normalized();
    }

    effect::EffectParameter value(const EffectParameterEntry& entry) const {
        switch (entry.kind) {
            case EffectParameterKind::number:
            case EffectParameterKind::number_or_vector3:
            case EffectParameterKind::number_or_list: return number(entry);
            case EffectParameterKind::vector3: return VectorXd(vector(entry));
            case EffectParameterKind::direction: return VectorXd(direction(entry));
            case EffectParameterKind::axis: return axis();
            case EffectParameterKind::marker_pair: {
                // Two markers that exist, as far as there are two; otherwise the reader refuses the name of the
                // parameter.
                std::vector<std::string> pair{entry.name, entry.name};
                const std::vector<std::string> names = names_for(entry.kind, experiment_);
                for (std::size_t k = 0; k < std::min(pair.size(), names.size()); ++k) pair[k] = names[k];
                return pair;
            }
            case EffectParameterKind::marker:
            case EffectParameterKind::trial:
            case EffectParameterKind::actuator: break;
        }
        const std::vector<std::string> names = names_for(entry.kind, experiment_);
        return names.empty() ? entry.name : names.front();
    }

private:
    bool is_amount(const EffectParameterEntry& entry) const { return entry.name == effect_.draw.amount; }

    /// The order matters: an amount takes precedence over the scale, an event's time over both.
    double number(const EffectParameterEntry& entry) const {
        double value = entry.scale;  // a change of this size matters
        if (is_amount(entry)) value = plausible(effect_.draw);
        // Numbers that are not fitted and have no range are times of events; phases begin at zero.
        if (!(entry.scale > 0.0)) value = place_.time_s;
        if (entry.optional) value = 0.0;
        return std::clamp(value, entry.lowest, entry.highest);
    }

    /// An amount with a direction is a shift; other vectors are places, optional ones off the body.
    Vector3d vector(const EffectParameterEntry& entry) const {
        // A shift is upwards, against gravity.
        if (is_amount(entry)) return plausible(effect_.draw) * up_;
        const Box& body = place_.body;
        const bool at_end = effect_.kind == effect::EffectKind::force;
        const Vector3d point = at_end ? end_.point_m : Vector3d(0.5 * (body.lowest + body.highest));
        return entry.optional ? Vector3d(point + body.size().norm() * up_) : point;
    }

    /// Upwards; an axis to turn about lies across gravity and, if possible, across the body.
    Vector3d direction(const EffectParameterEntry& entry) const {
        if (entry.name != "axis") return up_;
        const Vector3d across = up_.cross(Vector3d::Unit(end_.axis));
        return across.norm() > 1e-6 ? Vector3d(across.normalized()) : Vector3d(up_.unitOrthogonal());
    }

    /// Moduli vary along the body. Everything else acts across it, in the direction in which gravity bends it: along z,
    /// or y if the body extends along z.
    double axis() const {
        if (effect_.varies_within_cells) return end_.axis;
        int best = end_.axis == 2 ? 1 : 2;
        const Vector3d bending = (up_ - up_(end_.axis) * Vector3d::Unit(end_.axis)).cwiseAbs();
        if (bending.maxCoeff() > 1e-6) bending.maxCoeff(&best);
        return best;
    }

    const effect::Effect& effect_;
    const Experiment& experiment_;
    const NewEffectPlace& place_;
    FreeEnd end_;
    Vector3d up_ = Vector3d::UnitZ();
};

}  // namespace

effect::EffectDeclaration new_effect(const effect::Effect& effect, const Experiment& experiment,
                                     const NewEffectPlace& place) {
    effect::EffectDeclaration declaration;
    declaration.id = effect.id;
    declaration.law = effect::find_law(effect.id, experiment.laws);
    const NewValues values(effect, experiment, place);
    for (const EffectParameterEntry& entry : effect.parameters)
        declaration.parameters[entry.name] = values.value(entry);
    return declaration;
}

std::string lacking_for(const effect::Effect& effect, const Experiment& experiment) {
    if (effect.draw.needs.tendon && experiment.tendons.empty()) return "a tendon";
    if (effect.kind == effect::EffectKind::actuation && actuators(experiment).empty())
        return "a muscle, chamber or tendon";
    // The effect acts by a weight that hangs on the body, which an experiment declares as a force.
    const auto has_force = [](const TrialDeclaration& trial) {
        return std::any_of(trial.loads.begin(), trial.loads.end(),
                           [](const LoadDeclaration& load) { return load.kind == LoadKind::force; });
    };
    if (effect.draw.needs.hung_weight && std::none_of(experiment.trials.begin(), experiment.trials.end(), has_force))
        return "a force as a load of a trial";
    return {};
}

}  // namespace myo::experiment
