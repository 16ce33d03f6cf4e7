#include "law/quantities.hpp"

#include <algorithm>

namespace myo::law {

const char* to_string(Shape shape) {
    switch (shape) {
        case Shape::number: return "a number";
        case Shape::vector: return "a vector";
        case Shape::condition: return "a condition";
    }
    return "";
}

bool is_zero(const Quantity& a, const Expressions& expressions) {
    if (a.shape == Shape::condition) return false;
    const std::ptrdiff_t count = a.shape == Shape::vector ? 3 : 1;
    return std::all_of(a.nodes.begin(), a.nodes.begin() + count, [&](Node node) {
        const Term& term = expressions.term(node);
        return term.operation == Operation::constant && term.value == 0.0;
    });
}

namespace {

/// Unit of a product or quotient; unknown if one of its units is.
std::optional<Unit> both_known(const Quantity& a, const Quantity& b, Unit (*combined)(const Unit&, const Unit&)) {
    if (!a.unit || !b.unit) return std::nullopt;
    return combined(*a.unit, *b.unit);
}

Unit times(const Unit& a, const Unit& b) { return a * b; }
Unit over(const Unit& a, const Unit& b) { return a / b; }

}  // namespace

Quantity Quantities::number(double value, const std::optional<Unit>& unit) { return of(e_.constant(value), unit); }

void Quantities::need(const Quantity& a, Shape shape, const std::string& what, std::size_t column) const {
    if (a.shape != shape)
        throw ExpressionError{column, what + " must be " + to_string(shape) + ", not " + to_string(a.shape)};
}

void Quantities::need_plain(const Quantity& a, const std::string& what, std::size_t column) const {
    if (a.unit && !a.unit->is_plain() && !is_zero(a, e_))
        throw ExpressionError{column, what + " must be a plain number, but has the unit " + to_string(*a.unit)};
}

std::optional<Unit> Quantities::common_unit(const Quantity& a, const Quantity& b, const std::string& what,
                                            std::size_t column) const {
    // The order matters: a 0 takes the unit of the other side, and only then an unknown unit takes the known one.
    if (is_zero(a, e_)) return b.unit;
    if (is_zero(b, e_) || !b.unit) return a.unit;
    if (!a.unit) return b.unit;
    if (*a.unit == *b.unit) return a.unit;
    throw ExpressionError{column, "the units of the two sides of " + what + " differ: " + to_string(*a.unit) + " and " +
                                      to_string(*b.unit) + "; a number with a unit is written 0.3[m]"};
}

Quantity Quantities::sum(Operation operation, const Quantity& a, const Quantity& b, std::size_t column) {
    const std::string sign = operation == Operation::add ? "+" : "-";
    if (a.shape != b.shape || a.shape == Shape::condition)
        throw ExpressionError{column, "\"" + sign + "\" needs two numbers or two vectors, not " + to_string(a.shape) +
                                          " and " + to_string(b.shape)};
    Quantity result{a.shape, {-1, -1, -1}, common_unit(a, b, "\"" + sign + "\"", column)};
    for (std::size_t i = 0; i < (a.shape == Shape::vector ? 3u : 1u); ++i)
        result.nodes[i] = e_.make(operation, a.nodes[i], b.nodes[i]);
    return result;
}

Quantity Quantities::negative(const Quantity& a, std::size_t column) {
    if (a.shape == Shape::condition) throw ExpressionError{column, "\"-\" needs a number or a vector"};
    Quantity result = a;
    for (std::size_t i = 0; i < (a.shape == Shape::vector ? 3u : 1u); ++i)
        result.nodes[i] = e_.make(Operation::negate, a.nodes[i]);
    return result;
}

Quantity Quantities::product(const Quantity& a, const Quantity& b, std::size_t column) {
    if (a.shape == Shape::condition || b.shape == Shape::condition)
        throw ExpressionError{column, "a condition cannot be multiplied; write if(condition, value, 0)"};
    if (a.shape == Shape::vector && b.shape == Shape::vector)
        throw ExpressionError{column, "the product of two vectors is written dot(a, b) or cross(a, b)"};
    // Scaling is commutative: the vector, if there is one, is `other`.
    const Quantity &scale = a.shape == Shape::vector ? b : a, &other = a.shape == Shape::vector ? a : b;
    Quantity result{other.shape, {-1, -1, -1}, both_known(a, b, times)};
    for (std::size_t i = 0; i < (other.shape == Shape::vector ? 3u : 1u); ++i)
        result.nodes[i] = e_.multiply(scale.node(), other.nodes[i]);
    return result;
}

Quantity Quantities::quotient(const Quantity& a, const Quantity& b, std::size_t column) {
    if (a.shape == Shape::condition || b.shape != Shape::number)
        throw ExpressionError{column, "\"/\" divides a number or a vector by a number"};
    Quantity result{a.shape, {-1, -1, -1}, both_known(a, b, over)};
    for (std::size_t i = 0; i < (a.shape == Shape::vector ? 3u : 1u); ++i)
        result.nodes[i] = e_.make(Operation::ratio, a.nodes[i], b.node());
    return result;
}

Quantity Quantities::power(const Quantity& a, const Quantity& b, std::size_t column) {
    need(a, Shape::number, "what is raised to a power", column);
    need(b, Shape::number, "the exponent", column);
    need_plain(b, "the exponent", column);
    std::optional<Unit> unit = a.unit;
    // The unit of x^n depends on the value of n, so that n must be a constant.
    if (unit && !unit->is_plain()) {
        const Term& exponent = e_.term(b.node());
        if (exponent.operation != Operation::constant)
            throw ExpressionError{column, "a quantity in " + to_string(*unit) +
                                              " cannot be raised to a power that is no written number; divide it by a "
                                              "quantity of its unit first"};
        unit = to_power(*unit, exponent.value);
    }
    return of(e_.make(Operation::power, a.node(), b.node()), unit);
}

Quantity Quantities::comparison(std::string_view sign, const Quantity& a, const Quantity& b, std::size_t column) {
    need(a, Shape::number, "what is compared", column);
    need(b, Shape::number, "what is compared", column);
    common_unit(a, b, "\"" + std::string(sign) + "\"", column);
    // a > b is b < a: two operations serve the four signs.
    const Operation operation = sign.size() == 1 ? Operation::less : Operation::at_most;
    const bool exchanged = sign.front() == '>';
    const Node node = exchanged ? e_.make(operation, b.node(), a.node()) : e_.make(operation, a.node(), b.node());
    return {Shape::condition, {node, -1, -1}, Unit{}};
}

Quantity Quantities::logical(Operation operation, const Quantity& a, const Quantity& b, std::size_t column) {
    need(a, Shape::condition, "each side of \"and\", \"or\" and \"not\"", column);
    if (operation == Operation::opposite) return {Shape::condition, {e_.make(operation, a.node()), -1, -1}, Unit{}};
    need(b, Shape::condition, "each side of \"and\", \"or\" and \"not\"", column);
    return {Shape::condition, {e_.make(operation, a.node(), b.node()), -1, -1}, Unit{}};
}

Quantity Quantities::vector(const std::vector<Quantity>& parts, std::size_t column) {
    if (parts.size() != 3)
        throw ExpressionError{column, "a vector has three components, not " + std::to_string(parts.size())};
    Quantity result{Shape::vector, {-1, -1, -1}, {}};
    // A component with the unit of those so far: a 0 takes any unit, so that the first other one decides.
    Quantity with_unit = parts[0];
    for (std::size_t i = 0; i < 3; ++i) {
        need(parts[i], Shape::number, "a component of a vector", column);
        result.nodes[i] = parts[i].node();
        const std::optional<Unit> common = common_unit(with_unit, parts[i], "a comma", column);
        if (is_zero(with_unit, e_)) with_unit = parts[i];
        with_unit.unit = common;
    }
    result.unit = with_unit.unit;
    return result;
}

Quantity Quantities::component(const Quantity& a, std::string_view axis, std::size_t column) {
    need(a, Shape::vector, "what stands before \"." + std::string(axis) + "\"", column);
    if (axis != "x" && axis != "y" && axis != "z")
        throw ExpressionError{column, "a vector has the components .x, .y and .z, not ." + std::string(axis)};
    return of(a.nodes[static_cast<std::size_t>(axis.front() - 'x')], a.unit);
}

}  // namespace myo::law
