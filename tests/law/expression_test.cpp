#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "law/parser.hpp"
#include "law/program.hpp"

namespace myo::law {
namespace {

constexpr int x = 0, v = 3, k = 6;  // numbers of variables

/// Names of a place, a velocity and a plain number.
struct Language {
    Expressions expressions;
    Names names;

    Language() {
        const auto vector = [&](int first, const char* unit) {
            return Quantity{
                Shape::vector,
                {expressions.variable(first), expressions.variable(first + 1), expressions.variable(first + 2)},
                unit_from_words(unit)};
        };
        names["x"] = vector(x, "m");
        names["v"] = vector(v, "m/s");
        names["k"] = {Shape::number, {expressions.variable(k), -1, -1}, Unit{}};
    }

    Quantity read(const std::string& text) {
        auto result = parsed(text, names, expressions);
        const auto* const error = std::get_if<ExpressionError>(&result);
        EXPECT_EQ(error, nullptr) << text << ": " << (error ? error->sentence : "");
        return error ? Quantity{Shape::number, {expressions.constant(NAN), -1, -1}, Unit{}}
                     : std::get<Quantity>(result);
    }
    double value(const std::string& text, const std::vector<double>& at = {}) {
        return run_once(Program(expressions, {read(text).node()}), at).front();
    }
    /// Column from 1 and sentence of the error.
    std::string error(const std::string& text) {
        const auto result = parsed(text, names, expressions);
        const auto* const error = std::get_if<ExpressionError>(&result);
        return error ? std::to_string(error->column + 1) + ": " + error->sentence : "";
    }
};

const std::vector<double> some_state{0.3, -0.2, 0.7, 1.1, 0.4, -0.6, 1.7};

TEST(Expression, FollowsTheRulesOfArithmetic) {
    Language l;
    EXPECT_DOUBLE_EQ(l.value("1 + 2 * 3 - 4 / 8"), 6.5);
    EXPECT_DOUBLE_EQ(l.value("-2^2"), -4.0);
    EXPECT_DOUBLE_EQ(l.value("2^-1 * 2^3^0.5"), 0.5 * std::pow(2.0, std::sqrt(3.0)));
    EXPECT_DOUBLE_EQ(l.value("(1 - 2) - (3 - 5)"), 1.0);
    EXPECT_DOUBLE_EQ(l.value("1.5e-3 * 2E2"), 0.3);
    EXPECT_TRUE(std::isnan(l.value("0.25 + log(-1)"))) << "no number is not another constant";
    EXPECT_DOUBLE_EQ(l.value("dot(x, cross(x, v))", some_state), 0.0);
    EXPECT_DOUBLE_EQ(l.value("norm([3, 0, 4])"), 5.0);
    EXPECT_DOUBLE_EQ(l.value("[k, 2, 3].x * x.z", some_state), 1.7 * 0.7);
    EXPECT_DOUBLE_EQ(l.value("if(k < 1 or not k < 2, 1, if(k >= 1 and k <= 2, 2, 3))", some_state), 2.0);
    EXPECT_DOUBLE_EQ(l.value("max(k, 1, 3) - min(k, 1, 3)", some_state), 2.0);
    EXPECT_DOUBLE_EQ(l.value("abs(-k) + step(k) + step(-k)", some_state), 2.7);
    EXPECT_DOUBLE_EQ(l.value("smooth_step(0.25)"), 0.103515625);
    EXPECT_DOUBLE_EQ(l.value("positive(k - 1, 0.5) + positive(-k, 1)", some_state), 0.7);
    EXPECT_DOUBLE_EQ(l.value("positive(0, 0.4)"), 0.4 * (2.5 / 16.0 - 3.0 / 32.0 + 1.0 / 64.0));
    EXPECT_DOUBLE_EQ(l.value("smooth_step(-1) + 2 * smooth_step(7)"), 2.0);
    EXPECT_DOUBLE_EQ(l.value("cos(pi)"), -1.0);
}

/// Fourth order, over a step that suits numbers of size one.
double difference(const Program& program, const std::vector<double>& at, std::size_t variable) {
    const auto shifted = [&](double by) {
        std::vector<double> there = at;
        there[variable] += by;
        return run_once(program, there).front();
    };
    const double h = 1e-3;
    return (8.0 * (shifted(h) - shifted(-h)) - (shifted(2.0 * h) - shifted(-2.0 * h))) / (12.0 * h);
}

class Derivative : public testing::TestWithParam<const char*> {};

TEST_P(Derivative, IsThatOfDifferencesToSecondOrder) {
    Language l;
    const Node value = l.read(GetParam()).node();
    const Program program(l.expressions, {value});
    double largest = 0.0, second = 0.0;
    bool differs = false;
    for (int i = 0; i < 7; ++i) {
        const auto variable = static_cast<std::size_t>(i);
        const Program slope(l.expressions, {l.expressions.derivative(value, i)});
        const double exact = run_once(slope, some_state).front(), near = difference(program, some_state, variable);
        EXPECT_NEAR(exact, near, 1e-9 * std::max(1.0, std::abs(exact))) << "by variable " << i;
        largest = std::max(largest, std::abs(exact));
        differs = differs || exact != near;
        for (int j = 0; j < 7; ++j) {
            const Node twice = l.expressions.derivative(l.expressions.derivative(value, i), j);
            const double curvature = run_once(Program(l.expressions, {twice}), some_state).front();
            EXPECT_NEAR(curvature, difference(slope, some_state, static_cast<std::size_t>(j)),
                        1e-8 * std::max(1.0, std::abs(curvature)));
            second = std::max(second, std::abs(curvature));
        }
    }
    EXPECT_GT(largest, 1e-3);
    EXPECT_TRUE(differs);
    EXPECT_GT(second, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(OfEveryFunction, Derivative,
                         testing::Values("k^3 * x.x", "x.x * k / (1 + k^2)", "sqrt(k + k^2)", "exp(k * 0.3)", "log(k)",
                                         "sin(k) * cos(k)", "tan(k * 0.3)", "tanh(k)", "atan(k)", "k^k", "2^k",
                                         "norm(x) * v.x", "dot(x, v)^2", "cross(x, v).y^2", "abs(k - 3)^1.5",
                                         "max(k, 1)^2 * min(k, 3)", "if(k > 1, k^2, 5)", "smooth_step(k / 3)",
                                         "positive(k - 1.6, 1) * k", "step(k) * k^2", "k^-1.5", "pow(k, 2.5)",
                                         "norm(v)^3 / (1[m2] + norm(x)^2)"));

/// As section 3 of the manual's page on laws says.
TEST(Expression, HasAtACornerTheSlopeOfTheBranchThatIsTakenThere) {
    Language l;
    const std::vector<std::pair<const char*, double>> slopes{{"abs(k)", 1.0},        {"max(k, 2 * k)", 1.0},
                                                             {"max(2 * k, k)", 2.0}, {"min(k, 2 * k)", 2.0},
                                                             {"min(2 * k, k)", 1.0}, {"if(k < 0, -k, 3 * k)", 3.0}};
    for (const auto& [text, slope] : slopes) {
        const Program derivative(l.expressions, {l.expressions.derivative(l.read(text).node(), k)});
        EXPECT_EQ(run_once(derivative, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}).front(), slope) << text;
    }
}

TEST(Expression, HasTheSlopeZeroOfALengthAtItsCorner) {
    Language l;
    const std::vector<double> at_rest{0.1, 0.2, 0.3, 0.0, 0.0, 0.0, 1.0};
    const Quantity drag = l.read("norm(v) * v");
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            EXPECT_EQ(run_once(Program(l.expressions,
                                       {l.expressions.derivative(drag.nodes[static_cast<std::size_t>(i)], v + j)}),
                               at_rest)
                          .front(),
                      0.0);
    EXPECT_DOUBLE_EQ(run_once(Program(l.expressions, {l.expressions.derivative(l.read("k^k").node(), k)}),
                              {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0})
                         .front(),
                     1.0);
}

/// A direction of no length is 0, and so is its slope: u / norm(u) at rest.
TEST(Expression, DividesByZeroWithoutHarm) {
    Language l;
    const std::vector<double> at_rest(7, 0.0);
    const Quantity direction = l.read("max(0, norm(x) - 1[m]) * x / norm(x)");
    for (const Node node : direction.nodes) {
        EXPECT_EQ(run_once(Program(l.expressions, {node}), at_rest).front(), 0.0);
        for (int j = 0; j < 3; ++j)
            EXPECT_EQ(run_once(Program(l.expressions, {l.expressions.derivative(node, x + j)}), at_rest).front(), 0.0);
    }
    EXPECT_EQ(l.value("k^-1", at_rest), 0.0);
}

TEST(Expression, SharesEqualTerms) {
    Language l;
    EXPECT_EQ(l.read("k * x.x + 1[m]").node(), l.read("1[m] + x.x * k").node());
    EXPECT_EQ(l.read("0 * k + x.x * 1").node(), l.read("x.x").node());
    EXPECT_EQ(l.read("-(-k)").node(), l.read("k").node());
    EXPECT_EQ(l.expressions.derivative(l.read("x.x * 3").node(), k), l.expressions.constant(0.0));
}

TEST(Expression, RunsEightPlacesAtOnce) {
    Language l;
    const Program program(l.expressions, {l.read("k * exp(k) - 1").node()});
    Program::Registers registers = program.registers();
    Lanes* const lanes = program.input(registers, k);
    ASSERT_NE(lanes, nullptr);
    EXPECT_EQ(program.input(registers, x), nullptr);
    EXPECT_TRUE(program.uses(k));
    EXPECT_FALSE(program.uses(v));
    for (std::size_t i = 0; i < lanes->size(); ++i) (*lanes)[i] = 0.1 * static_cast<double>(i);
    program.run(registers);
    for (std::size_t i = 0; i < lanes->size(); ++i) {
        const double at = 0.1 * static_cast<double>(i);
        EXPECT_DOUBLE_EQ(program.output(registers, 0)[i], at * std::exp(at) - 1.0);
    }
}

TEST(Expression, KnowsUnits) {
    Language l;
    const auto unit = [&](const char* text) { return to_string(*l.read(text).unit); };
    EXPECT_EQ(unit("x.x / norm(v)"), "s");
    EXPECT_EQ(unit("1000[kg/m3] * norm(v)^2"), "kg/m s2");
    EXPECT_EQ(unit("sqrt(dot(x, x)) + 0"), "m");
    EXPECT_EQ(unit("max(0, x.z)"), "m");
    EXPECT_EQ(unit("if(k < 1, 0, x.z)"), "m");
    EXPECT_EQ(unit("k + 3"), "1");
    EXPECT_EQ(unit("2[N/m] * x.x - 1[N]"), "m kg/s2");
    EXPECT_EQ(unit("[0, x.y, 0]"), "m") << "a component of 0 fits every unit";
    EXPECT_EQ(unit("[0, 0, x.y]"), "m");
    EXPECT_EQ(unit("[0, 0, 0]"), "1");
}

TEST(Expression, SaysWhatIsWrongAndWhere) {
    Language l;
    EXPECT_EQ(l.error("k + "), "5: the expression ends too early: a number or a name is missing");
    EXPECT_EQ(l.error("k * (1 + 2"), "11: \")\" is missing after the part in parentheses");
    EXPECT_EQ(l.error("k $ 2"), "3: \"$\" has no meaning in an expression");
    EXPECT_EQ(l.error("2 k"), "3: \"k\" cannot stand here: an operator or the end is expected");
    EXPECT_EQ(l.error("kk + q2"), "1: \"kk\" is not known here; the closest name is k");
    EXPECT_EQ(l.error("1 + sinn(k)"), "5: no function sinn() is known; the closest one is sin()");
    EXPECT_EQ(l.error("sin(k, 2)"), "1: sin() takes 1 argument, not 2");
    EXPECT_EQ(l.error("sin(x.x)"), "1: what sin() is given must be a plain number, but has the unit m");
    EXPECT_EQ(l.error("norm(k)"), "1: what norm() is given must be a vector, not a number");
    EXPECT_EQ(l.error("x + k"), "3: \"+\" needs two numbers or two vectors, not a vector and a number");
    EXPECT_EQ(l.error("1 + x.x"),
              "3: the units of the two sides of \"+\" differ: 1 and m; a number with a unit is written 0.3[m]");
    EXPECT_EQ(l.error("x * v"), "3: the product of two vectors is written dot(a, b) or cross(a, b)");
    EXPECT_EQ(l.error("x.w"), "3: a vector has the components .x, .y and .z, not .w");
    EXPECT_EQ(l.error("k == 2"), "3: numbers that vary are never equal: compare by <, <=, > or >=");
    EXPECT_EQ(l.error("if(k, 1, 2)"), "1: the first argument of if() must be a condition, not a number");
    EXPECT_EQ(l.error("3[mm]"),
              "3: \"mm\" is not a unit; SI units without prefixes are known, such as N/m or kg/m3, and rad for angles");
    EXPECT_EQ(l.error("[0, 1[m], 2[s]]"),
              "1: the units of the two sides of a comma differ: m and s; a number with a unit is written 0.3[m]");
    EXPECT_EQ(l.error("[1, 2]"), "1: a vector has three components, not 2");
    EXPECT_NE(l.error("x.x^k").find("cannot be raised to a power that is no written number"), std::string::npos);
    EXPECT_NE(l.error(std::string(5000, '(')).find("nested too deeply"), std::string::npos);
    EXPECT_NE(l.error(""), "");
}

TEST(Unit, IsReadFromNamesAsTheCatalogueWritesThem) {
    for (const auto& [name, words] : std::vector<std::pair<std::string, std::string>>{{"coefficient_kg_m3", "kg/m3"},
                                                                                      {"coefficient_Pa_s_m", "Pa s/m"},
                                                                                      {"stiffness_N_per_m", "N/m"},
                                                                                      {"stiffness_Pa_per_m", "Pa/m"},
                                                                                      {"time_constant_s", "s"},
                                                                                      {"rate_per_s", "1/s"},
                                                                                      {"rate_1_s", "1/s"},
                                                                                      {"k_1_m2", "1/m2"},
                                                                                      {"modulus_ratio", ""},
                                                                                      {"exponent", ""},
                                                                                      {"tilt_deg", "deg"},
                                                                                      {"speed_m_s", "m/s"},
                                                                                      {"viscosity_Pa_s", "Pa s"},
                                                                                      {"foundation_Pa_m", "Pa/m"},
                                                                                      {"energy_J_m2", "J/m2"},
                                                                                      {"leak_kg_s", "kg/s"},
                                                                                      {"impulse_N_s", "N s"},
                                                                                      {"damping_N_s_m", "N s/m"},
                                                                                      {"force_N_per_m3", "N/m3"},
                                                                                      {"damping_N_s_per_m", "N s/m"},
                                                                                      {"m", ""}})
        EXPECT_EQ(unit_of_name(name), words) << name;
    EXPECT_EQ(unit_from_words("N/m"), unit_from_words("kg/s2"));
    EXPECT_EQ(unit_from_words("Pa s/m"), unit_from_words("N s/m3"));
    EXPECT_EQ(unit_from_words("m^2"), unit_from_words("m2"));
    EXPECT_FALSE(unit_from_words("mm"));
    EXPECT_FALSE(unit_from_words("deg"));  // sines take rad
    EXPECT_EQ(prefixed_ending("gap_mm"), "mm");
    EXPECT_EQ(prefixed_ending("gap_m"), "");
    EXPECT_TRUE(unit_from_words("")->is_plain());
}

}  // namespace
}  // namespace myo::law
