#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "law/law.hpp"
#include "law/program.hpp"

// Names, variables and units of each place where a law may act, and what a law refuses.

namespace myo::law::law_places_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::vector<Place> places{Place::surface, Place::point,  Place::volume,
                                Place::clamp,   Place::signal, Place::camera};

/// A law that does nothing, with further texts to be added.
LawText idle(Place place) {
    LawText text;
    text.place = place;
    text.key = result_keys(place).front();
    text.result = "0";
    return text;
}

/// Part and index, column from 0, and sentence; empty: the law is good.
std::string said_of(const LawText& text) {
    const auto made = make_law(text);
    const auto* const error = std::get_if<LawError>(&made);
    if (!error) return "";
    const char* const parts[] = {"parameter", "condition", "definition", "state", "initial", "rate", "result"};
    return std::string(parts[static_cast<int>(error->part)]) + " " + std::to_string(error->index) + " at " +
           std::to_string(error->error.column) + ": " + error->error.sentence;
}

std::string said_of_definitions(const std::vector<std::string>& definitions, Place place = Place::surface) {
    LawText text = idle(place);
    text.definitions = definitions;
    return said_of(text);
}

/// Values of the result with each variable set to its number, of a law that must be good.
std::vector<double> values_of(const LawText& text) {
    const auto made = make_law(text);
    EXPECT_EQ(said_of(text), "");
    const Law* const law = std::get_if<Law>(&made);
    if (!law) return {};
    std::vector<double> at;
    for (int i = 0; i < law->variable_count; ++i) at.push_back(i);
    std::vector<Node> nodes(law->result.begin(), law->result.end());
    if (text.key.shape == Shape::number) nodes.resize(1);
    return run_once(Program(law->expressions, nodes), at);
}

/// Section 2 of the manual's page on laws.
TEST(LawPlaces, HaveTheNamesOfTheManualAndNoOthers) {
    const std::set<std::string> of_all{"t", "session_time"},
        everywhere{"t", "session_time", "x", "X", "u", "v", "n", "area_ratio", "gravity", "a", "rate"};
    const std::set<std::string> own[] = {{"x", "X", "u", "v", "n", "area_ratio", "gravity"},
                                         {"x", "X", "u", "v", "n", "gravity"},
                                         {"x", "X", "u", "v", "gravity"},
                                         {"x", "X", "u", "v", "n", "area_ratio", "gravity"},
                                         {"a", "rate"},
                                         {"x"}};
    for (std::size_t i = 0; i < places.size(); ++i)
        for (const std::string& name : everywhere) {
            const std::string said = said_of_definitions({"seen = " + name}, places[i]);
            if (own[i].contains(name) || of_all.contains(name)) {
                EXPECT_EQ(said, "") << i << " " << name;
            } else {
                EXPECT_THAT(said, StartsWith("definition 0 at 7: \"" + name + "\" is not known here")) << i;
            }
        }
}

TEST(LawPlaces, GiveTheirNamesTheUnitsAndVariablesThatRunsSet) {
    LawText text = idle(Place::surface);
    const std::vector<std::pair<std::string, std::vector<double>>> vectors{
        {"1[Pa/m] * x", {0, 1, 2}}, {"1[Pa s/m] * v", {3, 4, 5}},           {"1[Pa/m] * X", {6, 7, 8}},
        {"1[Pa] * n", {9, 10, 11}}, {"1[Pa s2/m] * gravity", {14, 15, 16}}, {"1[Pa/m] * u", {-6, -6, -6}}};
    for (const auto& [result, expected] : vectors) {
        text.result = result;
        EXPECT_EQ(values_of(text), expected) << result;
        text.result = result + " + [1[J], 0, 0]";
        EXPECT_THAT(said_of(text), HasSubstr("the units of the two sides of \"+\" differ")) << result;
    }
    text.result = "[area_ratio * 1[Pa], t * 1[Pa/s], session_time * 1[Pa/s]]";
    EXPECT_THAT(values_of(text), ElementsAre(12.0, 13.0, 17.0));
    LawText signal = idle(Place::signal);
    signal.result = "100 * a + rate";
    EXPECT_THAT(values_of(signal), ElementsAre(1819.0)) << "the units of a signal are its own";
}

/// A force is an energy over a length, at each place.
TEST(LawPlaces, HaveEnergiesThatFitTheirForces) {
    for (const Place place : {Place::surface, Place::point, Place::volume, Place::clamp}) {
        const std::vector<ResultKey>& keys = result_keys(place);
        ASSERT_EQ(keys.size(), 2u);
        EXPECT_EQ(keys[0].shape, Shape::vector);
        EXPECT_FALSE(keys[0].is_energy);
        EXPECT_EQ(keys[1].shape, Shape::number);
        EXPECT_TRUE(keys[1].is_energy);
        EXPECT_EQ(*unit_from_words(keys[0].unit) * *unit_from_words("m"), *unit_from_words(keys[1].unit))
            << keys[0].key;
        for (const ResultKey& key : keys)
            EXPECT_EQ(unit_from_words(unit_of_name(key.key)), unit_from_words(key.unit)) << key.key;
    }
    ASSERT_EQ(result_keys(Place::signal).size(), 1u);
    EXPECT_EQ(result_keys(Place::signal)[0].unit, "");
    ASSERT_EQ(result_keys(Place::camera).size(), 1u);
    EXPECT_EQ(result_keys(Place::camera)[0].unit, "m");
}

/// The force of an energy is its slope over the place alone: what else moves with the body may not be in it.
TEST(LawPlaces, RefuseEnergiesOfVelocitiesAndOfNormalsThatTurn) {
    const auto said = [](Place place, const std::string& energy) {
        LawText text = idle(place);
        text.key = result_keys(place)[1];
        text.result = energy;
        return said_of(text);
    };
    const std::string refused = "result 0 at 0: an energy depends on places alone";
    EXPECT_THAT(said(Place::surface, "1[J/m2] * n.z"), StartsWith(refused));
    EXPECT_THAT(said(Place::clamp, "1[J/m2] * area_ratio"), StartsWith(refused));
    EXPECT_THAT(said(Place::volume, "1[J s/m4] * v.y"), StartsWith(refused));
    EXPECT_THAT(said(Place::point, "1[J s/m] * v.x"), StartsWith(refused));
    EXPECT_EQ(said(Place::point, "1[N] * dot(n, u)"), "") << "the normal at a point is that at rest";
    EXPECT_EQ(said(Place::surface, "1[Pa/m] * dot(u, u) * t / 1[s]"), "");
    EXPECT_EQ(said(Place::volume, "-1000[kg/m3] * dot(gravity, x)"), "");
    EXPECT_EQ(said(Place::surface, "0 * n.z + 1[Pa] * x.z"), "") << "nothing of the normal is left";
}

TEST(LawNames, AreNewWordsWithoutPrefixedUnits) {
    for (const std::string name : {"", "1a", "a b", "a-b", "\u00e4", "a.b"}) {
        LawText text = idle(Place::surface);
        text.parameters = {{"good", Shape::number, {}}, {name, Shape::number, {}}};
        EXPECT_EQ(said_of(text), "parameter 1 at 0: \"" + name +
                                     "\" is no name: letters, digits and underscores make one, no digit first");
    }
    for (const std::string name : {"pi", "and", "if", "norm", "n", "session_time", "good"}) {
        LawText text = idle(Place::surface);
        text.parameters = {{"good", Shape::number, {}}};
        text.conditions = {name};
        EXPECT_EQ(said_of(text), "condition 0 at 0: the name \"" + name + "\" has a meaning already");
        EXPECT_THAT(said_of_definitions({"good = 1", name + " = 2"}), StartsWith("definition 1 at 0: the name"));
    }
    LawText text = idle(Place::signal);
    text.states = {{"a_kPa", "0", "0", {}}};
    EXPECT_EQ(said_of(text),
              "state 0 at 0: the name \"a_kPa\" ends in kPa, but laws take SI units without prefixes: m, Pa, N, s");
    text.states = {{"b", "0", "0", "1/h"}};
    EXPECT_THAT(said_of(text), StartsWith("state 0 at 0: \"1/h\" is not a unit"));
    text.states.clear();
    text.parameters = {{"tilt_deg", Shape::number, {}}};
    EXPECT_THAT(said_of(text), StartsWith("parameter 0 at 0: \"deg\" is not a unit"));
    text.parameters = {{"tilt_deg", Shape::number, "rad"}};
    EXPECT_EQ(said_of(text), "") << "what is declared goes before the name";
}

TEST(LawDefinitions, AreReadInOrderAndCheckedAgainstTheirNames) {
    EXPECT_EQ(said_of_definitions({"  first\t =  2", "second = first * 3"}), "");
    EXPECT_THAT(said_of_definitions({"second = first * 3", "first = 2"}),
                StartsWith("definition 0 at 9: \"first\" is not"));
    EXPECT_EQ(said_of_definitions({"= 3"}), "definition 0 at 0: a definition is written \"name = expression\"");
    EXPECT_THAT(said_of_definitions({" = 3"}), StartsWith("definition 0 at 0: \"\" is no name"));
    EXPECT_THAT(said_of_definitions({"b =  1 + qq"}), StartsWith("definition 0 at 9: \"qq\" is not known"));
    EXPECT_THAT(said_of_definitions({"b == 1"}), StartsWith("definition 0 at 3: \"=\" has no meaning"));
    EXPECT_EQ(said_of_definitions({"gap_m = 1"}), "definition 0 at 7: \"gap_m\" has the unit 1, and its name says m");
    EXPECT_EQ(said_of_definitions({"gap_m = 1[m]", "wet = gap_m < x.z", "c = if(wet, 1, 2)"}), "");
    // The number 0 has every unit, and its name gives it one.
    EXPECT_EQ(said_of_definitions({"gap_m = 0", "b = gap_m + 1[m]"}), "");
    EXPECT_EQ(said_of_definitions({"wind_m_s = [0, 0, 0]", "b = wind_m_s - v"}), "");
    // A signal has no known unit; a name decides.
    EXPECT_THAT(said_of_definitions({"pull_N = a", "b = pull_N + 1[m]"}, Place::signal),
                HasSubstr("differ: m kg/s2 and m"));
}

TEST(LawStates, AreRefusedWithTheirOwnIndex) {
    LawText text = idle(Place::signal);
    text.states = {{"b_m", "1[m]", "b_m / 1[s]", {}}, {"c_m", "1[m]", "b_m", {}}};
    EXPECT_THAT(said_of(text), StartsWith("rate 1 at 0: the expression has the unit m, and must have m/s"));
    text.states[1] = {"c_m", "1[s]", "0", {}};
    EXPECT_THAT(said_of(text), StartsWith("initial 1 at 0: the expression has the unit s, and must have m"));
    text.states[1] = {"c_m", "b_m", "0", {}};
    EXPECT_THAT(said_of(text), StartsWith("initial 1 at 0: \"b_m\" is not known here"));
    text.states[1] = {"c", "a", "(a - c) * 1[1/s] + rate", {}};
    text.result = "b_m / 1[m] + c";
    EXPECT_EQ(said_of(text), "") << "a state without a unit fits the signal";
}

}  // namespace
}  // namespace myo::law::law_places_test
