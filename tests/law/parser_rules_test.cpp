#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "law/parser.hpp"
#include "law/program.hpp"
#include "law/quantities.hpp"

// Order of operations, conditions at their thresholds, refusals with their columns, and what 0 and unknown units fit.

namespace myo::law::parser_rules_test {
namespace {

constexpr int number_of_k = 3;

/// A place in m, a velocity's component in m/s, a plain number k, and a signal q without a known unit.
struct Reader {
    Expressions expressions;
    Names names;

    Reader() {
        const auto of = [&](int number) { return expressions.variable(number); };
        names["x"] = {Shape::vector, {of(0), of(1), of(2)}, unit_from_words("m")};
        names["k"] = {Shape::number, {of(number_of_k), -1, -1}, Unit{}};
        names["speed"] = {Shape::number, {of(4), -1, -1}, unit_from_words("m/s")};
        names["q"] = {Shape::number, {of(5), -1, -1}, std::nullopt};
    }

    /// Value for this k; NaN where the text is refused.
    double value(const std::string& text, double of_k = 0.0) {
        const auto read = parsed(text, names, expressions);
        const auto* const quantity = std::get_if<Quantity>(&read);
        if (!quantity) return std::numeric_limits<double>::quiet_NaN();
        return run_once(Program(expressions, {quantity->node()}), {0.1, 0.2, 0.3, of_k, 5.0, 6.0}).front();
    }
    /// Column from 0 and sentence of a refusal; the unit of what is accepted.
    std::string said(const std::string& text) {
        const auto read = parsed(text, names, expressions);
        if (const auto* const error = std::get_if<ExpressionError>(&read))
            return std::to_string(error->column) + " " + error->sentence;
        const std::optional<Unit> unit = std::get<Quantity>(read).unit;
        return unit ? to_string(*unit) : "unknown";
    }
    /// Shape, unit and whether all nodes are set, or the sentence, of an expression that must be one.
    std::string said_as(const std::string& text, Shape shape, const std::string& unit) {
        const auto read = parsed_as(text, names, shape, unit_from_words(unit), expressions);
        if (const auto* const error = std::get_if<ExpressionError>(&read))
            return std::to_string(error->column) + " " + error->sentence;
        const auto& quantity = std::get<Quantity>(read);
        for (std::size_t i = 0; i < (quantity.shape == Shape::vector ? 3u : 1u); ++i) EXPECT_GE(quantity.nodes[i], 0);
        return to_string(quantity.shape);
    }
};

TEST(ParserRules, BindFromTheSameSideAsArithmetic) {
    Reader reader;
    for (const auto& [text, expected] :
         std::vector<std::pair<const char*, double>>{{"8 / 4 / 2", 1.0},
                                                     {"8 / 4 * 2", 4.0},
                                                     {"8 - 4 - 2", 2.0},
                                                     {"8 - 4 + 2", 6.0},
                                                     {"2^3^2", 512.0},
                                                     {"(2^3)^2", 64.0},
                                                     {"-2^-2", -0.25},
                                                     {"-2^2 * 3", -12.0},
                                                     {"2^2 * 3", 12.0},
                                                     {"2^-1^2", 0.5},
                                                     {"2 * -3 - -4", -2.0},
                                                     {"+-+2", -2.0},
                                                     {"--2", 2.0},
                                                     {"6 / -2 / -3", 1.0},
                                                     {"[1, 2, 3].y^2", 4.0},
                                                     {"-[1, 2, 3].z", -3.0},
                                                     {"(2 * [1, 2, 3] / 4).z", 1.5},
                                                     {"cross([1, 0, 0], [0, 1, 0]).z", 1.0},
                                                     {"cross([0, 0, 1], [1, 0, 0]).y", 1.0},
                                                     {"dot([1, 2, 3], [4, -5, 6])", 12.0},
                                                     {"pow(2, 5) - 2^5", 0.0},
                                                     {"min(3, 1, 2) + 10 * max(3, 1, 4)", 41.0},
                                                     {"abs(-3) + abs(3)", 6.0},
                                                     {"atan(1) * 4 - pi", 0.0}})
        EXPECT_DOUBLE_EQ(reader.value(text), expected) << text;
}

/// "not" before "and" before "or", for all values of three conditions.
TEST(ParserRules, CombineConditionsAsLogicDoes) {
    Reader reader;
    for (int bits = 0; bits < 8; ++bits) {
        const bool a = (bits & 1) != 0, b = (bits & 2) != 0, c = (bits & 4) != 0;
        // Compared with k, so that nothing is computed while it is read.
        const auto condition = [](bool holds) { return std::string(holds ? "k < 1" : "1 <= k"); };
        const std::string A = condition(a), B = condition(b), C = condition(c);
        const auto holds = [&](const std::string& text) { return reader.value("if(" + text + ", 1, 0)") == 1.0; };
        EXPECT_EQ(holds(A + " or " + B + " and " + C), a || (b && c)) << bits;
        EXPECT_EQ(holds(A + " and " + B + " or " + C), (a && b) || c) << bits;
        EXPECT_EQ(holds("not " + A + " and " + B), !a && b) << bits;
        EXPECT_EQ(holds("not (" + A + " and " + B + ") or " + C), !(a && b) || c) << bits;
        EXPECT_EQ(holds("not not " + A), a) << bits;
    }
}

/// Just below, at and just above the number that is compared with.
TEST(ParserRules, CompareStrictlyOrNotAtTheThreshold) {
    Reader reader;
    const double below = std::nextafter(1.0, 0.0), above = std::nextafter(1.0, 2.0);
    for (const auto& [sign, at] : std::vector<std::pair<std::string, std::array<double, 3>>>{
             {"<", {1, 0, 0}}, {"<=", {1, 1, 0}}, {">", {0, 0, 1}}, {">=", {0, 1, 1}}}) {
        const std::string text = "if(k " + sign + " 1, 1, 0)";
        EXPECT_EQ(reader.value(text, below), at[0]) << sign;
        EXPECT_EQ(reader.value(text, 1.0), at[1]) << sign;
        EXPECT_EQ(reader.value(text, above), at[2]) << sign;
        const double none = std::numeric_limits<double>::quiet_NaN();
        EXPECT_EQ(reader.value(text, none), 0.0) << sign << ": no comparison with NaN holds";
    }
    EXPECT_EQ(reader.value("step(k - 1)", below), 0.0);
    EXPECT_EQ(reader.value("step(k - 1)", 1.0), 1.0);
}

TEST(ParserRules, RefuseWithColumnAndSentence) {
    Reader reader;
    const std::string unit_hint = "; a number with a unit is written 0.3[m]";
    for (const auto& [text, sentence] : std::vector<std::pair<std::string, std::string>>{
             {"1 < 2 < 3", "6 \"<\" cannot stand here: an operator or the end is expected"},
             {"k != 2", "2 numbers that vary are never equal: compare by <, <=, > or >="},
             {")", "0 \")\" cannot stand here: a number or a name is expected"},
             {"k.x", "2 what stands before \".x\" must be a vector, not a number"},
             {"x.", "2 \".\" needs x, y or z behind it"},
             {"x.1", "1 \".1\" cannot stand here: an operator or the end is expected"},
             {"-(k < 1)", "0 \"-\" needs a number or a vector"},
             {"2 * (k < 1)", "2 a condition cannot be multiplied; write if(condition, value, 0)"},
             {"(k < 1) / 2", "8 \"/\" divides a number or a vector by a number"},
             {"1 / x", "2 \"/\" divides a number or a vector by a number"},
             {"1 + (k < 1)", "2 \"+\" needs two numbers or two vectors, not a number and a condition"},
             {"(k < 1) - (k < 1)", "8 \"-\" needs two numbers or two vectors, not a condition and a condition"},
             {"x^2", "1 what is raised to a power must be a number, not a vector"},
             {"2^x", "1 the exponent must be a number, not a vector"},
             {"2^x.x", "1 the exponent must be a plain number, but has the unit m"},
             {"k and 1 < 2", "2 each side of \"and\", \"or\" and \"not\" must be a condition, not a number"},
             {"1 < 2 or k", "6 each side of \"and\", \"or\" and \"not\" must be a condition, not a number"},
             {"not k", "0 each side of \"and\", \"or\" and \"not\" must be a condition, not a number"},
             {"x < x", "2 what is compared must be a number, not a vector"},
             {"x.x < speed", "4 the units of the two sides of \"<\" differ: m and m/s" + unit_hint},
             {"x.x - speed", "4 the units of the two sides of \"-\" differ: m and m/s" + unit_hint},
             {"max(k)", "0 max() needs two numbers or more"},
             {"1 + min(x, x)", "4 what min() is given must be a number, not a vector"},
             {"max(q, 1[s], 2[m])", "0 the units of the two sides of max() differ: s and m" + unit_hint},
             {"if(1 < 2, 1)", "0 if() needs a condition and two values"},
             {"if(k < 1, x, k)", "0 the two values of if() are a vector and a number"},
             {"if(k < 1, 0, k < 2)", "0 the two values of if() are a number and a condition"},
             {"if(k < 1, 1[m], 2[s])", "0 the units of the two sides of if() differ: m and s" + unit_hint},
             {"norm()", "0 norm() takes 1 argument, not 0"},
             {"dot(x)", "0 dot() takes 2 arguments, not 1"},
             {"cross(x, k)", "0 what cross() is given must be a vector, not a number"},
             {"positive(x.x, 1[s])", "0 the units of the two sides of positive() differ: m and s" + unit_hint},
             {"smooth_step(x.x)", "0 what smooth_step() is given must be a plain number, but has the unit m"},
             {"[x, 0, 0]", "0 a component of a vector must be a number, not a vector"},
             {"(1, 2)", "2 \")\" is missing after the part in parentheses; \",\" stands there"},
             {"[1, 2, 3", "8 \"]\" is missing after the list"},
             {"3[m", "2 \"]\" is missing after the unit"},
             {"1 + 3[kN]",
              "6 \"kN\" is not a unit; SI units without prefixes are known, such as N/m or kg/m3, and rad "
              "for angles"}})
        EXPECT_EQ(reader.said(text), sentence) << text;
}

/// Text from a file may be nested by mistake or by malice; what stands side by side may be as long as it likes.
TEST(ParserRules, LimitNestingAndNotLength) {
    Reader reader;
    const auto repeated = [](const std::string& part, int times) {
        std::string text;
        for (int i = 0; i < times; ++i) text += part;
        return text;
    };
    EXPECT_EQ(reader.value(repeated("(", 150) + "7" + repeated(")", 150)), 7.0);
    EXPECT_EQ(reader.value(repeated("-", 150) + "7"), 7.0);
    for (const std::string& text : {repeated("-", 250) + "7", repeated("not ", 250) + "k < 1", repeated("abs(", 250),
                                    "2" + repeated("^-2", 250), repeated("[", 250)})
        EXPECT_NE(reader.said(text).find("the expression is nested too deeply"), std::string::npos) << text;
    EXPECT_EQ(reader.value("0" + repeated(" + (1)", 1000)), 1000.0);
    EXPECT_EQ(reader.value(repeated("-1 * ", 1000) + "3"), 3.0);
}

/// A quantity whose unit is not known takes that of its partner in a sum, and hides that of a product.
TEST(ParserRules, LetAnUnknownUnitFitEverywhere) {
    Reader reader;
    for (const auto& [text, unit] : std::vector<std::pair<std::string, std::string>>{{"q", "unknown"},
                                                                                     {"q + 1[m]", "m"},
                                                                                     {"1[m] - q", "m"},
                                                                                     {"q + 0", "unknown"},
                                                                                     {"q * 2[m]", "unknown"},
                                                                                     {"2[m] / q", "unknown"},
                                                                                     {"q^2", "unknown"},
                                                                                     {"sqrt(q)", "unknown"},
                                                                                     {"sin(q)", "1"},
                                                                                     {"-q", "unknown"},
                                                                                     {"[q, 1[m], 0]", "m"},
                                                                                     {"[0, q, 0]", "unknown"},
                                                                                     {"if(q < 1[m], q, 2[s])", "s"},
                                                                                     {"max(0, q, 1[s])", "s"},
                                                                                     {"dot([q, 0, 0], x)", "unknown"},
                                                                                     {"2^q", "1"}})
        EXPECT_EQ(reader.said(text), unit) << text;
}

TEST(ParserRules, LetOnlyZeroStandForEveryUnitAndVector) {
    Reader reader;
    const std::string vector = "a vector", number = "a number";
    EXPECT_EQ(reader.said_as("0", Shape::vector, "Pa"), vector);
    EXPECT_EQ(reader.said_as("0 * k", Shape::vector, "Pa"), vector) << "zero after simplification";
    EXPECT_EQ(reader.said_as("[0, 0, 0]", Shape::vector, "Pa"), vector);
    EXPECT_EQ(reader.said_as("if(k < 1, x, 0)", Shape::vector, "m"), vector);
    EXPECT_EQ(reader.said_as("0", Shape::number, "J"), number);
    EXPECT_EQ(reader.said_as("q", Shape::number, "J"), number);
    EXPECT_EQ(reader.said_as("k < 1", Shape::condition, ""), "a condition");
    EXPECT_EQ(reader.said_as("1", Shape::vector, "Pa"), "0 the expression is a number, and must be a vector");
    EXPECT_EQ(reader.said_as("[0, 0, 0]", Shape::number, "Pa"), "0 the expression is a vector, and must be a number");
    EXPECT_EQ(reader.said_as("1 < 2", Shape::number, ""), "0 the expression is a condition, and must be a number");
    EXPECT_EQ(reader.said_as("[0, 0, 1]", Shape::vector, "Pa"),
              "0 the expression has the unit 1, and must have kg/m s2; a number with a unit is written 1000[kg/m3]");
}

TEST(ParserRules, ReserveTheWordsOfTheLanguage) {
    for (const std::string& name : function_names()) EXPECT_TRUE(is_reserved(name)) << name;
    for (const std::string word : {"pi", "and", "or", "not", "if", "min", "max"})
        EXPECT_TRUE(is_reserved(word)) << word;
    for (const std::string word : {"", "Pi", "t", "x", "sine", "And"}) EXPECT_FALSE(is_reserved(word)) << word;
}

}  // namespace
}  // namespace myo::law::parser_rules_test
