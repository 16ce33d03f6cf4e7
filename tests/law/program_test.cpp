#include "law/program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

// Terms that are simplified keep their values, and programs compute what the operations say.

namespace myo::law::program_test {
namespace {

using ::testing::ElementsAre;

constexpr double infinite = std::numeric_limits<double>::infinity();
const double none = std::nan("");

/// Every operation on operands.
std::vector<Operation> operations() {
    std::vector<Operation> all;
    for (int i = static_cast<int>(Operation::add); i <= static_cast<int>(Operation::choose); ++i)
        all.push_back(static_cast<Operation>(i));
    return all;
}

/// Equal to rounding; infinite values and those that are no number have to be the same.
bool alike(double a, double b) {
    if (!std::isfinite(a) || !std::isfinite(b)) return a == b || (std::isnan(a) && std::isnan(b));
    return std::abs(a - b) <= 4e-16 * (std::abs(a) + std::abs(b));
}

/// Value of a node with variable i at the entry i.
double value_of(const Expressions& expressions, Node node, const std::vector<double>& at) {
    return run_once(Program(expressions, {node}), at).front();
}

/// The loops for frequent operations against the operation itself, also where arguments are no ordinary numbers.
TEST(LawProgram, ComputesEveryOperationInEveryLane) {
    const std::vector<std::array<double, 3>> arguments{{0.7, 1.9, -0.4},  {-2.5, 0.5, 3.0},      {0.0, -1.0, 0.0},
                                                       {1.0, 0.0, 2.0},   {0.0, 0.0, 1.0},       {infinite, 2.0, none},
                                                       {none, 1.0, -7.0}, {3.0, -infinite, none}};
    ASSERT_EQ(arguments.size(), lane_count);
    for (const Operation operation : operations()) {
        Expressions expressions;
        const int count = operands_of(operation);
        const Node a = expressions.variable(0), b = expressions.variable(1), c = expressions.variable(2);
        const Program program(expressions, {expressions.make(operation, a, count > 1 ? b : -1, count > 2 ? c : -1)});
        Program::Registers registers = program.registers();
        for (int i = 0; i < 3; ++i)
            if (Lanes* const lanes = program.input(registers, i))
                for (std::size_t l = 0; l < lane_count; ++l) (*lanes)[l] = arguments[l][static_cast<std::size_t>(i)];
        program.run(registers);
        for (std::size_t l = 0; l < lane_count; ++l) {
            const double expected = evaluated(operation, arguments[l][0], arguments[l][1], arguments[l][2]);
            EXPECT_TRUE(alike(program.output(registers, 0)[l], expected))
                << static_cast<int>(operation) << " lane " << l << ": " << program.output(registers, 0)[l] << " not "
                << expected;
        }
        EXPECT_TRUE(program.uses(0));
        EXPECT_EQ(program.uses(1), count > 1);
        EXPECT_EQ(program.uses(2), count > 2);
        EXPECT_FALSE(program.uses(1000));
    }
}

/// With each special constant on each side, at several values of the other one.
TEST(LawExpressions, KeepTheirValueWhenTheyAreSimplified) {
    for (const Operation operation : operations()) {
        if (operands_of(operation) != 2) continue;
        for (const double constant : {0.0, 1.0, -1.0, 2.0, 3.0, 0.5, -2.0})
            for (const double at : {-1.7, -1.0, 0.3, 1.0, 2.6}) {
                Expressions expressions;
                // Operands of sums and products are sorted by the order of storage.
                if (at > 0.0) expressions.constant(constant);
                const Node variable = expressions.variable(0), fixed = expressions.constant(constant),
                           first = expressions.make(operation, fixed, variable),
                           last = expressions.make(operation, variable, fixed);
                const double expected_first = evaluated(operation, constant, at, 0.0),
                             expected_last = evaluated(operation, at, constant, 0.0);
                EXPECT_TRUE(alike(value_of(expressions, first, {at}), expected_first))
                    << static_cast<int>(operation) << ": " << constant << ", " << at;
                EXPECT_TRUE(alike(value_of(expressions, last, {at}), expected_last))
                    << static_cast<int>(operation) << ": " << at << ", " << constant;
            }
    }
}

/// Signs are moved outwards: every combination of negated operands.
TEST(LawExpressions, KeepTheirSignsWhenTheyAreMovedOutwards) {
    for (const Operation operation :
         {Operation::add, Operation::subtract, Operation::multiply, Operation::divide, Operation::ratio})
        for (int bits = 0; bits < 8; ++bits) {
            Expressions expressions;
            const auto signed_by = [&](bool negative, Node node) {
                return negative ? expressions.make(Operation::negate, node) : node;
            };
            // In both orders of storage, by which operands of sums and products are sorted.
            const Node early = expressions.variable(0), late = expressions.variable(1);
            const bool turned = (bits & 4) != 0;
            const Node a = signed_by((bits & 1) != 0, turned ? late : early),
                       b = signed_by((bits & 2) != 0, turned ? early : late);
            const double of_a = ((bits & 1) != 0 ? -1.0 : 1.0) * (turned ? 0.7 : 3.0),
                         of_b = ((bits & 2) != 0 ? -1.0 : 1.0) * (turned ? 3.0 : 0.7);
            EXPECT_TRUE(alike(value_of(expressions, expressions.make(operation, a, b), {3.0, 0.7}),
                              evaluated(operation, of_a, of_b, 0.0)))
                << static_cast<int>(operation) << " " << bits;
        }
}

TEST(LawExpressions, StoreEqualTermsOnceAndNoOthers) {
    Expressions e;
    const Node a = e.variable(0), b = e.variable(1), c = e.variable(2), zero = e.constant(0.0);
    EXPECT_EQ(e.constant(-0.0), zero);
    EXPECT_FALSE(std::signbit(e.term(zero).value));
    EXPECT_EQ(e.add(a, b), e.add(b, a));
    EXPECT_NE(e.subtract(a, b), e.subtract(b, a));
    EXPECT_NE(e.make(Operation::divide, a, b), e.make(Operation::ratio, a, b)) << "they differ at 0";
    EXPECT_NE(e.make(Operation::less, a, b), e.make(Operation::at_most, a, b));
    EXPECT_EQ(e.subtract(c, c), zero);
    EXPECT_EQ(e.make(Operation::choose, a, b, b), b);
    EXPECT_EQ(e.make(Operation::choose, e.constant(2.0), b, c), b) << "all but 0 is true";
    EXPECT_EQ(e.make(Operation::choose, zero, b, c), c);
    // A constant that is no number keeps its operation, which is found again.
    const Node logarithm = e.make(Operation::logarithm, e.constant(-1.0));
    EXPECT_EQ(e.term(logarithm).operation, Operation::logarithm);
    const std::size_t size = e.size();
    EXPECT_EQ(e.make(Operation::logarithm, e.constant(-1.0)), logarithm);
    EXPECT_EQ(e.size(), size);
}

/// The 20th square of a square: one derivative per term, though it occurs a million times in the expression.
TEST(LawExpressions, DifferentiateSharedTermsOnce) {
    Expressions e;
    const Node start = e.variable(0);
    Node square = start;
    for (int i = 0; i < 20; ++i) square = e.multiply(square, square);
    const Node slope = e.derivative(square, 0);
    EXPECT_LT(e.size(), 150u);
    EXPECT_EQ(value_of(e, slope, {1.0}), std::pow(2.0, 20));
    EXPECT_EQ(e.derivative(square, 1), e.constant(0.0));
}

/// A power of a number that is not positive has no slope over its exponent, and none that is NaN over its base.
TEST(LawExpressions, HaveSlopesOfPowersWithoutLogarithmsBelowZero) {
    Expressions e;
    const Node power = e.make(Operation::power, e.variable(0), e.variable(1));
    const Node by_base = e.derivative(power, 0), by_exponent = e.derivative(power, 1);
    EXPECT_EQ(value_of(e, by_base, {-2.0, 3.0}), 12.0);
    EXPECT_EQ(value_of(e, by_exponent, {-2.0, 3.0}), 0.0);
    EXPECT_EQ(value_of(e, by_base, {0.0, 2.0}), 0.0);
    EXPECT_EQ(value_of(e, by_exponent, {0.0, 2.0}), 0.0);
    EXPECT_DOUBLE_EQ(value_of(e, by_exponent, {2.0, 3.0}), 8.0 * std::log(2.0));
    EXPECT_EQ(value_of(e, e.derivative(e.make(Operation::square_root, e.variable(0)), 0), {0.0}), 0.0);
}

TEST(LawProgram, KeepsInputsBetweenRunsAndRepeatsOutputs) {
    Expressions e;
    const Node sum = e.add(e.variable(0), e.variable(4)), two = e.constant(2.0);
    const Program program(e, {sum, two, e.variable(4), sum});
    EXPECT_EQ(program.output_count(), 4u);
    Program::Registers registers = program.registers(), other = program.registers();
    program.input(registers, 0)->fill(5.0);
    program.run(registers);
    EXPECT_EQ(program.output(registers, 0)[7], 5.0) << "a variable that is not set is 0";
    program.input(registers, 4)->fill(-1.0);
    program.run(registers);
    for (const auto& [output, expected] :
         std::vector<std::pair<std::size_t, double>>{{0, 4.0}, {1, 2.0}, {2, -1.0}, {3, 4.0}})
        EXPECT_EQ(program.output(registers, output)[0], expected) << output;
    program.run(other);
    EXPECT_EQ(program.output(other, 0)[0], 0.0) << "each run has registers of its own";
    EXPECT_EQ(program.input(registers, 2), nullptr);
    EXPECT_THAT(run_once(program, {1.0, 9.0, 9.0, 9.0, 2.0, 9.0}), ElementsAre(3.0, 2.0, 2.0, 3.0));
    EXPECT_THAT(run_once(program, {1.0}), ElementsAre(1.0, 2.0, 0.0, 1.0));
    EXPECT_TRUE(run_once(Program(), {1.0}).empty());
    EXPECT_TRUE(run_once(Program(e, {}), {1.0}).empty());
}

}  // namespace
}  // namespace myo::law::program_test
