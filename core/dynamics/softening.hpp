#pragma once

#include <Eigen/Core>

#include "model/model.hpp"

namespace myo::dynamics {

/// Raises the largest isochoric energy density of every point [J/m3] to that at x, where it has one; empty: virgin
/// ones. The factors that follow from it are frozen within a step, so that a step stays a minimisation, and the motion
/// lags behind them by a step: of first order while the softening grows.
void raise_peaks(const model::Model& model, const Eigen::Matrix3Xd& x, Eigen::VectorXd& peak_J_m3);

/// The factors of the elastic moduli at the points.
Eigen::VectorXd softening_factors(const material::StressSoftening& softening, const Eigen::VectorXd& peak_J_m3);

}  // namespace myo::dynamics
