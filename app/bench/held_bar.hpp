#pragma once

#include <Eigen/Core>

#include <functional>
#include <string>

#include "base/result.hpp"
#include "bench/beam_theory.hpp"
#include "dynamics/stage_solver.hpp"
#include "model/model.hpp"

namespace myo::bench {

/// A bar of bench/beam_theory.hpp as a neo-Hookean body, all nodes at x = 0 held; no gravity.
model::Model held_bar(const BarShape& bar, fem::ElementKind element, mesh::VolumeMesh mesh);

/// Integral of the shape functions over the free end, where x is largest, over its area: the mean of a nodal field, or
/// the shares of an even load.
Eigen::VectorXd free_end_share(const model::Body& body);

/// Unit torque about the axis of the bar, over the free end: forces across the arm and in proportion to it, 3 x n [N].
/// Their product with displacements is the mean rotation [rad].
Eigen::Matrix3Xd unit_torque(const model::Body& body);

/// First vibration of a body in bending along z.
struct BendingMode {
    double omega_rad_s = 0.0;
    double damping_factor = 0.0;  // of material_damping.hpp
};

/// Small displacements about the rest shape: linear, and solved with one factor.
class SmallMotions {
public:
    explicit SmallMotions(const model::Model& model);
    SmallMotions(const SmallMotions&) = delete;
    SmallMotions& operator=(const SmallMotions&) = delete;

    /// Of the body under nodal forces, both 3 x n [N, m].
    Eigen::Matrix3Xd under(const Eigen::Matrix3Xd& forces_N);

    /// By inverse iteration from the sag: stops on Rayleigh's quotient, which converges where rounding hides the
    /// residual of natural_modes() (bars of 40 times their height with nu = 0.4995).
    BendingMode first_bending();

    const Eigen::Matrix3Xd& weight_N() const { return weight_; }  // under 1 m/s2 along -z

private:
    const model::Model& model_;
    dynamics::StageSolver solver_;
    dynamics::Stage stage_;
    solver::SymmetricSparse stiffness_;
    Eigen::Matrix3Xd weight_;
};

}  // namespace myo::bench
