#include "inverse/bounded_step.hpp"

#include <algorithm>
#include <cmath>

namespace myo::inverse {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct BoundedStepPolicy {
    /// Nearly parallel columns need many rounds; a round costs n^2 operations only.
    int max_rounds = 20000;
    double min_change = 1e-10;  // relative to the norm of the residual
};
constexpr BoundedStepPolicy bounded_step_policy;

}  // namespace

VectorXd bounded_step(const MatrixXd& A, const VectorXd& r, const VectorXd& lower, const VectorXd& upper) {
    // After forming H and the slope, an iteration is independent of the number of rows.
    const MatrixXd H = A.transpose() * A;
    VectorXd slope = A.transpose() * r;
    VectorXd x = VectorXd::Zero(A.cols());
    const double enough = bounded_step_policy.min_change * r.norm();
    for (int round = 0; round < bounded_step_policy.max_rounds; ++round) {
        double most = 0.0;
        for (Index i = 0; i < x.size(); ++i) {
            if (H(i, i) == 0.0) continue;
            // Exact minimum along coordinate i, clipped to its bounds.
            const double next = std::clamp(x(i) - slope(i) / H(i, i), lower(i), upper(i));
            const double change = next - x(i);
            if (change == 0.0) continue;
            slope += change * H.col(i);
            x(i) = next;
            most = std::max(most, std::abs(change) * std::sqrt(H(i, i)));
        }
        if (most <= enough) break;
    }
    return x;
}

}  // namespace myo::inverse
