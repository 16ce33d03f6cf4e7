#include "calibration/numerical_deviation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>

#include "report/html_report.hpp"
#include "results/calibration_report.hpp"
#include "results/output_json.hpp"
#include "support/recorded_motion.hpp"
#include "support/swung_beam.hpp"

namespace myo::calibration {
namespace {

using testing::HasSubstr;

constexpr double modulus_Pa = 2.5e5;

/// The beam on tetrahedra of 8 mm, 20 times the cells of the coarse studies, with short steps.
setup::Setup fine_beam(const test::Folder& folder) {
    setup::SetupSettings settings;
    settings.mesh.element = fem::ElementKind::tet10;
    settings.mesh.resolution_m = 0.008;
    settings.h_s = 0.001;
    return test::setup_of_folder(folder, settings);
}

/// The beam's experiment with what the fine mesh does as its data, on other cells.
class SwungBeam {
public:
    SwungBeam() : folder_("numerical_deviation") {
        test::swung_beam(folder_, 0.3);
        setup::Setup fine = fine_beam(folder_);
        prediction::ParameterValues values = prediction::declared_values(fine);
        values.youngs_modulus_Pa = modulus_Pa;
        const prediction::TrialPrediction truth = prediction::predict_trial(fine, 0, values);
        EXPECT_TRUE(truth.ok()) << truth.message;
        test::record(fine, 0, values, truth.trace);
        tracks_ = fine.trials[0].measured.tracks;
        std::string text = "time_s";
        for (const std::string& name : fine.marker_names)
            for (const char axis : {'x', 'y', 'z'}) text += "," + name + "_" + axis + "_m";
        char number[32];
        for (Eigen::Index k = 0; k < fine.trials[0].measured.sample_count(); ++k) {
            std::snprintf(number, sizeof number, "\n%.2f", fine.trials[0].measured.time_s(k));
            text += number;
            for (const Eigen::Matrix3Xd& track : tracks_)
                for (int axis = 0; axis < 3; ++axis) {
                    std::snprintf(number, sizeof number, ",%.8f", track(axis, k));
                    text += number;
                }
        }
        folder_.write("swing.csv", text + "\n");
    }

    setup::Setup setup(double resolution_m) const {
        setup::SetupSettings settings;
        settings.mesh.resolution_m = resolution_m;
        return test::setup_of_folder(folder_, settings);
    }

private:
    test::Folder folder_;
    std::vector<Eigen::Matrix3Xd> tracks_;
};

double share(const Eigen::VectorXd& part) { return part.size() == 1 ? part(0) / modulus_Pa : std::nan(""); }

TEST(NumericalDeviation, CoversTheErrorAgainstAFineMeshAndShrinksWithTheEdges) {
    const SwungBeam beam;
    std::vector<double> mesh;
    for (const double edge : {0.015, 0.0075}) {
        const setup::Setup setup = beam.setup(edge);
        Calibration found = calibrate(setup);
        ASSERT_TRUE(found.fit.converged()) << found.fit.message;
        EXPECT_DOUBLE_EQ(found.deviation(0), found.fit.deviations(0));
        found.numerical = numerical_deviations(setup, found);
        EXPECT_EQ(found.numerical.message, "");
        ASSERT_EQ(found.numerical.mesh.size(), 1);
        const double error = std::abs(found.fit.values(0) - modulus_Pa), deviation = found.deviation(0);
        EXPECT_LT(error, 2.5 * deviation) << edge;
        EXPECT_LT(deviation, 0.05 * modulus_Pa) << edge;
        EXPECT_DOUBLE_EQ(
            deviation,
            Eigen::Vector3d(found.fit.deviations(0), found.numerical.mesh(0), found.numerical.step(0)).norm());
        mesh.push_back(share(found.numerical.mesh));
        // What the fit on these cells leaves beside the noise is what other cells change.
        const double ratio = found.after.fit_rms_m / setup::mean_noise(setup),
                     beside_noise = std::sqrt(ratio * ratio - 1.0);
        RecordProperty("left_" + std::to_string(edge), std::to_string(beside_noise));
        RecordProperty("motion_" + std::to_string(edge), std::to_string(found.numerical.motion_noise_levels));
        RecordProperty("error_" + std::to_string(edge), std::to_string(error / modulus_Pa));
        RecordProperty("mesh_" + std::to_string(edge), std::to_string(mesh.back()));
    }
    // Half the edges: a quarter of the error, between the orders 1.2 and 2.8.
    EXPECT_LT(mesh[1], 0.43 * mesh[0]);
    EXPECT_GT(mesh[1], 0.14 * mesh[0]);
}

/// What the same cells did with short steps leaves the steps' error alone, which theory knows: twice the frequency's.
TEST(NumericalDeviation, OfTheStepIsTwiceItsFrequencyError) {
    const test::Folder folder("step");
    setup::Setup setup = test::swung_beam(folder, 0.6);
    setup.noise_m *= 0.1;  // far below the error that is looked for
    prediction::ParameterValues values = prediction::declared_values(setup);
    setup::Setup fine = setup;
    setup::set_step(fine.trials[0], 0.0005);
    const prediction::TrialPrediction truth = prediction::predict_trial(fine, 0, values);
    ASSERT_TRUE(truth.ok()) << truth.message;
    test::record(setup, 0, values, truth.trace);
    for (setup::PreparedTrial& trial : setup.trials) set_step(trial, 0.005);
    setup.settings.h_s = 0.005;
    const Calibration plain = calibrate(setup), found = calibrate_with_chosen_steps(setup);
    ASSERT_TRUE(found.fit.converged()) << found.fit.message;
    EXPECT_EQ(found.fit.values, plain.fit.values);
    EXPECT_EQ(found.fit.deviations, plain.fit.deviations);  // of the noise, as they were
    const double error = std::abs(found.fit.values(0) - values.youngs_modulus_Pa);
    EXPECT_GT(error, 5.0 * found.fit.deviations(0));  // there is something to be found
    ASSERT_EQ(found.numerical.step.size(), 1);
    EXPECT_NEAR(found.numerical.step(0), error, 0.3 * error);
}

/// Parts are stated in every result.
TEST(NumericalDeviation, IsStatedByPart) {
    const test::Folder folder("parts");
    setup::Setup setup = test::swung_beam(folder, 0.3);
    const prediction::ParameterValues values = prediction::declared_values(setup);
    const prediction::TrialPrediction truth = prediction::predict_trial(setup, 0, values);
    test::record(setup, 0, values, truth.trace);
    const Calibration found = calibrate_with_chosen_steps(setup);
    const results::RunFacts run_facts{"test", {}, 0.0, 0, {}};
    const report::Json json = results::calibrate_json(setup, found, run_facts).at("parameters").at("youngs_modulus_Pa");
    EXPECT_DOUBLE_EQ(json.at("std"), found.deviation(0));
    EXPECT_DOUBLE_EQ(json.at("std_noise"), found.fit.deviations(0));
    EXPECT_DOUBLE_EQ(json.at("std_mesh"), found.numerical.mesh(0));
    EXPECT_DOUBLE_EQ(json.at("std_step"), found.numerical.step(0));
    EXPECT_THAT(report::html(results::calibration_report(setup, found, run_facts)), HasSubstr("by mesh"));
}

TEST(NumericalDeviation, CancelledIsTheNoiseAloneAndSaysSo) {
    const test::Folder folder("cancelled");
    setup::Setup setup = test::swung_beam(folder, 0.3);
    const prediction::ParameterValues values = prediction::declared_values(setup);
    const prediction::TrialPrediction truth = prediction::predict_trial(setup, 0, values);
    test::record(setup, 0, values, truth.trace);
    Calibration found = calibrate(setup);
    std::atomic<bool> cancel{true};
    found.numerical = numerical_deviations(setup, found, Progress({}, &cancel));
    EXPECT_EQ(found.numerical.mesh.size(), 0);
    EXPECT_EQ(found.numerical.step.size(), 0);
    EXPECT_EQ(found.deviation(0), found.fit.deviations(0));
    EXPECT_THAT(found.numerical.message, HasSubstr("noise alone"));
    EXPECT_THAT(found.numerical.message, HasSubstr("stopped by the user"));
    const report::Json
        json = results::calibrate_json(setup, found, {"test", {}, 0.0, 0, {}}).at("parameters").at("youngs_modulus_Pa");
    EXPECT_TRUE(json.at("std_mesh").is_null());
    EXPECT_TRUE(json.at("std_step").is_null());
}

/// Three layers, whose finer cells are five and whose coarser ones two; with the time of a run made by the policy, for
/// no clock shall decide.
class AnotherMesh : public testing::Test {
protected:
    AnotherMesh() : folder_("another_mesh") {
        test::swung_beam(folder_, 0.3);
        setup::SetupSettings settings;
        settings.mesh.resolution_m = 0.01;
        settings.h_s = 0.005;
        setup_ = test::setup_of_folder(folder_, settings);
        const prediction::ParameterValues values = prediction::declared_values(setup_);
        test::record(setup_, 0, values, prediction::predict_trial(setup_, 0, values).trace);
        found_ = calibrate(setup_);
        EXPECT_TRUE(found_.fit.converged()) << found_.fit.message;
        policy_.always_s = 1e9;
    }

    NumericalDeviations deviations() const { return numerical_deviations(setup_, found_, {}, policy_); }

    test::Folder folder_;
    setup::Setup setup_;
    Calibration found_;
    NumericalDeviationPolicy policy_;
};

TEST_F(AnotherMesh, IsACoarserOneWhereAFinerTakesTooLong) {
    policy_.edges = {2.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0};
    const NumericalDeviations finer = deviations();
    policy_.edges = {1.5, 1.5, 1.5};
    const NumericalDeviations coarser = deviations();
    policy_.edges = numerical_deviation_policy.edges;
    EXPECT_EQ(deviations().mesh, finer.mesh);
    policy_.time_exponent = 1e4;  // of unknowns: more of them take for ever, fewer no time
    const NumericalDeviations fallback = deviations();
    EXPECT_EQ(fallback.message, "");
    EXPECT_EQ(fallback.mesh, coarser.mesh);
    EXPECT_NE(fallback.mesh, finer.mesh);
    EXPECT_EQ(fallback.step, finer.step);
}

TEST_F(AnotherMesh, IsLeftOutWithAMessageWhereEveryOneTakesTooLong) {
    policy_.edges = {2.0 / 3.0, 0.5, 0.4};
    policy_.time_exponent = 1e4;
    const NumericalDeviations parts = deviations();
    EXPECT_EQ(parts.mesh.size(), 0);
    EXPECT_EQ(parts.step.size(), 1);
    EXPECT_EQ(parts.message,
              "the standard deviations leave out the mesh's error: "
              "runs on another mesh would take too long");
    found_.numerical = parts;
    EXPECT_DOUBLE_EQ(found_.deviation(0), std::hypot(found_.fit.deviations(0), parts.step(0)));
    // Where all are alike, it is not for want of time.
    policy_.edges = {1.0, 1.0, 1.0};
    EXPECT_THAT(deviations().message, HasSubstr("no other mesh can be made"));
}

}  // namespace
}  // namespace myo::calibration
