#pragma once

#include <cstddef>
#include <map>
#include <tuple>
#include <vector>

namespace myo::law {

/// Operations of an expression. Conditions are numbers: 1 true, 0 false.
enum class Operation {
    constant,
    variable,
    add,
    subtract,
    multiply,
    divide,
    ratio,  // a / b, and 0 where b is 0: directions of no length, slopes of lengths at their corner
    negate,
    power,
    square_root,
    exponential,
    logarithm,
    sine,
    cosine,
    tangent,
    hyperbolic_tangent,
    arc_tangent,
    less,      // a < b
    at_most,   // a <= b
    both,      // a and b
    either,    // a or b
    opposite,  // not a
    choose,    // a ? b : c
};

/// Number of operands.
int operands_of(Operation operation);

/// Index of a term in Expressions.
using Node = int;

/// An operation on earlier terms.
struct Term {
    Operation operation = Operation::constant;
    Node a = -1, b = -1, c = -1;
    double value = 0.0;  // of a constant
    int variable = -1;   // number of a variable
};

/// Terms of scalar expressions. Equal terms are stored once, and constant ones are computed, so that expressions made
/// by differentiation stay short.
class Expressions {
public:
    Node constant(double value);
    /// @param number  chosen by the caller; a value per number is given when a program runs
    Node variable(int number);
    Node make(Operation operation, Node a, Node b = -1, Node c = -1);

    Node add(Node a, Node b) { return make(Operation::add, a, b); }
    Node subtract(Node a, Node b) { return make(Operation::subtract, a, b); }
    Node multiply(Node a, Node b) { return make(Operation::multiply, a, b); }

    /// Exact derivative by a variable. A corner has the slope of its upper side; a root at 0 has the slope 0.
    Node derivative(Node of, int variable);

    const Term& term(Node node) const { return terms_[static_cast<std::size_t>(node)]; }
    std::size_t size() const { return terms_.size(); }

private:
    bool is_constant(Node node, double value) const;
    bool is_constant(Node node) const { return term(node).operation == Operation::constant; }
    /// Equal expression that needs no term of its own; -1: none is known.
    Node simpler(Operation operation, Node a, Node b, Node c);
    Node simpler_sum(Operation operation, Node a, Node b);
    Node simpler_product(Operation operation, Node a, Node b);
    Node stored(const Term& term);
    Node chain(Node of, int variable);
    Node power_rule(const Term& term, Node da, Node db);

    std::vector<Term> terms_;
    std::map<std::tuple<int, Node, Node, Node, double, int>, Node> known_;
    std::map<std::pair<Node, int>, Node> derivatives_;
};

/// Value of one operation on doubles.
double evaluated(Operation operation, double a, double b, double c);

}  // namespace myo::law
