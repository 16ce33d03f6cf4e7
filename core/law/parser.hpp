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
/// @param expressions  gets the terms
std::variant<Quantity, ExpressionError> parsed(std::string_view text, const Names& names, Expressions& expressions);

/// Error of an expression that must have a shape and, where known, a unit.
/// @param what  the key, for the sentence
std::variant<Quantity, ExpressionError> parsed_as(std::string_view text, const Names& names, Shape shape,
                                                  const std::optional<Unit>& unit, Expressions& expressions);

/// Whether a word has a meaning of its own, so that nothing can be named so.
bool is_reserved(const std::string& word);

}  // namespace myo::law
