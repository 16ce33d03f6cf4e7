#pragma once

#include <Eigen/Core>

#include <functional>
#include <vector>

#include "dynamics/stage_problem.hpp"

namespace myo::dynamics {

/// L-BFGS: recent curvature pairs (s, y) and the search direction they give together with a metric.
///
/// Source: Nocedal & Wright 2006, alg. 7.4; Liu, Bouaziz & Kavan 2017 (metrics of elastic bodies).
class CurvaturePairs {
public:
    /// @param most  number of pairs kept; the oldest is dropped
    explicit CurvaturePairs(std::size_t most) : most_(most) {}

    /// Adds s = change of position, y = change of gradient. Ignored unless s'y > 0 (positive curvature).
    void add(const Eigen::VectorXd& s, const Eigen::VectorXd& y);
    void clear() { pairs_.clear(); }
    bool empty() const { return pairs_.empty(); }

    /// Search direction -H g (two-loop recursion).
    ///
    /// @param metric  applies the initial inverse Hessian, i.e. the one assumed without any pairs
    Eigen::VectorXd direction(const Eigen::VectorXd& g,
                              const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& metric) const;

private:
    struct Pair {
        Eigen::VectorXd s, y;
        double inverse_sy;
    };
    std::size_t most_;
    std::vector<Pair> pairs_;  // oldest first
};

/// Tolerances of quasi_newton().
struct QuasiNewtonOptions {
    double tolerance = 1e-7;  // relative residual, |gradient| / scale
    double scale = 1.0;       // [N]
    int max_iterations = 30;
    double slow_contraction = 0.5;  // stop after two iterations in a row with a larger ratio of residuals
    std::size_t pairs = 8;          // L-BFGS history
};

/// Outcome of quasi_newton().
struct QuasiNewtonResult {
    bool converged = false;
    int iterations = 0;
    double residual = 0.0;  // relative to QuasiNewtonOptions::scale
};

/// Minimises the potential of a stage by L-BFGS with a backtracking line search.
///
/// @param metric  applies an approximate inverse Hessian to a vector of the free unknowns
/// @param x       in: initial guess; out: solution, or the best iterate on failure. 3 x n [m]
QuasiNewtonResult quasi_newton(const StageProblem& problem, const QuasiNewtonOptions& options,
                               const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& metric,
                               Eigen::Matrix3Xd& x);

}  // namespace myo::dynamics
