#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <variant>
#include <vector>

#include "planning/detection.hpp"
#include "planning/propose_trial.hpp"
#include "planning/reported_rivals.hpp"
#include "support/dense.hpp"
#include "support/folder.hpp"

// Closed forms of detection, what recalibration leaves of a contradiction, and rivals that a report names.

namespace myo::planning::detection_rules_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// An equal difference a in n rows of each of B blocks: B n a^2 / (1 + e^2 n), however many samples there are.
TEST(DetectionRules, NumericalErrorBoundsWhatSamplesCanShow) {
    const double a = 0.3, e = 0.12;
    for (const Eigen::Index n : {1, 10, 1000})
        for (const Eigen::Index blocks : {1, 2, 5}) {
            const VectorXd d = VectorXd::Constant(n * blocks, a);
            std::vector<ErrorBlock> of_trials;
            for (Eigen::Index b = 0; b < blocks; ++b) of_trials.push_back({b * n, n});
            const double rows = static_cast<double>(n), count = static_cast<double>(blocks),
                         expected = count * rows * a * a / (1.0 + e * e * rows);
            EXPECT_NEAR(noncentrality(d, of_trials, e), expected, 1e-12 * expected);
            EXPECT_NEAR(noncentrality(-d, of_trials, -e), expected, 1e-12 * expected) << "signs do not count";
            EXPECT_NEAR(noncentrality(d, of_trials, 0.0), count * rows * a * a, 1e-12 * count * rows);
            EXPECT_NEAR(noncentrality(d, {}, e), count * rows * a * a, 1e-12 * count * rows);
            EXPECT_LT(noncentrality(d, of_trials, e), count * a * a / (e * e));
        }
    // Only the block with the difference counts: 4 / (1 + e^2 2).
    const VectorXd second = (VectorXd(5) << 0.0, 0.0, 0.0, std::sqrt(2.0), std::sqrt(2.0)).finished();
    EXPECT_NEAR(noncentrality(second, {{0, 3}, {3, 2}}, 0.5), 4.0 / 1.5, 1e-12);
    EXPECT_EQ(noncentrality(VectorXd(), {}, e), 0.0);
    EXPECT_EQ(noncentrality(VectorXd::Constant(2, std::nan("")), {{0, 2}}, e), 0.0)
        << "what is no number shows nothing";
}

double upper_normal(double z) { return 0.5 * std::erfc(z / std::sqrt(2.0)); }

/// With one direction the test is two-sided and normal; further directions cost power.
TEST(DetectionRules, ProbabilityIsThatOfATwoSidedNormalTest) {
    const double z = 2.5758293035489004;  // upper 0.5 % of the normal distribution
    for (const double shift : {0.0, 0.5, 1.0, 3.0, 5.0}) {
        const double expected = upper_normal(z - shift) + upper_normal(z + shift);
        EXPECT_NEAR(detection_probability(shift * shift, 1.0, 0.01), expected, 1e-9) << shift;
        if (shift == 0.0) continue;
        EXPECT_LT(detection_probability(shift * shift, 3.0, 0.01), detection_probability(shift * shift, 2.0, 0.01));
        EXPECT_LT(detection_probability(shift * shift, 2.0, 0.01), expected);
        EXPECT_GT(detection_probability(shift * shift, 1.0, 0.05), expected) << "a laxer test sees more";
    }
    // Two directions without a difference: alpha = exp(-x/2) at the quantile, so that alpha comes back.
    for (const double alpha : {0.001, 0.01, 0.2}) EXPECT_NEAR(detection_probability(0.0, 2.0, alpha), alpha, 1e-12);
}

TEST(DetectionRules, NeededNoncentralityStaysWithinItsBounds) {
    DetectionPolicy policy;
    EXPECT_LT(needed_noncentrality(0.5 * policy.alpha, 1.0, policy), 1e-9) << "even no difference is rejected so often";
    EXPECT_EQ(needed_noncentrality(1.0 + 1e-9, 1.0, policy), policy.most_noncentrality);
    const double median = needed_noncentrality(0.5, 1.0, policy);
    EXPECT_NEAR(std::sqrt(median), 2.5758293, 1e-4) << "the other side of the test hardly counts";
    policy.most_noncentrality = 3.0;
    EXPECT_EQ(needed_noncentrality(0.5, 1.0, policy), 3.0);
    EXPECT_TRUE(error_blocks({}, 7).empty());
}

/// What is left of a difference is its distance from what the parameters can reproduce.
TEST(Contradiction, IsTheDistanceFromWhatRecalibrationReaches) {
    std::srand(3);
    const MatrixXd J = MatrixXd::Random(12, 3), known = 0.4 * MatrixXd::Random(5, 3);
    const VectorXd d = VectorXd::Random(12);
    double left = -1.0;
    // No parameters: all of it.
    EXPECT_NEAR(contradiction(MatrixXd(0, 0), {}, MatrixXd(12, 0), d, {}, 0.0, left), d.squaredNorm(), 1e-12);
    EXPECT_NEAR(left, d.norm(), 1e-12);
    // Reached by a step that nothing else forbids.
    EXPECT_LT(contradiction(MatrixXd(0, 3), {}, J, J * Eigen::Vector3d(2.0, -1.0, 0.5), {}, 0.0, left), 1e-20);
    EXPECT_LT(left, 1e-10);
    // With known trials: least squares on both, whose rows there ask for no step.
    MatrixXd both(17, 3);
    both << known, J;
    VectorXd wanted = VectorXd::Zero(17);
    wanted.tail(12) = d;
    const VectorXd rest = wanted - both * test::least_squares(both, wanted);
    EXPECT_NEAR(contradiction(known, {{0, 5}}, J, d, {{0, 12}}, 0.0, left), rest.squaredNorm(), 1e-12);
    EXPECT_NEAR(left, rest.tail(12).norm(), 1e-12) << "what the existing trials show does not belong to the new one";
    EXPECT_LT(left * left, rest.squaredNorm());
    // Numerical errors of the new trial stand on its own rows, behind those of the known ones.
    const double e = 0.3, share = rest.segment(5, 4).squaredNorm() / rest.squaredNorm(),
                 of_known = rest.head(5).squaredNorm() / rest.squaredNorm();
    EXPECT_NEAR(contradiction(known, {}, J, d, {{0, 4}}, e, left), rest.squaredNorm() / (1.0 + e * e * 4.0 * share),
                1e-12);
    EXPECT_NEAR(contradiction(known, {{0, 5}}, J, d, {{0, 4}}, e, left),
                rest.squaredNorm() / (1.0 + e * e * (4.0 * share + 5.0 * of_known)), 1e-12);
}

/// Reports with fits of effects, and which two of them are to be told apart.
class RivalsOfReports : public ::testing::Test {
protected:
    Result<std::array<RivalStart, 2>> rivals(const std::string& groups, const std::string& candidates,
                                             const std::string& sets,
                                             const std::string& declared_weight = "0.0") const {
        folder_.write("report.json", R"({"verdict": {"not_told_apart": )" + groups +
                                         R"(}, "details": {"declared": {"weight": )" + declared_weight +
                                         R"(}, "candidates": [)" + candidates + R"(], "sets": [)" + sets + "]}}");
        return reported_rivals(folder_.path() / "report.json");
    }
    static std::string candidate(const std::string& id, const std::string& fit) {
        return "{\"id\": \"" + id + "\"" + (fit.empty() ? "" : ", \"fit\": " + fit) + "}";
    }
    test::Folder folder_{"rivals_of_reports"};
};

TEST_F(RivalsOfReports, AreTheHeaviestFitsThatHoldOneAndNotTheOther) {
    const std::string pair = R"([["linear_drag", "point_mass"]])",
                      lone = candidate("linear_drag", R"({"weight": 0.1})"), unfitted = candidate("point_mass", ""),
                      both = R"({"ids": ["linear_drag", "point_mass"], "fit": {"weight": 0.9}})",
                      other = R"({"ids": ["linear_drag", "gravity_tilt"], "fit": {"weight": 0.5}})";
    const auto apart = rivals(pair, lone + ", " + unfitted, both + ", " + other);
    ASSERT_TRUE(apart) << apart.error().text();
    EXPECT_THAT((*apart)[0].ids, ElementsAre("linear_drag", "gravity_tilt")) << "heavier than the effect alone";
    EXPECT_THAT((*apart)[1].ids, ElementsAre("point_mass")) << "an effect that was not fitted is to be fitted";
    EXPECT_TRUE((*apart)[1].effects.empty());
    // A group of one tells nothing: the two heaviest fits count, the declared model among them.
    const auto heaviest = rivals(R"([["linear_drag"]])", lone, "", "0.7");
    ASSERT_TRUE(heaviest) << heaviest.error().text();
    EXPECT_TRUE((*heaviest)[0].ids.empty());
    EXPECT_THAT((*heaviest)[1].ids, ElementsAre("linear_drag"));
    // Where weights are equal, the order of the report counts.
    const auto equal = rivals("[]", lone + ", " + candidate("point_mass", R"({"weight": 0.1})"), "", "0.1");
    ASSERT_TRUE(equal);
    EXPECT_TRUE((*equal)[0].ids.empty());
    EXPECT_THAT((*equal)[1].ids, ElementsAre("linear_drag"));
}

TEST_F(RivalsOfReports, KeepTheValuesOfTheirFits) {
    const std::string fit = R"({"weight": 0.6, "parameters": {"youngs_modulus_Pa": 2e5, "density_kg_m3": null},
"effects": [{"id": "marker_swap", "parameters": {"markers": ["a", "b"], "time_s": 0.5, "trial": "swing"}},
{"id": "gravity_tilt", "parameters": {"axis": [0, 1, 0]}}]})";
    const auto read = rivals("[]", candidate("marker_swap", fit), "");
    ASSERT_TRUE(read) << read.error().text();
    const RivalStart& start = (*read)[0];
    EXPECT_EQ(start.parameters.size(), 1u) << "null is a value that is not known";
    EXPECT_EQ(start.parameters.at("youngs_modulus_Pa"), 2e5);
    ASSERT_EQ(start.effects.size(), 2u);
    const effect::EffectParameters& swap = start.effects[0].parameters;
    EXPECT_THAT(std::get<std::vector<std::string>>(swap.at("markers")), ElementsAre("a", "b"));
    EXPECT_EQ(std::get<double>(swap.at("time_s")), 0.5);
    EXPECT_EQ(std::get<std::string>(swap.at("trial")), "swing");
    EXPECT_EQ(std::get<VectorXd>(start.effects[1].parameters.at("axis")), Eigen::Vector3d(0.0, 1.0, 0.0));
}

TEST_F(RivalsOfReports, AreRefusedInOneSentence) {
    const auto said = [](const Result<std::array<RivalStart, 2>>& read) { return read ? "" : read.error().text(); };
    EXPECT_THAT(said(rivals("[]", candidate("linear_drag", ""), "")),
                HasSubstr("report.json: holds no two fits that could be told apart"));
    EXPECT_THAT(said(rivals("[]", candidate("old_law", "{}"), "")),
                HasSubstr("names an effect that is not known: \"old_law\""));
    EXPECT_THAT(said(rivals("{}", candidate("linear_drag", "{}"), "{}")), HasSubstr("is no report of a diagnosis"));
    EXPECT_THAT(said(rivals("[]", candidate("linear_drag", "3"), "")), HasSubstr("is no report of a diagnosis"));
}

}  // namespace
}  // namespace myo::planning::detection_rules_test
