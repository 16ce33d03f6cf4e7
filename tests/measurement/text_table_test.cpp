#include "measurement/text_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <string_view>
#include <vector>

// Lines, fields and numbers of tables that programs and spreadsheets write.

namespace myo::measurement::text_table_test {
namespace {

using Fields = std::vector<std::string_view>;

TEST(SplitLines, NumbersLinesWhateverEndsThem) {
    const std::vector<TextLine> lines = split_lines(
        "\xEF\xBB\xBF"
        "one\r\n\n  three \nfour\r\r\n\n \t\r\n\n");
    ASSERT_EQ(lines.size(), 4u) << "blank lines at the end are dropped, others are not";
    EXPECT_EQ(lines[0].text, "one");
    EXPECT_EQ(lines[1].text, "");
    EXPECT_EQ(lines[2].text, "  three ");
    EXPECT_EQ(lines[3].text, "four\r") << "one carriage return belongs to the end";
    for (int i = 0; i < 4; ++i) EXPECT_EQ(lines[static_cast<std::size_t>(i)].number, i + 1);
    EXPECT_EQ(split_lines("last").size(), 1u) << "without an end";
    for (const char* nothing : {"", "\n", "\r\n \n\t", "\xEF\xBB\xBF"}) EXPECT_TRUE(split_lines(nothing).empty());
}

struct Row {
    std::string_view text;
    char separator;
    Fields fields;
};

TEST(SplitFields, KeepsWhatIsQuotedAndDropsBlanksAround) {
    for (const Row& row : {
             Row{"a,b,c", ',', {"a", "b", "c"}},
             {" a ,\tb\r,", ',', {"a", "b", ""}},
             {"", ',', {""}},
             {",", ',', {"", ""}},
             {"a;b,c", ',', {"a;b", "c"}},
             {"\"a,b\",c", ',', {"a,b", "c"}},
             {"\" a \", b", ',', {" a ", "b"}},
             {"\"\",b", ',', {"", "b"}},
             {"\"", ',', {"\""}},
             {"a\"b,c", ',', {"a\"b,c"}},
             {"x \"1,2\" y,z", ',', {"x \"1,2\" y", "z"}},
             {"a\tb\t\tc", '\t', {"a", "b", "", "c"}},
             {"  a   b c  ", ' ', {"a", "b", "c"}},
             {"\t1 2", ' ', {"1", "2"}},
             {"\"a b\" c", ' ', {"a b", "c"}},
             {"", ' ', {}},
             {"1;2;;", ';', {"1", "2", "", ""}},
         })
        EXPECT_EQ(split_fields(row.text, row.separator), row.fields) << row.text;
}

TEST(Trimmed, TakesBlanksFromBothEndsOnly) {
    EXPECT_EQ(trimmed(" \t a b\r "), "a b");
    EXPECT_EQ(trimmed(" \t\r"), "");
    EXPECT_EQ(trimmed(""), "");
    EXPECT_EQ(trimmed("\na\n"), "\na\n") << "ends of lines are none of its business";
}

TEST(ParseSample, TakesNumbersAndGapsOnly) {
    struct Field {
        std::string_view text;
        bool valid;
        double value;
    };
    const double gap = std::numeric_limits<double>::quiet_NaN();
    for (const Field& field : {Field{"1.5", true, 1.5},
                               {" -2e-3\r", true, -2e-3},
                               {"+7", true, 7.0},
                               {"", true, gap},
                               {" \t", true, gap},
                               {"nan", true, gap},
                               {"NaN", true, gap},
                               {"inf", false, 0.0},
                               {"-inf", false, 0.0},
                               {"1e400", false, 0.0},
                               {"1,5", false, 0.0},
                               {"1.5 2", false, 0.0},
                               {"+-1", false, 0.0},
                               {"1.5m", false, 0.0},
                               {"-", false, 0.0},
                               {"0x10", false, 0.0},
                               {"NULL", false, 0.0}}) {
        double value = -1.0;
        EXPECT_EQ(parse_sample(field.text, value), field.valid) << "'" << field.text << "'";
        if (!field.valid) continue;
        EXPECT_TRUE(std::isnan(field.value) ? std::isnan(value) : value == field.value) << "'" << field.text << "'";
    }
}

TEST(ExactNumber, ReadsBackToTheLastBit) {
    std::mt19937_64 random(8);
    std::uniform_real_distribution<double> mantissa(-1.0, 1.0);
    std::uniform_int_distribution<int> exponent(-300, 300);
    std::vector<double> numbers{0.0,
                                1.0 / 3.0,
                                0.1,
                                1e22,
                                1e23,
                                std::numeric_limits<double>::max(),
                                1e-310,
                                std::numeric_limits<double>::denorm_min(),
                                std::nextafter(1.0, 2.0)};
    for (int i = 0; i < 200; ++i) numbers.push_back(std::ldexp(mantissa(random), exponent(random)));
    for (const double number : numbers)
        for (const double signed_number : {number, -number}) {
            const std::string text = exact_number(signed_number);
            double read = 0.0;
            ASSERT_TRUE(parse_sample(text, read)) << text;
            EXPECT_EQ(read, signed_number) << text;
            EXPECT_LE(text.size(), 24u);
        }
    EXPECT_EQ(exact_number(0.1), "0.1") << "the shortest text";
    EXPECT_EQ(exact_number(-0.0), "-0");
    EXPECT_EQ(exact_number(250.0), "250");
    EXPECT_EQ(exact_number(std::numeric_limits<double>::quiet_NaN()), "nan");
}

TEST(AtLine, IsFileAndLine) { EXPECT_EQ(at_line("folder/a.csv", 12), "folder/a.csv:12"); }

}  // namespace
}  // namespace myo::measurement::text_table_test
