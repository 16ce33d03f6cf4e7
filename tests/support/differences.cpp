#include "support/differences.hpp"

namespace myo::test {

void expect_equal_to_differences(const Eigen::MatrixXd& exact, const Eigen::MatrixXd& differences, double tolerance,
                                 const std::string& what) {
    ASSERT_EQ(exact.rows(), differences.rows()) << what;
    ASSERT_EQ(exact.cols(), differences.cols()) << what;
    // Two zero matrices would agree without testing anything.
    ASSERT_GT(differences.norm(), 0.0) << what;
    // Relative to the differences, whose norm is positive here.
    EXPECT_LT((exact - differences).norm() / differences.norm(), tolerance) << what;
}

void expect_derivative(const Eigen::MatrixXd& exact, const Eigen::MatrixXd& differences, double tolerance,
                       const std::string& what) {
    expect_equal_to_differences(exact, differences, tolerance, what);
    // Equal to the last bit means that the exact derivative was computed by the same differences.
    EXPECT_FALSE((exact.array() == differences.array()).all()) << what;
}

std::vector<double> observed_orders(const std::vector<double>& h, const std::vector<double>& error) {
    std::vector<double> orders;
    for (std::size_t i = 0; i + 1 < h.size(); ++i)
        orders.push_back(std::log(error[i] / error[i + 1]) / std::log(h[i] / h[i + 1]));
    return orders;
}

}  // namespace myo::test
