#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "diagnosis/made_fits.hpp"
#include "diagnosis/made_problem.hpp"
#include "diagnosis/verdict/deviations.hpp"
#include "diagnosis/verdict/final_fit.hpp"
#include "diagnosis/verdict/twins.hpp"
#include "support/swung_beam.hpp"

// Closed forms of deviations, the limit of twins, and what the final fit takes off.

namespace myo::diagnosis::verdict_values_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Four samples of slope 3 and two readings of slope 4; what is left alternates, so that nothing inflates.
JudgedFit with_sensors(double deviation) {
    JudgedFit fit;
    fit.fit.residual = Eigen::Vector4d(1.0, -1.0, 1.0, -1.0);
    fit.fit.jacobian = MatrixXd::Constant(4, 1, 3.0);
    fit.fit.sensor_residual = VectorXd::Zero(2);
    fit.fit.sensor_jacobian = MatrixXd::Constant(2, 1, 4.0);
    fit.fit.report.deviations = VectorXd::Constant(1, deviation);
    return fit;
}

/// The estimate moves by slope * error * samples / (sum of squared slopes), each error on its own.
TEST(DeviationValues, AddTheSquaresOfAllDoubts) {
    const NumericsPolicy policy;
    const FitData data = test::made_data(4);
    const auto shift = [](double over_noise) {
        return test::made_shift({VectorXd::Constant(4, over_noise * test::made_noise_m)});
    };
    NumericalError error;
    error.step_shift = shift(5.0);
    error.mesh_change = shift(-2.0);
    error.mesh_factor = 1.5;
    error.by_modulus = shift(4.0);
    const double squares = 25.0 + 9.0 + 16.0, slope = 3.0 * 4.0 / (4.0 * 9.0 + 2.0 * 16.0);
    const auto deviation = [&](const JudgedFit& fit) {
        return with_deviations(fit, data, error, policy).fit.report.deviations(0);
    };
    JudgedFit fit = with_sensors(0.5);
    EXPECT_NEAR(deviation(fit), std::sqrt(0.25 + std::pow(policy.extrapolation_doubt * slope, 2) * squares), 1e-9);
    fit.fit.values.effects = {{"dry_friction", {}}};
    EXPECT_NEAR(deviation(fit), std::sqrt(0.25 + std::pow(policy.doubt_of_corners * slope, 2) * squares), 1e-9);
    EXPECT_EQ(deviation(with_sensors(0.0)), 0.0) << "fixed";
    EXPECT_TRUE(std::isnan(deviation(with_sensors(std::nan(""))))) << "undetermined";
}

JudgedFit of_effects(const std::vector<std::string>& ids, const VectorXd& residual) {
    JudgedFit fit;
    for (const std::string& id : ids) fit.fit.effects.push_back({id, {}});
    fit.fit.residual = residual;
    return fit;
}

/// The declared fit leaves ten along the first axis. "a" takes it off, "b" takes off as much at this cosine to it.
Diagnosis beside(double cosine) {
    Diagnosis d;
    const VectorXd rest = VectorXd::Unit(4, 2), x = VectorXd::Unit(4, 0), y = VectorXd::Unit(4, 1);
    d.declared = of_effects({}, 10.0 * x + rest);
    d.declared.fit.jacobian.resize(4, 0);
    d.candidates.resize(2);
    d.candidates[0].score.id = "a";
    d.candidates[0].judged = of_effects({"a"}, rest);
    d.candidates[1].score.id = "b";
    const VectorXd other = 10.0 * (cosine * x + std::sqrt(1.0 - cosine * cosine) * y);
    d.candidates[1].judged = of_effects({"b"}, 10.0 * x + rest - other);
    d.verdict = {VerdictKind::effects, d.candidates[0].judged->fit.effects};
    return d;
}

TEST(TwinValues, AreBesideEachOtherByTheCosineOfThePolicy) {
    const double limit = ConfusionPolicy{}.twin_cosine;
    EXPECT_EQ(twins_of(beside(limit + 1e-6), "a"), std::vector<std::string>{"b"});
    EXPECT_TRUE(twins_of(beside(limit - 1e-6), "a").empty());
    Diagnosis d = beside(1.0);
    d.candidates[1].judged->fit.residual.conservativeResize(3);
    EXPECT_TRUE(twins_of(d, "a").empty()) << "other data";
}

/// A prediction is the run of the setup plus the error of its own fit; `none` has one prediction.
TEST(FinalFitValues, PredictWithTheErrorOfTheirOwnFit) {
    const test::Folder folder("final_fit");
    const setup::Setup setup = test::swung_beam(folder, 0.1);
    const auto error_of = [&](double shift_m) {
        NumericalError error;
        const auto samples = setup.trials[0].measured.sample_count();
        error.shift.assign(2, std::vector<Eigen::Matrix3Xd>(4, Eigen::Matrix3Xd::Constant(3, samples, shift_m)));
        return error;
    };
    JudgedFit fit = test::fit_that_leaves(1.0);
    fit.fit.values = prediction::declared_values(setup);
    const DiagnosisContext context{setup, {}, fit_data(setup, {0}), fit, {}, {}};
    const NumericalError declared_error = error_of(1e-3);
    fit.numerics = error_of(4e-3);
    for (const VerdictKind kind : {VerdictKind::effects, VerdictKind::none}) {
        const Decision decision{{kind}, fit, {}};
        FitStore store;
        PhaseLog log{Progress()};
        const FinalFit last = final_fit({context, declared_error, decision, {}}, store, log);
        ASSERT_TRUE(last.complete && last.before.ok() && last.after.ok());
        for (std::size_t t = 0; t < 2; ++t) {
            const double moved = last.after.predictions[t].residual_m[3](2, 5) -
                                 last.before.predictions[t].residual_m[3](2, 5);
            EXPECT_NEAR(moved, kind == VerdictKind::none ? 0.0 : 3e-3, 1e-12);
        }
        ASSERT_EQ(log.costs().size(), 1u) << "nothing is refitted";
        EXPECT_EQ(log.costs()[0].runs, 4);
    }
}

/// Where no time is left, the best attempt that explains nothing is predicted as it is.
TEST(FinalFitValues, LeaveAnAttemptAsItIsWhereItIsNotToBeCorrected) {
    const test::Folder folder("final_attempt");
    const setup::Setup setup = test::swung_beam(folder, 0.1);
    JudgedFit fit = test::fit_that_leaves(1.0);
    fit.fit.values = prediction::declared_values(setup);
    const DiagnosisContext context{setup, {}, fit_data(setup, {0}), fit, {}, {}};
    NumericalError declared_error;
    const auto samples = setup.trials[0].measured.sample_count();
    declared_error.shift.assign(2, std::vector<Eigen::Matrix3Xd>(4, Eigen::Matrix3Xd::Constant(3, samples, 1e-3)));
    declared_error.left_rms_m = 7e-5;
    const Decision decision{{VerdictKind::unknown}, fit, {}};
    FitStore store;
    PhaseLog log{Progress()};
    const FinalFit last = final_fit({context, declared_error, decision, declared_error.shift, false}, store, log);
    ASSERT_TRUE(last.complete);
    EXPECT_EQ(last.fit.numerics->left_rms_m, 7e-5);
    ASSERT_EQ(log.costs().size(), 1u) << "nothing is refitted";
}

}  // namespace
}  // namespace myo::diagnosis::verdict_values_test
