#include "inverse/identifiability.hpp"

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <cmath>
#include <random>

#include "inverse/least_squares.hpp"

namespace myo::inverse {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Independent columns of random numbers.
MatrixXd random_columns(Eigen::Index count) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    MatrixXd J(40, count);
    for (double& x : J.reshaped()) x = normal(random);
    return J;
}

const std::vector<Parameter> four_parameters = {
    {"a", 1.0, 0.0, 1e3}, {"b", 2.0, 0.0, 1e3}, {"c", 3.0, -1e3, 1e3}, {"d", 4.0, 0.0, 1e3}};
const VectorXd values_of_four = Eigen::Vector4d(1.0, 2.0, 3.0, 4.0);

VectorXd textbook_deviations(const MatrixXd& J) { return (J.transpose() * J).inverse().diagonal().cwiseSqrt(); }

TEST(Identifiability, OfIndependentColumnsIsTheInverseOfTheNormalMatrix) {
    MatrixXd J = random_columns(4);
    J.col(1) *= 30.0;  // a scale that nobody named does not make the others flat or dependent
    J.col(3) *= 1e-3;
    const Identifiability found = identifiability(four_parameters, J, 4.0);
    EXPECT_TRUE(found.undetermined.empty());
    const MatrixXd covariance = 4.0 * (J.transpose() * J).inverse();
    for (Eigen::Index i = 0; i < 4; ++i) {
        EXPECT_NEAR(found.deviations(i), std::sqrt(covariance(i, i)), 1e-9 * found.deviations(i));
        for (Eigen::Index j = 0; j < 4; ++j)
            EXPECT_NEAR(found.correlation(i, j), covariance(i, j) / std::sqrt(covariance(i, i) * covariance(j, j)),
                        1e-9);
    }
}

/// A parameter without influence takes nothing from the others, also where its column is errors of derivatives.
TEST(Identifiability, AFlatParameterLeavesTheOthersTheirDeviations) {
    for (const double left : {0.0, 1e-9}) {
        MatrixXd J = random_columns(4);
        J.col(2) *= left;
        const Identifiability found = identifiability(four_parameters, J, 1.0);
        ASSERT_EQ(found.undetermined.size(), 1u);
        EXPECT_EQ(found.undetermined[0].parameters, std::vector<Eigen::Index>{2});
        EXPECT_TRUE(std::isnan(found.deviations(2)));
        EXPECT_EQ(undetermined_reason(four_parameters, found.undetermined, values_of_four, 2),
                  "it has no influence on the data");
        EXPECT_EQ(undetermined_reason(four_parameters, found.undetermined, values_of_four, 0), "");
        const VectorXd others = textbook_deviations(J(Eigen::all, std::vector<int>{0, 1, 3}));
        EXPECT_NEAR(found.deviations(0), others(0), 1e-9);
        EXPECT_NEAR(found.deviations(1), others(1), 1e-9);
        EXPECT_NEAR(found.deviations(3), others(2), 1e-9);
        EXPECT_EQ(found.correlation(0, 2), 0.0);
    }
}

/// Of the product a b^2 the derivatives are b^2 and 2 a b times one column: c and d keep what they have beside it.
TEST(Identifiability, NamesTheProductThatIsDetermined) {
    MatrixXd J = random_columns(4);
    const VectorXd of_product = J.col(0);
    J.col(0) = values_of_four(1) * values_of_four(1) * of_product;
    J.col(1) = 2.0 * values_of_four(0) * values_of_four(1) * of_product;
    const Identifiability found = identifiability(four_parameters, J, 1.0);
    ASSERT_EQ(found.undetermined.size(), 1u);
    EXPECT_EQ(found.undetermined[0].parameters, (std::vector<Eigen::Index>{0, 1}));
    EXPECT_EQ(found.undetermined[0].combinations, 1);
    EXPECT_EQ(undetermined_reason(four_parameters, found.undetermined, values_of_four, 0),
              "the data determine only its combination with b: a · b^2");
    EXPECT_EQ(undetermined_reason(four_parameters, found.undetermined, values_of_four, 1),
              "the data determine only its combination with a: a · b^2");
    EXPECT_TRUE(std::isnan(found.deviations(0)));
    EXPECT_TRUE(std::isnan(found.deviations(1)));
    const VectorXd others = textbook_deviations(J(Eigen::all, std::vector<int>{0, 2, 3}));
    EXPECT_NEAR(found.deviations(2), others(1), 1e-9);
    EXPECT_NEAR(found.deviations(3), others(2), 1e-9);
    EXPECT_EQ(found.correlation(0, 1), 0.0);
}

TEST(Identifiability, NamesQuotientsAndSums) {
    MatrixXd J = random_columns(4);
    J.col(1) = -0.5 * J.col(0);  // a / b at a = 1, b = 2, times any number
    EXPECT_EQ(
        undetermined_reason(four_parameters, identifiability(four_parameters, J, 1.0).undetermined, values_of_four, 0),
        "the data determine only its combination with b: a / b");
    J = random_columns(4);
    J.col(2) = 3.0 * J.col(0);  // c may be negative: no power of it
    EXPECT_EQ(
        undetermined_reason(four_parameters, identifiability(four_parameters, J, 1.0).undetermined, values_of_four, 2),
        "the data determine only its combination with a: a + 3 c");
    J.col(2) = -J.col(0);
    EXPECT_EQ(
        undetermined_reason(four_parameters, identifiability(four_parameters, J, 1.0).undetermined, values_of_four, 0),
        "the data determine only its combination with c: a - c");
}

/// Three parameters in two combinations, and two pairs that have nothing to do with each other.
TEST(Identifiability, CountsCombinationsAndKeepsGroupsApart) {
    MatrixXd J = random_columns(4);
    J.col(2) = J.col(0) + J.col(1);
    Identifiability found = identifiability(four_parameters, J, 1.0);
    ASSERT_EQ(found.undetermined.size(), 1u);
    EXPECT_EQ(found.undetermined[0].combinations, 2);
    EXPECT_EQ(undetermined_reason(four_parameters, found.undetermined, values_of_four, 1),
              "the data determine only 2 combinations of it with a, c");
    EXPECT_TRUE(std::isfinite(found.deviations(3)));
    J = random_columns(4);
    J.col(2) = J.col(0);
    J.col(3) = 2.0 * J.col(1);
    found = identifiability(four_parameters, J, 1.0);
    ASSERT_EQ(found.undetermined.size(), 2u);
    EXPECT_EQ(found.undetermined[0].parameters, (std::vector<Eigen::Index>{0, 2}));
    EXPECT_EQ(found.undetermined[1].parameters, (std::vector<Eigen::Index>{1, 3}));
}

/// Badly determined is not undetermined: a correlation of 0.9999995 still has deviations, and the textbook's.
TEST(Identifiability, NearlyDependentColumnsKeepTheirDeviations) {
    MatrixXd J = random_columns(4);
    J.col(1) = J.col(0) + 1e-3 * J.col(1);
    const Identifiability found = identifiability(four_parameters, J, 1.0);
    EXPECT_TRUE(found.undetermined.empty());
    const VectorXd expected = textbook_deviations(J);
    for (Eigen::Index i = 0; i < 4; ++i) EXPECT_NEAR(found.deviations(i), expected(i), 1e-6 * expected(i));
}

/// Of dependent parameters the more influential ones suffice, but those that are in already.
TEST(Identifiability, ChoosesParametersThatSuffice) {
    MatrixXd J = random_columns(4);
    J.col(2) = 0.1 * J.col(0);
    J.col(3).setZero();
    using Chosen = std::vector<Eigen::Index>;
    EXPECT_EQ(sufficient_parameters(four_parameters, J, {}), (Chosen{0, 1}));
    EXPECT_EQ(sufficient_parameters(four_parameters, J, {2}), (Chosen{1, 2}));
    EXPECT_EQ(sufficient_parameters(four_parameters, J, {3}), (Chosen{0, 1, 3}));
    std::vector<Parameter> scaled = four_parameters;
    scaled[2].scale = 100.0;  // a change of c matters from 100 on, which changes more than one of a does
    EXPECT_EQ(sufficient_parameters(scaled, J, {}), (Chosen{1, 2}));
    EXPECT_EQ(sufficient_parameters(four_parameters, random_columns(4), {}), (Chosen{0, 1, 2, 3}));
}

TEST(Identifiability, NothingIsDeterminedWhereNothingHasInfluence) {
    const Identifiability found = identifiability(four_parameters, MatrixXd::Zero(40, 4), 1.0);
    EXPECT_EQ(found.undetermined.size(), 4u);
    EXPECT_TRUE(found.deviations.array().isNaN().all());
}

TEST(Identifiability, AParameterWithoutRoomIsExact) {
    std::vector<Parameter> held = four_parameters;
    held[1].lower = held[1].upper = held[1].value;
    const MatrixXd J = random_columns(4);
    const Identifiability found = identifiability(held, J, 1.0);
    EXPECT_TRUE(found.undetermined.empty());
    EXPECT_EQ(found.deviations(1), 0.0);
    const VectorXd others = textbook_deviations(J(Eigen::all, std::vector<int>{0, 2, 3}));
    EXPECT_NEAR(found.deviations(0), others(0), 1e-9);
}

/// y = slope x, unit noise; what else a fit is given is up to the test.
struct NoisyLine {
    VectorXd x = VectorXd::LinSpaced(30, 1.0, 2.0);
    VectorXd y = 3.0 * x;

    ResidualEvaluation with(double slope, MatrixXd jacobian) const {
        return {true, {}, slope * x - y, std::move(jacobian)};
    }
};

/// Errors of derivatives of 1e-9 that agree with the residuals would drive a parameter to its bound.
TEST(LeastSquares, LeavesAFlatParameterAtItsStart) {
    const NoisyLine line;
    const LeastSquaresReport report = fit_least_squares({{"slope", 1.0, 0.0, 10.0}, {"flat", 0.3, 0.0, 1.0}},
                                                        [&](const VectorXd& p, const Progress&) {
                                                            MatrixXd J(line.x.size(), 2);
                                                            J << line.x, 1e-9 * line.x;
                                                            return line.with(p(0), J);
                                                        });
    ASSERT_TRUE(report.converged()) << report.message;
    EXPECT_NEAR(report.values(0), 3.0, 1e-6);
    EXPECT_EQ(report.values(1), 0.3);
    EXPECT_NEAR(report.deviations(0), 1.0 / line.x.norm(), 1e-9);
    EXPECT_TRUE(std::isnan(report.deviations(1)));
}

TEST(LeastSquares, SecantsLeaveAFlatParameterWhereItIs) {
    const NoisyLine line;
    const LeastSquaresReport report = fit_least_squares(
        {{"slope", 1.0, 0.0, 10.0}, {"flat", 0.3, 0.0, 1.0}},
        [&](const VectorXd& p, const Progress&) { return line.with(p(0), {}); },
        [&](const VectorXd&, const ResidualEvaluation&, const Progress&) {
            MatrixXd J(line.x.size(), 2);
            J << line.x, 1e-9 * line.x;
            return J;
        },
        {}, {});
    ASSERT_TRUE(report.converged()) << report.message;
    EXPECT_NEAR(report.values(0), 3.0, 1e-6);
    EXPECT_EQ(report.values(1), 0.3);
    EXPECT_NEAR(report.deviations(0), 1.0 / line.x.norm(), 1e-9);
}

/// slope = amount shape: the shape has no influence while the amount is zero, and is found once that has moved.
TEST(LeastSquares, MovesAParameterThatGainsInfluenceOnTheWay) {
    const NoisyLine line;
    const VectorXd square = line.x.cwiseAbs2(), data = 2.0 * (line.x + 0.5 * square);
    const LeastSquaresReport report = fit_least_squares(
        {{"amount", 0.0, -10.0, 10.0}, {"shape", 0.0, -1.0, 1.0}}, [&](const VectorXd& p, const Progress&) {
            MatrixXd J(line.x.size(), 2);
            J << line.x + p(1) * square, p(0) * square;
            return ResidualEvaluation{true, {}, p(0) * (line.x + p(1) * square) - data, J};
        });
    ASSERT_TRUE(report.converged()) << report.message;
    EXPECT_NEAR(report.values(0), 2.0, 1e-3);
    EXPECT_NEAR(report.values(1), 0.5, 1e-3);
    EXPECT_TRUE(report.undetermined.empty());
}

/// Bounds of one value are an exact one: the library below takes them for an error.
TEST(LeastSquares, HoldsAParameterWithoutRoom) {
    const NoisyLine line;
    const LeastSquaresReport report = fit_least_squares(
        {{"slope", 1.0, 0.0, 10.0}, {"exact", 0.5, 0.5, 0.5}}, [&](const VectorXd& p, const Progress&) {
            MatrixXd J(line.x.size(), 2);
            J << line.x, line.x.cwiseAbs2();
            return ResidualEvaluation{true, {}, p(0) * line.x + p(1) * line.x.cwiseAbs2() - line.y, J};
        });
    ASSERT_TRUE(report.converged()) << report.message;
    EXPECT_EQ(report.values(1), 0.5);
    EXPECT_EQ(report.deviations(1), 0.0);
    EXPECT_NEAR(report.deviations(0), 1.0 / line.x.norm(), 1e-9);
}

/// Only the product is determined: the fit ends on it, and both are said to be free.
TEST(LeastSquares, FitsAProductAndSaysThatItIsAllItKnows) {
    const NoisyLine line;
    const std::vector<Parameter> both = {{"stiffness", 1.0, 0.1, 10.0}, {"factor", 1.0, 0.1, 10.0}};
    const LeastSquaresReport report = fit_least_squares(both, [&](const VectorXd& p, const Progress&) {
        MatrixXd J(line.x.size(), 2);
        J << p(1) * line.x, p(0) * line.x;
        return line.with(p(0) * p(1), J);
    });
    ASSERT_TRUE(report.converged()) << report.message;
    EXPECT_NEAR(report.values.prod(), 3.0, 1e-5);
    EXPECT_EQ(report.values.maxCoeff(), report.values.prod());  // one of them was moved, the other is 1 as it was
    EXPECT_EQ(undetermined_reason(both, report.undetermined, report.values, 1),
              "the data determine only its combination with stiffness: stiffness · factor");
}

}  // namespace
}  // namespace myo::inverse
