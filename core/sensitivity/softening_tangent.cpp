#include "sensitivity/softening_tangent.hpp"

#include <cmath>

#include "dynamics/start_state.hpp"
#include "model/point_energy.hpp"

namespace myo::sensitivity {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

struct SofteningTangentPolicy {
    /// Displacement of the difference quotients relative to the size of the body, as at the start of a run: energies
    /// are nearly quadratic in the positions.
    double motion_difference = 1e-5;
};
constexpr SofteningTangentPolicy softening_tangent_policy;

}  // namespace

void raise_peaks(const model::Model& model, const Matrix3Xd& x, const model::NodalColumns& dx,
                 const std::vector<ModelPair>& pairs, PeakTangents& peaks) {
    const VectorXd now = model::isochoric_energy_densities(model, x);
    const auto count = static_cast<Index>(pairs.size());
    MatrixXd derivative(now.size(), count);
    // Explicit dependence on the parameter, and that through the motion. Each has a width of its own: that of a pair of
    // equal models says nothing about the motion.
    const double size = softening_tangent_policy.motion_difference * std::cbrt(model.body->volume_m3);
    for (Index p = 0; p < count; ++p) {
        const ModelPair& pair = pairs[static_cast<std::size_t>(p)];
        derivative.col(p) = (model::isochoric_energy_densities(pair.over, dynamics::held_by(*pair.over.body, x)) -
                             model::isochoric_energy_densities(pair.under, dynamics::held_by(*pair.under.body, x))) /
                            pair.width;
        const Matrix3Xd moved = model::nodal_column(dx, p);
        const double most = moved.cwiseAbs().maxCoeff();
        if (most == 0.0) continue;
        const double step = size / most;
        derivative.col(p) += (model::isochoric_energy_densities(model, x + step * moved) -
                              model::isochoric_energy_densities(model, x - step * moved)) /
                             (2.0 * step);
    }
    if (peaks.energy_J_m3.size() == 0) peaks = {VectorXd::Zero(now.size()), MatrixXd::Zero(now.size(), count)};
    for (Index c = 0; c < now.size(); ++c)
        // Strictly larger: of equal maxima the first one keeps its derivative.
        if (std::isfinite(now(c)) && now(c) > peaks.energy_J_m3(c)) {
            peaks.energy_J_m3(c) = now(c);
            peaks.derivative.row(c) = derivative.row(c);
        }
}

MatrixXd factor_tangents(const material::StressSoftening& softening, const std::vector<ModelPair>& pairs,
                         const PeakTangents& peaks) {
    MatrixXd result(peaks.energy_J_m3.size(), static_cast<Index>(pairs.size()));
    for (Index c = 0; c < result.rows(); ++c) {
        const double W = peaks.energy_J_m3(c);
        for (Index p = 0; p < result.cols(); ++p) {
            const ModelPair& pair = pairs[static_cast<std::size_t>(p)];
            // Explicit dependence of the law plus the chain rule through the peak energy.
            const double own = (pair.over.softening->factor(W) - pair.under.softening->factor(W)) / pair.width;
            result(c, p) = own + softening.slope(W) * peaks.derivative(c, p);
        }
    }
    return result;
}

}  // namespace myo::sensitivity
