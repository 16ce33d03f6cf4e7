#include "material/material.hpp"

#include <cassert>
#include <utility>

namespace myo::material {

MaterialPointer Material::with_values(const std::vector<double>&) const {
    assert(false && "a law with parameters overrides this");
    return nullptr;
}

MaterialPointer Material::by_parameter(std::size_t) const {
    assert(false && "a law with parameters overrides this");
    return nullptr;
}

TensorFunction Material::distortion(const Eigen::Matrix3d& F, double mu, double kappa, bool with_hessian) const {
    LawResponse<double> response;
    respond(F, mu, kappa, with_hessian, response);
    return response.distortion;
}

TensorFunction Material::volume_measure(const Eigen::Matrix3d& F, bool with_hessian) const {
    LawResponse<double> response;
    if (has_split())
        respond(F, 1.0, 1.0, with_hessian, response);
    else
        response.volume.hessian.setZero();  // consistent with the zero value and gradient
    return response.volume;
}

void Material::respond_whole(const Matrix3<Pack>& F, const Pack& mu, const Pack& kappa, Pack& energy,
                             Matrix3<Pack>& stress) const {
    LawResponse<Pack> response;
    respond(F, mu, kappa, false, response);
    energy = response.distortion.value;
    stress = response.distortion.gradient;
    if (!has_split()) return;
    const ScalarFunctionOf<Pack> U = bulk(response.volume.value, kappa);
    energy += U.value;
    stress += response.volume.gradient * U.first;
}

}  // namespace myo::material
