#pragma once

#include <Eigen/Core>

#include <functional>
#include <vector>

#include "dynamics/stage_problem.hpp"

namespace myo::dynamics {

/// Recent changes of position and gradient, and the search direction they make of a metric: L-BFGS.
/// Source: Nocedal & Wright 2006, alg. 7.4; Liu, Bouaziz & Kavan 2017 (metrics of elastic bodies).
class CurvaturePairs {
public:
    explicit CurvaturePairs(std::size_t most) : most_(most) {}

    /// Keeps s = change of position, y = change of gradient, when they curve upwards.
    void add(const Eigen::VectorXd& s, const Eigen::VectorXd& y);
    void clear() { pairs_.clear(); }
    bool empty() const { return pairs_.empty(); }

    /// -H g, where `metric` applies the inverse Hessian that is assumed without pairs.
    Eigen::VectorXd direction(const Eigen::VectorXd& g,
                              const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& metric) const;

private:
    struct Pair {
        Eigen::VectorXd s, y;
        double inverse_sy;
    };
    std::size_t most_;
    std::vector<Pair> pairs_;  // the oldest first
};

struct QuasiNewtonOptions {
    double tolerance = 1e-7;  // residual over `scale`
    double scale = 1.0;       // [N]
    int max_iterations = 30;
    double slow_contraction = 0.5;  // two steps in a row that shrink the residual by less end the search
    std::size_t pairs = 8;
};

struct QuasiNewtonResult {
    bool converged = false;
    int iterations = 0;
    double residual = 0.0;  // relative
};

/// Minimises the stage's potential from x in a given metric. On failure x is the best iterate.
QuasiNewtonResult quasi_newton(const StageProblem& problem, const QuasiNewtonOptions& options,
                               const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& metric,
                               Eigen::Matrix3Xd& x);

}  // namespace myo::dynamics
