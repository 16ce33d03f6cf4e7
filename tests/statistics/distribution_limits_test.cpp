#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "statistics/distributions.hpp"
#include "statistics/evidence.hpp"
#include "statistics/random_signs.hpp"
#include "statistics/score_test.hpp"
#include "support/not_finite.hpp"

namespace myo::statistics::distribution_limits_test {
namespace {

using test::infinity;

TEST(DistributionTails, HaveTheirClosedForms) {
    for (const double x : {1e-3, 0.3, 1.0, 4.0, 25.0}) {
        // chi^2 of 1, 2 and 4 degrees of freedom.
        EXPECT_NEAR(chi_squared_tail(x, 1.0) / std::erfc(std::sqrt(0.5 * x)), 1.0, 1e-12) << x;
        EXPECT_NEAR(chi_squared_tail(x, 2.0) / std::exp(-0.5 * x), 1.0, 1e-12) << x;
        EXPECT_NEAR(chi_squared_tail(x, 4.0) / ((1.0 + 0.5 * x) * std::exp(-0.5 * x)), 1.0, 1e-12) << x;
        // F of 2 and n degrees of freedom, in this order.
        for (const double n : {1.0, 2.0, 9.0})
            EXPECT_NEAR(fisher_f_tail(x, 2.0, n) / std::pow(1.0 + 2.0 * x / n, -0.5 * n), 1.0, 1e-11) << x << " " << n;
        // Student's t of one degree of freedom is Cauchy's distribution, of very many the normal one.
        EXPECT_NEAR(student_two_sided(x, 1.0), 1.0 - 2.0 / std::numbers::pi * std::atan(x), 1e-12) << x;
        EXPECT_NEAR(student_two_sided(x, 1e6), 2.0 * normal_tail(x), 1e-5) << x;
        EXPECT_EQ(student_two_sided(-x, 3.0), student_two_sided(x, 3.0));
        // t^2 is F of 1 and n.
        EXPECT_NEAR(student_two_sided(x, 5.0) / fisher_f_tail(x * x, 1.0, 5.0), 1.0, 1e-11) << x;
        EXPECT_NEAR(normal_tail(x) + normal_tail(-x), 1.0, 1e-15);
    }
}

TEST(DistributionTails, AreOneBelowTheSupportAndNothingAtInfinity) {
    for (const double below : {0.0, -1.0, -infinity}) {
        EXPECT_EQ(chi_squared_tail(below, 3.0), 1.0);
        EXPECT_EQ(fisher_f_tail(below, 3.0, 4.0), 1.0);
        EXPECT_EQ(noncentral_chi_squared_tail(below, 3.0, 2.0), 1.0);
        EXPECT_EQ(log_chi_squared_tail(below, 3.0), 0.0);
    }
    EXPECT_EQ(chi_squared_tail(infinity, 3.0), 0.0);
    EXPECT_EQ(log_chi_squared_tail(infinity, 3.0), -infinity);
    EXPECT_EQ(student_two_sided(-infinity, 3.0), 0.0);
    EXPECT_EQ(student_two_sided(0.0, 3.0), 1.0);
    EXPECT_EQ(noncentral_chi_squared_tail(4.0, 1.0, infinity), 1.0);
    EXPECT_EQ(normal_tail(0.0), 0.5);
}

TEST(DistributionTails, OfNoDeviationAreAStepAtTheMean) {
    EXPECT_EQ(shifted_gamma_tail(2.9, 3.0, 0.0, 1.0), 1.0);
    EXPECT_EQ(shifted_gamma_tail(3.0, 3.0, 0.0, 1.0), 1.0);
    EXPECT_EQ(shifted_gamma_tail(3.1, 3.0, 0.0, 1.0), 0.0);
    // Skewness 1 is four exponentials: the support begins two deviations below the mean.
    EXPECT_EQ(shifted_gamma_tail(-1.0 - 1e-9, 3.0, 2.0, 1.0), 1.0);
    EXPECT_LT(shifted_gamma_tail(0.0, 3.0, 2.0, 1.0), 1.0);
    const double z = 4.0 + 2.0 * (6.0 - 3.0) / 2.0;
    EXPECT_NEAR(shifted_gamma_tail(6.0, 3.0, 2.0, 1.0), std::exp(-z) * (1.0 + z + z * z / 2.0 + z * z * z / 6.0),
                1e-12);
}

TEST(DistributionTails, GoOnWhereTheLogarithmIsComputedOtherwise) {
    // For two degrees of freedom ln P = -x / 2: the change of method is at 1e-280, x = 1289.4.
    for (const double x : {1e-3, 1.0, 1289.0, 1290.0, 1500.0, 1e6})
        EXPECT_NEAR(log_chi_squared_tail(x, 2.0), -0.5 * x, 1e-9 * x);
    // For one degree: the asymptotic series of erfc, to three terms.
    const double x = 3000.0, tail = 1.0 - 1.0 / x + 3.0 / (x * x) - 15.0 / (x * x * x);
    EXPECT_NEAR(log_chi_squared_tail(x, 1.0), -0.5 * x + 0.5 * std::log(2.0 / (std::numbers::pi * x)) + std::log(tail),
                1e-9);
}

TEST(Quantiles, AreInversesOfTheTails) {
    for (const double tail : {1e-12, 0.01, 0.5, 0.99}) {
        for (const double freedom : {1.0, 3.5, 200.0})
            EXPECT_NEAR(chi_squared_tail(chi_squared_upper_quantile(tail, freedom), freedom) / tail, 1.0, 1e-9);
        EXPECT_NEAR(normal_tail(normal_upper_quantile(tail)) / tail, 1.0, 1e-9);
    }
    EXPECT_NEAR(normal_upper_quantile(0.5), 0.0, 1e-15);
}

/// A noncentral chi^2 is a Poisson mixture of central ones.
TEST(DistributionTails, OfANoncentralChiSquaredAreAMixture) {
    for (const double noncentrality : {0.5, 6.0})
        for (const double freedom : {1.0, 5.0})
            for (const double x : {0.5, 4.0, 20.0}) {
                double expected = 0.0, weight = std::exp(-0.5 * noncentrality);
                for (int k = 0; k < 80; ++k) {
                    expected += weight * chi_squared_tail(x, freedom + 2.0 * k);
                    weight *= 0.5 * noncentrality / (k + 1);
                }
                EXPECT_NEAR(noncentral_chi_squared_tail(x, freedom, noncentrality), expected, 1e-11);
            }
    // Far above x the tail is 1 to rounding, whether it is computed or not.
    for (const double noncentrality : {400.0, 1e4})
        EXPECT_NEAR(noncentral_chi_squared_tail(10.0, 1.0, noncentrality), 1.0, 1e-12);
}

TEST(EvidenceWeights, DependOnDifferencesOnlyAndNeverOverflow) {
    const std::vector<double> near = evidence_weights({0.0, 3.0, 1.0});
    for (const double shift : {-1e6, 1e6}) {
        const std::vector<double> far = evidence_weights({shift, shift + 3.0, shift + 1.0});
        for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(far[i], near[i], 1e-9);
    }
    EXPECT_EQ(evidence_weights({-1e308, 1e308}), (std::vector<double>{1.0, 0.0}));
    EXPECT_EQ(evidence_weights({5.0, 5.0}), (std::vector<double>{0.5, 0.5}));
    // Neither of the infinities is a best model.
    EXPECT_EQ(evidence_weights({-infinity, 4.0, infinity}), (std::vector<double>{0.0, 1.0, 0.0}));
    EXPECT_EQ(evidence_weights({infinity, test::nan}), (std::vector<double>{0.0, 0.0}));
    const std::vector<double> hot = evidence_weights({0.0, 3.0}, 1e12);
    EXPECT_NEAR(hot[1], 0.5, 1e-9) << "an endless temperature knows nothing";
}

/// Two models that differ by d, the better one being true in the share f of the comparisons, have the temperature
/// d / (2 ln(f / (1 - f))).
TEST(Temperature, HasAClosedFormForTwoModels) {
    struct Judged {
        double difference;
        int right, wrong;
    };
    for (const Judged& judged : {Judged{4.0, 3, 1}, {20.0, 9, 1}, {1.0, 6, 4}}) {
        std::vector<JudgedComparison> comparisons;
        for (int k = 0; k < judged.right + judged.wrong; ++k) {
            // The place of the better model does not matter.
            const bool first = k % 2 == 0, right = k < judged.right;
            JudgedComparison one{{100.0, 100.0}, 0};
            one.criteria[first ? 1 : 0] += judged.difference;
            one.truth = first == right ? 0 : 1;
            comparisons.push_back(one);
        }
        const double expected = judged.difference / (2.0 * std::log(static_cast<double>(judged.right) / judged.wrong));
        EXPECT_NEAR(calibrated_temperature(comparisons) / expected, 1.0, 1e-3) << judged.difference;
    }
    // Criteria that are always wrong, as unsure as allowed.
    EXPECT_NEAR(calibrated_temperature({{{0.0, 5.0}, 1}}) / 1000.0, 1.0, 0.03);
}

TEST(Criteria, OfTheSameFitDifferByTheParametersAlone) {
    for (const int more : {1, 5}) {
        const double step = more * std::log(80.0);
        EXPECT_NEAR(information_criterion(90.0, 100.0, 80.0, 2 + more) - information_criterion(90.0, 100.0, 80.0, 2),
                    step, 1e-12);
        EXPECT_NEAR(information_criterion_known_noise(90.0, 100.0, 80.0, 2 + more) -
                        information_criterion_known_noise(90.0, 100.0, 80.0, 2),
                    step, 1e-12);
    }
    EXPECT_NEAR(information_criterion_known_noise(90.0, 100.0, 80.0, 0), 72.0, 1e-12);
    EXPECT_NEAR(information_criterion(100.0, 100.0, 80.0, 0), 0.0, 1e-12) << "noise as stated";
}

TEST(HolmSteps, AreMonotonicBoundedAndBlindToTheOrder) {
    EXPECT_EQ(holm_adjusted({0.3}), (std::vector<double>{0.3}));
    EXPECT_EQ(holm_adjusted({0.5, 0.6}), (std::vector<double>{1.0, 1.0}));
    // 3 x 0.02 is more than 2 x 0.025: the second one is not below the first.
    const std::vector<double> close = holm_adjusted({0.025, 0.02, 0.9});
    EXPECT_DOUBLE_EQ(close[1], 0.06);
    EXPECT_DOUBLE_EQ(close[0], 0.06);
    EXPECT_DOUBLE_EQ(close[2], 0.9);
    const std::vector<double> ties = holm_adjusted({0.01, 0.01, 0.01, 0.01});
    for (const double p : ties) EXPECT_DOUBLE_EQ(p, 0.04);
}

TEST(Signs, AreThoseOfTheSeedAndEvenlySpread) {
    std::vector<double> a(10'000), b;
    std::iota(a.begin(), a.end(), 1.0);
    b = a;
    RandomSigns first(7), second(7), other(8);
    first.flip(a), second.flip(b);
    EXPECT_EQ(a, b);
    int negative = 0, changes = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(std::abs(a[i]), static_cast<double>(i + 1));
        negative += a[i] < 0.0;
        changes += i > 0 && (a[i] < 0.0) != (a[i - 1] < 0.0);
    }
    // Five deviations of a count of ten thousand.
    EXPECT_NEAR(negative, 5000, 250);
    EXPECT_NEAR(changes, 5000, 250);
    other.flip(b);
    EXPECT_NE(a, b);
}

}  // namespace
}  // namespace myo::statistics::distribution_limits_test
