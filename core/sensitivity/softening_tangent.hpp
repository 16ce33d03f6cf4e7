#pragma once

#include <Eigen/Core>

#include <vector>

#include "model/force_columns.hpp"
#include "model/model.hpp"
#include "sensitivity/model_change.hpp"

namespace myo::sensitivity {

/// Largest isochoric energy densities of the points so far, and their derivatives along parameters. Where points have
/// it at the same time again and again there is no derivative; there it is that of the first time.
struct PeakTangents {
    Eigen::VectorXd energy_J_m3;  // point_count
    Eigen::MatrixXd derivative;   // point_count x parameters
};

/// raise_peaks() at x, which moves along `dx` per unit of the parameters; pairs: the models on both sides of each.
void raise_peaks(const model::Model& model, const Eigen::Matrix3Xd& x, const model::NodalColumns& dx,
                 const std::vector<ModelPair>& pairs, PeakTangents& peaks);

/// Derivatives of the softening factors, point_count x parameters; the pairs tell those of the law's own numbers.
Eigen::MatrixXd factor_tangents(const material::StressSoftening& softening, const std::vector<ModelPair>& pairs,
                                const PeakTangents& peaks);

}  // namespace myo::sensitivity
