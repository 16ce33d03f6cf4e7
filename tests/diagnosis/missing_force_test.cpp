#include "diagnosis/missing_force/missing_force.hpp"
#include "diagnosis/unmoved_fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <numbers>

#include "diagnosis/missing_force/force_fields.hpp"
#include "diagnosis/missing_force/smooth_force.hpp"
#include "diagnosis/missing_force/timed_forces.hpp"
#include "support/recorded_motion.hpp"
#include "support/swung_beam.hpp"

namespace myo::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Diagnosis unexplained(const setup::Setup& setup) {
    Diagnosis d;
    d.data = fit_data(setup, prediction::trials_with_role(setup, experiment::TrialRole::fit));
    d.augmented.fit = test::unmoved_fit(setup, d.data, prediction::declared_values(setup));
    d.verdict.kind = VerdictKind::unknown;
    return d;
}

double correlation(const VectorXd& a, const VectorXd& b) { return a.dot(b) / (a.norm() * b.norm()); }

/// 0.3 N that come and go twice, far above what the markers need.
VectorXd pulses(const VectorXd& times, double end) {
    return times.unaryExpr([&](double t) { return 0.3 * std::sin(2.0 * std::numbers::pi * 2.0 * t / end); });
}

TEST(MissingForce, RecoversDirectionPlaceAndCourseOfAKnownForce) {
    const test::Folder folder("missing_force");
    setup::Setup setup = test::swung_beam(folder);
    const prediction::ParameterValues values = prediction::declared_values(setup);
    effect::Affected trial = prediction::affected_trial(setup, 0, values);
    const ForceFields fields = force_fields(*trial.model.body, MissingForcePolicy{});
    const Eigen::Matrix3Xd at_end_along_y = fields.patterns[7] / fields.patterns[7].sum();  // 1 N altogether
    const double end = trial.options.end_s;
    const VectorXd fine = VectorXd::LinSpaced(121, 0.0, end), course = pulses(fine, end);
    trial.model.force_elements.push_back(
        timed_forces({{at_end_along_y, {{fine.begin(), fine.end()}, {course.begin(), course.end()}}}}));
    test::record(setup, 0, values, dynamics::simulate(trial.model, trial.options));

    const MissingForce force = infer_missing_force(setup, unexplained(setup));
    ASSERT_TRUE(force.failure.empty()) << force.failure;
    EXPECT_EQ(force.trial, "swing");
    EXPECT_GT(force.before_over_noise, 10.0);
    EXPECT_LT(force.after_over_noise, 1.3);
    EXPECT_GT(force.removed(), 0.98);
    ASSERT_FALSE(force.modes.empty());
    const ForceMode& mode = force.modes.front();
    EXPECT_GT(mode.share, 0.9);
    EXPECT_GT(mode.direction.y(), 0.99);
    EXPECT_GT(mode.aligned, 0.95);
    EXPECT_GT(mode.place, 0.7);
    EXPECT_NE(mode.where.find("+y"), std::string::npos) << mode.where;
    const VectorXd truth = pulses(force.time_s, end);
    EXPECT_GT(correlation(mode.amplitude_N, truth), 0.97);
    EXPECT_LT((mode.amplitude_N - truth).norm(), 0.25 * truth.norm());
}

TEST(MissingForce, IsNothingWhereTheModelIsRight) {
    const test::Folder folder("missing_force");
    setup::Setup setup = test::swung_beam(folder);
    const prediction::ParameterValues values = prediction::declared_values(setup);
    const effect::Affected trial = prediction::affected_trial(setup, 0, values);
    test::record(setup, 0, values, dynamics::simulate(trial.model, trial.options));
    const MissingForce force = infer_missing_force(setup, unexplained(setup));
    EXPECT_NEAR(force.before_over_noise, 1.0, 0.1);
    if (!force.modes.empty()) {
        EXPECT_LT(force.modes.front().peak_N(), 0.03);
    }
}

TEST(MissingForce, OfADragGoesAgainstTheVelocity) {
    const test::Folder folder("missing_force");
    setup::Setup setup = test::swung_beam(folder);
    const prediction::ParameterValues values = prediction::declared_values(setup);
    prediction::ParameterValues dragged = values;
    dragged.effects.push_back({"quadratic_drag", {{"coefficient_kg_m3", 900.0}}});
    const effect::Affected trial = prediction::affected_trial(setup, 0, dragged);
    test::record(setup, 0, values, dynamics::simulate(trial.model, trial.options));
    Diagnosis d = unexplained(setup);
    const MissingForce force = infer_missing_force(setup, d);
    ASSERT_FALSE(force.modes.empty()) << force.failure;
    EXPECT_GT(force.runs, 2);
    EXPECT_GT(force.removed(), 0.95);
    const ForceMode& mode = force.modes.front();
    EXPECT_GT(std::abs(mode.direction.z()), 0.8);
    ASSERT_FALSE(mode.correlates.empty());
    const statistics::Correlate& first = mode.correlates.front();
    EXPECT_TRUE(first.name == "velocity" || first.name == "|v| v" || first.name == "strain rate") << first.name;
    for (const statistics::Correlate& c : mode.correlates)
        if (c.name == "|v| v") {
            EXPECT_LT(c.correlation, -0.7);
        }
    // The policy of the diagnosis holds: without a run with a force there is none.
    d.settings.policy.force.max_runs = 0;
    const MissingForce without_runs = infer_missing_force(setup, d);
    EXPECT_EQ(without_runs.runs, 2) << "the run without a force and that with tangents";
    EXPECT_EQ(without_runs.failure, "no force makes the residual smaller");
    // With a noise that might be so much larger, this residual is noise.
    d.settings.policy.force.noise_doubt = 1e8;
    EXPECT_EQ(infer_missing_force(setup, d).failure, "the residual is noise");
}

TEST(SmoothForce, LeavesTheNoiseAndIsTheSmallestThatDoes) {
    srand(7);
    const MatrixXd A = MatrixXd::Random(60, 8), half = MatrixXd::Random(8, 8);
    const MatrixXd R = half * half.transpose() + MatrixXd::Identity(8, 8);
    const VectorXd d = VectorXd::Random(60) - A * VectorXd::LinSpaced(8, 1.0, 3.0);
    const SmoothForce solver(A, R, MissingForcePolicy{});
    const double wanted = 0.3 * d.squaredNorm();
    const VectorXd x = solver.solve(d, wanted);
    EXPECT_NEAR((d + A * x).squaredNorm(), wanted, 1e-6 * wanted);
    // At the smallest x' R x the gradients of misfit and size are opposite.
    const VectorXd of_misfit = A.transpose() * (d + A * x), of_size = R * x;
    EXPECT_NEAR(of_misfit.dot(of_size) / (of_misfit.norm() * of_size.norm()), -1.0, 1e-9);
    // What cannot be reached is nearly reached.
    const VectorXd most = solver.solve(d, 0.0), least = A.colPivHouseholderQr().solve(-d);
    const double floor = (d + A * least).squaredNorm();
    EXPECT_NEAR((d + A * most).squaredNorm(), 1.1 * floor, 1e-3 * floor);
}

TEST(ForceFields, FillTheBody) {
    const test::Folder folder("missing_force");
    const setup::Setup setup = test::swung_beam(folder);
    const ForceFields fields = force_fields(*setup.body, MissingForcePolicy{});
    const double volume = 0.1 * 0.03 * 0.03;
    ASSERT_EQ(fields.patterns.size(), 9u);
    double of_x = 0.0;
    for (Index j = 0; j < 9; j += 3)
        for (Index k = 0; k < 9; k += 3) of_x += fields.volume(j, k);
    EXPECT_NEAR(of_x, volume, 1e-9 * volume);
    EXPECT_NEAR(fields.place.minCoeff(), 0.0, 1e-12);
    EXPECT_NEAR(fields.place.maxCoeff(), 1.0, 1e-12);
    for (Index i = 0; i < fields.place.size(); ++i)
        EXPECT_NEAR(fields.place(i), setup.body->mesh.nodes(0, i) / 0.1, 1e-9);
}

TEST(ForceFields, RespondAsTheRunDoesToASmallForce) {
    const test::Folder folder("missing_force");
    setup::Setup setup = test::swung_beam(folder, 0.4);
    // Without gravity the mean state is the state itself, so that the response is exact for small forces.
    for (setup::PreparedTrial& trial : setup.trials) trial.model.gravity_m_s2.setZero();
    const prediction::ParameterValues values = prediction::declared_values(setup);
    const effect::Affected trial = prediction::affected_trial(setup, 0, values);
    const ForceFields fields = force_fields(*setup.body, MissingForcePolicy{});
    const KnotTimes knots = knot_times(trial.options.end_s, MissingForcePolicy{});
    const FitData data = fit_data(setup, {0});
    const MatrixXd A = force_response(setup, data, values, {fields, knots}, MissingForcePolicy{}, {});
    ASSERT_EQ(A.rows(), data.layout.size());
    ASSERT_EQ(A.cols(), 9 * knots.count);
    const auto residual = [&](int knot, double size) {
        model::Model model = trial.model;
        dynamics::SimulationOptions options = trial.options;
        options.solver.tolerance = 1e-9;
        model.force_elements.push_back(
            timed_forces({{fields.patterns[8], knot_signal(knots, VectorXd::Unit(knots.count, knot) * size)}}));
        return flat_residual(data, {prediction::observe_trial(setup, 0, values, dynamics::simulate(model, options))});
    };
    const double size = 100.0;  // N/m3: a hundredth of the weight
    for (const int knot : {0, 1, knots.count / 2}) {
        const VectorXd difference = (residual(knot, size) - residual(knot, -size)) / (2.0 * size),
                       column = A.col(9 * knot + 8);
        ASSERT_GT(difference.norm(), 0.0);
        EXPECT_LT((column - difference).norm(), 0.03 * difference.norm()) << "knot " << knot;
    }
}

}  // namespace
}  // namespace myo::diagnosis
