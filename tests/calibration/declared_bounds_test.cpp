#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "calibration/calibrate.hpp"
#include "check/catalogue.hpp"
#include "check/checks.hpp"
#include "dynamics/simulate.hpp"
#include "experiment/read_experiment.hpp"
#include "support/recorded_motion.hpp"
#include "support/swung_beam.hpp"

// [[unknown]]: bounds and tolerances of fitted values.

namespace myo::calibration {
namespace {

using testing::HasSubstr;

/// The swung beam with further tables, recorded from a body of 300 kPa and 5 ms. Both values are to be found.
setup::Setup recorded(const test::Folder& folder, const std::string& unknowns) {
    test::swung_beam(folder, 0.3);
    std::string text = test::swung_beam_toml();
    text.replace(text.find("[\"youngs_modulus\"]"), 18, "[\"youngs_modulus\", \"damping\"]");
    folder.write("experiment.toml", text + unknowns);
    setup::Setup setup = test::setup_in(folder);
    prediction::ParameterValues made = prediction::declared_values(setup);
    made.youngs_modulus_Pa = 3.0e5;
    made.damping_s = 0.005;
    for (const std::size_t trial : {0u, 1u})
        test::record(setup, trial, made,
                     dynamics::simulate(prediction::trial_model(setup, trial, made), setup.trials[trial].options));
    return setup;
}

TEST(DeclaredBounds, AFitStopsAtThemAndTheCheckSaysSo) {
    const test::Folder folder("declared_bounds");
    const setup::Setup setup = recorded(folder, R"(
[[unknown]]
name = "youngs_modulus_Pa"
lowest = 2.0e5
highest = 2.8e5
[[unknown]]
name = "damping_s"
tolerance = 0.0005
)");
    const Calibration calibration = calibrate(setup);
    EXPECT_NEAR(calibration.after.values.youngs_modulus_Pa, 2.8e5, 1.0);
    EXPECT_LE(calibration.after.values.damping_s, 0.0045 + 1e-9);
    EXPECT_GE(calibration.after.values.damping_s, 0.0035 - 1e-9);
    const std::vector<check::Finding> found = check::check_bounds({setup, nullptr, &calibration});
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found.front().level, check::CheckLevel::doubtful);
    EXPECT_THAT(found.front().sentence, HasSubstr("youngs_modulus_Pa: the fit ended at its upper bound, 280000 Pa"));
    EXPECT_THAT(found.front().sentence, HasSubstr("[[unknown]]"));
}

TEST(DeclaredBounds, ThatAreNotReachedChangeNothing) {
    const test::Folder free("declared_bounds_free"), wide("declared_bounds_wide");
    const Calibration without = calibrate(recorded(free, ""));
    const Calibration with = calibrate(recorded(wide, R"(
[[unknown]]
name = "youngs_modulus_Pa"
lowest = 1.0e5
highest = 6.0e5
[[unknown]]
name = "damping_s"
lowest = 1e-4
)"));
    ASSERT_TRUE(with.fit.converged()) << with.fit.message;
    EXPECT_NEAR(with.after.values.youngs_modulus_Pa / 3.0e5, 1.0, 0.01);
    EXPECT_NEAR(with.after.values.youngs_modulus_Pa / without.after.values.youngs_modulus_Pa, 1.0, 1e-9);
    EXPECT_NEAR(with.after.values.damping_s / without.after.values.damping_s, 1.0, 1e-9);
}

/// A damping time of 5 s and more is none that a model may have: the usual bounds hold, and the check says so.
TEST(DeclaredBounds, ThatCannotHoldAreTold) {
    const test::Folder folder("declared_bounds_unmet");
    const setup::Setup setup = recorded(folder, "[[unknown]]\nname = \"damping_s\"\nlowest = 5.0\n");
    const Calibration calibration = calibrate(setup);
    EXPECT_NEAR(calibration.after.values.damping_s, 0.005, 0.0005);
    const std::vector<check::Finding> found = check::check_bounds({setup, nullptr, &calibration});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found.front().level, check::CheckLevel::doubtful);
    EXPECT_THAT(found.front().sentence, HasSubstr("damping_s: its bounds in [[unknown]] leave nothing"));
}

TEST(DeclaredBounds, RefusesWhatBoundsNothing) {
    const auto error = [](const std::string& table) {
        const test::Folder folder("declared_bounds_bad");
        folder.write("experiment.toml", test::swung_beam_toml() + "[[unknown]]\n" + table);
        folder.write("swing.csv", "-");
        const Result<experiment::Experiment> read = experiment::read_experiment(folder.path());
        EXPECT_FALSE(read);
        return read ? std::string() : read.error().text();
    };
    EXPECT_THAT(error("name = \"stiffness\"\nlowest = 1.0\n"), HasSubstr("no fit finds a value \"stiffness\""));
    EXPECT_THAT(error("name = \"damping_s\"\nlowest = 2.0\nhighest = 1.0\n"), HasSubstr("is not below highest"));
    EXPECT_THAT(error("name = \"damping_s\"\nlowest = 0.1\ntolerance = 1.0\n"), HasSubstr("cannot be combined"));
    EXPECT_THAT(error("name = \"youngs_modulus_Pa\"\nlowest = -1.0\n"), HasSubstr("must be positive"));
    EXPECT_THAT(error("name = \"youngs_modulus_Pa\"\ntolerance = 3.0e6\n"), HasSubstr("must be below the modulus"));
}

/// Each number that a fit moves has a name, and no other name bounds it.
TEST(DeclaredBounds, OfAnEffectNameOneOfItsNumbers) {
    const test::Folder folder("declared_bounds_effect");
    test::swung_beam(folder, 0.1);
    const auto read = [&](const std::string& name) {
        folder.write("experiment.toml", test::swung_beam_toml() + "[[unknown]]\nname = \"" + name +
                                            "\"\nhighest = 1.0\n[[effect]]\nid = \"point_mass\"\nmass_kg = 0.01\n"
                                            "position_m = [0.1, 0.015, 0.03]\ncalibrate = true\n");
        return experiment::read_experiment(folder.path());
    };
    for (const char* name : {"effect.point_mass.mass_kg", "effect.point_mass.position_m.z"}) {
        const Result<experiment::Experiment> good = read(name);
        EXPECT_TRUE(good) << good.error().text();
    }
    for (const std::string name : {"effect.point_mass.mass_kg_typo", "effect.point_mass.position_m",
                                   "effect.point_mass.position_m.w", "effect.point_mass.mass"}) {
        const Result<experiment::Experiment> bad = read(name);
        ASSERT_FALSE(bad) << name;
        EXPECT_THAT(bad.error().what, HasSubstr("unknown[0].name: no fit finds a value \"" + name + "\""));
    }
}

}  // namespace
}  // namespace myo::calibration
