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
    // Operands, stored before this term; -1: the operation has fewer.
    Node a = -1, b = -1, c = -1;
    double value = 0.0;  // of a constant
    int variable = -1;   // number of a variable
};

/// Terms of scalar expressions. Equal terms are stored once, and constant ones are computed, so that expressions made
/// by differentiation stay short.
/// Directed acyclic graph of scalar expressions, as for symbolic differentiation; a Node is an index into its terms,
/// which are never removed, so that nodes stay valid.
class Expressions {
public:
    /// The term with this value; zero has no sign, so that 0 and -0 are one term.
    Node constant(double value);
    /// @param number  chosen by the caller; a value per number is given when a program runs
    Node variable(int number);
    /// The term of an operation on nodes of this object, simplified where a rule is known (x + 0, x * 1, constants).
    ///
    /// @param operation  neither constant nor variable (asserted)
    /// @param b, c       -1 where the operation has fewer operands
    Node make(Operation operation, Node a, Node b = -1, Node c = -1);

    Node add(Node a, Node b) { return make(Operation::add, a, b); }
    Node subtract(Node a, Node b) { return make(Operation::subtract, a, b); }
    Node multiply(Node a, Node b) { return make(Operation::multiply, a, b); }

    /// Exact derivative by a variable, as a term.
    ///
    /// At a corner the slope is that of the branch which is evaluated there: the upper side for abs(), of equal
    /// arguments the first for max() and the last for min(). A root at 0, a condition and a jump have the slope 0.
    Node derivative(Node of, int variable);

    /// Reference to a term; not valid once a term is added.
    const Term& term(Node node) const { return terms_[static_cast<std::size_t>(node)]; }
    std::size_t size() const { return terms_.size(); }

private:
    bool is_constant(Node node, double value) const;
    bool is_constant(Node node) const { return term(node).operation == Operation::constant; }
    /// Equal expression that needs no term of its own; -1: none is known.
    Node simpler(Operation operation, Node a, Node b, Node c);
    /// Rules of add and subtract, and of multiply, divide and ratio; -1 as above.
    Node simpler_sum(Operation operation, Node a, Node b);
    Node simpler_product(Operation operation, Node a, Node b);
    /// The node of a term, appended only if no equal one is known.
    Node stored(const Term& term);
    /// Derivative of a term by the chain rule, from the derivatives of its operands.
    Node chain(Node of, int variable);
    Node power_rule(const Term& term, Node da, Node db);

    std::vector<Term> terms_;
    // Term by all of its members: an equal one is found in O(log n).
    std::map<std::tuple<int, Node, Node, Node, double, int>, Node> known_;
    // Derivatives computed so far: without them the cost of shared parts would grow exponentially with depth.
    std::map<std::pair<Node, int>, Node> derivatives_;
};

/// Value of one operation on doubles. Conditions are true where they are not 0, and give 1 or 0.
///
/// @param a  the value itself for constant and variable
/// @param b, c  ignored by operations of fewer operands
/// Errors: none. Invalid arguments (log of a negative number) give NaN or infinity as <cmath> does.
double evaluated(Operation operation, double a, double b, double c);

}  // namespace myo::law
