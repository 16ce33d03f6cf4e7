#pragma once

#include <Eigen/Core>

#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "fibre/fibre_group.hpp"
#include "fibre/signal.hpp"
#include "material/material.hpp"
#include "material/maxwell_branch.hpp"
#include "material/moduli.hpp"
#include "material/stress_softening.hpp"
#include "model/body.hpp"
#include "model/directional_mass.hpp"
#include "model/mass_matrix.hpp"
#include "model/mass_model.hpp"

namespace myo::model {

/// Force of fixed direction distributed over nodes, active in [from_s, until_s) and scaled by its course.
struct DeadForce {
    Eigen::VectorXd share;                                     // per node, sums to 1
    Eigen::Vector3d force_N = Eigen::Vector3d::Zero();         // total force, world frame
    double from_s = -std::numeric_limits<double>::infinity();  // start, included
    double until_s = std::numeric_limits<double>::infinity();  // end, excluded
    fibre::Signal course = fibre::Signal::constant(1.0);       // factor of force_N over time

    /// True at time t [s].
    bool active(double t) const { return t >= from_s && t < until_s; }
    /// True just before time t [s]: the left limit of active().
    bool active_before(double t) const { return t > from_s && t <= until_s; }
    /// Factor of force_N at t [s]; with `before` the left limit.
    double factor(double t, bool before) const {
        if (before) return active_before(t) ? course.value_before(t) : 0.0;
        return active(t) ? course.value(t) : 0.0;
    }
    /// Whether the force has no course but its start and end.
    bool switches() const { return course.values.size() == 1; }
};

/// Rigid body attached to the specimen; contributes weight and inertia.
struct AttachedMass {
    Eigen::VectorXd share;  // per node, >= 0, sums to 1
    double mass_kg = 0.0;   // >= 0
};

class ForceElement;
using ForceElementPointer = std::shared_ptr<const ForceElement>;

/// Constant data of a simulation: body, material, fibres and loads. Cheap to copy, because large parts are shared.
struct Model {
    BodyPointer body;                      // discretisation and clamped nodes
    material::MaterialPointer material;    // constitutive law
    std::vector<material::Moduli> moduli;  // [Pa] per cell
    Eigen::VectorXd point_factors;         // scale the moduli at the body's points (see Body::point_entry); empty: 1
    std::vector<double> poissons_ratio;    // per cell, for the bending of hex8 cells; constant under differentiation.
                                           // Empty: from the moduli
    double damping_s = 0.0;                // Kelvin-Voigt damping: S = 2 damping mu dev(dE/dt)
    std::vector<double> damping_excess_s;  // per cell, damping time beyond damping_s; empty: 0. Not of creeping bodies
    double density_kg_m3 = 0.0;            // of the rest configuration
    std::vector<double> density_factors;   // per cell, on density_kg_m3; empty: 1
    MassModel mass_model = MassModel::consistent;            // how the density is discretised
    double velocity_force_1_s = 0.0;                         // Lambda of the force f = Lambda M v ; 0: none
    Eigen::Vector3d gravity_m_s2 = Eigen::Vector3d::Zero();  // world frame
    std::shared_ptr<const std::vector<fibre::FibreGroup>> fibres = std::make_shared<std::vector<fibre::FibreGroup>>();
    std::vector<fibre::Signal> activation;            // a(t) per fibre group
    std::vector<DeadForce> forces;                    // dead loads
    std::vector<AttachedMass> masses;                 // with weight and inertia
    std::vector<DirectionalMass> directional_masses;  // with inertia only
    std::vector<ForceElementPointer> force_elements;  // springs, pressures, drag, ...
    // Memory of past strain in simulations; statics and modes use the relaxed body
    std::optional<material::MaxwellBranch> creep;
    // Memory of the largest strain; each simulation and each equilibrium starts from the virgin state
    std::optional<material::StressSoftening> softening;
};

/// Poisson's ratio of each cell, from its moduli.
std::vector<double> poissons_ratios(const std::vector<material::Moduli>& moduli);

/// Equal moduli in all cells.
std::vector<material::Moduli> uniform_moduli(int cell_count, double youngs_modulus_Pa, double poissons_ratio);

/// External dead forces: weight of body and attached masses plus active dead loads.
///
/// @param t       [s]
/// @param before  left limit at a discontinuity
/// @return        3 x n [N], world frame
Eigen::Matrix3Xd external_forces(const Model& model, const MassMatrix& mass, double t, bool before = false);

/// Activations of all fibre groups.
///
/// @param t       [s]
/// @param before  left limit at a discontinuity
std::vector<double> activations(const Model& model, double t, bool before = false);

/// Times of discontinuities of forces, directional masses, activations and force elements.
///
/// @return  [s], ascending, unique
std::vector<double> jump_times(const Model& model);

}  // namespace myo::model
