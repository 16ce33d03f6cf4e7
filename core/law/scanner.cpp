#include "law/scanner.hpp"

#include <array>
#include <cctype>

#include "base/text.hpp"

namespace myo::law {
namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool starts_word(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// The signs == and != are tokens only to be refused by the parser with a reason.
constexpr std::array<std::string_view, 4> long_signs{"<=", ">=", "==", "!="};
constexpr std::string_view signs = "+-*/^(),.<>[]";

}  // namespace

/// Digits, point and exponent, as in 1, .5, 2. and 1e-3. A sign is an operator, not part of the number.
void Scanner::read_number() {
    std::size_t end = next_;
    while (end < text_.size() && is_digit(text_[end])) ++end;
    if (end < text_.size() && text_[end] == '.') ++end;
    while (end < text_.size() && is_digit(text_[end])) ++end;
    // An e without digits behind it is not an exponent: it begins the next word.
    if (end < text_.size() && (text_[end] == 'e' || text_[end] == 'E')) {
        std::size_t exponent = end + 1;
        if (exponent < text_.size() && (text_[exponent] == '+' || text_[exponent] == '-')) ++exponent;
        if (exponent < text_.size() && is_digit(text_[exponent])) {
            end = exponent;
            while (end < text_.size() && is_digit(text_[end])) ++end;
        }
    }
    now_.text = text_.substr(next_, end - next_);
    now_.kind = TokenKind::number;
    if (!parse_number(now_.text, now_.value))
        throw ExpressionError{next_, "\"" + std::string(now_.text) + "\" is not a number"};
}

void Scanner::advance() {
    while (next_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[next_]))) ++next_;
    // At the end of the text the token keeps its column, at which messages point.
    now_ = {TokenKind::end, {}, next_, 0.0};
    if (next_ == text_.size()) return;
    const char c = text_[next_];
    if (is_digit(c) || (c == '.' && next_ + 1 < text_.size() && is_digit(text_[next_ + 1]))) {
        read_number();
    } else if (starts_word(c)) {
        std::size_t end = next_;
        while (end < text_.size() && (starts_word(text_[end]) || is_digit(text_[end]))) ++end;
        now_.text = text_.substr(next_, end - next_);
        now_.kind = TokenKind::word;
    } else {
        now_.kind = TokenKind::sign;
        now_.text = text_.substr(next_, 1);
        // The longer sign wins: "<=" is not "<" and "=". A single "=" has no meaning.
        for (const std::string_view sign : long_signs)
            if (text_.substr(next_, 2) == sign) now_.text = text_.substr(next_, 2);
        if (now_.text.size() == 1 && signs.find(c) == std::string_view::npos) {
            // The whole character of UTF-8: one of its bytes alone is no text.
            std::size_t end = next_ + 1;
            while (end < text_.size() && (static_cast<unsigned char>(text_[end]) & 0xC0u) == 0x80u) ++end;
            throw ExpressionError{
                next_, "\"" + std::string(text_.substr(next_, end - next_)) + "\" has no meaning in an expression"};
        }
    }
    next_ += now_.text.size();
}

std::string_view Scanner::up_to(char closing) {
    const std::size_t from = next_, end = text_.find(closing, from);
    if (end == std::string_view::npos)
        throw ExpressionError{from, std::string("\"") + closing + "\" is missing after the unit"};
    next_ = end + 1;
    advance();
    return text_.substr(from, end - from);
}

}  // namespace myo::law
