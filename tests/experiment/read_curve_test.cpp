#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/read_experiment.hpp"
#include "support/good_experiment.hpp"

// Curves over time: of a force, and of a chamber or tendon.

namespace myo::experiment {
namespace {

using testing::HasSubstr;
using testing_support::replaced;

/// A held block with a tendon, in one trial that is only simulated.
const std::string driven_toml = R"(schema = "experiment/1"
name = "driven"
[geometry]
kind = "box"
size_m = [0.1, 0.02, 0.02]
[clamp]
box_m = [[-1e-3, -1e-3, -1e-3], [1e-3, 0.021, 0.021]]
[material]
model = "neo_hookean"
youngs_modulus_Pa = 3e5
poissons_ratio = 0.49
density_kg_m3 = 1070
damping_s = 0.004
[[tendon]]
name = "pull"
path_m = [[0.0, 0.01, 0.02], [0.1, 0.01, 0.02]]
drive = "tension"
[markers]
[markers.probe_m]
tip = [0.1, 0.01, 0.01]
[[trial]]
name = "drive"
role = "simulate"
duration_s = 1.0
start = "straight"
tension_N = { pull = [[0.0, 0.0], [0.5, 2.0], [0.5, 1.0]] }
[[trial.load]]
kind = "force"
box_m = [[0.099, -0.001, -0.001], [0.101, 0.021, 0.021]]
force_N = [0.0, 0.0, -0.1]
curve = [[0.0, 0.0], [0.2, 1.0]]
)";

Result<Experiment> read(const std::string& toml) {
    const test::Folder folder("driven");
    folder.write("experiment.toml", toml);
    return read_experiment(folder.path());
}

TEST(Curves, AreRead) {
    const Result<Experiment> experiment = read(driven_toml);
    ASSERT_TRUE(experiment) << experiment.error().text();
    const TrialDeclaration& trial = experiment->trials[0];
    EXPECT_EQ(*trial.loads[0].curve, (fibre::Signal{{0.0, 0.2}, {0.0, 1.0}}));
    ASSERT_EQ(trial.constant_commands.size(), 1u);
    EXPECT_EQ(*trial.constant_commands[0].curve, (fibre::Signal{{0.0, 0.5, 0.5}, {0.0, 2.0, 1.0}}));
}

TEST(Curves, RefuseWhatIsNoCurve) {
    const auto error = [](const std::string& from, const std::string& to) {
        const Result<Experiment> result = read(replaced(driven_toml, from, to));
        EXPECT_FALSE(result) << to;
        return result ? std::string() : result.error().text();
    };
    const std::string curve = "curve = [[0.0, 0.0], [0.2, 1.0]]";
    EXPECT_THAT(error(curve, "curve = [[0.0, 1.0]]"), HasSubstr("at least two rows"));
    EXPECT_THAT(error(curve, "curve = [[0.2, 1.0], [0.0, 1.0]]"), HasSubstr("must ascend"));
    EXPECT_THAT(error(curve, "curve = [[0, 1], [0, 2], [0, 3]]"), HasSubstr("three times"));
    EXPECT_THAT(error(curve, curve + "\nfrom_s = 0.0"), HasSubstr("cannot be combined with curve"));
    EXPECT_THAT(error("[0.5, 1.0]]", "[0.5, -1.0]]"), HasSubstr("never pushes"));
    EXPECT_THAT(error("kind = \"force\"", "kind = \"mass\"\nmass_kg = 0.1"), HasSubstr("belongs to kind"));
}

}  // namespace
}  // namespace myo::experiment
