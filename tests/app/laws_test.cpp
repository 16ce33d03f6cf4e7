#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "app/experiment_calls.hpp"
#include "base/random_stream.hpp"
#include "base/text.hpp"
#include "effect/catalogue.hpp"
#include "measurement/trace_csv.hpp"
#include "support/experiment_folder.hpp"
#include "support/law_texts.hpp"

namespace myo::test {
namespace {

using ::testing::HasSubstr;
using testing_support::replaced;

/// A wind that blows along y and pushes the surface as it faces it.
const std::string wind_law = R"law(schema = "law/1"
id = "side_wind"
sentence = "a wind pushes the side that faces it"
acts_on = "surface"
traction_Pa = "pressure_Pa * exp(-2 * (n.y + 1)^2) * [0, 1, 0]"
[[parameter]]
name = "pressure_Pa"
range = [-1e4, 1e4]
scale = 20.0
start = 5.0
)law";

/// The small block with a file of a law, and what the experiment declares of it.
void write_with_law(const Folder& folder, const std::string& law, const std::string& declared) {
    write_small_experiment(folder, 0.3);
    folder.write("exp/laws/own.toml", law);
    folder.write("exp/experiment.toml", replaced(small_toml(), "name = \"small block\"",
                                                 "laws = [\"laws/own.toml\"]\nname = \"small block\"") +
                                            declared);
}

/// The simulated trial with noise takes the place of the recording.
void record_simulation(const Folder& folder, double noise_m) {
    Result<measurement::Recording> simulated = measurement::read_trace_csv(folder.path() / "out/drop.csv");
    ASSERT_TRUE(simulated) << simulated.error().text();
    RandomStream random({7});
    for (Eigen::Matrix3Xd& track : simulated->tracks)
        for (Eigen::Index k = 0; k < track.size(); ++k) track(k) += noise_m * random.normal();
    ASSERT_TRUE(measurement::write_trace_csv(folder.path() / "exp/drop.csv", *simulated));
}

TEST(LawsOfOnesOwn, AreRefusedWithLineAndColumn) {
    const Folder folder("law_errors");
    write_with_law(folder, replaced(wind_law, "(n.y + 1)", "(m.y + 1)"), "");
    const ProgramRun run = run_program(call({"simulate", folder.str("exp"), "--out", folder.str("out")}));
    EXPECT_EQ(run.status, 2);
    EXPECT_THAT(run.err, HasSubstr("laws/own.toml:5:40: traction_Pa: \"m\" is not known here"));
    write_with_law(folder, wind_law, "");
    const ProgramRun unknown = run_program(
        call({"diagnose", folder.str("exp"), "--out", folder.str("out"), "--without", "side_wind,side_wynd"}));
    EXPECT_EQ(unknown.status, 2);
    EXPECT_THAT(unknown.err, HasSubstr("side_wynd"));
}

TEST(LawsOfOnesOwn, AreNamedByADiagnosisOfDataThatHoldThem) {
    const Folder folder("law_diagnosis");
    write_with_law(folder, wind_law, "[[effect]]\nid = \"side_wind\"\npressure_Pa = 100.0\n");
    // On a finer mesh: diagnose takes off the mesh error of its own runs, which a recording of theirs would not have.
    const ProgramRun made = run_program(
        {"simulate", folder.str("exp"), "--out", folder.str("out"), "--dt", "0.0025", "--resolution", "0.005"});
    ASSERT_EQ(made.status, 0) << made.err;
    write_with_law(folder, wind_law, "");
    record_simulation(folder, 1e-4);
    std::vector<std::string> others = effect::effect_ids();
    // Gravity that tilts bends the block nearly as the wind does.
    std::erase_if(others, [](const std::string& id) { return id == "linear_drag" || id == "clamp_compliance"; });
    const ProgramRun run = run_program(call({"diagnose", folder.str("exp"), "--out", folder.str("found"), "--without",
                                             join(others, ","), "--dt", "0.0025", "--quiet"}));
    ASSERT_EQ(run.status, 0) << run.err;
    const nlohmann::json report = nlohmann::json::parse(content_of(folder.path() / "found/report.json"));
    const nlohmann::json& named = report.at("verdict").at("effects");
    ASSERT_EQ(named.size(), 1u) << named;
    EXPECT_EQ(named[0].at("id"), "side_wind");
    EXPECT_NEAR(named[0].at("parameters").at("pressure_Pa").get<double>(), 100.0, 6.0);
    // The experiment that it writes finds the law from its folder.
    const ProgramRun checked = run_program(
        call({"gradcheck", folder.str("found/experiment_augmented.toml"), "--json", folder.str("check.json")}));
    EXPECT_EQ(checked.status, 0) << checked.out << checked.err;
    EXPECT_THAT(checked.out, HasSubstr("effect.side_wind.pressure_Pa"));
}

}  // namespace
}  // namespace myo::test
