#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "support/swung_beam.hpp"

namespace myo::setup {
namespace {

using testing::HasSubstr;

/// A beam whose trace has four markers that move by up to 5 mm, with so many decimals and so much added to all times
/// and to the tip's height.
setup::Setup setup_of(int decimals, double clock_s, double tip_off_m,
                      const std::string& declared = test::swung_beam_toml()) {
    const test::Folder folder("study_warnings");
    folder.write("experiment.toml", declared);
    std::string text = "time_s";
    for (const char* name : {"tip_left", "tip_right", "tip_low", "middle"})
        for (const char axis : {'x', 'y', 'z'}) text += std::string(",") + name + "_" + axis + "_m";
    const double rest[4][3] = {{0.1, 0.0, 0.03}, {0.1, 0.03, 0.03}, {0.1, 0.015, 0.0}, {0.05, 0.015, 0.03}};
    for (int k = 0; k < 60; ++k) {
        const double drop = k < 10 ? 0.0 : 0.0025 * (1.0 - std::cos(0.2 * (k - 10)));
        char number[32];
        std::snprintf(number, sizeof number, "\n%.2f", clock_s + 0.01 * k);
        text += number;
        for (int m = 0; m < 4; ++m)
            for (int axis = 0; axis < 3; ++axis) {
                std::snprintf(number, sizeof number, ",%.*f", decimals,
                              rest[m][axis] + (axis == 2 ? -drop * rest[m][0] / 0.1 + (m == 0 ? tip_off_m : 0.0)
                                                         : 0.0003 * std::sin(0.7 * k + m)));
                text += number;
            }
    }
    folder.write("swing.csv", text + "\n");
    setup::Setup setup = test::setup_in(folder);
    // The coarse mesh, for speed, and the one trace of both trials are told of as well, in tests Suitability and
    // SharedRecordings.
    for (const char* other : {"torsion", "tests nothing"})
        std::erase_if(setup.warnings,
                      [&](const std::string& warning) { return warning.find(other) != std::string::npos; });
    return setup;
}

std::vector<std::string> said_of(int decimals, double clock_s, double tip_off_m,
                                 const std::string& declared = test::swung_beam_toml()) {
    return setup_of(decimals, clock_s, tip_off_m, declared).warnings;
}

std::string declared_with(const std::string& before_markers, bool noise = true) {
    std::string text = test::swung_beam_toml();
    if (!noise) text.erase(text.find("noise_m = 1e-4\n"), std::string("noise_m = 1e-4\n").size());
    return text.insert(text.find("[markers]"), before_markers);
}

TEST(SetupWarnings, SayNothingOfAGoodTrace) { EXPECT_TRUE(said_of(6, 0.0, 0.0).empty()); }

TEST(SetupWarnings, TellOfATraceThatIsCoarserThanItsNoise) {
    const std::vector<std::string> said = said_of(3, 0.0, 0.0);
    ASSERT_EQ(said.size(), 1u);
    EXPECT_THAT(
        said[0],
        HasSubstr(
            "rounded to 1 mm, which is noise of 0.289 mm by itself; it is taken in place of the 0.1 mm declared"));
}

TEST(SetupWarnings, TellOfAClockThatBeganElsewhere) {
    const std::vector<std::string> said = said_of(6, 5.0, 0.0);
    ASSERT_EQ(said.size(), 2u);  // for each trial
    EXPECT_THAT(said[0], HasSubstr("trial swing: its trace begins 5 s after the start"));
}

/// Times that nobody would simulate up to are those of another clock; so are times that all lie before the start.
TEST(SetupWarnings, RefuseATraceOfAnotherClock) {
    const test::Folder folder("study_warnings");
    test::swung_beam(folder, 0.1);
    for (const char* rows : {"1000.00", "1700000000.00", "-5.00"}) {
        const double first = std::stod(rows);
        std::string text = "time_s";
        for (const char* name : {"tip_left", "tip_right", "tip_low", "middle"})
            for (const char axis : {'x', 'y', 'z'}) text += std::string(",") + name + "_" + axis + "_m";
        for (int k = 0; k < 60; ++k) {
            char number[128];
            std::snprintf(number, sizeof number, "\n%.2f,0.1,0,0.03,0.1,0.03,0.03,0.1,0.015,0,0.05,0.015,0.03",
                          first + 0.01 * k);
            text += number;
        }
        folder.write("swing.csv", text + "\n");
        SetupSettings settings;
        settings.mesh.resolution_m = 0.015;
        const Result<setup::Setup> setup = prepare_setup(*experiment::read_experiment(folder.path()), settings);
        ASSERT_FALSE(setup) << rows;
        EXPECT_THAT(setup.error().what, testing::StartsWith("trial[0].start_s: swing.csv runs from " +
                                                            std::to_string(std::lround(first)) + " s to "));
        EXPECT_THAT(setup.error().what, HasSubstr("state start_s, the time in the file at which the trial starts"));
        EXPECT_THAT(setup.error().where, HasSubstr("experiment.toml:"));
    }
}

TEST(SetupWarnings, TellOfMarkersThatAreNotWhereTheyWereDeclared) {
    const std::string rest_pose = declared_with("[registration]\nknown = false\nmethod = \"rest_pose\"\n");
    EXPECT_TRUE(said_of(6, 0.0, 0.0, rest_pose).empty());
    const std::vector<std::string> said = said_of(6, 0.0, 0.02, rest_pose);
    ASSERT_EQ(said.size(), 2u);
    EXPECT_THAT(said[0], HasSubstr("mm rms from their declared rest positions"));
}

/// Not declared, it is found in the trace, at least what rounding makes, and nothing needs to be said.
TEST(SetupNoise, IsEstimatedWhereItIsNotDeclared) {
    const setup::Setup fine = setup_of(6, 0.0, 0.0, declared_with("", false)),
                       coarse = setup_of(3, 0.0, 0.0, declared_with("", false));
    ASSERT_EQ(fine.noise_m.size(), 4);
    EXPECT_GT(fine.noise_m.minCoeff(), 0.0);
    EXPECT_LT(fine.noise_m.maxCoeff(), 5e-4);
    EXPECT_GE(coarse.noise_m.minCoeff(), 1e-3 / std::sqrt(12.0));
    EXPECT_TRUE(coarse.warnings.empty());
}

}  // namespace
}  // namespace myo::setup
