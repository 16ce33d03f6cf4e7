#include <cmath>
#include <memory>

#include "model/force_element.hpp"
#include "sensitivity/gradient_check.hpp"

namespace myo::sensitivity {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

const Vector3d direction = Vector3d(0.6, -0.5, 0.62).normalized();  // parallel to no axis

/// A field over the free nodes that varies from node to node, so that it is orthogonal to no mode.
Matrix3Xd rough_field(const model::Body& body) {
    Matrix3Xd field(3, body.node_count());
    for (Eigen::Index i = 0; i < field.size(); ++i) field(i) = std::sin(0.3 + 1.7 * static_cast<double>(i));
    return model::free_part(body, field);
}

/// Changes E or nu of every cell by the given amount.
void shift_elasticity(model::Model& model, double by_modulus, double by_ratio) {
    for (material::Moduli& m : model.moduli) {
        const auto [E, nu] = material::young_from_moduli(m);
        m = material::moduli_from_young(E + by_modulus, nu + by_ratio);
    }
}

/// Copy of the model's fibres, which models otherwise share, for modification.
std::vector<fibre::FibreGroup>& own_fibres(model::Model& model) {
    auto copy = std::make_shared<std::vector<fibre::FibreGroup>>(*model.fibres);
    model.fibres = copy;
    return *copy;
}

/// A cell with at least one free node, searched from the middle of the list: a fully clamped cell has no influence.
std::size_t movable_cell(const model::Body& body) {
    const int count = body.cell_count();
    for (int i = 0; i < count; ++i) {
        const int cell = (count / 2 + i) % count;
        for (const int node : body.mesh.cells.col(cell))
            if (!body.clamped[static_cast<std::size_t>(node)]) return static_cast<std::size_t>(cell);
    }
    return 0;
}

/// E, nu, mu of one cell, damping, density and velocity force.
void add_material(const model::Model& model, std::vector<CheckedParameter>& list) {
    const auto [E, nu] = material::young_from_moduli(model.moduli.front());
    list.push_back({"Young's modulus", 1e-3 * E,
                    [](model::Model& m, dynamics::SimulationOptions&, double by) { shift_elasticity(m, by, 0.0); },
                    [&model](const ModelGradient& g) { return young_gradient(model, g).youngs_modulus_Pa; }});
    list.push_back({"Poisson's ratio", 1e-2 * (0.5 - nu),
                    [](model::Model& m, dynamics::SimulationOptions&, double by) { shift_elasticity(m, 0.0, by); },
                    [&model](const ModelGradient& g) { return young_gradient(model, g).poissons_ratio; }});
    const std::size_t cell = movable_cell(*model.body);
    list.push_back({"mu of cell " + std::to_string(cell), 1e-3 * model.moduli[cell].mu,
                    [cell](model::Model& m, dynamics::SimulationOptions&, double by) { m.moduli[cell].mu += by; },
                    [cell](const ModelGradient& g) { return g.moduli[cell].mu; }});
    const std::vector<material::LawParameter> law = model.material->parameters();
    for (std::size_t k = 0; k < law.size(); ++k)
        list.push_back({law[k].name, law[k].over_decades ? 1e-2 * model.material->values()[k] : 0.1 * law[k].scale,
                        [k](model::Model& m, dynamics::SimulationOptions&, double by) {
                            std::vector<double> values = m.material->values();
                            values[k] += by;
                            m.material = m.material->with_values(values);
                        },
                        [k](const ModelGradient& g) { return g.law[k]; }});
    if (model.damping_s > 0.0)
        list.push_back({"damping time", 1e-2 * model.damping_s,
                        [](model::Model& m, dynamics::SimulationOptions&, double by) { m.damping_s += by; },
                        [](const ModelGradient& g) { return g.damping_s; }});
    list.push_back({"density", 1e-3 * model.density_kg_m3,
                    [](model::Model& m, dynamics::SimulationOptions&, double by) { m.density_kg_m3 += by; },
                    [](const ModelGradient& g) { return g.density_kg_m3; }});
    // The velocity force may be zero: absolute step.
    list.push_back({"velocity force", 0.01,
                    [](model::Model& m, dynamics::SimulationOptions&, double by) { m.velocity_force_1_s += by; },
                    [](const ModelGradient& g) { return g.velocity_force_1_s; }});
}

/// Gravity, dead forces, attached and directional masses. Steps are relative to the mass of the body.
void add_loads(const model::Model& model, std::vector<CheckedParameter>& list) {
    const double mass = model.density_kg_m3 * model.body->volume_m3;
    list.push_back({"gravity", 1e-2,
                    [](model::Model& m, dynamics::SimulationOptions&, double by) { m.gravity_m_s2 += by * direction; },
                    [](const ModelGradient& g) { return g.gravity_m_s2.dot(direction); }});
    for (std::size_t f = 0; f < model.forces.size(); ++f)
        list.push_back(
            {"force " + std::to_string(f), 1e-2 * mass,
             [f](model::Model& m, dynamics::SimulationOptions&, double by) { m.forces[f].force_N += by * direction; },
             [f](const ModelGradient& g) { return g.forces_N[f].dot(direction); }});
    for (std::size_t k = 0; k < model.masses.size(); ++k)
        list.push_back({"attached mass " + std::to_string(k), 1e-3 * mass,
                        [k](model::Model& m, dynamics::SimulationOptions&, double by) { m.masses[k].mass_kg += by; },
                        [k](const ModelGradient& g) { return g.attached_masses_kg[k]; }});
    for (std::size_t k = 0; k < model.directional_masses.size(); ++k)
        list.push_back({"directional mass " + std::to_string(k), 1e-3,
                        [k](model::Model& m, dynamics::SimulationOptions&, double by) {
                            m.directional_masses[k].inertia_kg *= 1.0 + by;
                        },
                        [k](const ModelGradient& g) { return g.directional_masses[k]; }});
}

/// Whether a knot influences a run: of those before t = 0 only the last one does, and none after the end.
bool acts(const fibre::Signal& signal, std::size_t knot, double end_s) {
    return (knot + 1 == signal.values.size() || signal.times_s[knot + 1] >= 0.0) && signal.times_s[knot] <= end_s;
}

/// Fibre stiffness, directions and the knots of the signals.
void add_fibres(const model::Model& model, const dynamics::SimulationOptions& options,
                std::vector<CheckedParameter>& list) {
    for (std::size_t g = 0; g < model.fibres->size(); ++g) {
        const std::string name = (*model.fibres)[g].name;
        list.push_back(
            {"stiffness of " + name, 1e-3 * (*model.fibres)[g].stiffness_Pa,
             [g](model::Model& m, dynamics::SimulationOptions&, double by) { own_fibres(m)[g].stiffness_Pa += by; },
             [g](const ModelGradient& d) { return d.fibre_stiffness_Pa[g]; }});
        list.push_back({"directions of " + name, 1e-3,
                        [g](model::Model& m, dynamics::SimulationOptions&, double by) {
                            fibre::FibreGroup& group = own_fibres(m)[g];
                            for (std::size_t k = 0; k < group.points.size(); ++k)
                                group.points[k].shape += by * (group.gradients[k] * direction);
                        },
                        [&model, g](const ModelGradient& d) {
                            return direction.dot(fibre_direction_gradient(model, d, g).rowwise().sum());
                        }});
        list.push_back({"amount of " + name, 1e-3,
                        [g](model::Model& m, dynamics::SimulationOptions&, double by) {
                            for (fibre::FibrePoint& point : own_fibres(m)[g].points) point.volume *= 1.0 + by;
                        },
                        [&model, g](const ModelGradient& d) {
                            const std::vector<fibre::FibrePoint>& points = (*model.fibres)[g].points;
                            double sum = 0.0;
                            for (std::size_t k = 0; k < points.size(); ++k)
                                sum += points[k].volume * d.fibre_volume_m3[g][k];
                            return sum;
                        }});
        const fibre::Signal& signal = model.activation[g];
        for (std::size_t k = 0; k < signal.values.size(); ++k) {
            if (acts(signal, k, options.end_s))
                list.push_back({"activation of " + name + ", knot " + std::to_string(k), 1e-3,
                                [g, k](model::Model& m, dynamics::SimulationOptions&, double by) {
                                    m.activation[g].values[k] += by;
                                },
                                [g, k](const ModelGradient& d) { return d.activation[g][k]; }});
        }
    }
}

/// Parameters of the force elements, with 1e-3 of their own scale as step.
void add_force_elements(const model::Model& model, const dynamics::SimulationOptions& options,
                        std::vector<CheckedParameter>& list) {
    for (std::size_t e = 0; e < model.force_elements.size(); ++e) {
        const std::vector<model::ForceParameter> parameters = model.force_elements[e]->parameters();
        const fibre::Signal* const command = model.force_elements[e]->command();
        for (std::size_t k = 0; k < parameters.size(); ++k) {
            // The first parameters are the knots of the command.
            if (command && k < command->values.size() && !acts(*command, k, options.end_s)) continue;
            const auto index = static_cast<Eigen::Index>(k);
            list.push_back({"force element " + std::to_string(e) + ", " + parameters[k].name,
                            1e-3 * parameters[k].scale,
                            [e, index](model::Model& m, dynamics::SimulationOptions&, double by) {
                                Eigen::VectorXd values = model::parameter_values(*m.force_elements[e]);
                                values(index) += by;
                                m.force_elements[e] = m.force_elements[e]->changed(values);
                            },
                            [e, index](const ModelGradient& g) { return g.force_elements[e](index); }});
        }
    }
}

/// Initial positions (unless the run starts at equilibrium) and velocities.
void add_start(const model::Model& model, const dynamics::SimulationOptions& options,
               std::vector<CheckedParameter>& list) {
    const Matrix3Xd& X = model.body->mesh.nodes;
    const Matrix3Xd field = rough_field(*model.body);
    const double edge = std::cbrt(model.body->volume_m3 / model.body->cell_count());
    if (!options.starts_at_equilibrium())
        list.push_back({"initial positions", 1e-4 * edge,
                        [X, field](model::Model&, dynamics::SimulationOptions& o, double by) {
                            if (o.initial.positions.size() == 0) o.initial.positions = X;
                            o.initial.positions += by * field;
                        },
                        [field](const ModelGradient& g) { return g.initial_positions.cwiseProduct(field).sum(); }});
    list.push_back({"initial velocities", edge,
                    [field](model::Model&, dynamics::SimulationOptions& o, double by) {
                        if (o.initial.velocities.size() == 0) o.initial.velocities = Matrix3Xd::Zero(3, field.cols());
                        o.initial.velocities += by * field;
                    },
                    [field](const ModelGradient& g) { return g.initial_velocities.cwiseProduct(field).sum(); }});
}

}  // namespace

std::vector<CheckedParameter> checked_parameters(const model::Model& model,
                                                 const dynamics::SimulationOptions& options) {
    std::vector<CheckedParameter> list;
    add_material(model, list);
    add_loads(model, list);
    add_fibres(model, options, list);
    add_force_elements(model, options, list);
    add_start(model, options, list);
    return list;
}

}  // namespace myo::sensitivity
