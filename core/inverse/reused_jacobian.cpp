#include "inverse/reused_jacobian.hpp"

#include "inverse/fit_evaluations.hpp"

namespace myo::inverse {

using Eigen::MatrixXd;
using Eigen::VectorXd;

ReusedJacobian::ReusedJacobian(const std::vector<Parameter>& parameters, const JacobianFunction& jacobian,
                               const LeastSquaresOptions& options, const Progress& progress, LeastSquaresReport& report)
    : parameters_(parameters), jacobian_(jacobian), options_(options), progress_(progress), report_(report) {}

/// Internal values of all parameters, in which the optimiser moves.
VectorXd ReusedJacobian::internal(const VectorXd& values) const {
    VectorXd moved(values.size());
    for (Eigen::Index i = 0; i < values.size(); ++i)
        moved(i) = internal_value(parameters_[static_cast<std::size_t>(i)], values(i));
    return moved;
}

/// Whether the last Jacobian predicts the residuals at this point, see LeastSquaresOptions::max_prediction_error.
bool ReusedJacobian::foretells(const VectorXd& internal, const VectorXd& residuals) const {
    if (last_.size() == 0) return false;
    if (internal == internal_) return true;
    const VectorXd change = residuals - residuals_;
    return (change - last_ * (internal - internal_)).norm() <= options_.max_prediction_error * change.norm();
}

MatrixXd ReusedJacobian::at(const VectorXd& values, const ResidualEvaluation& there) {
    if (!jacobian_ || parameters_.empty() || there.jacobian.size() > 0) return there.jacobian;
    const VectorXd now = internal(values), slopes = physical_slopes(parameters_, now);
    if (!foretells(now, there.residuals) && !(progress_.cancelled() && last_.size() > 0)) {
        const MatrixXd fresh = jacobian_(values, there, progress_.with_sink({}));
        if (fresh.rows() != there.residuals.size() || fresh.cols() != values.size() || !fresh.allFinite()) return {};
        ++report_.jacobians;
        internal_ = now;
        residuals_ = there.residuals;
        // Stored with respect to internal values, returned with respect to physical ones.
        last_ = fresh * slopes.asDiagonal();
    }
    return last_ * slopes.cwiseInverse().asDiagonal();
}

}  // namespace myo::inverse
