#pragma once

#include <string>

#include "base/result.hpp"
#include "law/law.hpp"
#include "toml/toml_value.hpp"

namespace myo::experiment {

/// Error "key: sentence" with the place in the file at which an expression is wrong: "laws/drag.toml:7:25".
///
/// @param expression  the TOML string, with the place at which it begins
/// @param key         of the expression, such as "force_N" or "let[1]"
/// @param source      text of the whole file
/// @return            without a column in the file if the string contains escapes, so that the source does not hold its
///                    text; the sentence then states the column of the expression
Error error_in_expression(const toml::TomlValue& expression, const std::string& key, const std::string& source,
                          const law::ExpressionError& error);

}  // namespace myo::experiment
