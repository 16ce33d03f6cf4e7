#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "app/program.hpp"
#include "app/small_experiment.hpp"

// Recordings in another unit than they state are refused with exit status 2, and nothing is written.

namespace myo::test {
namespace {

using ::testing::HasSubstr;

/// The small block swings at 10 Hz, seen at 100 Hz, with so many units per second and per metre.
std::string swing_in_units(double per_second, double per_metre) {
    std::string text = "time_s,tip_x_m,tip_y_m,tip_z_m,middle_x_m,middle_y_m,middle_z_m\n";
    char line[256];
    for (int k = 0; k < 60; ++k) {
        const double drop_m = 1e-3 * (1.0 - std::cos(0.63 * k));
        std::snprintf(line, sizeof line, "%g,%.6f,%.6f,%.6f,%.6f,%.6f,%.6f\n", 0.01 * k * per_second, 0.04 * per_metre,
                      0.01 * per_metre, (0.02 - drop_m) * per_metre, 0.02 * per_metre, 0.01 * per_metre,
                      (0.02 - 0.35 * drop_m) * per_metre);
        text += line;
    }
    return text;
}

ProgramRun simulated(const Folder& folder, double per_second, double per_metre, const std::string& set = {}) {
    folder.write("exp/experiment.toml", small_toml());
    folder.write("exp/drop.csv", swing_in_units(per_second, per_metre));
    std::vector<std::string> words{
        "simulate", folder.str("exp"), "--out", folder.str("out"), "--resolution", "0.01", "--dt", "0.01"};
    if (!set.empty()) words.insert(words.end(), {"--set", "trial.drop." + set, "--set", "trial[1]." + set});
    return run_program(words);
}

TEST(WrongUnit, OfTimesIsRefusedAndTheKeyHelps) {
    const Folder folder("wrong_time_unit");
    const ProgramRun refused = simulated(folder, 1000.0, 1.0);
    EXPECT_EQ(refused.status, 2) << refused.err;
    EXPECT_THAT(refused.err, HasSubstr("trial[0].time_unit: "));
    EXPECT_THAT(refused.err, HasSubstr("time_unit = \"ms\", or \"s\" if they are seconds"));
    EXPECT_FALSE(folder.has("out/simulate.json"));
    const ProgramRun declared = simulated(folder, 1000.0, 1.0, "time_unit=\"ms\"");
    EXPECT_EQ(declared.status, 0) << declared.err;
}

TEST(WrongUnit, OfLengthIsRefused) {
    const Folder folder("wrong_length_unit");
    const ProgramRun refused = simulated(folder, 1.0, 1000.0);
    EXPECT_EQ(refused.status, 2) << refused.err;
    EXPECT_EQ(count_lines(refused.err), 1) << refused.err;
    EXPECT_THAT(refused.err, HasSubstr("drop.csv has its markers 1000 times as far apart as declared"));
    EXPECT_THAT(refused.err, HasSubstr("look like mm instead of m"));
    EXPECT_FALSE(folder.has("out/simulate.json"));
}

}  // namespace
}  // namespace myo::test
