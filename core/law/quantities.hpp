#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "law/quantity.hpp"
#include "law/scanner.hpp"

namespace myo::law {

/// Operations on quantities, with the checks of shapes and units. Each throws ExpressionError with its column where
/// shapes or units do not fit. A result has no unit (nullopt) where that of an operand is unknown and needed. Their
/// `column` is that of the operator or function in the text, from 0, for messages.
class Quantities {
public:
    /// @param expressions  gets the terms, and must outlive this object
    explicit Quantities(Expressions& expressions) : e_(expressions) {}

    /// A constant with its unit.
    Quantity number(double value, const std::optional<Unit>& unit);
    /// @param operation  add or subtract; two numbers or two vectors of one unit
    Quantity sum(Operation operation, const Quantity& a, const Quantity& b, std::size_t column);
    /// A number times a number or a vector; two vectors throw.
    Quantity product(const Quantity& a, const Quantity& b, std::size_t column);
    /// A number or vector over a number. A quotient by exactly 0 is 0 (Operation::ratio).
    Quantity quotient(const Quantity& a, const Quantity& b, std::size_t column);
    /// @param a  number; with a unit only if `b` is a constant
    /// @param b  plain number
    Quantity power(const Quantity& a, const Quantity& b, std::size_t column);
    /// A number or vector with the opposite sign; a condition throws.
    Quantity negative(const Quantity& a, std::size_t column);
    /// @param sign  <, <=, > or >=
    Quantity comparison(std::string_view sign, const Quantity& a, const Quantity& b, std::size_t column);
    /// @param operation  both, either, or opposite, for which `b` is ignored
    Quantity logical(Operation operation, const Quantity& a, const Quantity& b, std::size_t column);
    /// @param parts  three numbers of one unit
    Quantity vector(const std::vector<Quantity>& parts, std::size_t column);
    /// @param axis  x, y or z
    Quantity component(const Quantity& a, std::string_view axis, std::size_t column);
    /// Result of a function; a wrong number, shape or unit of its arguments throws.
    /// @param name    of a function; an unknown one throws
    Quantity call(std::string_view name, const std::vector<Quantity>& arguments, std::size_t column);

    /// Throws unless the quantity has this shape.
    void need(const Quantity& a, Shape shape, const std::string& what, std::size_t column) const;

private:
    /// Number with a unit.
    Quantity of(Node node, const std::optional<Unit>& unit) const { return {Shape::number, {node, -1, -1}, unit}; }
    /// Unit of two sides that must have one; an unknown unit and the number 0 fit every other. Throws if they differ.
    std::optional<Unit> common_unit(const Quantity& a, const Quantity& b, const std::string& what,
                                    std::size_t column) const;
    /// Throws if the quantity has a known unit and is not 0.
    void need_plain(const Quantity& a, const std::string& what, std::size_t column) const;
    /// max() or min() of two numbers or more; of equal ones max() returns the first, min() the last.
    Quantity extreme(bool largest, const std::vector<Quantity>& arguments, std::size_t column);
    /// if(condition, a, b); the number 0 stands for a zero vector as well.
    Quantity choice(const std::vector<Quantity>& arguments, std::size_t column);
    /// Functions of the names that they have in expressions; call() has checked shapes and numbers of arguments.
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
