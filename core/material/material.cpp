#include "material/material.hpp"

namespace myo {

TensorFunction Material::distortion(const Eigen::Matrix3d& F, double mu, double kappa, bool with_hessian) const {
    LawResponse<double> response;
    respond(F, mu, kappa, with_hessian, response);
    return response.distortion;
}

TensorFunction Material::volume_measure(const Eigen::Matrix3d& F, bool with_hessian) const {
    LawResponse<double> response;
    if (has_split()) respond(F, 1.0, 1.0, with_hessian, response);
    else response.volume.hessian.setZero();   // zero, as the value and the gradient are
    return response.volume;
}

}  // namespace myo
