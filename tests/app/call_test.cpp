#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/program.hpp"
#include "app/small_experiment.hpp"

namespace myo::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(Call, InfoNamesVersionLibrariesAndChoices) {
    const ProgramRun run = run_program({"info"});
    EXPECT_EQ(run.status, 0);
    for (const char* word : {"myoloop", "SuiteSparse", "VTK", "Ceres", "TetGen", "threads", "hex8", "tet10", "tr_bdf2",
                             "implicit_euler", "neo_hookean", "corotational"})
        EXPECT_THAT(run.out, HasSubstr(word));
    EXPECT_THAT(run.out, Not(HasSubstr("unknown")));
    EXPECT_EQ(run.err, "");
}

/// One compiler makes the program and its tests.
TEST(Call, InfoNamesTheCompilerOnce) {
    const std::string out = run_program({"info"}).out;
#ifdef __clang__
    EXPECT_THAT(out, HasSubstr("Clang"));
    EXPECT_THAT(out, Not(HasSubstr("GCC")));
#else
    EXPECT_THAT(out, HasSubstr("GCC " __VERSION__));
#endif
}

TEST(Call, VersionAndHelpSucceed) {
    EXPECT_THAT(run_program({"--version"}).out, HasSubstr("myoloop "));
    const ProgramRun help = run_program({"--help"});
    EXPECT_EQ(help.status, 0);
    for (const char* command :
         {"simulate", "calibrate", "diagnose", "validate", "mesh", "screenshot", "frames", "effects", "info"})
        EXPECT_THAT(help.out, HasSubstr(command));
    EXPECT_THAT(run_program({"simulate", "--help"}).out, HasSubstr("--resolution"));
}

TEST(Call, EffectsAreListedWithTheirParameters) {
    const ProgramRun run = run_program({"effects"});
    EXPECT_EQ(run.status, 0);
    EXPECT_THAT(run.out, HasSubstr("quadratic_drag"));
    EXPECT_THAT(run.out, HasSubstr("coefficient_kg_m3"));
}

TEST(Call, UnderstandsTheFormerNameOfACommandWithANote) {
    const ProgramRun run = run_program({"study"});
    EXPECT_EQ(run.status, 2);
    EXPECT_THAT(run.err, HasSubstr("note: 'study' is now called 'validate'"));
    EXPECT_THAT(run.err, HasSubstr("--out: name a folder"));
    EXPECT_THAT(run_program({"study", "--help"}).out, HasSubstr("--cases"));
}

struct BadCall {
    std::vector<std::string> arguments;
    std::vector<std::string> expected;  // in the message
};

class BadCalls : public ::testing::TestWithParam<BadCall> {};

TEST_P(BadCalls, AreTurnedDownInOneSentence) {
    const Folder folder("bad_call");
    write_small_experiment(folder);
    std::vector<std::string> arguments;
    for (const std::string& word : GetParam().arguments)
        arguments.push_back(word == "EXP"            ? folder.str("exp")
                            : word == "OUT"          ? folder.str("out")
                            : word == "EXP/drop.csv" ? folder.str("exp/drop.csv")
                                                     : word);
    const ProgramRun run = run_program(arguments);
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(count_lines(run.err), 1) << run.err;
    EXPECT_EQ(run.err.rfind("myoloop: ", 0), 0u) << run.err;
    for (const std::string& text : GetParam().expected) EXPECT_THAT(run.err, HasSubstr(text));
    EXPECT_FALSE(folder.has("out/simulate.json"));
}

INSTANTIATE_TEST_SUITE_P(
    All, BadCalls,
    ::testing::Values(
        BadCall{{"simulte"}, {"simulte", "did you mean 'simulate'"}},
        BadCall{{"anneal", "EXP", "--out", "OUT"}, {"anneal", "simulate, calibrate"}},
        BadCall{{"nowhere/beam.stl"}, {"nowhere/beam.stl", "not found"}}, BadCall{{"simulate"}, {"experiment folder"}},
        BadCall{{"simulate", "EXP"}, {"--out"}}, BadCall{{"simulate", "nowhere", "--out", "OUT"}, {"nowhere"}},
        BadCall{{"simulate", "EXP", "--out"}, {"--out"}},
        BadCall{{"simulate", "EXP", "EXP", "--out", "OUT"}, {"one argument too many"}},
        BadCall{{"simulate", "EXP", "--out", "OUT", "--resolutoin", "0.01"},
                {"--resolutoin", "did you mean '--resolution'"}},
        BadCall{{"simulate", "EXP", "--out", "OUT", "--dt", "fast"}, {"--dt", "fast"}},
        BadCall{{"simulate", "EXP", "--out", "OUT", "--dt", "0"}, {"--dt", "positive"}},
        BadCall{{"simulate", "EXP", "--out", "OUT", "--dt", "nan"}, {"--dt"}},
        BadCall{{"simulate", "EXP", "--out", "OUT", "--dt", "1e-12"}, {"--dt", "memory"}},
        BadCall{{"simulate", "EXP", "--out", "OUT", "--resolution", "-1"}, {"--resolution"}},
        BadCall{{"simulate", "EXP", "--out", "OUT", "--resolution", "1e-6"}, {"--resolution", "2 million"}},
        BadCall{{"simulate", "EXP", "--out", "OUT", "--element", "hex9"},
                {"--element", "did you mean 'hex8'", "tet10"}},
        BadCall{{"simulate", "EXP", "--out", "OUT", "--integrator", "euler"},
                {"--integrator", "implicit_euler", "tr_bdf2"}},
        BadCall{{"simulate", "EXP", "--out", "OUT", "--integrator", "generalized_alpha", "--spectral-radius", "1.5"},
                {"--spectral-radius", "0 ... 1"}},
        BadCall{{"simulate", "EXP", "--out", "OUT", "--spectral-radius", "half"},
                {"--spectral-radius", "not a number"}},
        BadCall{{"simulate", "EXP", "--out", "OUT", "--spectral-radius", "0.5"},
                {"--spectral-radius", "generalized_alpha"}},
        BadCall{{"simulate", "EXP", "--out", "OUT", "--strategy", "newtom"},
                {"--strategy", "did you mean 'newton'", "projective"}},
        BadCall{{"simulate", "EXP", "--out", "OUT", "--mass", "lumped"}, {"--mass", "consistent", "equal_vertices"}},
        BadCall{{"simulate", "EXP", "--out", "OUT", "--voxels", "trunctated"},
                {"--voxels", "did you mean 'truncated'"}},
        BadCall{{"validate"}, {"--out"}}, BadCall{{"validate", "--out", "EXP/drop.csv"}, {"drop.csv"}},
        BadCall{{"validate", "--out", "OUT", "--effects", "quadratic_drg"},
                {"--effects", "did you mean 'quadratic_drag'"}},
        BadCall{{"validate", "--out", "OUT", "--geometry", "beem"}, {"--geometry", "did you mean 'beam'"}},
        BadCall{{"validate", "--out", "OUT", "--geometry", "plate", "--effects", "actuation_lag"},
                {"--geometry", "muscles"}},
        BadCall{{"validate", "--defaults", "--out", "OUT", "--geometry", "beam"}, {"--defaults", "leave --geometry"}},
        BadCall{{"validate", "--out", "OUT", "--share", "5/4"}, {"--share", "5/4"}},
        BadCall{{"validate", "--out", "OUT", "--cases", "0"}, {"--cases"}},
        BadCall{{"bench", "realease"}, {"bench", "did you mean 'release'"}},
        BadCall{{"simulate", "EXP", "--out", "OUT", "--material", "neohookean"},
                {"--material", "did you mean 'neo_hookean'"}},
        BadCall{{"simulate", "EXP", "--out", "OUT", "--threads", "0"}, {"--threads"}},
        BadCall{{"simulate", "EXP", "--out", "OUT", "--seed", "x"}, {"--seed"}},
        BadCall{{"simulate", "EXP", "--out", "OUT", "--set", "material"}, {"--set", "key=value"}},
        BadCall{{"simulate", "EXP", "--out", "OUT", "--set", "material.youngs_modulus=1"},
                {"--set", "youngs_modulus_Pa"}},
        BadCall{{"simulate", "EXP", "--out", "OUT", "--velocity-force", "much"}, {"--velocity-force"}},
        BadCall{{"simulate", "EXP", "--out", "OUT", "--trial", "dorp"}, {"--trial", "did you mean 'drop'"}},
        BadCall{{"simulate", "EXP", "--out", "EXP/drop.csv"}, {"--out"}},
        BadCall{{"simulate", "EXP", "--out", "EXP"}, {"--out", "drop.csv is read as input"}},
        BadCall{{"simulate", "EXP", "--out", "/proc/results"}, {"--out"}},
        BadCall{{"calibrate", "EXP", "--out", "OUT", "--parameters", "youngs"}, {"--parameters", "youngs_modulus"}},
        BadCall{
            {"calibrate", "EXP", "--out", "OUT", "--set", "material.calibrate=[]", "--set", "material.damping_s=0.001"},
            {"--parameters"}},
        BadCall{{"mesh"}, {"name a surface"}}, BadCall{{"mesh", "EXP"}, {"extension"}},
        BadCall{{"screenshot", "EXP", "--out", "x.jpg"}, {"--out", ".png"}},
        BadCall{{"screenshot", "EXP", "--out", "x.png", "--size", "big"}, {"--size"}}));

TEST(Call, WithoutDisplayTheWindowSaysSo) {
    const ProgramRun run = run_program({});
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(count_lines(run.err), 1);
}

}  // namespace
}  // namespace myo::test
