#include "experiment/law_places.hpp"

#include <algorithm>
#include <cstdlib>

namespace myo::experiment {
namespace {

/// Offset of the first character of a line in the text; lines are counted from 1. npos if there are fewer lines.
std::size_t start_of_line(const std::string& text, std::size_t line) {
    std::size_t at = 0;
    for (std::size_t i = 1; i < line && at != std::string::npos; ++i) {
        at = text.find('\n', at);
        if (at != std::string::npos) ++at;
    }
    return at;
}

}  // namespace

Error error_in_expression(const toml::TomlValue& expression, const std::string& key, const std::string& source,
                          const law::ExpressionError& error) {
    // `where` is "file:line", and the file's name may hold further colons.
    const std::size_t colon = expression.where.rfind(':');
    const std::string number = colon == std::string::npos ? "" : expression.where.substr(colon + 1);
    const std::size_t line = std::strtoul(number.c_str(), nullptr, 10);
    const std::size_t from = line > 0 ? start_of_line(source, line) : std::string::npos;
    // The value is searched from the start of its line: the key before it has any length. A string with escapes differs
    // from the source, so it is not found, and the error gets a column of the expression instead.
    const std::size_t found = from == std::string::npos ? from : source.find(expression.text, from);
    if (found == std::string::npos || expression.text.empty())
        return {key + ": " + error.sentence + " (column " + std::to_string(error.column + 1) + " of the expression)",
                expression.where};
    // An expression over several lines has its error on one of them.
    const std::size_t at = found + error.column;
    const auto end = source.begin() + static_cast<std::ptrdiff_t>(at);
    const auto lines = static_cast<std::size_t>(std::count(source.begin(), end, '\n')) + 1;
    const std::size_t before = at == 0 ? std::string::npos : source.rfind('\n', at - 1);
    const std::size_t column = before == std::string::npos ? at + 1 : at - before;
    return {key + ": " + error.sentence,
            expression.where.substr(0, colon + 1) + std::to_string(lines) + ":" + std::to_string(column)};
}

}  // namespace myo::experiment
