#pragma once

#include <Eigen/Core>

#include "model/model.hpp"

namespace myo::model {

/// Isochoric energy per rest volume at every point of the body at x (3 x n), see Body::point_entry [J/m3]: what the
/// shear modulus answers for. Not finite where the law knows no such deformation.
Eigen::VectorXd isochoric_energy_densities(const Model& model, const Eigen::Matrix3Xd& x);

}  // namespace myo::model
