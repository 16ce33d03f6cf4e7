#include "diagnosis/verdict/deviations.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <vector>

#include "effect/catalogue.hpp"
#include "statistics/autocorrelation.hpp"
#include "statistics/distributions.hpp"

namespace myo::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Rows of the least-squares estimator: numbers = rows * residuals, parameters x (N + S).
MatrixXd estimator(const JointFit& fit, const NumericsPolicy& policy) {
    const MatrixXd J = all_slopes(fit);
    VectorXd size = J.colwise().norm();
    size = (size.array() > 0.0).select(size, 1.0);
    // By the small triangular factor: the pseudoinverse of the whole matrix takes a square one of all residuals.
    const Eigen::HouseholderQR<MatrixXd> qr(J * size.cwiseInverse().asDiagonal());
    const Index small = std::min(J.rows(), J.cols());
    const MatrixXd Q = qr.householderQ() * MatrixXd::Identity(J.rows(), small);
    Eigen::CompleteOrthogonalDecomposition<MatrixXd> solver;
    solver.setThreshold(policy.tangent_tolerance);
    solver.compute(MatrixXd(qr.matrixQR().topRows(small).triangularView<Eigen::Upper>()));
    return size.cwiseInverse().asDiagonal() * solver.pseudoInverse() * Q.transpose();
}

/// The shift times a factor.
PredictionShift scaled(PredictionShift shift, double factor) {
    for (std::vector<Eigen::Matrix3Xd>& trial : shift)
        for (Eigen::Matrix3Xd& track : trial) track *= factor;
    return shift;
}

/// Possible errors of the flat residual by the extrapolations, each with its own sign.
std::vector<VectorXd> numerical_doubts(const FitData& data, const NumericalError& numerics, double share) {
    std::vector<VectorXd> doubts;
    const auto add = [&](const PredictionShift& shift, double factor) {
        if (!shift.empty()) doubts.push_back(flat_shift(data, scaled(shift, share * factor)));
    };
    add(numerics.step_shift, 1.0);
    add(numerics.mesh_change, numerics.mesh_factor);
    add(numerics.by_modulus, 1.0);
    return doubts;
}

}  // namespace

JudgedFit with_deviations(JudgedFit fit, const FitData& data, const NumericalError& numerics,
                          const NumericsPolicy& policy) {
    JointFit& of = fit.fit;
    VectorXd& deviations = of.report.deviations;
    const Index n = of.jacobian.cols();
    if (!fit.usable() || n == 0 || deviations.size() != n || of.jacobian.rows() != data.layout.size()) return fit;
    const MatrixXd rows = estimator(of, policy);
    const std::vector<VectorXd> doubts = numerical_doubts(
        data, numerics,
        effect::any_has_corner(of.values.effects) ? policy.doubt_of_corners : policy.extrapolation_doubt);
    const Index N = of.residual.size(), S = of.sensor_residual.size();
    for (Index i = 0; i < n; ++i) {
        if (!(deviations(i) > 0.0)) continue;  // fixed, or undetermined
        const VectorXd by_markers = rows.row(i).head(N);
        const double markers = by_markers.squaredNorm(), sensors = rows.row(i).tail(S).squaredNorm();
        if (!(markers + sensors > 0.0)) continue;
        // Residuals that are correlated in time count as fewer samples. Readings of sensors are taken as independent.
        const double inflation = markers > 0.0 ? statistics::variance_inflation(of.residual, by_markers, data.layout)
                                               : 1.0;
        double variance = std::pow(deviations(i), 2) * (inflation * markers + sensors) / (markers + sensors);
        // First-order change of the estimate by each possible error; the errors are independent of the noise.
        for (const VectorXd& doubt : doubts) variance += std::pow(by_markers.dot(doubt), 2);
        deviations(i) = std::sqrt(variance);
    }
    return fit;
}

std::optional<Interval> interval_95(const inverse::Parameter& parameter, double value, double deviation) {
    if (!std::isfinite(deviation)) return {};
    const double half = statistics::normal_upper_quantile(0.025) * deviation;
    Interval interval{value - half, value + half};
    if (parameter.over_decades && value > 0.0) {
        // The fit moves ln(1 + value / scale).
        const double factor = std::exp(half / (value + parameter.scale));
        interval = {(value + parameter.scale) / factor - parameter.scale,
                    (value + parameter.scale) * factor - parameter.scale};
    }
    return Interval{std::max(interval.low, parameter.lower), std::min(interval.high, parameter.upper)};
}

}  // namespace myo::diagnosis
