#include "mesh/text_scanner.hpp"

#include <gtest/gtest.h>

#include <string>

// Words, numbers and lines of text files of meshes.

namespace myo::mesh::text_scanner_test {
namespace {

TEST(TextScanner, WordsCrossLinesUnlessAskedNotTo) {
    TextScanner text("  one\ttwo\r\n\n three \v four\f\n", "file.obj");
    EXPECT_EQ(text.word_on_line(), "one");
    EXPECT_EQ(text.word_on_line(), "two");
    EXPECT_EQ(text.word_on_line(), "") << "the carriage return is a blank";
    EXPECT_EQ(text.word_on_line(), "") << "the line's end stays where it is";
    EXPECT_EQ(text.line(), 1);
    EXPECT_EQ(text.word(), "three");
    EXPECT_EQ(text.line(), 3);
    EXPECT_EQ(text.word(), "four");
    EXPECT_TRUE(text.at_end());
    EXPECT_EQ(text.word(), "");
}

TEST(TextScanner, CountsLinesForMessages) {
    TextScanner text("a\nb c\nd", "mesh.msh");
    EXPECT_EQ(text.error("is wrong").text(), "mesh.msh:1: is wrong");
    EXPECT_TRUE(text.next_line());
    EXPECT_EQ(text.word(), "b");
    EXPECT_TRUE(text.next_line()) << "the rest of the line is skipped";
    EXPECT_EQ(text.word(), "d");
    EXPECT_EQ(text.error("is wrong").where, "mesh.msh:3");
    EXPECT_FALSE(text.next_line());
    EXPECT_EQ(text.line(), 3);
    EXPECT_EQ(TextScanner("a\nb c\nd", "").size(), 7u);
    TextScanner empty("", "");
    EXPECT_TRUE(empty.at_end());
    EXPECT_FALSE(empty.next_line());
    EXPECT_EQ(empty.word_on_line(), "");
    EXPECT_EQ(empty.line(), 1);
}

/// A number is a whole word: what follows the digits makes it wrong.
TEST(TextScanner, NumbersAreWholeFiniteWords) {
    struct Word {
        const char* text;
        bool is_number, is_integer;
    };
    for (const Word& word : {Word{"12", true, true},
                             {"+12", true, true},
                             {"-12", true, true},
                             {"-1.5e-3", true, false},
                             {".5", true, false},
                             {"1e3", true, false},
                             {"1,5", false, false},
                             {"1.5mm", false, false},
                             {"0x10", false, false},
                             {"nan", false, false},
                             {"inf", false, false},
                             {"-inf", false, false},
                             {"1e999", false, false},
                             {"+", false, false},
                             {"", false, false},
                             {"99999999999999999999", true, false}}) {
        double value = 0.0, on_line = 0.0;
        long long integer = 0;
        EXPECT_EQ(TextScanner(word.text, "").number(value), word.is_number) << word.text;
        EXPECT_EQ(TextScanner(word.text, "").number_on_line(on_line), word.is_number) << word.text;
        EXPECT_EQ(TextScanner(word.text, "").integer(integer), word.is_integer) << word.text;
        if (word.is_number) EXPECT_EQ(value, std::stod(word.text)) << word.text;
        if (word.is_integer) EXPECT_EQ(integer, std::stoll(word.text)) << word.text;
    }
}

TEST(TextScanner, NumbersOfALineEndWithIt) {
    TextScanner text("1 2\n3", "");
    double value = 0.0;
    long long integer = 0;
    EXPECT_TRUE(text.number_on_line(value));
    EXPECT_TRUE(text.integer_on_line(integer));
    EXPECT_EQ(integer, 2);
    EXPECT_FALSE(text.number_on_line(value));
    EXPECT_FALSE(text.integer_on_line(integer));
    EXPECT_TRUE(text.number(value));
    EXPECT_EQ(value, 3.0);
}

}  // namespace
}  // namespace myo::mesh::text_scanner_test
