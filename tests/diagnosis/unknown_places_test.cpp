#include <gtest/gtest.h>

#include <cmath>

#include "diagnosis/fit/declared_fit.hpp"
#include "diagnosis/fit/joint_fit.hpp"
#include "prediction/marker_places.hpp"
#include "prediction/predict_trials.hpp"
#include "support/recorded_motion.hpp"
#include "support/swung_beam.hpp"

// A diagnosis of recordings whose markers sit some millimetres from their declared places.

namespace myo::diagnosis::unknown_places_test {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double placement_m = 0.002;

struct Recorded {
    std::vector<Vector3d> truth{
        {0.0005, 0.0014, -0.0018}, {-0.0021, -0.0009, 0.0012}, {0.0008, -0.0024, 0.0003}, {0.0019, 0.0006, -0.0013}};
    test::Folder folder{"places"};
    setup::Setup setup = test::swung_beam(folder, 0.2);

    Recorded() {
        prediction::ParameterValues values = prediction::declared_values(setup);
        values.youngs_modulus_Pa *= 1.08;
        values.places_m = truth;
        test::record(setup, 0, values, prediction::predict_trial(setup, 0, values).trace);
        setup.experiment.markers.placement_m = placement_m;
    }
};

/// Residual of the right model: noise of variance 1 in all directions.
double mean_square(const VectorXd& residual) { return residual.squaredNorm() / static_cast<double>(residual.size()); }

TEST(UnknownPlaces, AreTakenOutOfTheDeclaredFit) {
    Recorded of;
    const auto fitted = [&] {
        FitStore store;
        PhaseLog log({});
        DeclaredFit fit = fit_declared(of.setup, {}, store, log);
        EXPECT_TRUE(fit.usable()) << fit.failure;
        return fit;
    };
    const DeclaredFit open = fitted();
    EXPECT_NEAR(mean_square(open.fit.fit.residual), 1.0, 0.15);
    EXPECT_NEAR(open.fit.fit.values.youngs_modulus_Pa, 1.08 * 2.6e5, 0.02 * 2.6e5);  // with long steps
    const std::vector<Vector3d> found = probable_places(of.setup, open.data, open.fit.fit.residual);
    ASSERT_EQ(found.size(), 4u);
    for (std::size_t m = 0; m < 4; ++m) {
        EXPECT_LT((found[m] - of.truth[m]).norm(), 2e-4) << m;
        EXPECT_LT((open.fit.fit.values.places_m[m] - of.truth[m]).norm(), 3e-4) << m;
    }
    of.setup.experiment.markers.placement_m = 0.0;
    const DeclaredFit exact = fitted();
    EXPECT_GT(mean_square(exact.fit.fit.residual), 50.0);
    EXPECT_TRUE(exact.data.places.empty());
    EXPECT_TRUE(probable_places(of.setup, exact.data, exact.fit.fit.residual).empty());
}

TEST(UnknownPlaces, WhitenAllFlatVectorsAlike) {
    const Recorded of;
    const FitData plain = fit_data(of.setup, {0});
    const prediction::ParameterValues values = prediction::declared_values(of.setup);
    const std::vector<prediction::ModelParameter> parameters = prediction::free_parameters(of.setup);
    const prediction::TrialPrediction there = prediction::predict_trial(of.setup, 0, values, parameters);
    const FitData open = with_unknown_places(of.setup, plain, {there});
    ASSERT_EQ(open.places.derivatives().cols(), 12);
    EXPECT_LT((flat_residual(open, {there}) - open.places.whitened(flat_residual(plain, {there}))).norm(), 1e-9);
    EXPECT_LT((flat_jacobian(open, {there}, 1) - open.places.whitened(flat_jacobian(plain, {there}, 1))).norm(), 1e-12);
    EXPECT_EQ(flat_tangent(open, {there.tangents[0]}), flat_jacobian(open, {there}, 1).col(0));
    // To first order the residual does not depend on the places at which the markers were observed.
    prediction::ParameterValues placed = values;
    placed.places_m = of.truth;
    const prediction::TrialPrediction other = prediction::observe_trial(of.setup, 0, placed, there.trace);
    const double seen = (flat_residual(plain, {other}) - flat_residual(plain, {there})).norm();
    EXPECT_GT(seen, 100.0);
    EXPECT_LT((flat_residual(open, {other}) - flat_residual(open, {there})).norm(), 1e-3 * seen);
    // What a place does to the residuals is nearly gone, what the modulus does is not.
    const VectorXd place = open.places.derivatives().col(2);
    EXPECT_LT(open.places.whitened(place).norm(), 1.0);
    EXPECT_GT(place.norm(), 50.0);
    EXPECT_GT(flat_jacobian(open, {there}, 1).norm(), 0.3 * flat_jacobian(plain, {there}, 1).norm());
}

}  // namespace
}  // namespace myo::diagnosis::unknown_places_test
