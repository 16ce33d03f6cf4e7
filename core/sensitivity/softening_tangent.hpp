#pragma once

#include <Eigen/Core>

#include <vector>

#include "model/force_columns.hpp"
#include "model/model.hpp"
#include "sensitivity/model_change.hpp"

namespace myo::sensitivity {

/// Largest isochoric energy densities reached at the points, and their derivatives along parameters.
///
/// A maximum that is attained repeatedly is not differentiable; the derivative is then that of the first time.
struct PeakTangents {
    Eigen::VectorXd energy_J_m3;  // per quadrature point
    Eigen::MatrixXd derivative;   // point_count x parameters [J/m3 per unit]
};

/// Updates peaks as dynamics::raise_peaks() does, with derivatives.
///
/// @param dx     derivatives of x, one column per parameter
/// @param pairs  models on both sides of each parameter, for the explicit dependence of the energy
void raise_peaks(const model::Model& model, const Eigen::Matrix3Xd& x, const model::NodalColumns& dx,
                 const std::vector<ModelPair>& pairs, PeakTangents& peaks);

/// Derivatives of the softening factors, point_count x parameters. `pairs` supply the dependence on the parameters of
/// the softening law.
Eigen::MatrixXd factor_tangents(const material::StressSoftening& softening, const std::vector<ModelPair>& pairs,
                                const PeakTangents& peaks);

}  // namespace myo::sensitivity
