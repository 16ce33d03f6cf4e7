#include "law/parser.hpp"

#include <algorithm>
#include <numbers>

#include "base/text.hpp"
#include "law/quantities.hpp"

namespace myo::law {
namespace {

std::string in_quotes(std::string_view text) { return "\"" + std::string(text) + "\""; }

/// Recursive descent. From the weakest to the strongest: or, and, not, comparison, sum, product, sign, power,
/// component.
///
///   alternative     = conjunction { "or" conjunction }
///   conjunction     = negation { "and" negation }
///   negation        = "not" negation | comparison
///   comparison      = sum [ ("<" | "<=" | ">" | ">=") sum ]
///   sum             = product { ("+" | "-") product }
///   product         = signed_factor { ("*" | "/") signed_factor }
///   signed_factor   = ("+" | "-") signed_factor | power
///   power           = with_components [ "^" signed_factor ]
///   with_components = primary { "." ("x" | "y" | "z") }
///   primary         = number [ "[" unit "]" ] | name | function "(" list ")" | "(" alternative ")" | "[" list "]"
class Parser {
public:
    Parser(std::string_view text, const Names& names, Expressions& expressions)
        : scanner_(text), names_(names), quantities_(expressions) {}

    Quantity whole() {
        const Quantity result = alternative();
        if (now().kind != TokenKind::end)
            fail(in_quotes(now().text) + " cannot stand here: an operator or the end is expected");
        return result;
    }

private:
    /// Counts the nested calls of rules that recurse; ends the reading beyond most_nested.
    struct Depth {
        explicit Depth(Parser& parser) : parser_(parser) {
            // Text from a file must not exhaust the stack.
            if (++parser_.depth_ > most_nested) parser_.fail("the expression is nested too deeply");
        }
        ~Depth() { --parser_.depth_; }
        Depth(const Depth&) = delete;
        Depth& operator=(const Depth&) = delete;
        Parser& parser_;
    };
    // About nine calls per level of parentheses; far above what a person writes.
    static constexpr int most_nested = 200;

    const Token& now() const { return scanner_.now(); }
    [[noreturn]] void fail(const std::string& sentence) const { throw ExpressionError{now().column, sentence}; }
    bool is_sign(std::string_view sign) const { return now().kind == TokenKind::sign && now().text == sign; }
    bool is_word(std::string_view word) const { return now().kind == TokenKind::word && now().text == word; }
    void expect(std::string_view sign, const std::string& where) {
        if (!is_sign(sign))
            fail(in_quotes(sign) + " is missing " + where +
                 (now().kind == TokenKind::end ? "" : "; " + in_quotes(now().text) + " stands there"));
        scanner_.advance();
    }

    Quantity alternative() {
        const Depth depth(*this);
        Quantity left = conjunction();
        while (is_word("or")) {
            const std::size_t column = now().column;
            scanner_.advance();
            left = quantities_.logical(Operation::either, left, conjunction(), column);
        }
        return left;
    }

    Quantity conjunction() {
        Quantity left = negation();
        while (is_word("and")) {
            const std::size_t column = now().column;
            scanner_.advance();
            left = quantities_.logical(Operation::both, left, negation(), column);
        }
        return left;
    }

    Quantity negation() {
        if (!is_word("not")) return comparison();
        const Depth depth(*this);
        const std::size_t column = now().column;
        scanner_.advance();
        return quantities_.logical(Operation::opposite, negation(), {}, column);
    }

    /// At most one comparison: a < b < c is an error.
    Quantity comparison() {
        const Quantity left = sum();
        for (const std::string_view sign : {"<=", ">=", "<", ">"}) {
            if (!is_sign(sign)) continue;
            const std::size_t column = now().column;
            scanner_.advance();
            return quantities_.comparison(sign, left, sum(), column);
        }
        if (is_sign("==") || is_sign("!=")) fail("numbers that vary are never equal: compare by <, <=, > or >=");
        return left;
    }

    Quantity sum() {
        Quantity left = product();
        while (is_sign("+") || is_sign("-")) {
            const Operation operation = is_sign("+") ? Operation::add : Operation::subtract;
            const std::size_t column = now().column;
            scanner_.advance();
            left = quantities_.sum(operation, left, product(), column);
        }
        return left;
    }

    Quantity product() {
        Quantity left = signed_factor();
        while (is_sign("*") || is_sign("/")) {
            const bool times = is_sign("*");
            const std::size_t column = now().column;
            scanner_.advance();
            const Quantity right = signed_factor();
            left = times ? quantities_.product(left, right, column) : quantities_.quotient(left, right, column);
        }
        return left;
    }

    Quantity signed_factor() {
        if (!is_sign("-") && !is_sign("+")) return power();
        const Depth depth(*this);
        const bool negative = is_sign("-");
        const std::size_t column = now().column;
        scanner_.advance();
        const Quantity factor = signed_factor();
        return negative ? quantities_.negative(factor, column) : factor;
    }

    /// Binds to the right, and more strongly than the sign: -2^2 is -4, 2^-1 is 0.5.
    /// The exponent is a signed factor and thus takes in a further power: 2^3^2 is 2^9.
    Quantity power() {
        const Quantity base = with_components();
        if (!is_sign("^")) return base;
        const std::size_t column = now().column;
        scanner_.advance();
        return quantities_.power(base, signed_factor(), column);
    }

    Quantity with_components() {
        Quantity result = primary();
        while (is_sign(".")) {
            scanner_.advance();
            if (now().kind != TokenKind::word) fail("\".\" needs x, y or z behind it");
            result = quantities_.component(result, now().text, now().column);
            scanner_.advance();
        }
        return result;
    }

    Quantity primary() {
        const Token token = now();
        if (token.kind == TokenKind::number) return number(token);
        if (token.kind == TokenKind::word) return named(token);
        if (is_sign("(")) {
            scanner_.advance();
            const Quantity inner = alternative();
            expect(")", "after the part in parentheses");
            return inner;
        }
        if (is_sign("[")) {
            scanner_.advance();
            return quantities_.vector(list("]"), token.column);
        }
        if (token.kind == TokenKind::end) fail("the expression ends too early: a number or a name is missing");
        fail(in_quotes(token.text) + " cannot stand here: a number or a name is expected");
    }

    Quantity number(const Token& token) {
        scanner_.advance();
        if (!is_sign("[")) return quantities_.number(token.value, Unit{});
        // A bracket directly behind a number is its unit; anywhere else it begins a vector. Its words are no tokens.
        const std::size_t column = now().column + 1;
        const std::string words(scanner_.up_to(']'));
        // An unknown unit is an error at the column of its words, not of the number.
        const std::optional<Unit> unit = unit_from_words(words);
        if (!unit)
            throw ExpressionError{column, in_quotes(words) +
                                              " is not a unit; SI units without prefixes are known, such "
                                              "as N/m or kg/m3, and rad for angles"};
        return quantities_.number(token.value, unit);
    }

    Quantity named(const Token& token) {
        scanner_.advance();
        // A word with a parenthesis is a function, also where a name of a quantity is equal to it.
        if (is_sign("(")) {
            scanner_.advance();
            return quantities_.call(token.text, list(")"), token.column);
        }
        if (token.text == "pi") return quantities_.number(std::numbers::pi, Unit{});
        if (const auto found = names_.find(token.text); found != names_.end()) return found->second;
        std::vector<std::string> known;
        for (const auto& [name, quantity] : names_) known.push_back(name);
        // An unknown name gets the closest known one in its message, or the list if none is close.
        const std::string near = closest_word(token.text, known);
        throw ExpressionError{token.column,
                              in_quotes(token.text) + " is not known here" +
                                  (near.empty() ? "; there are " + join(known) : "; the closest name is " + near)};
    }

    /// Expressions separated by commas, up to the closing sign, which is passed.
    std::vector<Quantity> list(std::string_view closing) {
        std::vector<Quantity> parts;
        if (!is_sign(closing)) {
            parts.push_back(alternative());
            while (is_sign(",")) {
                scanner_.advance();
                parts.push_back(alternative());
            }
        }
        expect(closing, "after the list");
        return parts;
    }

    Scanner scanner_;
    const Names& names_;
    Quantities quantities_;
    int depth_ = 0;
};

}  // namespace

std::variant<Quantity, ExpressionError> parsed(std::string_view text, const Names& names, Expressions& expressions) {
    try {
        return Parser(text, names, expressions).whole();
    } catch (const ExpressionError& error) {
        return error;
    }
}

std::variant<Quantity, ExpressionError> parsed_as(std::string_view text, const Names& names, Shape shape,
                                                  const std::optional<Unit>& unit, Expressions& expressions) {
    std::variant<Quantity, ExpressionError> result = parsed(text, names, expressions);
    auto* const quantity = std::get_if<Quantity>(&result);
    if (!quantity) return result;
    // A constant by simplification is 0 too, such as 0 * x.
    const bool zero = is_zero(*quantity, expressions);
    if (shape == Shape::vector && quantity->shape == Shape::number && zero)
        *quantity = {Shape::vector, {quantity->node(), quantity->node(), quantity->node()}, unit};
    if (quantity->shape != shape)
        return ExpressionError{
            0, std::string("the expression is ") + to_string(quantity->shape) + ", and must be " + to_string(shape)};
    if (unit && quantity->unit && *unit != *quantity->unit && !zero)
        return ExpressionError{0, "the expression has the unit " + to_string(*quantity->unit) + ", and must have " +
                                      to_string(*unit) + "; a number with a unit is written 1000[kg/m3]"};
    return result;
}

bool is_reserved(const std::string& word) {
    const std::vector<std::string>& functions = function_names();
    return word == "pi" || word == "and" || word == "or" || word == "not" ||
           std::find(functions.begin(), functions.end(), word) != functions.end();
}

}  // namespace myo::law
