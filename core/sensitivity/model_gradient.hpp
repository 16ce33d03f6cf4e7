#pragma once

#include <Eigen/Core>

#include <vector>

#include "model/internal_forces.hpp"
#include "model/model.hpp"
#include "model/virtual_work.hpp"

namespace myo::sensitivity {

/// Derivative of a scalar (a loss) with respect to all inputs of a run, in units of the loss per unit of the input.
struct ModelGradient {
    std::vector<material::Moduli> moduli;  // per cell, [1/Pa]
    std::vector<double> law;               // per parameter of the constitutive law
    double damping_s = 0.0;
    double density_kg_m3 = 0.0;
    double velocity_force_1_s = 0.0;
    Eigen::Vector3d gravity_m_s2 = Eigen::Vector3d::Zero();
    std::vector<std::vector<double>> activation;  // per fibre group and knot of its signal
    std::vector<double> fibre_stiffness_Pa;       // per fibre group
    std::vector<std::vector<Eigen::VectorXd>>
        fibre_shape;                                   // per group and point, see FibrePoint::shape; only on request
    std::vector<std::vector<double>> fibre_volume_m3;  // per group and point; only on request
    std::vector<Eigen::Vector3d> forces_N;             // per dead force
    std::vector<double> attached_masses_kg;            // per attached mass
    std::vector<double> directional_masses;       // per directional mass: derivative with respect to a factor on it
    std::vector<Eigen::VectorXd> force_elements;  // per element, one entry per parameter
    Eigen::Matrix3Xd initial_positions;           // 3 x n; zero on clamped nodes, and for a start at equilibrium
    Eigen::Matrix3Xd initial_velocities;          // 3 x n; zero on clamped nodes
};

/// Gradient with respect to Young's modulus [per Pa] and Poisson's ratio of the law.
///
/// Both are shifted by the same amount in all given cells (all cells if empty); E and nu of each cell follow from its
/// moduli. Model::poissons_ratio, which sets the thinning of hex8 cells, is held: at rest their energy is stationary in
/// it.
material::YoungPoisson young_gradient(const model::Model& model, const ModelGradient& gradient,
                                      const std::vector<int>& cells = {});

/// Gradient with respect to the fibre direction in each cell, 3 x cells; zero in cells without fibres of the group.
///
/// The direction is a free vector: changes of its length are included. Asserts that the gradient contains the shapes of
/// the group.
Eigen::Matrix3Xd fibre_direction_gradient(const model::Model& model, const ModelGradient& gradient, std::size_t group);

/// Accumulates the gradient from the equilibria of a run (stages, jumps, start), each with its adjoint.
class GradientSum {
public:
    GradientSum(const model::Model& model, bool fibre_points);

    /// Equilibrium inertia M x + dW/dx = ... of a stage, a jump or the start, at the solution x.
    struct Balance {
        const Eigen::Matrix3Xd& x;                        // 3 x n [m]
        const Eigen::Matrix3Xd* v = nullptr;              // velocities for the force elements; null: at rest
        model::StrainRate rate;                           // null history: no derivative with respect to damping
        double time_s = 0.0;                              // instant of loads and activations
        bool before_jump = false;                         // loads left of a jump
        double inertia_at_s = 0.0;                        // see Stage
        const Eigen::Matrix3Xd* accelerations = nullptr;  // 3 x n: factor of M besides gravity; null: zero
        const Eigen::Matrix3Xd*
            by_velocity_force = nullptr;  // 3 x n: derivative of `accelerations` with respect to Lambda; null: zero
        const Eigen::VectorXd* softening = nullptr;  // factors of the elastic moduli at the points; null or empty: 1
    };
    /// Adds the contribution of one equilibrium.
    ///
    /// @param p   adjoint of its forces, 3 x n [loss per N], zero on clamped nodes
    /// @param Mp  times_mass(p) with the mass at `inertia_at_s`
    void add(const Balance& balance, const Eigen::Matrix3Xd& p, const Eigen::Matrix3Xd& Mp);

    /// Adds the contribution of a momentum M u with adjoint p, M at `at_s`.
    void add_momentum(double at_s, const Eigen::Matrix3Xd& p, const Eigen::Matrix3Xd& Mp, const Eigen::Matrix3Xd& u,
                      const Eigen::Matrix3Xd* by_velocity_force);

    /// Adds the explicit dependence on moduli and law of the sum of weight times isochoric energy density at x.
    ///
    /// @param weights  per quadrature point [loss per J/m3]
    void add_energies(const Eigen::Matrix3Xd& x, const Eigen::VectorXd& weights);

    /// The gradient; call once, at the end.
    ModelGradient take();

private:
    /// Work of elastic and viscous forces and parameters of the law.
    void add_material(const Balance& balance, const Eigen::Matrix3Xd& p);
    /// Contribution of M u for the isotropic masses: density and attached masses.
    void add_isotropic(const Eigen::Matrix3Xd& p, const Eigen::Matrix3Xd& isotropic_p, const Eigen::Matrix3Xd& u);

    const model::Model& model_;
    std::vector<model::MassSpan> masses_;
    std::vector<model::Stiffness> by_law_;  // derivative of the stiffness by each parameter of the law
    ModelGradient gradient_;
    model::ModuliWork moduli_;
    model::ModuliWork damping_;  // creeping body: viscous work of damping alone
    model::Model softened_;      // softening body: the model with the factors of the present equilibrium
    model::FibreWork fibres_;
    double of_mass_ = 0.0;  // sum of p . M u over the isotropic mass; the share of the density is this minus that of
                            // the attached masses
};

}  // namespace myo::sensitivity
