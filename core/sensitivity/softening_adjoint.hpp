#pragma once

#include <Eigen/Core>

#include "dynamics/stage_solver.hpp"
#include "model/model.hpp"

namespace myo::sensitivity {

/// Adjoint of the peak energies of a softening body, which soften the next step (see dynamics/softening.hpp).
///
/// Backwards through a run, forces that used the peaks add to it, and a point that reached a new peak passes its part
/// on to the positions. A maximum that is attained repeatedly belongs to the first time, as for PeakTangents.
class PeakAdjoint {
public:
    /// Prepares the solver for the transposition of stages with these peaks [J/m3].
    static void soften(dynamics::StageSolver& solver, const Eigen::VectorXd& peak);

    /// Adds the part of the peaks in the elastic forces at x, whose adjoint is p: 3 x n.
    void use(const model::Model& model, const Eigen::VectorXd& peak, const Eigen::Matrix3Xd& x,
             const Eigen::Matrix3Xd& p);

    /// Transposes dynamics::raise_peaks().
    ///
    /// @param before  peaks before the positions x were reached [J/m3]; empty: zero
    /// @return        weights of the energy densities at x that were new peaks, whose part is zero afterwards
    Eigen::VectorXd take_raised(const model::Model& model, const Eigen::VectorXd& before, const Eigen::Matrix3Xd& x);

private:
    Eigen::VectorXd of_peak_;  // per quadrature point; empty: zero
};

}  // namespace myo::sensitivity
