#include "sensitivity/softening_adjoint.hpp"

#include <cmath>
#include <utility>

#include "dynamics/softening.hpp"
#include "model/point_energy.hpp"

namespace myo::sensitivity {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::VectorXd;

void PeakAdjoint::soften(dynamics::StageSolver& solver, const VectorXd& peak) {
    solver.soften(dynamics::softening_factors(*solver.model().softening, peak));
}

void PeakAdjoint::use(const model::Model& model, const VectorXd& peak, const Matrix3Xd& x, const Matrix3Xd& p) {
    const VectorXd slope = peak.unaryExpr([&](double energy) { return model.softening->slope(energy); });
    if (of_peak_.size() == 0) of_peak_ = VectorXd::Zero(peak.size());
    of_peak_ -= slope.cwiseProduct(model::point_factor_work(model, x, p));
}

VectorXd PeakAdjoint::take_raised(const model::Model& model, const VectorXd& before, const Matrix3Xd& x) {
    const VectorXd now = model::isochoric_energy_densities(model, x);
    VectorXd raised = VectorXd::Zero(now.size());
    if (of_peak_.size() == 0) return raised;
    for (Index c = 0; c < now.size(); ++c)
        if (std::isfinite(now(c)) && now(c) > (before.size() > 0 ? before(c) : 0.0)) std::swap(raised(c), of_peak_(c));
    return raised;
}

}  // namespace myo::sensitivity
