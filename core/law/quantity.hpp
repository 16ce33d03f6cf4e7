#pragma once

#include <array>
#include <optional>

#include "law/expressions.hpp"
#include "law/unit.hpp"

namespace myo::law {

/// What an expression, or a part of it, is.
enum class Shape { number, vector, condition };
/// "a number", "a vector", "a condition".
const char* to_string(Shape shape);

/// Part of an expression with its unit: one node of Expressions for a number or a condition, three for a vector.
struct Quantity {
    Shape shape = Shape::number;
    std::array<Node, 3> nodes{-1, -1, -1};  // a number or condition has one
    std::optional<Unit> unit = Unit{};      // nullopt: not known, so that it fits everywhere

    /// The node of a number or a condition.
    Node node() const { return nodes[0]; }
};

/// Whether a number or all components of a vector are the constant 0, which fits every unit.
///
/// @param expressions  to which the nodes belong
bool is_zero(const Quantity& a, const Expressions& expressions);

}  // namespace myo::law
