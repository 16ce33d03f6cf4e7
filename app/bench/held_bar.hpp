#pragma once

#include <Eigen/Core>

#include <functional>
#include <string>

#include "base/result.hpp"
#include "bench/beam_theory.hpp"
#include "dynamics/stage_solver.hpp"
#include "model/model.hpp"

namespace myo::bench {

/// A bar of beam_theory.hpp as a neo-Hookean body with all nodes at x = 0 clamped; no gravity.
model::Model held_bar(const BarShape& bar, fem::ElementKind element, mesh::VolumeMesh mesh);

/// Integrals of the shape functions over the free end (highest x), divided by its area, one per node, sum 1: weights of
/// the mean of a nodal field, or shares of a uniform load.
Eigen::VectorXd free_end_share(const model::Body& body);

/// Unit torque about the bar axis, as nodal forces 3 x n [N] on the free end, perpendicular and proportional to the
/// lever arm. Its product with displacements is the mean rotation [rad].
Eigen::Matrix3Xd unit_torque(const model::Body& body);

/// First natural mode in bending along z.
struct BendingMode {
    double omega_rad_s = 0.0;
    double damping_factor = 0.0;  // see material_damping.hpp
};

/// Linearised statics and vibration about the rest shape, with one factorisation.
class SmallMotions {
public:
    /// Factorises the stiffness at rest.
    ///
    /// @param model  must outlive the object
    explicit SmallMotions(const model::Model& model);
    SmallMotions(const SmallMotions&) = delete;
    SmallMotions& operator=(const SmallMotions&) = delete;

    /// Displacements 3 x n [m] under nodal forces 3 x n [N].
    Eigen::Matrix3Xd under(const Eigen::Matrix3Xd& forces_N);

    /// First bending mode by inverse iteration from the static deflection. The iteration ends on the Rayleigh quotient,
    /// which converges where rounding hides the residual of natural_modes() (length over height 40 at nu = 0.4995).
    BendingMode first_bending();

    const Eigen::Matrix3Xd& weight_N() const { return weight_; }  // nodal forces at 1 m/s2 along -z

private:
    const model::Model& model_;
    dynamics::StageSolver solver_;
    dynamics::Stage stage_;
    solver::SymmetricSparse stiffness_;
    Eigen::Matrix3Xd weight_;
};

}  // namespace myo::bench
