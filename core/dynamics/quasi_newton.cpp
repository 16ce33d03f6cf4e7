#include "dynamics/quasi_newton.hpp"

#include <cmath>

namespace myo::dynamics {

using Eigen::VectorXd;

void CurvaturePairs::add(const VectorXd& s, const VectorXd& y) {
    // Curvature condition: without it the update would lose positive definiteness.
    const double sy = s.dot(y);
    if (!(sy > 1e-12 * s.norm() * y.norm())) return;
    if (pairs_.size() == most_) pairs_.erase(pairs_.begin());
    pairs_.push_back({s, y, 1.0 / sy});
}

VectorXd CurvaturePairs::direction(const VectorXd& g, const std::function<VectorXd(const VectorXd&)>& metric) const {
    // Two-loop recursion: newest to oldest before the metric, oldest to newest after it.
    VectorXd q = -g;
    std::vector<double> alpha(pairs_.size());
    for (std::size_t i = pairs_.size(); i-- > 0;) {
        alpha[i] = pairs_[i].inverse_sy * pairs_[i].s.dot(q);
        q -= alpha[i] * pairs_[i].y;
    }
    VectorXd p = metric(q);
    for (std::size_t i = 0; i < pairs_.size(); ++i)
        p += (alpha[i] - pairs_[i].inverse_sy * pairs_[i].y.dot(p)) * pairs_[i].s;
    return p;
}

QuasiNewtonResult quasi_newton(const StageProblem& problem, const QuasiNewtonOptions& options,
                               const std::function<VectorXd(const VectorXd&)>& metric, Eigen::Matrix3Xd& x) {
    QuasiNewtonResult result;
    CurvaturePairs pairs(options.pairs);
    StageProblem::Evaluation now = problem.evaluate(x, model::HessianKind::none);
    int slow = 0;
    while (true) {
        result.residual = now.residual.norm() / options.scale;
        if (!std::isfinite(result.residual)) return result;
        if (result.residual <= options.tolerance) {
            // A guess within the tolerance is nevertheless corrected once, because its errors would otherwise
            // accumulate from step to step.
            if (result.iterations == 0) {
                const Eigen::Matrix3Xd corrected = x + model::scatter(problem.pattern(), metric(-now.residual));
                const double left = problem.evaluate(corrected, model::HessianKind::none).residual.norm() /
                                    options.scale;
                ++result.iterations;
                if (left < result.residual) {
                    result.residual = left;
                    x = corrected;
                }
            }
            result.converged = true;
            return result;
        }
        if (result.iterations >= options.max_iterations || slow >= 2) return result;
        ++result.iterations;
        VectorXd p = pairs.direction(now.residual, metric);
        double slope = now.residual.dot(p);
        // Loss of descent is usually due to old curvature pairs: retry without them.
        if (!(slope < 0.0)) {
            if (pairs.empty()) return result;  // not even the bare metric gives a descent direction
            pairs.clear();
            p = pairs.direction(now.residual, metric);
            slope = now.residual.dot(p);
            if (!(slope < 0.0)) return result;
        }
        double length = 1.0;
        StageProblem::Evaluation next;
        Eigen::Matrix3Xd trial;
        bool accepted = false;
        for (int shortening = 0; shortening < 4; ++shortening, length *= 0.3) {
            trial = x + model::scatter(problem.pattern(), length * p);
            next = problem.evaluate(trial, model::HessianKind::none);
            // Close to the solution rounding hides the decrease of the potential; then the residual decides.
            accepted = next.residual.allFinite() && (next.residual.norm() < 0.9 * now.residual.norm() ||
                                                     next.potential <= now.potential + 1e-4 * length * slope);
            if (accepted) break;
        }
        if (!accepted) return result;
        slow = next.residual.norm() > options.slow_contraction * now.residual.norm() ? slow + 1 : 0;
        pairs.add(length * p, next.residual - now.residual);
        x = std::move(trial);
        now = std::move(next);
    }
}

}  // namespace myo::dynamics
