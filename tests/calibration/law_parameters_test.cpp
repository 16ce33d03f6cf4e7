#include <gtest/gtest.h>

#include <cmath>

#include "calibration/calibrate.hpp"
#include "dynamics/simulate.hpp"
#include "support/recorded_motion.hpp"
#include "support/swung_beam.hpp"

namespace myo::calibration {
namespace {

/// The law's parameter and the modulus are found from a motion that was made with others. The beam is so soft that it
/// swings through a large part of its length.
void expect_found(const std::string& key, const std::string& law, double declared, double truth) {
    const test::Folder folder("law_" + key);
    test::swung_beam(folder, 0.4);
    std::string text = test::swung_beam_toml();
    const auto replace = [&](const std::string& from, const std::string& to) {
        text.replace(text.find(from), from.size(), to);
    };
    replace("\"neo_hookean\"", "\"" + law + "\"\n" + key + " = " + std::to_string(declared));
    replace("2.6e5", "5e4");
    replace("[\"youngs_modulus\"]", "[\"youngs_modulus\", \"" + key + "\"]");
    replace("noise_m = 1e-4", "noise_m = 1e-5");
    folder.write("experiment.toml", text);
    setup::Setup setup = test::setup_in(folder);
    prediction::ParameterValues made = prediction::declared_values(setup);
    ASSERT_EQ(made.law, std::vector<double>{declared});
    made.law = {truth};
    made.youngs_modulus_Pa = 5.5e4;
    for (const std::size_t trial : {0u, 1u})
        test::record(setup, trial, made,
                     dynamics::simulate(prediction::trial_model(setup, trial, made), setup.trials[trial].options));
    const Calibration calibration = calibrate(setup);
    ASSERT_TRUE(calibration.fit.converged()) << calibration.fit.message;
    ASSERT_EQ(calibration.parameters.size(), 2u);
    EXPECT_EQ(calibration.parameters[1].parameter.name, key);
    const double deviation = calibration.fit.deviations(1);
    EXPECT_GT(deviation, 0.0);
    EXPECT_LT(deviation, 0.1 * truth) << "the motion says little of " << key;
    EXPECT_NEAR(calibration.after.values.law[0], truth, 4.0 * deviation);
    EXPECT_NEAR(calibration.after.values.youngs_modulus_Pa, 5.5e4, 4.0 * calibration.fit.deviations(0));
    EXPECT_LT(calibration.after.fit_rms_m, 1.2e-5);
}

TEST(LawParameters, OfGentIsFitted) { expect_found("gent_limit", "gent", 3.0, 1.0); }

TEST(LawParameters, OfMooneyAndRivlinIsFitted) { expect_found("mooney_rivlin_share", "mooney_rivlin", 0.2, 0.5); }

}  // namespace
}  // namespace myo::calibration
