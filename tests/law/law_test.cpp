#include <gtest/gtest.h>

#include "law/law.hpp"
#include "law/program.hpp"

namespace myo::law {
namespace {

LawText drag() {
    LawText text;
    text.place = Place::surface;
    text.parameters = {{"coefficient_kg_m3", Shape::number, {}}};
    text.definitions = {"speed_m_s = norm(v)", "force = coefficient_kg_m3 * speed_m_s * v"};
    text.key = result_keys(Place::surface)[0];
    text.result = "-force";
    return text;
}

/// Part, index, column from 1, and sentence.
std::string error_of(const LawText& text) {
    const auto made = make_law(text);
    const auto* const error = std::get_if<LawError>(&made);
    return error ? std::to_string(static_cast<int>(error->part)) + "/" + std::to_string(error->index) + "/" +
                       std::to_string(error->error.column + 1) + ": " + error->error.sentence
                 : "";
}

TEST(Law, AssignsVariablesToParametersStatesAndConditions) {
    LawText text = drag();
    text.parameters.push_back({"wind_m_s", Shape::vector, {}});
    text.conditions = {"temperature"};
    text.result = "-force - coefficient_kg_m3 * norm(wind_m_s) * wind_m_s * temperature";
    const auto made = make_law(text);
    ASSERT_TRUE(std::holds_alternative<Law>(made)) << error_of(text);
    const Law& law = std::get<Law>(made);
    EXPECT_EQ(law.number_count(), 4);
    EXPECT_EQ(law.parameters[1].variable, Variable::first_free + 1);
    EXPECT_EQ(law.conditions[0].variable, Variable::first_free + 4);
    EXPECT_EQ(law.variable_count, Variable::first_free + 5);
    std::vector<double> at(static_cast<std::size_t>(law.variable_count), 0.0);
    at[Variable::v] = 3.0;
    at[Variable::v + 1] = 4.0;
    at[Variable::first_free] = 2.0;
    const Program program(law.expressions, {law.result.begin(), law.result.end()});
    EXPECT_EQ(run_once(program, at), (std::vector<double>{-30.0, -40.0, 0.0}));
}

TEST(Law, SaysInWhichTextTheErrorIs) {
    LawText text = drag();
    text.definitions[1] = "force = coefficient_kg_m3 * sped_m_s * v";
    EXPECT_EQ(error_of(text), "2/1/29: \"sped_m_s\" is not known here; the closest name is speed_m_s");
    text = drag();
    text.result = "-force * 2[s]";
    EXPECT_EQ(error_of(text).substr(0, 7), "6/0/1: ");
    EXPECT_NE(error_of(text).find("kg/m s, and must have kg/m s2"), std::string::npos) << error_of(text);
    text = drag();
    text.definitions[0] = "speed_m = norm(v)";
    EXPECT_EQ(error_of(text).substr(0, 33), "2/0/10: \"speed_m\" has the unit m/");
    text = drag();
    text.parameters[0].name = "v";
    EXPECT_EQ(error_of(text), "0/0/1: the name \"v\" has a meaning already");
    text.parameters[0] = {"coefficient_kg_m3", Shape::number, "kg/mm3"};
    EXPECT_NE(error_of(text).find("is not a unit"), std::string::npos);
    text = drag();
    text.definitions[0] = "no expression";
    EXPECT_EQ(error_of(text), "2/0/1: a definition is written \"name = expression\"");
    text = drag();
    text.key = result_keys(Place::surface)[1];
    text.result = "coefficient_kg_m3 * dot(v, v) * 1[m]";
    EXPECT_NE(error_of(text).find("an energy depends on places alone"), std::string::npos) << error_of(text);
    text.result = "-force";
    EXPECT_NE(error_of(text).find("is a vector, and must be a number"), std::string::npos) << error_of(text);
}

TEST(Law, HasStatesThatStartWithoutStates) {
    LawText text;
    text.place = Place::signal;
    text.parameters = {{"tau_s", Shape::number, {}}};
    text.states = {{"s", "a", "(a - s) / tau_s", {}}};
    text.key = result_keys(Place::signal)[0];
    text.result = "s";
    EXPECT_EQ(error_of(text), "");
    text.states[0].initial = "s";
    EXPECT_EQ(error_of(text).substr(0, 7), "4/0/1: ");
    text.definitions = {"twice = 2 * s"};
    text.states[0].initial = "twice";
    EXPECT_EQ(error_of(text), "4/0/1: no state has a value at the start, and a definition in it uses \"s\"");
    text.definitions.clear();
    text.states[0] = {"s_m", "a", "(a - s_m) / tau_s", {}};
    text.states.push_back({"w_m", "0", "s_m", {}});
    EXPECT_NE(error_of(text).find("must have m/s"), std::string::npos) << error_of(text);
    text.states.pop_back();
    text.result = "s_m + x.x";
    EXPECT_NE(error_of(text).find("\"x\" is not known here"), std::string::npos) << "signals have no place";
}

TEST(Law, KnowsWhetherItChooses) {
    EXPECT_FALSE(has_choices(std::get<Law>(make_law(drag()))));
    LawText text = drag();
    text.result = "if(x.z < 0.1[m], -force, 0)";
    EXPECT_TRUE(has_choices(std::get<Law>(make_law(text))));
}

}  // namespace
}  // namespace myo::law
