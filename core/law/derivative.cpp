#include "law/expressions.hpp"

namespace myo::law {

Node Expressions::derivative(Node of, int variable) {
    const auto key = std::pair{of, variable};
    if (const auto known = derivatives_.find(key); known != derivatives_.end()) return known->second;
    const Node result = chain(of, variable);
    derivatives_.emplace(key, result);
    return result;
}

/// d(a^b) = b a^(b-1) da + a^b ln(a) db; the second term is 0 where a is not positive.
Node Expressions::power_rule(const Term& term, Node da, Node db) {
    const Node a = term.a, b = term.b;
    const Node of_base = multiply(multiply(b, make(Operation::power, a, subtract(b, constant(1.0)))), da);
    if (is_constant(db, 0.0)) return of_base;
    // The inner choice gives log an argument of 1 where a <= 0: both branches of a choice are evaluated, and a NaN in
    // the one not taken would survive in later products.
    const Node positive = make(Operation::less, constant(0.0), a);
    const Node log = make(Operation::choose, positive,
                          make(Operation::logarithm, make(Operation::choose, positive, a, constant(1.0))),
                          constant(0.0));
    return add(of_base, multiply(multiply(make(Operation::power, a, b), log), db));
}

Node Expressions::chain(Node of, int variable) {
    // A copy: terms are appended below.
    const Term t = term(of);
    if (t.operation == Operation::constant) return constant(0.0);
    if (t.operation == Operation::variable) return constant(t.variable == variable ? 1.0 : 0.0);
    const int count = operands_of(t.operation);
    // The first operand of a choice is a condition: its slope is 0 and would never be used.
    const bool is_choice = t.operation == Operation::choose;
    const Node da = is_choice ? -1 : derivative(t.a, variable), db = count > 1 ? derivative(t.b, variable) : -1,
               dc = count > 2 ? derivative(t.c, variable) : -1;
    const auto one = [&] { return constant(1.0); };
    // d(a / b) = (da - (a / b) db) / b; the value a / b is the term itself.
    const auto quotient = [&](Operation operation) { return make(operation, subtract(da, multiply(of, db)), t.b); };
    switch (t.operation) {
        case Operation::add: return add(da, db);
        case Operation::subtract: return subtract(da, db);
        case Operation::multiply: return add(multiply(da, t.b), multiply(t.a, db));
        case Operation::divide: return quotient(Operation::divide);
        case Operation::ratio: return quotient(Operation::ratio);
        case Operation::negate: return make(Operation::negate, da);
        case Operation::power: return power_rule(t, da, db);
        // The quotient that is 0 at 0 keeps the slope of norm(u) finite at u = 0.
        case Operation::square_root: return multiply(make(Operation::ratio, constant(0.5), of), da);
        case Operation::exponential: return multiply(of, da);
        case Operation::logarithm: return make(Operation::divide, da, t.a);
        case Operation::sine: return multiply(make(Operation::cosine, t.a), da);
        case Operation::cosine: return make(Operation::negate, multiply(make(Operation::sine, t.a), da));
        case Operation::tangent: return multiply(add(one(), multiply(of, of)), da);
        case Operation::hyperbolic_tangent: return multiply(subtract(one(), multiply(of, of)), da);
        case Operation::arc_tangent: return make(Operation::divide, da, add(one(), multiply(t.a, t.a)));
        case Operation::choose: return make(Operation::choose, t.a, db, dc);
        default: return constant(0.0);  // conditions are constant but for jumps
    }
}

}  // namespace myo::law
