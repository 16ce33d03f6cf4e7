#include "effect/cell_stiffness.hpp"

#include <algorithm>

#include "effect/places.hpp"

namespace myo {

void scale_stiffness(const EffectSite& site, const std::function<double(const Eigen::Vector3d&)>& factor, Affected& affected) {
    const Eigen::Matrix3Xd centres = cell_centres(*site.body);
    for (std::size_t c = 0; c < affected.model.moduli.size(); ++c) {
        const double times = std::max(0.01, factor(centres.col(static_cast<Eigen::Index>(c))));
        affected.model.moduli[c].mu *= times;
        affected.model.moduli[c].kappa *= times;
    }
}

}  // namespace myo
