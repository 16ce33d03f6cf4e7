#pragma once

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <cmath>
#include <string>
#include <vector>

namespace myo::test {

/// Jacobian of f at x by central differences of step `eps`: f(x) and x as vectors.
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

/// Equal to central differences and not zero. On its own for functions whose differences are exact, as linear ones.
void expect_equal_to_differences(const Eigen::MatrixXd& exact, const Eigen::MatrixXd& differences, double tolerance,
                                 const std::string& what);

/// A derivative three ways: equal to central differences, not zero, and not itself made by differences.
void expect_derivative(const Eigen::MatrixXd& exact, const Eigen::MatrixXd& differences, double tolerance,
                       const std::string& what);

/// Orders of convergence between neighbouring entries: log(e_i / e_i+1) / log(h_i / h_i+1).
std::vector<double> observed_orders(const std::vector<double>& h, const std::vector<double>& error);

}  // namespace myo::test
