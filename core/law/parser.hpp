#pragma once

#include <map>
#include <string>
#include <string_view>
#include <variant>

#include "law/quantity.hpp"
#include "law/scanner.hpp"

namespace myo::law {

/// Names that an expression may use.
using Names = std::map<std::string, Quantity, std::less<>>;

/// Reads an expression: numbers, with a unit in brackets if need be, names, vectors [a, b, c], components .x .y .z,
/// + - * / ^, comparisons, and, or, not, and the functions of function_names(). Units are checked in sums, comparisons
/// and functions where they are known; the number 0 has every unit.
///
/// @param names        quantities of nodes of `expressions`
/// @param expressions  gets the terms; keeps those read before an error
/// @return             the quantity, or what is wrong and in which column of the text (from 0)
std::variant<Quantity, ExpressionError> parsed(std::string_view text, const Names& names, Expressions& expressions);

/// Reads as parsed() an expression that must have a shape and, where both are known, a unit. The number 0 also stands
/// for the zero vector.
/// @return  the quantity, or the error; a wrong shape or unit of the whole has column 0
std::variant<Quantity, ExpressionError> parsed_as(std::string_view text, const Names& names, Shape shape,
                                                  const std::optional<Unit>& unit, Expressions& expressions);

/// Whether a word has a meaning of its own (pi, and, or, not, names of functions), so that nothing can be named so.
bool is_reserved(const std::string& word);

}  // namespace myo::law
