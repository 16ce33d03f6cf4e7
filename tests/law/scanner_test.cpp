#include "law/scanner.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

// Tokens of an expression with their columns, at which messages point.

namespace myo::law::scanner_test {
namespace {

using ::testing::ElementsAre;

/// Kind, text and column of all tokens, such as "n:1.5@0", the end included; or column and sentence of the error.
std::vector<std::string> tokens_of(const std::string& text) {
    std::vector<std::string> tokens;
    const std::string kinds = "nws.";  // number, word, sign, end
    try {
        for (Scanner scanner(text);; scanner.advance()) {
            const Token& now = scanner.now();
            tokens.push_back(kinds.substr(static_cast<std::size_t>(now.kind), 1) + ":" + std::string(now.text) + "@" +
                             std::to_string(now.column));
            if (now.kind == TokenKind::end) return tokens;
        }
    } catch (const ExpressionError& error) {
        tokens.push_back("error@" + std::to_string(error.column) + " " + error.sentence);
    }
    return tokens;
}

TEST(Scanner, SplitsSignsWordsAndNumbersWithoutSpaces) {
    EXPECT_THAT(tokens_of("2*a_1b<=-x.y"),
                ElementsAre("n:2@0", "s:*@1", "w:a_1b@2", "s:<=@6", "s:-@8", "w:x@9", "s:.@10", "w:y@11", ".:@12"));
    EXPECT_THAT(tokens_of("a>=b!=c==d<e"), ElementsAre("w:a@0", "s:>=@1", "w:b@3", "s:!=@4", "w:c@6", "s:==@7", "w:d@9",
                                                       "s:<@10", "w:e@11", ".:@12"));
    EXPECT_THAT(tokens_of("\t_a\n ^\r"), ElementsAre("w:_a@1", "s:^@5", ".:@7")) << "the end is behind the spaces";
    EXPECT_THAT(tokens_of(""), ElementsAre(".:@0"));
    EXPECT_THAT(tokens_of("   "), ElementsAre(".:@3"));
}

/// Every spelling with its value, and what is left of a text that only begins as a number.
TEST(Scanner, ReadsNumbersWithPointAndExponent) {
    for (const auto& [text, value] : std::vector<std::pair<std::string, double>>{{"0", 0.0},
                                                                                 {"12", 12.0},
                                                                                 {".5", 0.5},
                                                                                 {"2.", 2.0},
                                                                                 {"2.e1", 20.0},
                                                                                 {"1e-3", 1e-3},
                                                                                 {"1E+2", 100.0},
                                                                                 {"007", 7.0},
                                                                                 {"1e300", 1e300}}) {
        const Scanner scanner(text);
        EXPECT_EQ(scanner.now().kind, TokenKind::number) << text;
        EXPECT_EQ(scanner.now().value, value) << text;
        EXPECT_EQ(scanner.now().text, text);
    }
    EXPECT_THAT(tokens_of("1e"), ElementsAre("n:1@0", "w:e@1", ".:@2"));
    EXPECT_THAT(tokens_of("1e+k"), ElementsAre("n:1@0", "w:e@1", "s:+@2", "w:k@3", ".:@4"));
    EXPECT_THAT(tokens_of("1-2"), ElementsAre("n:1@0", "s:-@1", "n:2@2", ".:@3")) << "a sign is an operator";
    EXPECT_THAT(tokens_of("1.2.3"), ElementsAre("n:1.2@0", "n:.3@3", ".:@5"));
    EXPECT_THAT(tokens_of("1..z"), ElementsAre("n:1.@0", "s:.@2", "w:z@3", ".:@4"));
    EXPECT_THAT(tokens_of("2pi"), ElementsAre("n:2@0", "w:pi@1", ".:@3"));
}

TEST(Scanner, RefusesWhatIsNoTokenAtItsColumn) {
    EXPECT_THAT(tokens_of("a = b"), ElementsAre("w:a@0", "error@2 \"=\" has no meaning in an expression"));
    EXPECT_THAT(tokens_of("a <b& c"),
                ElementsAre("w:a@0", "s:<@2", "w:b@3", "error@4 \"&\" has no meaning in an expression"));
    EXPECT_THAT(tokens_of("!a"), ElementsAre("error@0 \"!\" has no meaning in an expression"));
    EXPECT_THAT(tokens_of("1e999"), ElementsAre("error@0 \"1e999\" is not a number"));
    EXPECT_THAT(tokens_of("2 \"m\""), ElementsAre("n:2@0", "error@2 \"\"\" has no meaning in an expression"));
}

/// A byte of a character alone would make the message no text: report pages and JSON could not hold it.
TEST(Scanner, NamesAForeignCharacterAsAWhole) {
    EXPECT_THAT(tokens_of("2\u00b7k"), ElementsAre("n:2@0", "error@1 \"\u00b7\" has no meaning in an expression"));
    EXPECT_THAT(tokens_of("k\u00b2"), ElementsAre("w:k@0", "error@1 \"\u00b2\" has no meaning in an expression"));
    EXPECT_THAT(tokens_of("\u2212 1"), ElementsAre("error@0 \"\u2212\" has no meaning in an expression"));
    EXPECT_THAT(tokens_of("\u00e4\u00e4"), ElementsAre("error@0 \"\u00e4\" has no meaning in an expression"));
}

TEST(Scanner, PassesTheWordsOfAUnit) {
    Scanner scanner("[kg m/s2] + 1");
    EXPECT_EQ(scanner.up_to(']'), "kg m/s2");
    EXPECT_EQ(scanner.now().text, "+");
    EXPECT_EQ(scanner.now().column, 10u);
    Scanner empty("[]");
    EXPECT_EQ(empty.up_to(']'), "");
    EXPECT_EQ(empty.now().kind, TokenKind::end);
    Scanner open("[m/s");
    try {
        open.up_to(']');
        FAIL() << "a bracket that is not closed was read";
    } catch (const ExpressionError& error) {
        EXPECT_EQ(error.column, 1u);
        EXPECT_EQ(error.sentence, "\"]\" is missing after the unit");
    }
}

}  // namespace
}  // namespace myo::law::scanner_test
