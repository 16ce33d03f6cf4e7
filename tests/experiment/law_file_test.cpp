#include "experiment/law_file.hpp"

#include <gtest/gtest.h>

#include "effect/catalogue.hpp"
#include "experiment/experiment_text.hpp"
#include "experiment/read_experiment.hpp"
#include "support/experiment_folder.hpp"
#include "support/good_experiment.hpp"
#include "support/law_texts.hpp"

namespace myo::experiment {
namespace {

using testing_support::replaced;

std::string error_of(const std::string& text) {
    const Result<effect::LawPointer> law = read_law_text(text, "laws/drag.toml");
    return law ? "" : law.error().text();
}

TEST(LawFile, MakesAnEntryOfItsPlaceAndParameters) {
    const Result<effect::LawPointer> law = read_law_text(test::cable_law, "cable.toml");
    ASSERT_TRUE(law) << law.error().text();
    const effect::Effect& entry = **law;
    EXPECT_EQ(entry.id, "own_cable");
    EXPECT_EQ(entry.kind, effect::EffectKind::force);
    ASSERT_EQ(entry.parameters.size(), 3u);
    EXPECT_TRUE(entry.parameters[0].over_decades);
    EXPECT_EQ(entry.parameters[0].highest, 1e4);
    EXPECT_EQ(entry.parameters[1].kind, effect::EffectParameterKind::vector3);
    EXPECT_EQ(entry.parameters[2].name, "position_m");
    EXPECT_EQ(entry.draw.amount, "stiffness_N_m");
    EXPECT_FALSE(entry.has_corner);
    EXPECT_EQ((*read_law_text(test::lag_law, ""))->kind, effect::EffectKind::actuation);
    EXPECT_EQ((*read_law_text(test::lag_law, ""))->parameter("signal")->optional, true);
    EXPECT_EQ((*read_law_text(test::bed_law, ""))->kind, effect::EffectKind::support);
    EXPECT_FALSE((*read_law_text(test::bed_law, ""))->draw.grows);
    EXPECT_EQ((*read_law_text(test::scale_law, ""))->kind, effect::EffectKind::measurement);
}

TEST(LawFile, TellsFileLineAndColumnOfAnError) {
    const std::string& good = test::drag_law;
    EXPECT_EQ(error_of(good), "");
    EXPECT_EQ(error_of(replaced(good, "norm(v) * v", "nrm(v) * v")),
              "laws/drag.toml:5:37: traction_Pa: no function nrm() is known; the closest one is norm()");
    EXPECT_EQ(error_of(replaced(good, "norm(v) * v", "norm(v)")),
              "laws/drag.toml:5:16: traction_Pa: the expression is a number, and must be a vector");
    EXPECT_EQ(
        error_of(replaced(good, "traction_Pa = \"-coefficient_kg_m3 * norm(v) * v\"",
                          "let = [\n  \"speed = norm(v)\",\n  \"more = speed +\",\n]\ntraction_Pa = \"more * v\"")),
        "laws/drag.toml:7:18: let[1]: the expression ends too early: a number or a name is missing");
    EXPECT_EQ(
        error_of(replaced(good, "\"-coefficient_kg_m3 * norm(v) * v\"", "'''\n-coefficient_kg_m3\n  * norm(w) * v'''")),
        "laws/drag.toml:7:10: traction_Pa: \"w\" is not known here; there are X, area_ratio, coefficient_kg_m3, "
        "gravity, n, session_time, t, u, v, x");
    EXPECT_NE(error_of(replaced(good, "kg_m3 * norm(v) * v", "kg_m3 * v")).find("must have kg/m s2"),
              std::string::npos);
}

TEST(LawFile, RefusesWhatHasNoMeaning) {
    const auto expect = [](const std::string& text, const std::string& part) {
        EXPECT_NE(error_of(text).find(part), std::string::npos) << error_of(text) << "\n is without: " << part;
    };
    const std::string& good = test::drag_law;
    expect(replaced(good, "law/1", "law/2"), "schema: must be \"law/1\"");
    expect(replaced(good, "\"surface\"", "\"skin\""), "acts_on");
    expect(replaced(good, "own_drag", "quadratic_drag"), "an effect of the catalogue");
    expect(replaced(good, "own_drag", "Own drag"), "small letters");
    expect(replaced(good, "traction_Pa", "force_N"), "force_N: unknown key");
    expect(replaced(good, "traction_Pa = \"-coefficient_kg_m3 * norm(v) * v\"\n", ""), "energy_J_per_m2");
    expect(good + "[[state]]\nname = \"s\"\nrate = \"-s\"\n", "only laws that act on a signal have states");
    expect(replaced(good, "start = 50.0", "start = -1.0"), "lies outside the range");
    expect(replaced(good, "start = 50.0", "start = 0.0"), "starts at 0");
    expect(replaced(good, "start = 50.0", "start = []"), "start");
    expect(replaced(good, "start = 50.0\n", ""), "start: required key is missing");
    expect(replaced(good, "range = [0.0, 1e6]", "range = [1.0, 0.0]"), "[lowest, highest]");
    expect(replaced(good, "scale = 300.0\n", ""), "over_decades: needs");
    expect(replaced(good, "name = \"coefficient_kg_m3\"", "name = \"v\""), "has a meaning already");
    expect(replaced(good, "name = \"coefficient_kg_m3\"", "name = \"signal\""), "a key that every effect may have");
    expect(replaced(good, "name = \"coefficient_kg_m3\"", "name = \"coefficient_kg_m3\"\nunit = \"g/m3\""),
           "laws/drag.toml:8:9: parameter[0].unit: \"g/m3\" is not a unit");
    expect(good + "[[parameter]]\nname = \"axis\"\nkind = \"direction\"\nstart = [0, 0, 0]\n",
           "parameter[1].start: has no direction: it is zero");
    expect(replaced(test::bed_law, "range = [1e4, 1e12]", "range = [0.0, 1e12]"), "lowest value above 0");
    expect("schema = ", "laws/drag.toml:1");
}

/// The experiment of the tests with a law of drag that it declares.
class LawsOfAnExperiment : public testing::Test {
protected:
    void write(const std::string& list, const std::string& end = "") {
        testing_support::write_files(
            folder,
            replaced(testing_support::good_toml, "name = \"tail\"", "laws = " + list + "\nname = \"tail\"") + end);
    }
    std::string said() const {
        const Result<Experiment> read = read_experiment(folder.path());
        return read ? "" : read.error().text();
    }
    void expect_said(const std::string& part) const {
        EXPECT_NE(said().find(part), std::string::npos) << said() << "\n is without: " << part;
    }
    LawsOfAnExperiment() { folder.write("laws/drag.toml", test::drag_law); }
    test::Folder folder{"laws_of_an_experiment"};
    const std::string declared = "\n[[effect]]\nid = \"own_drag\"\ncoefficient_kg_m3 = 40.0\ncalibrate = true\n";
};

TEST_F(LawsOfAnExperiment, AreDeclaredAsEffects) {
    write("[\"laws/drag.toml\"]", declared);
    const Result<Experiment> read = read_experiment(folder.path());
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->laws.size(), 1u);
    EXPECT_EQ(read->law_files, std::vector<std::filesystem::path>{folder.path() / "laws/drag.toml"});
    const effect::EffectDeclaration& effect = read->effects.back();
    EXPECT_EQ(effect.law, read->laws[0]);
    EXPECT_EQ(effect::find_effect(effect), read->laws[0].get());
    EXPECT_EQ(std::get<double>(effect.parameters.at("coefficient_kg_m3")), 40.0);
    EXPECT_EQ(effect::all_effects(read->laws).size(), effect::effect_catalogue().size() + 1);
    EXPECT_EQ(effect::find_effect("own_drag"), nullptr) << "other experiments do not have it";
    EXPECT_EQ(effect::find_effect("own_drag", read->laws), read->laws[0].get());
}

TEST_F(LawsOfAnExperiment, AreCheckedWithIt) {
    write("[\"laws/lag.toml\"]");
    expect_said("laws: there is no file \"laws/lag.toml\"");
    write("[\"laws/drag.toml\", \"laws/drag.toml\"]");
    expect_said("two files state a law of the id \"own_drag\"");
    write("[\"laws/drag.toml\"]", replaced(declared, "coefficient_kg_m3", "coefficient"));
    expect_said("unknown key; the closest known one is \"coefficient_kg_m3\"");
    write("[\"laws/drag.toml\"]", replaced(declared, "own_drag", "own_dragg"));
    expect_said("the closest known one is \"own_drag\"");
    write("[\"laws/drag.toml\"]", replaced(declared, "40.0", "-1"));
    expect_said("zero or positive");
    folder.write("laws/drag.toml", replaced(test::drag_law, "norm(v)", "nrm(v)"));
    write("[\"laws/drag.toml\"]");
    expect_said("laws/drag.toml:5:37: traction_Pa: no function nrm()");
    folder.write("laws/drag.toml", replaced(test::drag_law, "acts_on", "conditions = [\"pressure_mbar\"]\nacts_on"));
    expect_said("trial[0].condition: \"pressure_mbar\" is missing, which the law \"own_drag\" reads");
}

/// A copy of the experiment elsewhere still finds its laws.
TEST_F(LawsOfAnExperiment, StayFoundFromAnotherFolder) {
    write("[\n  \"laws/drag.toml\",  # own\n]", declared);
    std::filesystem::create_directories(folder.path() / "out");
    const Result<std::string> text = experiment_text_for(folder.path() / "out", folder.path() / "experiment.toml");
    ASSERT_TRUE(text);
    folder.write("out/experiment.toml", *text);
    const Result<Experiment> read = read_experiment(folder.path() / "out");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->laws.size(), 1u);
}

}  // namespace
}  // namespace myo::experiment
