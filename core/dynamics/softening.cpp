#include "dynamics/softening.hpp"

#include <algorithm>
#include <cmath>

#include "model/point_energy.hpp"

namespace myo {

using Eigen::VectorXd;

void raise_peaks(const Model& model, const Eigen::Matrix3Xd& x, VectorXd& peak) {
    const VectorXd now = isochoric_energy_densities(model, x);
    if (peak.size() == 0) peak = VectorXd::Zero(now.size());
    for (Eigen::Index c = 0; c < now.size(); ++c)
        if (std::isfinite(now(c))) peak(c) = std::max(peak(c), now(c));
}

VectorXd softening_factors(const StressSoftening& softening, const VectorXd& peak) {
    return peak.unaryExpr([&](double energy) { return softening.factor(energy); });
}

}  // namespace myo
