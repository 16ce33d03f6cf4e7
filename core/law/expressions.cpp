#include "law/expressions.hpp"

#include <cassert>
#include <cmath>

namespace myo::law {

int operands_of(Operation operation) {
    switch (operation) {
        case Operation::constant:
        case Operation::variable: return 0;
        case Operation::negate:
        case Operation::square_root:
        case Operation::exponential:
        case Operation::logarithm:
        case Operation::sine:
        case Operation::cosine:
        case Operation::tangent:
        case Operation::hyperbolic_tangent:
        case Operation::arc_tangent:
        case Operation::opposite: return 1;
        case Operation::choose: return 3;
        default: return 2;
    }
}

double evaluated(Operation operation, double a, double b, double c) {
    switch (operation) {
        case Operation::constant:
        case Operation::variable: return a;
        case Operation::add: return a + b;
        case Operation::subtract: return a - b;
        case Operation::multiply: return a * b;
        case Operation::divide: return a / b;
        case Operation::ratio: return b == 0.0 ? 0.0 : a / b;
        case Operation::negate: return -a;
        case Operation::power: return std::pow(a, b);
        case Operation::square_root: return std::sqrt(a);
        case Operation::exponential: return std::exp(a);
        case Operation::logarithm: return std::log(a);
        case Operation::sine: return std::sin(a);
        case Operation::cosine: return std::cos(a);
        case Operation::tangent: return std::tan(a);
        case Operation::hyperbolic_tangent: return std::tanh(a);
        case Operation::arc_tangent: return std::atan(a);
        case Operation::less: return a < b ? 1.0 : 0.0;
        case Operation::at_most: return a <= b ? 1.0 : 0.0;
        case Operation::both: return a != 0.0 && b != 0.0 ? 1.0 : 0.0;
        case Operation::either: return a != 0.0 || b != 0.0 ? 1.0 : 0.0;
        case Operation::opposite: return a == 0.0 ? 1.0 : 0.0;
        case Operation::choose: return a != 0.0 ? b : c;
    }
    return 0.0;
}

Node Expressions::stored(const Term& term) {
    // Terms are equal if all of their members are: the operands are indices of terms that are stored once.
    const auto key = std::tuple{static_cast<int>(term.operation), term.a, term.b, term.c, term.value, term.variable};
    const auto [place, is_new] = known_.try_emplace(key, static_cast<Node>(terms_.size()));
    if (is_new) terms_.push_back(term);
    return place->second;
}

Node Expressions::constant(double value) {
    Term term;
    term.value = value == 0.0 ? 0.0 : value;  // one zero, without a sign
    return stored(term);
}

Node Expressions::variable(int number) {
    Term term;
    term.operation = Operation::variable;
    term.variable = number;
    return stored(term);
}

bool Expressions::is_constant(Node node, double value) const { return is_constant(node) && term(node).value == value; }

Node Expressions::simpler_sum(Operation operation, Node a, Node b) {
    // Signs are moved outwards, so that a - (-b) and a + b become one term.
    if (is_constant(b, 0.0)) return a;
    if (operation == Operation::subtract) {
        if (a == b) return constant(0.0);
        if (is_constant(a, 0.0)) return make(Operation::negate, b);
        if (term(b).operation == Operation::negate) return add(a, term(b).a);
        return -1;
    }
    if (is_constant(a, 0.0)) return b;
    if (term(b).operation == Operation::negate) return subtract(a, term(b).a);
    if (term(a).operation == Operation::negate) return subtract(b, term(a).a);
    return -1;
}

Node Expressions::simpler_product(Operation operation, Node a, Node b) {
    // The 0 wins over a factor or divisor that might be infinite or 0: a term vanishes with its factor.
    if (is_constant(a, 0.0)) return a;
    if (is_constant(b, 1.0)) return a;
    if (is_constant(b, -1.0)) return make(Operation::negate, a);
    if (term(a).operation == Operation::negate) return make(Operation::negate, make(operation, term(a).a, b));
    if (term(b).operation == Operation::negate) return make(Operation::negate, make(operation, a, term(b).a));
    if (operation != Operation::multiply) return -1;
    if (is_constant(b, 0.0)) return b;
    if (is_constant(a, 1.0)) return b;
    if (is_constant(a, -1.0)) return make(Operation::negate, b);
    // A condition has no slope, so that a product of two choices need not be simplified further.
    return -1;
}

Node Expressions::simpler(Operation operation, Node a, Node b, Node c) {
    // Rules for all operations: an operation on constants is its value.
    const int count = operands_of(operation);
    const bool all = is_constant(a) && (count < 2 || is_constant(b)) && (count < 3 || is_constant(c));
    if (all) {
        const double value = evaluated(operation, term(a).value, count > 1 ? term(b).value : 0.0,
                                       count > 2 ? term(c).value : 0.0);
        // NaN has no place in the order by which equal terms are found; its operation stays.
        if (!std::isnan(value)) return constant(value);
    }
    switch (operation) {
        case Operation::add:
        case Operation::subtract: return simpler_sum(operation, a, b);
        case Operation::multiply:
        case Operation::divide:
        case Operation::ratio: return simpler_product(operation, a, b);
        case Operation::negate: return term(a).operation == Operation::negate ? term(a).a : -1;
        case Operation::power:
            // Small exponents become products, which the program computes eight at a time without calling pow().
            if (is_constant(b, 0.0)) return constant(1.0);
            if (is_constant(b, 1.0)) return a;
            if (is_constant(b, 2.0)) return multiply(a, a);
            if (is_constant(b, 3.0)) return multiply(a, multiply(a, a));
            if (is_constant(b, 0.5)) return make(Operation::square_root, a);
            if (is_constant(b, -1.0)) return make(Operation::ratio, constant(1.0), a);
            return -1;
        case Operation::choose:
            if (is_constant(a)) return term(a).value != 0.0 ? b : c;
            return b == c ? b : -1;
        default: return -1;
    }
}

Node Expressions::make(Operation operation, Node a, Node b, Node c) {
    assert(operands_of(operation) > 0 && a >= 0);
    // One order of the operands, so that a + b and b + a are one term.
    if ((operation == Operation::add || operation == Operation::multiply) && a > b) std::swap(a, b);
    if (const Node known = simpler(operation, a, b, c); known >= 0) return known;
    Term term;
    term.operation = operation;
    term.a = a;
    term.b = b;
    term.c = c;
    return stored(term);
}

}  // namespace myo::law
