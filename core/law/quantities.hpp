#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "law/quantity.hpp"
#include "law/scanner.hpp"

namespace myo::law {

/// Operations on quantities, with the checks of shapes and units. Each throws ExpressionError with its column.
class Quantities {
public:
    explicit Quantities(Expressions& expressions) : e_(expressions) {}

    Quantity number(double value, const std::optional<Unit>& unit);
    Quantity sum(Operation operation, const Quantity& a, const Quantity& b, std::size_t column);
    Quantity product(const Quantity& a, const Quantity& b, std::size_t column);
    Quantity quotient(const Quantity& a, const Quantity& b, std::size_t column);
    Quantity power(const Quantity& a, const Quantity& b, std::size_t column);
    Quantity negative(const Quantity& a, std::size_t column);
    /// @param sign  <, <=, > or >=
    Quantity comparison(std::string_view sign, const Quantity& a, const Quantity& b, std::size_t column);
    Quantity logical(Operation operation, const Quantity& a, const Quantity& b, std::size_t column);
    Quantity vector(const std::vector<Quantity>& parts, std::size_t column);
    Quantity component(const Quantity& a, std::string_view axis, std::size_t column);
    /// @param name    of a function; an unknown one throws
    Quantity call(std::string_view name, const std::vector<Quantity>& arguments, std::size_t column);

    /// Throws unless the quantity has this shape.
    void need(const Quantity& a, Shape shape, const std::string& what, std::size_t column) const;

private:
    Quantity of(Node node, const std::optional<Unit>& unit) const { return {Shape::number, {node, -1, -1}, unit}; }
    std::optional<Unit> common_unit(const Quantity& a, const Quantity& b, const std::string& what,
                                    std::size_t column) const;
    void need_plain(const Quantity& a, const std::string& what, std::size_t column) const;
    bool is_zero(const Quantity& a) const;
    Quantity extreme(bool largest, const std::vector<Quantity>& arguments, std::size_t column);
    Quantity choice(const std::vector<Quantity>& arguments, std::size_t column);
    Quantity absolute(const Quantity& a);
    Quantity dot(const Quantity& a, const Quantity& b);
    Quantity cross(const Quantity& a, const Quantity& b);
    Quantity root(const Quantity& a);
    Node blended(Node s, int power, const std::array<double, 3>& factors, Node above);
    Quantity smooth_step(const Quantity& a);
    Quantity positive(const Quantity& a, const Quantity& width, std::size_t column);

    Expressions& e_;
};

/// Names of the functions of an expression.
const std::vector<std::string>& function_names();

}  // namespace myo::law
