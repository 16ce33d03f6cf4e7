#pragma once

#include <Eigen/Core>

#include "model/model.hpp"

namespace myo::dynamics {

/// Updates the largest isochoric energy density reached at each quadrature point with that at x.
///
/// The softening factors are frozen within a step, so that a step remains a minimisation. They lag the motion by one
/// step, a first-order error while the softening grows.
/// @param x          node positions, 3 x n [m]
/// @param peak_J_m3  in/out, one entry per point; empty: virgin. Points with a non-finite energy keep their value.
void raise_peaks(const model::Model& model, const Eigen::Matrix3Xd& x, Eigen::VectorXd& peak_J_m3);

/// Factors of the elastic moduli, one per quadrature point.
Eigen::VectorXd softening_factors(const material::StressSoftening& softening, const Eigen::VectorXd& peak_J_m3);

}  // namespace myo::dynamics
