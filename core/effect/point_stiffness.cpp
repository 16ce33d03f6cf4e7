#include "effect/point_stiffness.hpp"

#include <algorithm>

#include "model/internal_forces.hpp"
#include "model/rest_points.hpp"

namespace myo::effect {

void scale_stiffness(const TrialContext& context, const std::function<double(const Eigen::Vector3d&)>& factor,
                     Affected& affected) {
    const Eigen::Matrix3Xd points = model::rest_points(*context.body);
    Eigen::VectorXd factors(points.cols());
    // The lower bound keeps the stiffness positive.
    for (Eigen::Index i = 0; i < factors.size(); ++i) factors(i) = std::max(0.01, factor(points.col(i)));
    // Several effects of this kind multiply.
    affected.model.point_factors = model::times_factors(affected.model.point_factors, factors);
}

}  // namespace myo::effect
