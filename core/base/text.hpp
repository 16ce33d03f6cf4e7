#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace myo {

/// Candidate with the smallest edit distance to `word`, for "did you mean" messages.
/// @return  empty if the distance to every candidate exceeds half the length of `word`
std::string closest_word(std::string_view word, const std::vector<std::string>& candidates);

/// Concatenates the words with the separator in between: "a, b, c".
std::string join(const std::vector<std::string>& words, std::string_view separator = ", ");

/// Parses a complete text as a finite number or NaN, independent of the locale.
/// @return  false if anything but blanks surrounds the number; `value` is then unspecified
bool parse_number(std::string_view text, double& value);

/// Decimal text with the given number of significant digits, shortest form (%g).
std::string format_number(double value, int significant_digits = 6);

}  // namespace myo
