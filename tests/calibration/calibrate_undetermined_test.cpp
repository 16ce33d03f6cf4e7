#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

#include "calibration/calibrate.hpp"
#include "calibration/values_at_bounds.hpp"
#include "report/html_report.hpp"
#include "results/calibration_report.hpp"
#include "results/output_json.hpp"
#include "support/experiment_folder.hpp"
#include "support/swung_beam.hpp"

namespace myo::calibration {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using testing_support::replaced;

/// Writes what the beam of a folder's declaration does with these values, and noise of 0.1 mm, into its trace.
void write_motion(const test::Folder& folder, const std::string& toml, double youngs_modulus_Pa) {
    test::swung_beam(folder, 0.3);
    folder.write("experiment.toml", toml);
    const setup::Setup setup = test::setup_in(folder);
    prediction::ParameterValues values = prediction::declared_values(setup);
    values.youngs_modulus_Pa = youngs_modulus_Pa;
    const prediction::TrialPrediction truth = prediction::predict_trial(setup, 0, values);
    ASSERT_TRUE(truth.ok()) << truth.message;
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0.0, 1e-4);
    std::string text = "time_s";
    for (const std::string& name : setup.marker_names)
        for (const char axis : {'x', 'y', 'z'}) text += "," + name + "_" + axis + "_m";
    for (Eigen::Index k = 0; k < setup.trials[0].measured.sample_count(); ++k) {
        char number[32];
        std::snprintf(number, sizeof number, "\n%.2f", setup.trials[0].measured.time_s(k));
        text += number;
        for (const Eigen::Matrix3Xd& track : truth.positions_m)
            for (int axis = 0; axis < 3; ++axis) {
                std::snprintf(number, sizeof number, ",%.7f", track(axis, k) + noise(random));
                text += number;
            }
    }
    folder.write("swing.csv", text + "\n");
}

const std::string hold = [] {
    std::string text = replaced(test::swung_beam_toml(), "calibrate = [\"youngs_modulus\"]",
                                "calibrate = [\"youngs_modulus\", \"damping\"]");
    for (int i = 0; i < 2; ++i) text = replaced(text, "start = \"straight\"", "start = \"equilibrium\"");
    return text;
}();

const results::RunFacts facts{"test", {}, 0.0, 0, {}};

/// A body at rest says nothing of its damping: that is left where it was declared, and the modulus has the deviation
/// that it has alone.
TEST(CalibrateUndetermined, AHoldDeterminesTheModulusAndNotTheDamping) {
    const test::Folder folder("hold");
    write_motion(folder, hold, 2.3e5);
    const setup::Setup setup = test::setup_in(folder);
    CalibrationSettings modulus_only;
    modulus_only.names = {"youngs_modulus"};
    const Calibration both = calibrate(setup), alone = calibrate(setup, modulus_only);
    ASSERT_TRUE(both.fit.converged()) << both.fit.message;
    EXPECT_NEAR(both.fit.values(0), alone.fit.values(0), 1e-6 * alone.fit.values(0));
    EXPECT_NEAR(both.fit.values(0), 2.3e5, 5.0 * alone.fit.deviations(0));
    EXPECT_NEAR(both.fit.deviations(0), alone.fit.deviations(0), 1e-3 * alone.fit.deviations(0));
    EXPECT_EQ(both.fit.values(1), 0.004);
    EXPECT_TRUE(std::isnan(both.fit.deviations(1)));
    EXPECT_THAT(both.warnings,
                Contains("damping_s: it has no influence on the data, so it is left at its start, 0.004 s"));
    EXPECT_THAT(both.warnings, Not(Contains(HasSubstr("youngs_modulus_Pa"))));
    EXPECT_TRUE(values_at_bounds(both).empty());

    const report::Json json = results::calibrate_json(setup, both, facts);
    EXPECT_TRUE(json.at("parameters").at("damping_s").at("std").is_null());
    EXPECT_EQ(json.at("parameters").at("damping_s").at("reason"), "it has no influence on the data");
    EXPECT_FALSE(json.at("parameters").at("youngs_modulus_Pa").contains("reason"));
    EXPECT_THAT(report::html(results::calibration_report(setup, both, facts)),
                HasSubstr("Damping time is not determined: it has no influence on the data."));
}

/// Random starts keep it there, too.
TEST(CalibrateUndetermined, RandomStartsLeaveWhatHasNoInfluenceWhereItWasDeclared) {
    const test::Folder folder("hold");
    write_motion(folder, hold, 2.3e5);
    CalibrationSettings settings;
    settings.starts = 2;
    const Calibration found = calibrate(test::setup_in(folder), settings);
    ASSERT_EQ(found.starts.size(), 2u);
    EXPECT_NE(found.starts[1].start(0), 2.6e5);
    EXPECT_EQ(found.starts[1].values(1), 0.004);
    EXPECT_EQ(found.fit.values(1), 0.004);
}

/// Gravity has two angles, a tilt about an axis three: the modulus and the tilt are determined, of the axis's two
/// angles one combination.
TEST(CalibrateUndetermined, AnAxisIsTwoAnglesOfWhichTheDataSeeOneCombination) {
    const test::Folder folder("tilted");
    const std::string effect = "[[effect]]\nid = \"gravity_tilt\"\ntilt_deg = 6\naxis = [0, 2, 0]\n";
    write_motion(folder, test::swung_beam_toml() + effect, 2.3e5);
    folder.write("experiment.toml",
                 test::swung_beam_toml() + replaced(effect, "tilt_deg = 6", "tilt_deg = 3\ncalibrate = true"));
    const setup::Setup setup = test::setup_in(folder);
    const Calibration found = calibrate(setup);
    ASSERT_TRUE(found.fit.converged()) << found.fit.message;
    ASSERT_EQ(found.parameters.size(), 4u);
    EXPECT_EQ(found.parameters[2].parameter.name, "effect.gravity_tilt.axis.turn_1_rad");
    EXPECT_EQ(found.parameters[3].parameter.name, "effect.gravity_tilt.axis.turn_2_rad");
    EXPECT_NEAR(found.fit.values(1), 6.0, 5.0 * found.fit.deviations(1));
    EXPECT_TRUE(std::isfinite(found.fit.deviations(0)));
    EXPECT_LT(found.fit.deviations(1), 1.0);
    EXPECT_TRUE(std::isnan(found.fit.deviations(2)));
    EXPECT_TRUE(std::isnan(found.fit.deviations(3)));
    EXPECT_THAT(found.undetermined_reason(2),
                HasSubstr("the data determine only its combination with effect.gravity_tilt.axis.turn_2_rad"));
    const report::Json direction = results::calibrate_json(setup, found, facts)
                                       .at("parameters")
                                       .at("effect.gravity_tilt.axis.turn_2_rad")
                                       .at("direction");
    const Eigen::Vector3d axis(direction[0], direction[1], direction[2]);
    EXPECT_NEAR(axis.norm(), 1.0, 1e-12);
    EXPECT_GT(axis.y(), 0.99);
}

/// A tolerance of 0 is an exact value, in a calibration with and without other parameters.
TEST(CalibrateExact, AToleranceOfZeroHoldsTheModulus) {
    const test::Folder folder("exact");
    std::string toml = replaced(test::swung_beam_toml(), "youngs_modulus_Pa = 2.6e5",
                                "youngs_modulus_Pa = 2.6e5\nyoungs_modulus_tolerance = 0");
    toml = replaced(toml, "calibrate = [\"youngs_modulus\"]", "calibrate = [\"youngs_modulus\", \"damping\"]");
    write_motion(folder, toml, 2.6e5);
    const setup::Setup setup = test::setup_in(folder);
    EXPECT_THAT(setup.warnings,
                Contains("material.youngs_modulus_tolerance: 0 declares the modulus exact, so a fit does not move it"));
    const Calibration found = calibrate(setup);
    ASSERT_TRUE(found.fit.converged()) << found.fit.message;
    ASSERT_EQ(found.parameters.size(), 1u);
    EXPECT_EQ(found.parameters[0].parameter.name, "damping_s");
    EXPECT_NEAR(found.fit.values(0), 0.004, 5.0 * found.fit.deviations(0));
    EXPECT_EQ(found.after.values.youngs_modulus_Pa, 2.6e5);
    EXPECT_TRUE(prediction::free_parameters(setup, {"youngs_modulus"}).empty());
}

/// Limits of a registration are half-widths, too.
TEST(CalibrateExact, ALimitOfZeroHoldsTheRegistration) {
    const test::Folder folder("exact");
    std::string toml = test::swung_beam_toml();
    toml.insert(toml.find("[markers]"),
                "[registration]\nknown = false\nmax_translation_m = 0.001\nmax_rotation_deg = 0\n");
    write_motion(folder, toml, 2.6e5);
    const Calibration found = calibrate(test::setup_in(folder));
    ASSERT_TRUE(found.fit.converged()) << found.fit.message;
    EXPECT_EQ(found.parameters.size(), 4u);
}

TEST(ValuesAtBounds, NameTheValueAndTheBound) {
    const test::Folder folder("bound");
    write_motion(folder, test::swung_beam_toml(), 1.5e5);  // below the tolerance of 30 %
    const setup::Setup setup = test::setup_in(folder);
    const Calibration found = calibrate(setup);
    const std::vector<ValueAtBound> bounds = values_at_bounds(found);
    ASSERT_EQ(bounds.size(), 1u);
    EXPECT_EQ(bounds[0].parameter, 0u);
    EXPECT_FALSE(bounds[0].upper);
    EXPECT_NEAR(bounds[0].bound, 0.7 * 2.6e5, 1e-6);
    EXPECT_NEAR(bounds[0].value, bounds[0].bound, 1.0);
    EXPECT_THAT(found.warnings, Contains(HasSubstr("material.youngs_modulus_Pa: the fit ended at its lower bound, "
                                                   "182000 Pa, the edge of the declared tolerance of 30 %")));
    EXPECT_EQ(results::calibrate_json(setup, found, facts).at("parameters").at("youngs_modulus_Pa").at("at_bound"),
              "lower");
}

}  // namespace
}  // namespace myo::calibration
