#pragma once

#include <Eigen/Core>

#include "model/model.hpp"

namespace myo {

/// Mean isochoric energy per rest volume of every cell at x (3 x n), hourglass strains included [J/m3]: what the shear modulus answers
/// for. Not finite where the law knows no such deformation.
Eigen::VectorXd isochoric_energy_densities(const Model& model, const Eigen::Matrix3Xd& x);

}  // namespace myo
