#pragma once

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <cmath>
#include <string>
#include <vector>

namespace myo::test {

/// Jacobian of f at x by central differences of step `eps`, in the unit of x. f maps a vector to a vector.
template <class Function>
Eigen::MatrixXd central_differences(const Function& f, const Eigen::VectorXd& x, double eps) {
    Eigen::MatrixXd J;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
        Eigen::VectorXd plus = x, minus = x;
        plus(i) += eps;
        minus(i) -= eps;
        const Eigen::VectorXd column = (f(plus) - f(minus)) / (plus(i) - minus(i));
        if (J.size() == 0) J.resize(column.size(), x.size());
        J.col(i) = column;
    }
    return J;
}

/// Expects that a derivative equals central differences and is not zero. Alone it serves functions whose differences
/// are exact, such as linear ones.
///
/// @param tolerance  relative, in the Frobenius norm
/// @param what  for the failure message
void expect_equal_to_differences(const Eigen::MatrixXd& exact, const Eigen::MatrixXd& differences, double tolerance,
                                 const std::string& what);

/// Expects in addition that the derivative was not itself computed by differences. Arguments as above.
void expect_derivative(const Eigen::MatrixXd& exact, const Eigen::MatrixXd& differences, double tolerance,
                       const std::string& what);

/// Observed orders of convergence between neighbouring entries: log(e_i / e_i+1) / log(h_i / h_i+1).
///
/// @param h, error  step sizes and errors, same length
std::vector<double> observed_orders(const std::vector<double>& h, const std::vector<double>& error);

}  // namespace myo::test
