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

/// A force of fixed direction over a part of the surface, active in [from_s, until_s).
struct DeadForce {
    Eigen::VectorXd share;  // per node, sums to 1
    Eigen::Vector3d force_N = Eigen::Vector3d::Zero();
    double from_s = -std::numeric_limits<double>::infinity();
    double until_s = std::numeric_limits<double>::infinity();

    bool active(double t) const { return t >= from_s && t < until_s; }
    bool active_before(double t) const { return t > from_s && t <= until_s; }
};

/// A body fixed to the specimen: weight and inertia.
struct AttachedMass {
    Eigen::VectorXd share;  // per node, sums to 1, never negative
    double mass_kg = 0.0;
};

class ForceElement;
using ForceElementPointer = std::shared_ptr<const ForceElement>;

/// Everything that does not change while it runs: a body with its material, fibres and loads. Cheap to copy.
struct Model {
    BodyPointer body;
    material::MaterialPointer material;
    std::vector<material::Moduli> moduli;  // per cell
    Eigen::VectorXd point_factors;         // of the moduli, at the body's points (see Body::point_entry); empty: 1
    std::vector<double> poissons_ratio;  // per cell, by which hex8 cells thin as they bend: a datum, which derivatives
                                         // hold; empty: that of the moduli
    double damping_s = 0.0;              // Kelvin-Voigt: S = 2 damping mu dev(dE/dt)
    double density_kg_m3 = 0.0;
    MassModel mass_model = MassModel::consistent;
    double velocity_force_1_s = 0.0;  // Lambda of f = Lambda M v; 0 = none
    Eigen::Vector3d gravity_m_s2 = Eigen::Vector3d::Zero();
    std::shared_ptr<const std::vector<fibre::FibreGroup>> fibres = std::make_shared<std::vector<fibre::FibreGroup>>();
    std::vector<fibre::Signal> activation;  // per fibre group
    std::vector<DeadForce> forces;
    std::vector<AttachedMass> masses;
    std::vector<DirectionalMass> directional_masses;
    std::vector<ForceElementPointer> force_elements;  // springs, pressures, drag ...
    std::optional<material::MaxwellBranch>
        creep;  // memory of the past strain: runs have it, statics and modes know the relaxed body
    std::optional<material::StressSoftening>
        softening;  // memory of the largest strain; every run and every equilibrium starts virgin
};

/// Poisson's ratio of the moduli of each cell.
std::vector<double> poissons_ratios(const std::vector<material::Moduli>& moduli);

/// The same moduli in every cell.
std::vector<material::Moduli> uniform_moduli(int cell_count, double youngs_modulus_Pa, double poissons_ratio);

/// Gravity on body and attached masses plus the forces active at t, 3 x n [N]. `before`: the limit from the left.
Eigen::Matrix3Xd external_forces(const Model& model, const MassMatrix& mass, double t, bool before = false);

/// Activations of all groups at t.
std::vector<double> activations(const Model& model, double t, bool before = false);

/// Times at which a force, a directional mass, an activation or a force element jumps, ascending, without repetition.
std::vector<double> jump_times(const Model& model);

}  // namespace myo::model
