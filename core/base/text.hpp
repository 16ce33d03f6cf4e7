#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace myo {

/// The candidate with the smallest edit distance to `word`, or empty when none is near (more than half differs).
std::string closest_word(std::string_view word, const std::vector<std::string>& candidates);

/// "a, b, c"
std::string join(const std::vector<std::string>& words, std::string_view separator = ", ");

/// The whole text as a finite or nan number, blanks around it allowed; false when anything else is there. Locale-free.
bool parse_number(std::string_view text, double& value);

/// Decimal text with the given number of significant digits.
std::string format_number(double value, int significant_digits = 6);

}  // namespace myo
