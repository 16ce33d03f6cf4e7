#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/program.hpp"
#include "app/small_experiment.hpp"
#include "support/corpus.hpp"

// What commands on an experiment tell beside their results.

namespace myo::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

/// The small block on coarse cells.
struct Told {
    ProgramRun run;
    json result;
};
Told told_by(const std::string& command, const std::vector<std::string>& set = {}) {
    const Folder folder("told");
    write_small_experiment(folder);
    std::vector<std::string> words{command, folder.str("exp"), "--out", folder.str("out"), "--resolution", "0.01"};
    for (const std::string& value : set) words.insert(words.end(), {"--set", value});
    Told told{run_program(words), {}};
    EXPECT_EQ(told.run.status, 0) << told.run.err;
    told.result = json::parse(content_of(folder.path() / "out" / (command + ".json")));
    return told;
}

TEST(Told, ADoubtfulUnitOnce) {
    const std::string err = told_by("calibrate", {"material.density_kg_m3=1.0"}).run.err;
    const std::size_t first = err.find("material.density_kg_m3 = 1 kg/m3");
    ASSERT_NE(first, std::string::npos) << err;
    EXPECT_EQ(err.find("material.density_kg_m3 = 1 kg/m3", first + 1), std::string::npos) << err;
}

/// The made-up trace is not what the declared values do.
TEST(Told, BySimulateWhatTheDeclaredValuesLeave) {
    const Told told = told_by("simulate");
    EXPECT_THAT(told.run.err, HasSubstr("nothing was fitted; "));
    const json& checks = told.result.at("checks");
    const auto residual = std::find_if(checks.begin(), checks.end(),
                                       [](const json& check) { return check.at("id") == "residual"; });
    ASSERT_NE(residual, checks.end());
    EXPECT_NE(residual->at("level"), "green");
    EXPECT_GT(residual->at("figure").get<double>(), residual->at("threshold").get<double>());
}

/// 2 x 2 x 4 cells of 1 cm.
TEST(Told, WhatTheBodyIsMadeOf) {
    for (const char* command : {"simulate", "calibrate"}) {
        const Told told = told_by(command);
        EXPECT_THAT(told.run.out, HasSubstr("small block\n16 hex8 elements of 10 mm, 2 layers across 20.0 mm, 135 "
                                            "degrees of freedom, tr_bdf2, "))
            << command;
        EXPECT_EQ(told.result.at("layers"), 2.0);
        EXPECT_DOUBLE_EQ(told.result.at("layers_across_m").get<double>(), 0.02);
        EXPECT_EQ(told.result.at("dofs"), 135);
        const std::string file = std::string(command) + "/" + command + ".json";
        expect_keys_of(told.result, file, {".parameters", ".noise_m", ".trials.[].markers"});
    }
}

/// A run of declared values is tested by no trial.
TEST(Told, ByFitsAloneThatNoTrialIsLeftToTestThem) {
    const char* const warning = "so nothing is left to test the fit on";
    for (const char* command : {"simulate", "calibrate"}) {
        const bool fits = std::string(command) == "calibrate";
        const Told told = told_by(command, {"trial[1].role=fit"});
        EXPECT_EQ(told.run.err.find(warning) != std::string::npos, fits) << told.run.err;
        EXPECT_EQ(told.result.at("warnings").dump().find(warning) != std::string::npos, fits);
    }
}

}  // namespace
}  // namespace myo::test
