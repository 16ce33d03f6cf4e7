#pragma once

#include <cctype>
#include <string>

namespace myo {

/// Copy of the text with all ASCII letters in lower case.
inline std::string lower_case(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

/// Copy of the text with its first letter in upper case, for a phrase that becomes a sentence.
inline std::string upper_first(std::string text) {
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

/// Copy of the text with its first letter in lower case, for use inside a sentence.
inline std::string lower_first(std::string text) {
    if (!text.empty()) text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
    return text;
}

}  // namespace myo
