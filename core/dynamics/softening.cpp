#include "dynamics/softening.hpp"

#include <algorithm>
#include <cmath>

#include "model/point_energy.hpp"

namespace myo::dynamics {

using Eigen::VectorXd;

void raise_peaks(const model::Model& model, const Eigen::Matrix3Xd& x, VectorXd& peak) {
    const VectorXd now = model::isochoric_energy_densities(model, x);
    if (peak.size() == 0) peak = VectorXd::Zero(now.size());
    for (Eigen::Index c = 0; c < now.size(); ++c)
        // An inverted point has no finite energy and keeps its peak.
        if (std::isfinite(now(c))) peak(c) = std::max(peak(c), now(c));
}

VectorXd softening_factors(const material::StressSoftening& softening, const VectorXd& peak) {
    return peak.unaryExpr([&](double energy) { return softening.factor(energy); });
}

}  // namespace myo::dynamics
