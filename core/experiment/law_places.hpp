#pragma once

#include <string>

#include "base/result.hpp"
#include "law/law.hpp"
#include "toml/toml_value.hpp"

namespace myo::experiment {

/// Where the text of an expression stands in a file, with the column of its error: "laws/drag.toml:7:25".
///
/// @param source  text of the whole file
Error error_in_expression(const toml::TomlValue& expression, const std::string& key, const std::string& source,
                          const law::ExpressionError& error);

}  // namespace myo::experiment
