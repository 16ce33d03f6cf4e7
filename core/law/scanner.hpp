#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace myo::law {

/// What is wrong with an expression, and where.
struct ExpressionError {
    std::size_t column = 0;  // in the expression, from 0
    std::string sentence;
};

enum class TokenKind { number, word, sign, end };

/// Number, word, or sign of an expression.
/// Views into the text given to the scanner, which must outlive the token.
struct Token {
    TokenKind kind = TokenKind::end;
    std::string_view text;
    std::size_t column = 0;
    double value = 0.0;  // of a number
};

/// Splits an expression into tokens.
/// Errors: the constructor, too, throws ExpressionError if the first character belongs to no token.
class Scanner {
public:
    explicit Scanner(std::string_view text) : text_(text) { advance(); }

    /// Current token; TokenKind::end behind the last one.
    const Token& now() const { return now_; }
    /// Goes on to the next token. Throws ExpressionError if a character belongs to none.
    void advance();
    /// Text up to a closing bracket, which is passed, for units.
    /// Called with the opening bracket as current token. Throws ExpressionError if the closing one is missing.
    std::string_view up_to(char closing);

private:
    void read_number();

    std::string_view text_;
    std::size_t next_ = 0;
    Token now_;
};

}  // namespace myo::law
