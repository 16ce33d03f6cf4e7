#include "prediction/marker_places.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <cmath>
#include <sstream>

#include "prediction/weighted_residuals.hpp"
#include "support/recorded_motion.hpp"
#include "support/swung_beam.hpp"

// Unknown places of the markers of a swinging beam, and what they do to residuals.

namespace myo::prediction::marker_places_test {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Where the four markers really sit.
const std::vector<Vector3d> truth{
    {0.0005, 0.0014, -0.0018}, {-0.0021, -0.0009, 0.0012}, {0.0008, -0.0024, 0.0003}, {0.0019, 0.0006, -0.0013}};

double largest(const std::vector<Matrix3Xd>& tracks) {
    double most = 0.0;
    for (const Matrix3Xd& track : tracks)
        for (const double value : track.reshaped())
            if (std::isfinite(value)) most = std::max(most, std::abs(value));
    return most;
}

/// Residuals that the derivatives by the places predict for markers at these places.
std::vector<Matrix3Xd> residual_at(const TrialPrediction& prediction, const std::vector<Vector3d>& places_m) {
    std::vector<Matrix3Xd> residual = prediction.residual_m;
    for (std::size_t k = 0; k < prediction.place_tangents.size(); ++k) {
        const std::size_t marker = k / 3;
        const auto axis = static_cast<Index>(k % 3);
        const auto at = [&](const std::vector<Vector3d>& places) {
            return places.empty() ? 0.0 : places[marker](axis);
        };
        const double change = at(places_m) - at(prediction.places_m);
        if (change == 0.0) continue;
        for (std::size_t m = 0; m < residual.size(); ++m)
            if (const Matrix3Xd& tangent = prediction.place_tangents[k][m]; tangent.cols() > 0)
                residual[m] += change * tangent;
    }
    return residual;
}

/// Largest error of residual_at() for this part of the true places, there and back, over that part.
double miss_of_linearity(const setup::Setup& setup, const ParameterValues& values, const dynamics::Trace& trace,
                         double part) {
    const TrialPrediction declared = observe_trial(setup, 0, values, trace);
    ParameterValues placed = values;
    for (const Vector3d& place : truth) placed.places_m.emplace_back(part * place);
    // Two markers lie on the border of cells, where the deformation gradient jumps along y.
    placed.places_m[2].y() = placed.places_m[3].y() = 0.0;
    const TrialPrediction there = observe_trial(setup, 0, placed, trace);
    std::vector<Matrix3Xd> miss = residual_at(declared, placed.places_m), back = residual_at(there, {});
    for (std::size_t m = 0; m < miss.size(); ++m) {
        miss[m] -= there.residual_m[m];
        back[m] -= declared.residual_m[m];
    }
    return std::max(largest(miss), largest(back)) / part;
}

TEST(MarkerPlaces, HaveDerivativesInEveryComparison) {
    const test::Folder folder("places");
    setup::Setup setup = test::swung_beam(folder, 0.2);
    ParameterValues values = declared_values(setup);
    const dynamics::Trace trace = predict_trial(setup, 0, values).trace;
    EXPECT_TRUE(observe_trial(setup, 0, values, trace).place_tangents.empty());
    setup.experiment.markers.placement_m = 0.002;
    EXPECT_EQ(observe_trial(setup, 0, values, trace).place_tangents.size(), 12u);
    const auto expect_derivatives = [&] {
        const double small = miss_of_linearity(setup, values, trace, 1e-3);
        EXPECT_LT(small, 2e-4 * 0.002);
        EXPECT_LT(small, 0.02 * miss_of_linearity(setup, values, trace, 0.1));
    };
    expect_derivatives();
    // A turned camera, wrong names and a wrong scale carry the places along.
    values.rotation_rad = {0.1, -0.2, 0.3};
    values.effects.push_back({"scale_error", {{"relative_error", 0.01}}});
    values.effects.push_back(
        {"marker_swap", {{"markers", std::vector<std::string>{"middle", "tip_low"}}, {"time_s", 0.1}}});
    expect_derivatives();
    // Displacements feel a place only by the deformation since the start.
    setup.experiment.markers.compare = experiment::Comparison::displacement;
    for (const Matrix3Xd& track : setup.trials[0].measured.tracks) setup.trials[0].reference_m.push_back(track.col(0));
    values.effects.pop_back();
    expect_derivatives();
    EXPECT_LT(observe_trial(setup, 0, values, trace).place_tangents[0][0].col(0).norm(), 1e-12);
    EXPECT_GT(largest(observe_trial(setup, 0, values, trace).place_tangents[0]), 0.05);
}

/// A Gauss-Newton step to the minimum of |r + J step|^2.
VectorXd step_of(const MatrixXd& J, const VectorXd& r) { return -(J.transpose() * J).ldlt().solve(J.transpose() * r); }

TEST(MarkerPlaces, MarginalFitIsTheFitOfModulusAndPlacesTogether) {
    const test::Folder folder("places");
    setup::Setup setup = test::swung_beam(folder, 0.2);
    setup.trials.resize(1);
    setup.experiment.trials.resize(1);
    ParameterValues true_values = declared_values(setup);
    true_values.youngs_modulus_Pa *= 1.08;
    true_values.places_m = truth;
    test::record(setup, 0, true_values, predict_trial(setup, 0, true_values).trace);
    setup.trials[0].measured.tracks[1].middleCols(4, 3).setConstant(std::nan(""));  // not seen for a while
    setup.experiment.markers.placement_m = 0.002;
    const std::vector<ModelParameter> parameters = free_parameters(setup);
    ASSERT_EQ(parameters.size(), 1u);
    const double scale = parameters[0].parameter.scale;

    // A fit of the modulus alone, with the places marginalised and their most probable ones used for the derivative.
    ParameterValues marginal = declared_values(setup);
    VectorXd residuals;
    for (int round = 0; round < 7; ++round) {
        const std::vector<TrialPrediction> there{predict_trial(setup, 0, marginal, parameters)};
        const inverse::ResidualEvaluation at = weighted_residuals(setup, {0}, there, 1);
        ASSERT_TRUE(at.ok);
        residuals = at.residuals;
        marginal.places_m = probable_places(setup, unknown_places(setup, {0}, there), residuals);
        marginal.youngs_modulus_Pa += step_of(at.jacobian * scale, residuals)(0) * scale;
    }
    // A fit of modulus and places together, with a row of the prior for each coordinate.
    ParameterValues together = declared_values(setup);
    together.places_m.assign(4, Vector3d::Zero());
    setup::Setup plain = setup;
    plain.experiment.markers.placement_m = 0.0;
    VectorXd rows;
    for (int round = 0; round < 7; ++round) {
        const inverse::ResidualEvaluation at = weighted_residuals(plain, {0},
                                                                  {predict_trial(plain, 0, together, parameters)}, 1);
        const MatrixXd A = unknown_places(setup, {0}, {predict_trial(setup, 0, together)}).derivatives();
        MatrixXd J = MatrixXd::Zero(A.rows() + 12, 13);
        J.topLeftCorner(A.rows(), 1) = at.jacobian * scale;
        J.topRightCorner(A.rows(), 12) = A;
        J.bottomRightCorner(12, 12).setIdentity();
        rows.resize(J.rows());
        rows << at.residuals, VectorXd::Zero(12);
        for (Index m = 0; m < 4; ++m)
            rows.segment<3>(A.rows() + 3 * m) = together.places_m[static_cast<std::size_t>(m)] / 0.002;
        const VectorXd step = step_of(J, rows);
        together.youngs_modulus_Pa += scale * step(0);
        for (Index m = 0; m < 4; ++m)
            together.places_m[static_cast<std::size_t>(m)] += 0.002 * step.segment<3>(1 + 3 * m);
    }
    EXPECT_NEAR(marginal.youngs_modulus_Pa / together.youngs_modulus_Pa, 1.0, 1e-8);
    EXPECT_NEAR(residuals.squaredNorm() / rows.squaredNorm(), 1.0, 1e-8);
    for (std::size_t m = 0; m < 4; ++m)
        EXPECT_LT((marginal.places_m[m] - together.places_m[m]).norm(), 1e-8 * truth[m].norm()) << m;
    EXPECT_NEAR(marginal.youngs_modulus_Pa / true_values.youngs_modulus_Pa, 1.0, 0.01);
    EXPECT_GT(std::abs(marginal.youngs_modulus_Pa / setup.experiment.material.youngs_modulus_Pa - 1.0), 0.05);
}

/// What cameras elsewhere saw of these tracks: half a second at rest, then the motion.
std::string seen_from_elsewhere(const std::vector<Matrix3Xd>& tracks) {
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.8, Vector3d(1, 2, -1).normalized()).toRotationMatrix();
    std::ostringstream text;
    text.precision(12);
    text << "time_s";
    for (const char* name : {"tip_left", "tip_right", "tip_low", "middle"})
        for (const char axis : {'x', 'y', 'z'}) text << "," << name << "_" << axis << "_m";
    for (int k = -50; k < tracks.front().cols(); ++k) {
        text << "\n" << 0.01 * (k + 50);
        for (const Matrix3Xd& track : tracks) {
            const Vector3d seen = turn * track.col(std::max(k, 0)) + Vector3d(0.3, 1.2, -0.4);
            for (const double coordinate : seen) text << "," << coordinate;
        }
    }
    return text.str() + "\n";
}

TEST(MarkerPlaces, AreKeptApartFromARegistrationByTheMarkersThemselves) {
    const test::Folder folder("places");
    const setup::Setup straight = test::swung_beam(folder, 0.2);
    ParameterValues values = declared_values(straight);
    values.places_m = truth;
    const TrialPrediction run = predict_trial(straight, 0, values);
    folder.write("swing.csv", seen_from_elsewhere(run.positions_m));
    std::string toml = test::swung_beam_toml();
    for (std::size_t at = 0; (at = toml.find("start = \"straight\"", at)) != std::string::npos; at += 20)
        toml.insert(at, "start_s = 0.5\n"), at += 14;
    toml.replace(toml.find("noise_m = 1e-4"), 14, "noise_m = 1e-4\nplacement_m = 0.002");
    toml.insert(toml.find("[markers]"), "[registration]\nknown = false\nmethod = \"rest_pose\"\n");
    for (const bool by_displacement : {false, true}) {
        if (by_displacement) toml.insert(toml.find("placement_m"), "compare = \"displacement\"\n");
        folder.write("experiment.toml", toml);
        const setup::Setup setup = test::setup_in(folder);
        ASSERT_EQ(setup.trials[0].registration_by_places.cols(), 12);
        ParameterValues at_declared = values;
        at_declared.places_m.clear();
        const TrialPrediction declared = observe_trial(setup, 0, at_declared, run.trace),
                              there = observe_trial(setup, 0, values, run.trace);
        // The registration takes up part of the places, and leaves the rest of them in the residuals.
        const double before = largest(declared.residual_m);
        EXPECT_GT(before, 2e-4);
        EXPECT_LT(largest(there.residual_m), 0.05 * before);
        EXPECT_LT(largest(residual_at(declared, truth)), 0.1 * before);
        ParameterValues found = at_declared;
        const double placed = largest(
            at_probable_places(setup, {0}, found, {predict_trial(setup, 0, at_declared)}).front().residual_m);
        EXPECT_LT(placed, 0.05 * before);
    }
}

}  // namespace
}  // namespace myo::prediction::marker_places_test
