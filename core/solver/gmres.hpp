#pragma once

#include <Eigen/Core>

#include <functional>

namespace myo::solver {

/// Product of a linear operator with a vector.
using VectorProduct = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

/// Result of gmres().
struct GmresReport {
    bool converged = false;
    int iterations = 0;
    Eigen::VectorXd solution;
};

/// Solves A x = b for a matrix without symmetry by the generalised minimal residual method.
///
/// @param product         x -> A x
/// @param preconditioner  b -> approximately A^-1 b, linear
/// @param tolerance       relative residual |b - A x| / |b|
/// @param max_iterations  restarts included
/// @param guess           initial x; empty: 0
/// Source: Saad & Schultz 1986; preconditioned from the right, so that residuals are those of the system itself.
GmresReport gmres(const VectorProduct& product, const VectorProduct& preconditioner, const Eigen::VectorXd& b,
                  double tolerance, int max_iterations, const Eigen::VectorXd& guess = {});

}  // namespace myo::solver
