#include "solver/gmres.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <vector>

namespace myo::solver {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct GmresPolicy {
    /// Basis vectors before a restart: factors of the symmetric part need 5 to 20 iterations.
    Index restart = 40;
};
constexpr GmresPolicy gmres_policy;

/// One cycle of at most `most` iterations from x; returns the number of iterations.
int cycle(const VectorProduct& product, const VectorProduct& preconditioner, const VectorXd& b, double wanted, int most,
          VectorXd& x) {
    const VectorXd r = b - product(x);
    const double size = r.norm();
    const Index count = std::min<Index>(gmres_policy.restart, most);
    if (!(size > wanted) || count < 1) return 0;
    // Arnoldi basis of the preconditioned operator.
    std::vector<VectorXd> basis{r / size}, directions;
    MatrixXd H = MatrixXd::Zero(count + 1, count);
    VectorXd y;
    Index k = 0;
    while (k < count) {
        directions.push_back(preconditioner(basis.back()));
        VectorXd w = product(directions.back());
        for (Index i = 0; i <= k; ++i) {
            H(i, k) = w.dot(basis[static_cast<std::size_t>(i)]);
            w -= H(i, k) * basis[static_cast<std::size_t>(i)];
        }
        H(k + 1, k) = w.norm();
        ++k;
        const MatrixXd part = H.topLeftCorner(k + 1, k);
        const VectorXd first = size * VectorXd::Unit(k + 1, 0);
        y = part.colPivHouseholderQr().solve(first);
        const double left = (first - part * y).norm();
        if (!std::isfinite(left) || left <= wanted || H(k, k - 1) == 0.0) break;
        basis.push_back(w / H(k, k - 1));
    }
    for (Index i = 0; i < k; ++i) x += y(i) * directions[static_cast<std::size_t>(i)];
    return static_cast<int>(k);
}

}  // namespace

GmresReport gmres(const VectorProduct& product, const VectorProduct& preconditioner, const VectorXd& b,
                  double tolerance, int max_iterations, const VectorXd& guess) {
    GmresReport report;
    report.solution = guess.size() == b.size() ? guess : VectorXd::Zero(b.size());
    const double wanted = tolerance * b.norm();
    while (true) {
        const int taken = cycle(product, preconditioner, b, wanted, max_iterations - report.iterations,
                                report.solution);
        report.iterations += taken;
        if (!report.solution.allFinite()) return report;
        if (taken == 0) {
            report.converged = (b - product(report.solution)).norm() <= wanted;
            return report;
        }
    }
}

}  // namespace myo::solver
