#include "effect/law_effect.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>
#include <utility>

#include "effect/changed_body.hpp"
#include "effect/law_signal.hpp"
#include "effect/places.hpp"
#include "model/law_force.hpp"

namespace myo::effect {
namespace law_effect_parts {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr const char* position = "position_m";

struct LawEffectPolicy {
    std::size_t places = 10;  // on the surface, where the search for a force at a point starts
    double span = 10.0;       // factor of an amount to each side of its first start: plausible values
    double place_scale_m = 0.01, largest_place_m = 10.0;
};
constexpr LawEffectPolicy law_effect_policy;

/// Order in which a law is applied among other effects, by where it acts.
EffectKind kind_of(law::Place place) {
    switch (place) {
        case law::Place::surface:
        case law::Place::point:
        case law::Place::volume: return EffectKind::force;
        case law::Place::clamp: return EffectKind::support;
        case law::Place::signal: return EffectKind::actuation;
        case law::Place::camera: return EffectKind::measurement;
    }
    return EffectKind::force;
}

/// Numbers of the parameters of a law, in its order.
VectorXd numbers_of(const law::Law& law, const EffectParameters& parameters) {
    VectorXd numbers(law.number_count());
    Index k = 0;
    for (const law::Law::Parameter& parameter : law.parameters) {
        if (parameter.shape == law::Shape::vector) {
            numbers.segment<3>(k) = vector(parameters, parameter.name);
        } else {
            numbers(k) = number(parameters, parameter.name);
        }
        k += parameter.count();
    }
    return numbers;
}

/// Test conditions of the trial, in the order of the law.
std::vector<double> conditions_of(const law::Law& law, const TrialContext& context) {
    std::vector<double> values;
    for (const law::Law::Condition& condition : law.conditions) {
        const auto stated = context.condition.find(condition.name);
        // The reader refuses trials without it; what is made otherwise has no run.
        values.push_back(stated != context.condition.end() ? stated->second : std::nan(""));
    }
    return values;
}

/// Values of all variables that are the same throughout a trial.
std::vector<double> variables_of(const law::Law& law, const EffectParameters& parameters, const TrialContext& context) {
    std::vector<double> values(static_cast<std::size_t>(law.variable_count), 0.0);
    values[law::Variable::session_time] = context.session_time_s;
    const VectorXd numbers = numbers_of(law, parameters);
    Index k = 0;
    for (const law::Law::Parameter& parameter : law.parameters)
        for (int i = 0; i < parameter.count(); ++i)
            values[static_cast<std::size_t>(parameter.variable + i)] = numbers(k++);
    const std::vector<double> conditions = conditions_of(law, context);
    for (std::size_t c = 0; c < conditions.size(); ++c)
        values[static_cast<std::size_t>(law.conditions[c].variable)] = conditions[c];
    return values;
}

/// A law of a force, with what its elements need.
struct ForceLaw {
    std::shared_ptr<const model::LawPrograms> programs;
    VectorXd scales;                        // a change of each number that matters; 1 where none is stated
    std::vector<std::string> directions{};  // parameters of which fits move angles

    const law::Law& law() const { return programs->law; }
};

/// Compiles a law of a force. Takes the law out of the statement.
ForceLaw force_law(LawStatement& statement) {
    const VectorXd numbers = numbers_of(statement.law, statement.starts.front());
    ForceLaw force{nullptr, VectorXd::Ones(numbers.size())};
    Index k = 0;
    // One scale per component: k counts components, p parameters.
    for (std::size_t p = 0; p < statement.parameters.size(); ++p)
        for (int i = 0; i < statement.law.parameters[p].count(); ++i, ++k)
            if (statement.parameters[p].scale > 0.0) force.scales(k) = statement.parameters[p].scale;
    for (const EffectParameterEntry& entry : statement.parameters)
        if (entry.kind == EffectParameterKind::direction) force.directions.push_back(entry.name);
    force.programs = model::law_programs(std::move(statement.law), numbers);
    return force;
}

/// Nodes that the declared clamp holds, ascending.
std::vector<int> clamped_nodes(const model::Body& body) {
    std::vector<int> nodes;
    for (int i = 0; i < body.node_count(); ++i)
        if (body.clamped[static_cast<std::size_t>(i)]) nodes.push_back(i);
    return nodes;
}

/// The points at which a law acts; a clamp is released.
std::vector<model::LawCarrier> carriers_of(law::Place place, const TrialContext& context,
                                           const EffectParameters& parameters, Affected& affected) {
    const model::Body& body = *context.body;
    if (place == law::Place::surface) return model::law_points_of_faces(body, model::free_faces(body));
    if (place == law::Place::volume) return model::law_points_of_cells(body);
    if (place == law::Place::point) {
        const SurfacePlace at = surface_place(body, vector(parameters, position));
        return model::law_point(body, at.cell, at.nodes, at.shares, at.normal);
    }
    const std::vector<int> nodes = clamped_nodes(body), faces = model::faces_of_nodes(body, nodes);
    if (faces.empty()) return {};  // clamped nodes inside the body have no face
    affected.model.body = released_body(*affected.model.body, nodes);
    return model::law_points_of_faces(body, faces);
}

/// Appends the force element of the law, unless it acts nowhere.
void apply_force(const ForceLaw& force, const TrialContext& context, const EffectParameters& parameters,
                 Affected& affected) {
    auto carriers = std::make_shared<const std::vector<model::LawCarrier>>(
        carriers_of(force.law().place, context, parameters, affected));
    if (carriers->empty()) return;
    const model::LawConditions conditions{affected.model.gravity_m_s2, context.session_time_s,
                                          conditions_of(force.law(), context)};
    affected.model.force_elements.push_back(
        model::law_force(force.programs, carriers, conditions, numbers_of(force.law(), parameters), force.scales));
}

/// Derivative of a model by a number of the law: that of its force element by its parameter.
std::optional<sensitivity::ModelTangent> force_tangent(const ForceLaw& force, const EffectParameters& parameters,
                                                       const std::string& name, int component,
                                                       const Affected& affected) {
    // Fits move two angles of a direction, and the element knows its three components only.
    if (std::find(force.directions.begin(), force.directions.end(), name) != force.directions.end())
        return std::nullopt;
    const VectorXd numbers = numbers_of(force.law(), parameters);
    Index k = 0;
    bool found = false;
    for (const law::Law::Parameter& parameter : force.law().parameters) {
        found = parameter.name == name;
        if (found) break;
        k += parameter.count();
    }
    if (!found) return std::nullopt;
    const auto& elements = affected.model.force_elements;
    const auto is_own = [&](const model::ForceElementPointer& e) {
        return model::is_law_force(*e, *force.programs, numbers);
    };
    // Two declarations with equal values cannot be told apart.
    if (std::count_if(elements.begin(), elements.end(), is_own) != 1) return std::nullopt;
    sensitivity::ModelTangent tangent;
    tangent.force_elements.resize(elements.size());
    const auto own = static_cast<std::size_t>(std::find_if(elements.begin(), elements.end(), is_own) -
                                              elements.begin());
    tangent.force_elements[own] = VectorXd::Unit(numbers.size(), k + std::max(component, 0));
    return tangent;
}

/// A law of the cameras, compiled once: three components of the place, then their derivatives, row by row.
struct CameraLaw {
    law::Law law;
    law::Program seen;
};

/// Compiles a law of the cameras with its derivatives by the place.
CameraLaw camera_law(law::Law law) {
    std::vector<law::Node> outputs(law.result.begin(), law.result.end());
    for (const law::Node component : law.result)
        for (int j = 0; j < 3; ++j) outputs.push_back(law.expressions.derivative(component, law::Variable::x + j));
    law::Program program(law.expressions, outputs);
    return {std::move(law), std::move(program)};
}

/// Where the cameras see a point at x [m] at a time [s].
/// @param variables  see variables_of(); place and time are entered here
measurement::SeenPlace seen_by_law(const CameraLaw& camera, std::vector<double> variables, const Vector3d& x,
                                   double time_s) {
    for (int i = 0; i < 3; ++i) variables[static_cast<std::size_t>(law::Variable::x + i)] = x(i);
    variables[law::Variable::t] = time_s;
    const std::vector<double> out = law::run_once(camera.seen, variables);
    measurement::SeenPlace seen;
    for (std::size_t i = 0; i < 3; ++i) {
        seen.place_m(static_cast<Index>(i)) = out[i];
        for (std::size_t j = 0; j < 3; ++j)
            seen.by_place(static_cast<Index>(i), static_cast<Index>(j)) = out[3 + 3 * i + j];
    }
    return seen;
}

/// Start values of a search, with places for a force at a point.
class LawProbes {
public:
    explicit LawProbes(const LawStatement& statement)
        : place_(statement.law.place),
          starts_(statement.starts),
          amount_(statement.amount),
          reciprocal_(statement.absent_at_infinity) {
        for (const EffectParameterEntry& entry : statement.parameters)
            if (entry.of_signal) of_signal_.push_back(entry.name);
    }

    std::vector<EffectProbe> operator()(const EffectSearch& search) const {
        std::vector<EffectProbe> list;
        if (place_ == law::Place::signal && !any_signal(acts, search)) return list;
        for (EffectParameters start : starts_) {
            // Starts in the unit of the signal are stated as shares of its largest deviation from rest.
            for (const std::string& name : of_signal_) start[name] = number(start, name) * largest_input(search);
            if (place_ != law::Place::point) {
                list.push_back(probe_at(std::move(start)));
                continue;
            }
            for (const Vector3d& place : spread_surface_points(search.trials.front(), law_effect_policy.places)) {
                start[position] = VectorXd(place);
                list.push_back(probe_at(start));
            }
        }
        return list;
    }

private:
    EffectProbe probe_at(EffectParameters start) const { return {{std::move(start)}, amount_, reciprocal_, nullptr}; }

    law::Place place_;
    std::vector<EffectParameters> starts_;
    std::string amount_;
    bool reciprocal_;
    std::vector<std::string> of_signal_;
};

/// Range from which amounts of synthetic experiments are drawn; other parameters keep their starts.
EffectDraw draw_of(const LawStatement& statement) {
    EffectDraw draw;
    if (statement.amount.empty()) return draw;
    draw.amount = statement.amount;
    draw.grows = !statement.absent_at_infinity;
    const double start = std::abs(number(statement.starts.front(), statement.amount));
    draw.lowest = start / law_effect_policy.span;
    draw.highest = start * law_effect_policy.span;
    return draw;
}

}  // namespace law_effect_parts

Effect law_effect(LawStatement statement) {
    using namespace law_effect_parts;
    assert(!statement.starts.empty() && statement.parameters.size() == statement.law.parameters.size());
    Effect effect;
    effect.id = statement.id;
    effect.kind = kind_of(statement.law.place);
    effect.summary = statement.sentence;
    effect.parameters = statement.parameters;
    effect.has_corner = law::has_choices(statement.law);
    for (const law::Law::Condition& condition : statement.law.conditions) effect.conditions.push_back(condition.name);
    effect.draw = draw_of(statement);
    if (!statement.amount.empty()) effect.probes = LawProbes(statement);
    // The closures own the compiled law: the entry may outlive the statement.
    switch (statement.law.place) {
        case law::Place::signal:
            effect.parameters.push_back(signal_parameter());
            effect.apply = [law = signal_programs(std::move(statement.law))](
                               const TrialContext& context, const EffectParameters& parameters, Affected& affected) {
                const std::vector<double> variables = variables_of(law->law, parameters, context);
                respond_to_signals(
                    context, parameters, acts,
                    [&](const std::vector<double>& times_s, const std::vector<double>& u) {
                        return law_response(*law, variables, times_s, u);
                    },
                    affected);
            };
            return effect;
        case law::Place::camera:
            effect.apply = [camera = std::make_shared<const CameraLaw>(camera_law(std::move(statement.law)))](
                               const TrialContext& context, const EffectParameters& parameters, Affected& affected) {
                affected.observation_error.lenses.push_back(
                    [camera, variables = variables_of(camera->law, parameters, context)](const Vector3d& x, double t) {
                        return seen_by_law(*camera, variables, x, t);
                    });
            };
            return effect;
        default: break;
    }
    if (statement.law.place == law::Place::point)
        effect.parameters.push_back({position, EffectParameterKind::vector3, false, -law_effect_policy.largest_place_m,
                                     law_effect_policy.largest_place_m, law_effect_policy.place_scale_m});
    const auto force = std::make_shared<const ForceLaw>(force_law(statement));
    effect.apply = [force](const TrialContext& context, const EffectParameters& parameters, Affected& affected) {
        apply_force(*force, context, parameters, affected);
    };
    effect.tangent = [force](const EffectParameters& parameters, const std::string& name, int component,
                             const Affected& affected) {
        return force_tangent(*force, parameters, name, component, affected);
    };
    return effect;
}

}  // namespace myo::effect
