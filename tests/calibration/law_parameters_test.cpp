#include <gtest/gtest.h>

#include <cmath>

#include "calibration/calibrate.hpp"
#include "dynamics/simulate.hpp"
#include "support/recorded_motion.hpp"
#include "support/setup_of_folder.hpp"

namespace myo::calibration {
namespace {

/// A short soft cantilever that a weight at its end bends by a fifth of its length.
std::string soft_beam(const std::string& material) {
    return R"(schema = "experiment/1"
name = "soft"
[geometry]
kind = "box"
size_m = [0.08, 0.02, 0.02]
origin_m = [0.0, 0.0, 0.0]
[clamp]
box_m = [[-1e-4, -1e-3, -1e-3], [1e-4, 0.021, 0.021]]
[material]
youngs_modulus_Pa = 1e5
poissons_ratio = 0.49
density_kg_m3 = 1070
damping_s = 0.003
)" + material +
           R"(
[markers]
noise_m = 1e-5
[markers.rest_m]
tip = [0.08, 0.01, 0.02]
middle = [0.04, 0.01, 0.02]
[[trial]]
name = "release"
role = "fit"
trace = "release.csv"
format = "csv"
start = "straight"
start_s = 0.0
[[trial.load]]
kind = "mass"
box_m = [[0.0799, -0.001, -0.001], [0.0801, 0.021, 0.021]]
mass_kg = 0.06
)";
}

/// The law's parameter and the modulus are found from a motion that was made with others.
void expect_found(const std::string& key, const std::string& law, double declared, double truth) {
    const test::Folder folder("law_" + key);
    folder.write("experiment.toml", soft_beam("model = \"" + law + "\"\n" + key + " = " + std::to_string(declared) +
                                              "\ncalibrate = [\"youngs_modulus\", \"" + key + "\"]"));
    std::string trace = "time_s,tip_x_m,tip_y_m,tip_z_m,middle_x_m,middle_y_m,middle_z_m\n";
    for (int k = 0; k < 40; ++k) trace += std::to_string(0.01 * k) + ",0.08,0.01,0.02,0.04,0.01,0.02\n";
    folder.write("release.csv", trace);
    setup::SetupSettings settings;
    settings.mesh.resolution_m = 0.01;
    settings.h_s = 0.005;
    settings.threads = 2;
    setup::Setup setup = test::setup_of_folder(folder, settings);
    prediction::ParameterValues made = prediction::declared_values(setup);
    ASSERT_EQ(made.law, std::vector<double>{declared});
    made.law = {truth};
    made.youngs_modulus_Pa = 1.1e5;
    test::record(setup, 0, made, dynamics::simulate(prediction::trial_model(setup, 0, made), setup.trials[0].options));
    const Calibration calibration = calibrate(setup);
    ASSERT_TRUE(calibration.fit.converged()) << calibration.fit.message;
    ASSERT_EQ(calibration.parameters.size(), 2u);
    EXPECT_EQ(calibration.parameters[1].parameter.name, key);
    const double deviation = calibration.fit.deviations(1);
    EXPECT_GT(deviation, 0.0);
    EXPECT_LT(deviation, 0.1 * truth) << "the motion says little of " << key;
    EXPECT_NEAR(calibration.after.values.law[0], truth, 4.0 * deviation);
    EXPECT_NEAR(calibration.after.values.youngs_modulus_Pa, 1.1e5, 4.0 * calibration.fit.deviations(0));
    EXPECT_LT(calibration.after.fit_rms_m, 1.2e-5);
}

TEST(LawParameters, OfGentIsFitted) { expect_found("gent_limit", "gent", 3.0, 1.0); }

TEST(LawParameters, OfMooneyAndRivlinIsFitted) { expect_found("mooney_rivlin_share", "mooney_rivlin", 0.2, 0.5); }

}  // namespace
}  // namespace myo::calibration
