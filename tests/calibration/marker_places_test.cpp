#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "calibration/calibrate.hpp"
#include "check/catalogue.hpp"
#include "prediction/predict_trials.hpp"
#include "results/calibration_report.hpp"
#include "results/marker_places.hpp"
#include "results/output_json.hpp"
#include "support/recorded_motion.hpp"
#include "support/swung_beam.hpp"

// A calibration whose markers sit up to some millimetres from their declared places.

namespace myo::calibration::marker_places_test {
namespace {

using Eigen::Vector3d;

constexpr double placement_m = 0.002, true_modulus_Pa = 2.8e5;

/// A beam recorded in two trials with its markers off by draws of `placement_m`.
struct Recorded {
    setup::Setup setup;
    std::vector<Vector3d> places_m;
};

Recorded recorded(setup::Setup setup, unsigned seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> unit;
    prediction::ParameterValues values = prediction::declared_values(setup);
    values.youngs_modulus_Pa = true_modulus_Pa;
    for (std::size_t m = 0; m < setup.marker_names.size(); ++m) {
        Vector3d place;
        for (double& coordinate : place) coordinate = placement_m * unit(random);
        values.places_m.push_back(place);
    }
    const dynamics::Trace trace = prediction::predict_trial(setup, 0, values).trace;
    for (std::size_t t = 0; t < 2; ++t) test::record(setup, t, values, trace, 2 * seed + static_cast<unsigned>(t));
    return {std::move(setup), values.places_m};
}

double error_in_deviations(const Calibration& calibration) {
    return (calibration.fit.values(0) - true_modulus_Pa) / calibration.fit.deviations(0);
}

TEST(MarkerPlaces, AreFittedBesideTheModulus) {
    const test::Folder folder("places");
    const setup::Setup plain = test::swung_beam(folder, 0.2);
    double squares = 0.0, ignored = 0.0;
    const int draws = 5;
    for (unsigned seed = 1; seed <= draws; ++seed) {
        Recorded of = recorded(plain, seed);
        const Calibration exact = calibrate(of.setup);
        of.setup.experiment.markers.placement_m = placement_m;
        const Calibration open = calibrate(of.setup);
        ASSERT_TRUE(open.fit.converged() && exact.fit.converged());
        EXPECT_TRUE(exact.places.empty());
        ASSERT_EQ(open.places.size(), 4u);
        squares += std::pow(error_in_deviations(open), 2);
        ignored += std::pow(exact.fit.values(0) - true_modulus_Pa, 2) / std::pow(open.fit.deviations(0), 2);
        // The places are found as well as they say, and are clearly not the declared ones.
        double places = 0.0, zero = 0.0;
        for (std::size_t m = 0; m < 4; ++m) {
            const prediction::FoundPlace& found = open.places[m];
            places += (found.shift_m - of.places_m[m]).cwiseQuotient(found.deviation_m).squaredNorm();
            zero += of.places_m[m].cwiseQuotient(found.deviation_m).squaredNorm();
            EXPECT_LT((found.deviation_m.array() / placement_m).maxCoeff(), 1.0);
        }
        EXPECT_LT(places, 3.0 * 12.0);
        EXPECT_GT(zero, 30.0 * 12.0);
        // With the places only noise is left, and the trial that was not fitted is predicted to within it.
        EXPECT_NEAR(open.after.fit_rms_m, 1e-4, 1e-5);
        EXPECT_NEAR(open.after.validation_rms_m, 1e-4, 2e-5);
        EXPECT_GT(exact.after.validation_rms_m, 1e-3);
        EXPECT_EQ(open.before.fit_rms_m, exact.before.fit_rms_m);
    }
    // Chi-squared of five draws: between 0.83 and 12.8 with probability 0.95.
    EXPECT_LT(squares, 16.0);
    EXPECT_GT(squares, 0.5);
    EXPECT_GT(ignored, 10.0 * squares);
}

/// The beam at rest under four forces on its tip, the last one to be predicted.
setup::Setup held_beam(const test::Folder& folder) {
    std::string toml = test::swung_beam_toml();
    toml.resize(toml.find("[[trial]]"));
    const char* const forces[] = {"[0, 0, 1.5]", "[0, 1.0, 1.0]", "[0, -1.5, 1.2]", "[0.5, 1.2, -1.2]"};
    for (int t = 0; t < 4; ++t)
        toml += "[[trial]]\nname = \"hold " + std::to_string(t) + "\"\nrole = \"" + (t < 3 ? "fit" : "validate") +
                "\"\ntrace = \"swing.csv\"\nformat = \"csv\"\nhold = true\n[[trial.load]]\nkind = \"force\"\n"
                "box_m = [[0.0995, -0.001, -0.001], [0.1005, 0.031, 0.031]]\nforce_N = " +
                forces[t] + "\n";
    const setup::Setup swung = test::swung_beam(folder, 0.2);  // writes the trace
    folder.write("experiment.toml", toml);
    return test::setup_in(folder);
}

TEST(MarkerPlaces, AreSharedByHoldsAndTurnWithTheMaterial) {
    const test::Folder folder("places");
    setup::Setup setup = held_beam(folder);
    prediction::ParameterValues values = prediction::declared_values(setup);
    values.youngs_modulus_Pa = true_modulus_Pa;
    values.places_m = {{0.001, 0.002, 0.002}, {-0.001, 0.001, 0.002}, {0.001, -0.001, 0.003}, {0.002, -0.001, 0.001}};
    for (std::size_t t = 0; t < 4; ++t) {
        const dynamics::Trace trace = prediction::predict_trial(setup, t, values).trace;
        test::record(setup, t, values, trace, static_cast<unsigned>(t));
    }
    const Calibration exact = calibrate(setup);
    setup.experiment.markers.placement_m = placement_m;
    const Calibration open = calibrate(setup);
    ASSERT_TRUE(open.fit.converged()) << open.fit.message;
    EXPECT_LT(std::abs(error_in_deviations(open)), 3.0);
    EXPECT_GT(std::abs(exact.fit.values(0) - true_modulus_Pa), 5.0 * open.fit.deviations(0));
    ASSERT_EQ(open.places.size(), 4u);
    double squares = 0.0;
    for (std::size_t m = 0; m < 4; ++m)
        squares += (open.places[m].shift_m - values.places_m[m])
                       .cwiseQuotient(open.places[m].deviation_m)
                       .squaredNorm();
    EXPECT_LT(squares, 3.0 * 12.0);
    EXPECT_LT(open.places[0].deviation_m.maxCoeff(), 3e-4);
    EXPECT_LT(open.after.validation_rms_m, 2e-4);
    EXPECT_GT(exact.after.validation_rms_m, 1e-3);
}

TEST(MarkerPlaces, AreReportedAndQuestionedFarFromTheirDeclaration) {
    const test::Folder folder("places");
    Recorded of = recorded(test::swung_beam(folder, 0.2), 1);
    of.setup.experiment.markers.placement_m = placement_m;
    const auto finding_of = [&](const Calibration& calibration) {
        return check::run_check(*check::find_check("places"), {of.setup, &calibration.after, &calibration});
    };
    Calibration open = calibrate(of.setup);
    ASSERT_EQ(finding_of(open).size(), 1u);
    EXPECT_EQ(finding_of(open)[0].level, check::CheckLevel::passed);
    const report::Json json = results::calibrate_json(of.setup, open, {});
    EXPECT_EQ(json["marker_places"]["tip_low"]["shift_m"][2], open.places[2].shift_m.z());
    EXPECT_EQ(json["marker_places"]["tip_low"]["std_m"][0], open.places[2].deviation_m.x());
    EXPECT_NE(report::html(results::calibration_report(of.setup, open, {})).find("Places of the markers"),
              std::string::npos);
    EXPECT_NE(results::place_lines(open.places).find("\ntip_low "), std::string::npos);
    // A marker that was put on the wrong place is 10 mm off.
    for (setup::PreparedTrial& trial : of.setup.trials) trial.measured.tracks[3].row(0).array() += 0.010;
    open = calibrate(of.setup);
    ASSERT_EQ(finding_of(open).size(), 1u);
    EXPECT_EQ(finding_of(open)[0].subject, "middle");
    EXPECT_EQ(finding_of(open)[0].level, check::CheckLevel::doubtful);
    EXPECT_EQ(finding_of(open)[0].sentence.find("marker middle sits "), 0u);
    // Exact places are no matter of a check or a report.
    of.setup.experiment.markers.placement_m = 0.0;
    const Calibration exact = calibrate(of.setup);
    EXPECT_TRUE(finding_of(exact).empty());
    EXPECT_FALSE(results::calibrate_json(of.setup, exact, {}).contains("marker_places"));
    EXPECT_TRUE(results::place_lines(exact.places).empty());
}

}  // namespace
}  // namespace myo::calibration::marker_places_test
