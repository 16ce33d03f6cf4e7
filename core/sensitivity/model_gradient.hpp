#pragma once

#include <Eigen/Core>

#include <vector>

#include "model/model.hpp"
#include "model/virtual_work.hpp"

namespace myo::sensitivity {

/// Derivative of a scalar (a loss) with respect to everything that a run depends on; units are those of the loss per
/// unit of the name.
struct ModelGradient {
    std::vector<material::Moduli> moduli;  // per cell
    double damping_s = 0.0;
    double density_kg_m3 = 0.0;
    double velocity_force_1_s = 0.0;
    Eigen::Vector3d gravity_m_s2 = Eigen::Vector3d::Zero();
    std::vector<std::vector<double>> activation;  // per fibre group and knot of its signal
    std::vector<double> fibre_stiffness_Pa;       // per group
    std::vector<std::vector<Eigen::VectorXd>>
        fibre_shape;                        // per group and point, see FibrePoint::shape; only when asked for
    std::vector<Eigen::Vector3d> forces_N;  // per dead force
    std::vector<double> attached_masses_kg;
    std::vector<double> directional_masses;       // per directional mass: of a factor on it
    std::vector<Eigen::VectorXd> force_elements;  // per element and parameter
    Eigen::Matrix3Xd initial_positions;           // 3 x n; zero on clamped nodes and where a run starts at equilibrium
    Eigen::Matrix3Xd initial_velocities;          // 3 x n; zero on clamped nodes
};

/// With respect to Young's modulus [per Pa] and Poisson's ratio of the law, shifted alike in the given cells (all of
/// them when empty); each cell has its own from its moduli. Model::poissons_ratio, by which hex8 cells thin, is held:
/// at rest their energy is stationary in it.
material::YoungPoisson young_gradient(const model::Model& model, const ModelGradient& gradient,
                                      const std::vector<int>& cells = {});

/// With respect to the fibre direction in each cell, 3 x cells (zero where the group has none), for a group whose
/// fibres have the direction as a free vector: changes of its length count, too. Asserts that the gradient has the
/// group's shapes.
Eigen::Matrix3Xd fibre_direction_gradient(const model::Model& model, const ModelGradient& gradient, std::size_t group);

/// Gathers the gradient from the equilibria of a run, each with its adjoint.
class GradientSum {
public:
    GradientSum(const model::Model& model, bool fibre_shapes);

    /// The equilibrium inertia M x + dW/dx = ... of a stage, a jump or the start, solved or evaluated at x.
    struct Balance {
        const Eigen::Matrix3Xd& x;
        const Eigen::Matrix3Xd* v = nullptr;  // for the force elements; null: at rest
        model::StrainRate rate;  // history null: not known, or no derivative with respect to damping wanted
        double time_s = 0.0;
        bool before_jump = false;
        double inertia_at_s = 0.0;  // see Stage
        const Eigen::Matrix3Xd*
            accelerations = nullptr;  // 3 x n: what the mass is multiplied by, gravity aside; null: nothing
        const Eigen::Matrix3Xd*
            by_velocity_force = nullptr;  // 3 x n: the derivative of that with respect to Lambda; null: none
    };
    /// p: the adjoint of its forces, 3 x n [1/N per loss], zero on clamped nodes. Mp: times_mass(p) with the mass of
    /// then.
    void add(const Balance& balance, const Eigen::Matrix3Xd& p, const Eigen::Matrix3Xd& Mp);

    /// M u, M of that time, enters a momentum with the adjoint p.
    void add_momentum(double at_s, const Eigen::Matrix3Xd& p, const Eigen::Matrix3Xd& Mp, const Eigen::Matrix3Xd& u,
                      const Eigen::Matrix3Xd* by_velocity_force);

    ModelGradient take();

private:
    void add_isotropic(const Eigen::Matrix3Xd& p, const Eigen::Matrix3Xd& isotropic_p, const Eigen::Matrix3Xd& u);

    const model::Model& model_;
    std::vector<model::MassSpan> masses_;
    ModelGradient gradient_;
    model::ModuliWork moduli_;
    model::FibreWork fibres_;
    double of_mass_ = 0.0;  // p . M u of the isotropic mass: the density's share is what the attached masses leave
};

}  // namespace myo::sensitivity
