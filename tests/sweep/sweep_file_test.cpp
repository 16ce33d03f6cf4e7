#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/small_experiment.hpp"
#include "app/sweep_texts.hpp"
#include "sweep/sweep_cases.hpp"

// Sweep files that cannot be run are refused in one sentence with file, line and key, before any case begins.

namespace myo::test {
namespace {

using ::testing::HasSubstr;

/// Takes any arguments.
Result<void> takes_all(const std::string&, const std::vector<std::string>&) { return {}; }

/// Cases of sweep.toml, or why there are none.
Result<sweep::PreparedSweep> prepared(const Folder& folder, const sweep::CheckArguments& check = takes_all) {
    const Result<sweep::Sweep> read = sweep::read_sweep(folder.path() / "sweep.toml");
    if (!read) return read.error();
    return sweep::prepare_sweep(*read, check, "0.1");
}

struct BadSweep {
    std::string text;
    std::vector<std::string> expected;  // in the message
};

class BadSweeps : public ::testing::TestWithParam<BadSweep> {};

TEST_P(BadSweeps, AreRefusedWithTheirPlace) {
    const Folder folder("bad_sweep");
    write_sweep(folder, GetParam().text);
    const Result<sweep::PreparedSweep> sweep = prepared(folder);
    ASSERT_FALSE(sweep);
    const std::string message = sweep.error().text();
    EXPECT_THAT(message, HasSubstr(folder.str("sweep.toml") + ":"));
    EXPECT_EQ(message.find('\n'), std::string::npos);
    for (const std::string& text : GetParam().expected) EXPECT_THAT(message, HasSubstr(text));
}

const std::string modulus_key = "material.youngs_modulus_Pa";
const std::string modulus_axis = "[[vary]]\nkey = \"" + modulus_key + "\"\n";

INSTANTIATE_TEST_SUITE_P(
    All, BadSweeps,
    ::testing::Values(
        BadSweep{"schema = \"sweep/2\"\n", {":1: schema", "sweep/1"}},
        BadSweep{sweep_head() + "axes = 1\n" + axis(modulus_key, "[1e4]"), {":5: axes: unknown key"}},
        BadSweep{sweep_head("fit") + axis(modulus_key, "[1e4]"), {":3: command", "simulate"}},
        BadSweep{sweep_head(), {"vary: is missing"}},
        BadSweep{
            "schema = \"sweep/1\"\nexperiment = \"nowhere\"\ncommand = \"simulate\"\n" + axis(modulus_key, "[1e4]"),
            {":2: experiment", "nowhere is not there"}},
        BadSweep{sweep_head() + axis(modulus_key, "[]"), {":7: vary[0].values: holds no value"}},
        BadSweep{sweep_head() + axis(modulus_key, "[1e4, nan]"), {":7: vary[0].values: value 1"}},
        BadSweep{sweep_head() + axis("--dt", "[[1, 2]]"), {":7: vary[0].values: value 0 is no number"}},
        BadSweep{sweep_head() + modulus_axis + "from = 1e4\nto = 2e4\n", {"vary[0].count: required key is missing"}},
        BadSweep{sweep_head() + modulus_axis + "from = 0.0\nto = 2e4\ncount = 3\nspacing = \"log\"\n",
                 {":7: vary[0].from: must be positive"}},
        BadSweep{sweep_head() + modulus_axis + "from = 1.0\nto = 2.0\ncount = 2.5\n", {":9: vary[0].count", "whole"}},
        BadSweep{sweep_head() + modulus_axis + "from = 1.0\nvalues = [1.0]\n",
                 {":7: vary[0].from: does not go with values"}},
        BadSweep{sweep_head() + modulus_axis +
                     "from = 1.0\nto = 2.0\ncount = 200\n[[vary]]\nkey = \"material.damping_s\"\n" +
                     "from = 1e-3\nto = 2e-3\ncount = 200\n",
                 {"vary: the grid has 4e+04 cases; the limit is 10000"}},
        BadSweep{sweep_head() + "[[vary]]\nvalues = [1.0]\n", {"vary[0].key: name either a key"}},
        BadSweep{sweep_head() + axis(modulus_key, "[1e4]") + axis(modulus_key, "[2e4]"),
                 {":9: vary[1].key", "varied twice"}},
        BadSweep{sweep_head() + axis("--out", "[\"x\"]"), {":6: vary[0].option: --out is set by the sweep itself"}},
        BadSweep{sweep_head() + axis(modulus_key, "[1e4, 2e4]") + "[[vary]]\nkey = \"material.damping_s\"\n" +
                     "values = [1e-3]\ntogether = true\n",
                 {":11: vary[1].together: 1 values cannot move with the 2 of " + modulus_key}},
        BadSweep{sweep_head() + "seeds = 3\n" + axis(modulus_key, "[1e4]"), {":5: seeds: simulate has nothing random"}},
        BadSweep{sweep_head("calibrate") + "seeds = [1.5]\n", {":5: seeds: must be whole numbers"}},
        // What the experiment or the command does not know.
        BadSweep{sweep_head() + axis("material.youngs_modulus", "[1e4]"),
                 {":5: case 1 (material.youngs_modulus = 10000): material.youngs_modulus: unknown key",
                  "youngs_modulus_Pa"}},
        BadSweep{sweep_head() + axis(modulus_key, "[1e4]") + axis("material.poissons_ratio", "[0.4, 0.7]"),
                 {":8: case 2 (", "material.poissons_ratio: must be"}},
        BadSweep{sweep_head() + axis("trial.dorp.role", "[\"fit\"]"),
                 {":5: trial.dorp.role: no trial is called \"dorp\"; the closest name is \"drop\""}},
        BadSweep{sweep_head() + axis("trial[7].role", "[\"fit\"]"), {":5: trial[7].role: trial has 2 elements"}}));

TEST(SweepFile, ArgumentsThatTheCommandRefusesAreAnErrorOfTheCase) {
    const Folder folder("refused_arguments");
    write_sweep(folder, sweep_head() + axis("--dt", "[0.001, 1e6]"));
    const auto no_long_step = [](const std::string& command, const std::vector<std::string>& words) -> Result<void> {
        EXPECT_EQ(command, "simulate");
        EXPECT_EQ(words.size(), 4u);
        // Options are given whole numbers as such.
        if (words.back() == "1000000") return Error{"--dt: too long", ""};
        return {};
    };
    const Result<sweep::PreparedSweep> sweep = prepared(folder, no_long_step);
    ASSERT_FALSE(sweep);
    EXPECT_THAT(sweep.error().text(), HasSubstr("sweep.toml:5: case 2 (--dt = 1000000): --dt: too long"));
}

TEST(SweepFile, AnExperimentThatIsWrongByItselfIsReportedWithItsOwnLine) {
    const Folder folder("wrong_base");
    write_sweep(folder, sweep_head() + axis(modulus_key, "[1e4]"));
    folder.write("exp/experiment.toml", small_toml() + "[[trial]]\nnam = \"x\"\n");
    const Result<sweep::PreparedSweep> sweep = prepared(folder);
    ASSERT_FALSE(sweep);
    EXPECT_THAT(sweep.error().text(), HasSubstr("exp/experiment.toml:31: trial[2].nam: unknown key"));
}

TEST(SweepFile, AxesMakeAGridWhoseLastChangesFastest) {
    const Folder folder("sweep_grid");
    write_sweep(folder, sweep_head("calibrate") + "seeds = 2\n" + modulus_axis +
                            "from = 1e4\nto = 4e4\ncount = 3\nspacing = \"log\"\n[[vary]]\n" +
                            "key = \"markers.rest_m.tip[2]\"\nfrom = 0.01\nto = 0.02\ncount = 3\ntogether = true\n" +
                            axis("--as-published", "[true, false]"));
    const Result<sweep::PreparedSweep> sweep = prepared(folder);
    ASSERT_TRUE(sweep) << sweep.error().text();
    ASSERT_EQ(sweep->cases.size(), 12u);
    const sweep::SweepCase& c = sweep->cases[6];
    EXPECT_EQ(c.number, 7);
    EXPECT_EQ(sweep::case_words(sweep->sweep, c),
              "material.youngs_modulus_Pa = 20000, markers.rest_m.tip[2] = 0.015, "
              "--as-published = false, --seed = 1");
    EXPECT_EQ(c.options, (std::vector<std::string>{"--resolution", "0.01", "--seed", "1"}));
    EXPECT_EQ(sweep->cases[4].options,
              (std::vector<std::string>{"--resolution", "0.01", "--as-published", "--seed", "1"}));
    EXPECT_THAT(c.text, HasSubstr("youngs_modulus_Pa = 20000.0\n"));
    EXPECT_THAT(c.text, HasSubstr("tip = [0.04, 0.01, 0.015]\n"));
}

TEST(SweepFile, FingerprintsTellCasesOptionsAndDataApart) {
    const Folder folder("fingerprints");
    write_sweep(folder, sweep_head() + axis(modulus_key, "[1e4, 2e4]"));
    const auto fingerprints = [&] {
        std::vector<std::uint64_t> list;
        const Result<sweep::PreparedSweep> sweep = prepared(folder);
        for (const sweep::SweepCase& c : sweep->cases) list.push_back(c.fingerprint);
        return list;
    };
    const std::vector<std::uint64_t> first = fingerprints();
    EXPECT_NE(first[0], first[1]);
    EXPECT_EQ(fingerprints(), first);
    // More values at the end of the first axis leave the cases before them as they are.
    folder.write("sweep.toml", sweep_head() + axis(modulus_key, "[1e4, 2e4, 3e4]"));
    EXPECT_EQ(fingerprints()[1], first[1]);
    folder.write("sweep.toml", sweep_head("calibrate") + axis(modulus_key, "[1e4, 2e4]"));
    EXPECT_NE(fingerprints()[1], first[1]);
    folder.write("sweep.toml", sweep_head() + axis(modulus_key, "[1e4, 2e4]"));
    EXPECT_EQ(fingerprints(), first);
    folder.write("exp/drop.csv", small_trace(0.05));
    EXPECT_NE(fingerprints()[1], first[1]);
}

}  // namespace
}  // namespace myo::test
