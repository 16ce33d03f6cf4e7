#include "cases/case_range.hpp"

#include <charconv>

namespace myo::cases {
namespace {

/// A whole number that is the entire text; 0 if it is none.
int whole_number(const std::string& text) {
    int value = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    return code == std::errc{} && end == text.data() + text.size() ? value : 0;
}

}  // namespace

std::optional<Share> parse_share(const std::string& text) {
    const std::size_t slash = text.find('/');
    if (slash == std::string::npos) return std::nullopt;
    const int part = whole_number(text.substr(0, slash)), parts = whole_number(text.substr(slash + 1));
    if (part < 1 || parts < part) return std::nullopt;
    return Share{part - 1, parts};
}

std::vector<int> numbers_of(const CaseRange& range) {
    std::vector<int> numbers;
    for (int number = range.first; number < range.first + range.cases; ++number)
        if (number % range.share.parts == range.share.part) numbers.push_back(number);
    return numbers;
}

}  // namespace myo::cases
