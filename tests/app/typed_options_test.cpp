#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/program.hpp"
#include "app/small_experiment.hpp"

// Words of the command line as people type them: which are refused, with which sentence, and which are understood.

namespace myo::app::typed_options_test {
namespace {

using test::box_stl;
using test::count_lines;
using test::Folder;
using test::ProgramRun;
using test::run_program;
using test::write_small_experiment;
using ::testing::HasSubstr;
using ::testing::Not;

struct Typed {
    std::vector<std::string> words;  // EXP and OUT stand for folders, BOX for a surface
    std::string sentence;            // of the refusal, from its beginning
};

/// A folder with the small experiment and a surface, in which no call leaves anything.
class TypedFolder {
public:
    TypedFolder() : folder_("typed_options") {
        write_small_experiment(folder_);
        folder_.write("box.stl", box_stl(40.0, 20.0, 10.0));
    }
    ProgramRun run(const std::vector<std::string>& words) const {
        const std::map<std::string, std::string> places{
            {"EXP", folder_.str("exp")}, {"OUT", folder_.str("out")}, {"BOX", folder_.str("box.stl")}};
        std::vector<std::string> call;
        for (const std::string& word : words) call.push_back(places.contains(word) ? places.at(word) : word);
        return run_program(call);
    }
    bool has(const std::string& file) const { return folder_.has(file); }

private:
    Folder folder_;
};

void expect_refusals(const std::vector<Typed>& all) {
    const TypedFolder folder;
    for (const Typed& typed : all) {
        const ProgramRun run = folder.run(typed.words);
        EXPECT_EQ(run.status, 2) << typed.sentence;
        EXPECT_EQ(run.err.rfind("myoloop: " + typed.sentence, 0), 0u) << run.err;
        EXPECT_EQ(count_lines(run.err), 1) << run.err;
        EXPECT_EQ(run.out, "") << typed.sentence;
    }
    EXPECT_FALSE(folder.has("out"));
}

std::vector<std::string> simulate(const std::vector<std::string>& more) {
    std::vector<std::string> words{"simulate", "EXP", "--out", "OUT"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

TEST(TypedOptions, NumbersAreWholeWordsAndFinite) {
    expect_refusals({{simulate({"--dt", "1e-3s"}), "--dt: '1e-3s' is not a number"},
                     {simulate({"--dt", "inf"}), "--dt: 'inf' is not a number"},
                     {simulate({"--dt", "0,001"}), "--dt: '0,001' is not a number"},
                     {simulate({"--dt", ""}), "--dt"},
                     {simulate({"--dt=1e999"}), "--dt: '1e999' is not a number"},
                     {simulate({"--resolution", "0"}), "--resolution: '0' is not positive"},
                     {{"diagnose", "EXP", "--out", "OUT", "--time-limit", "0"}, "--time-limit: '0' is not positive"},
                     {simulate({"--resolution=-0.01"}), "--resolution: '-0.01' is not positive"}});
}

TEST(TypedOptions, CountsAndSeedsAreWhole) {
    expect_refusals(
        {{simulate({"--threads", "2.0"}), "--threads: '2.0' is not a whole number from 1 on"},
         {simulate({"--threads=-1"}), "--threads: '-1' is not a whole number from 1 on"},
         {simulate({"--threads", "99999999999"}), "--threads: '99999999999' is not a whole number from 1 on"},
         {simulate({"--seed", "1e3"}), "--seed: '1e3' is not a whole number from 0 on"},
         {simulate({"--seed=-1"}), "--seed: '-1' is not a whole number from 0 on"},
         {simulate({"--seed", "18446744073709551616"}), "--seed: '18446744073709551616' is not a whole number"}});
}

TEST(TypedOptions, WordsOfAListAreNamedWithTheirNeighbours) {
    expect_refusals({{simulate({"--element", "HEX8"}), "--element: 'HEX8' is not known"},
                     {simulate({"--set", "=3"}), "--set: '=3' is not of the form key=value"},
                     {simulate({"--resolutoin=0.01"}),
                      "unknown option '--resolutoin' is not known; did you mean "
                      "'--resolution'? Known: "},
                     {{"mesh", "BOX", "--unit", "cm"}, "--unit: 'cm' is not known; did you mean 'm'? Known: m, mm"},
                     {{"validate", "--out", "OUT", "--effects", "quadratic_drag,,linear_drag"},
                      "--effects: '' is not known; known: "},
                     {{"validate", "--out", "OUT", "--effects", "gravity_tilt, linear_drga"},
                      "--effects: 'linear_drga' is not known; did you mean 'linear_drag'? Known: "}});
}

TEST(TypedOptions, SharesAreTheFirstToTheLastOfSome) {
    std::vector<Typed> all;
    for (const char* share : {"0/4", "5/4", "1/0", "1", "/", "1/4/2", "a/b", "1/ 4", "-1/4", "1.0/4", "1/99999999999"})
        all.push_back({{"validate", "--out", "OUT", std::string("--share=") + share},
                       "--share: '" + std::string(share) + "' is not a share like 1/4, the first of four"});
    expect_refusals(all);
}

TEST(TypedOptions, CommandsStandFirstAndAlone) {
    expect_refusals({{{"info", "EXTRA"}, "'EXTRA' is one argument too many"},
                     {{"effects", "--lsit"}, "unknown option '--lsit' is not known"},
                     {{"EXP", "info"}, ""},
                     {{"sweep"}, "name a sweep file"},
                     {{"sweep", "nowhere.toml"}, "--out: name a folder for the results"},
                     {{"sweep", "nowhere.toml", "--out", "OUT"}, "nowhere.toml: file not found"}});
    const TypedFolder folder;
    EXPECT_THAT(folder.run({"EXP", "info"}).err, HasSubstr("' stands before the command info"));
}

TEST(TypedOptions, OptionsThatBelongToOthersAreRefused) {
    expect_refusals(
        {{simulate({"--starts", "2"}), "unknown option '--starts' is not known"},
         {{"mesh", "BOX", "--unit", "mm", "--dt", "1"}, "unknown option '--dt' is not known"},
         {{"calibrate", "EXP", "--out", "OUT", "--starts", "0"}, "--starts: '0' is not a whole number from 1 on"},
         {{"calibrate", "EXP", "--out", "OUT", "--parameters", "youngs_modulus,dampin"},
          "--parameters: 'dampin' is not known; did you mean 'damping'? Known: "}});
}

/// A sign, an exponent and a value behind "=" are read as what they are.
TEST(TypedOptions, WhatIsUnderstoodIsShown) {
    const TypedFolder folder;
    const ProgramRun run = folder.run(simulate({"--dt", "+5e-3", "--integrator=implicit_euler", "--resolution", "1e-2",
                                                "--seed", "0", "--threads=1", "--set", "material.density_kg_m3=900"}));
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("implicit_euler, 1 thread\n"));
    EXPECT_THAT(run.out, HasSubstr("density 900 kg/m3"));
    EXPECT_THAT(run.out, HasSubstr("16 hex8 elements of 10 mm"));
}

/// --quiet leaves errors only; the bar of progress is for terminals.
TEST(TypedOptions, QuietRunsSayNothing) {
    const TypedFolder folder;
    std::vector<std::string> words = simulate({"--resolution", "0.01", "--dt", "0.005"});
    const ProgramRun loud = folder.run(words);
    EXPECT_NE(loud.out, "");
    EXPECT_THAT(loud.err, Not(HasSubstr("\r")));
    EXPECT_THAT(loud.err, Not(HasSubstr("\"event\"")));
    words.push_back("--quiet");
    const ProgramRun quiet = folder.run(words);
    EXPECT_EQ(quiet.status, 0);
    EXPECT_EQ(quiet.out + quiet.err, "");
    EXPECT_TRUE(folder.has("out/simulate.json"));
}

TEST(TypedOptions, AUnitScalesTheMesh) {
    const TypedFolder folder;
    const auto mesh_in = [&](const char* unit, const char* resolution) {
        return folder.run({"mesh", "BOX", "--unit", unit, "--type", "hex8", "--resolution", resolution, "--json"});
    };
    const ProgramRun millimetres = mesh_in("mm", "0.01");
    ASSERT_EQ(millimetres.status, 0) << millimetres.err;
    const nlohmann::json json = nlohmann::json::parse(millimetres.out);
    EXPECT_EQ(json.at("element"), "hex8");
    EXPECT_EQ(json.at("elements"), 8);
    EXPECT_EQ(json.at("dofs"), 3 * 5 * 3 * 2);
    EXPECT_NEAR(json.at("volume_m3").get<double>(), 8e-6, 1e-15);
    // 40 x 20 x 10 m is no size of a robot.
    EXPECT_EQ(mesh_in("m", "10").status, 2);
}

}  // namespace
}  // namespace myo::app::typed_options_test
