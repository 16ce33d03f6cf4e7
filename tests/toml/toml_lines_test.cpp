#include "toml/toml_lines.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

// Lines and statements of a TOML text: where they begin and end, and which comments go with them.

namespace myo::toml::toml_lines_test {
namespace {

TEST(Replaced, MakesAllChangesAtTheirOldPlaces) {
    EXPECT_EQ(replaced("abcdef", {}), "abcdef");
    // In any order, longer and shorter than what they replace, at both ends.
    EXPECT_EQ(replaced("abcdef", {{{4, 6}, ""}, {{0, 1}, "AAA"}, {{2, 3}, "c-c"}}), "AAAbc-cd");
    EXPECT_EQ(replaced("ab", {{{1, 1}, "1"}, {{1, 1}, "2"}, {{2, 2}, "3"}, {{0, 0}, "0"}}), "0a12b3")
        << "insertions at one place stay in their order";
    EXPECT_EQ(replaced("", {{{0, 0}, "new"}}), "new");
}

TEST(LineEnds, AreThoseOfTheFirstLine) {
    EXPECT_EQ(line_end_of("a\r\nb\n"), "\r\n");
    EXPECT_EQ(line_end_of("a\nb\r\n"), "\n");
    for (const char* text : {"", "a", "\n", "a\r"}) EXPECT_EQ(line_end_of(text), "\n");
    EXPECT_EQ(line_end_of("\r\n"), "\r\n");
    for (const std::string mixed : {"a\nb\r\n\n", "a\r\nb\n\r\n"}) {
        EXPECT_EQ(with_line_ends(mixed, "\n"), "a\nb\n\n");
        EXPECT_EQ(with_line_ends(mixed, "\r\n"), "a\r\nb\r\n\r\n");
    }
    EXPECT_EQ(with_line_ends("a\rb\r", "\n"), "a\rb\r") << "no line ends there";
}

TEST(Lines, AreFoundFromAnyByteWithin) {
    const std::string text = "ab\n\n  cd";
    //                        01 2 3 4567
    const std::vector<std::size_t> begins{0, 0, 0, 3, 4, 4, 4, 4, 4}, ends{3, 3, 3, 4, 8, 8, 8, 8, 8};
    for (std::size_t at = 0; at <= text.size(); ++at) {
        EXPECT_EQ(line_begin(text, at), begins[at]) << at;
        EXPECT_EQ(next_line(text, at), ends[at]) << at;
        EXPECT_EQ(indentation(text, at), at < 4 ? "" : "  ") << at;
    }
    EXPECT_EQ(indentation("\t \n", 0), "\t ");
    EXPECT_EQ(indentation("a\n \t", 3), " \t") << "a last line of blanks";
}

TEST(Lines, AreBlankIfTheyHoldNothing) {
    const std::string text = "a\n \t\r\n\n  b\n  ";
    //                        0 1 2 3 4 5 6 789 10
    EXPECT_FALSE(is_blank_line(text, 0));
    EXPECT_TRUE(is_blank_line(text, 2));
    EXPECT_TRUE(is_blank_line(text, 6));
    EXPECT_FALSE(is_blank_line(text, 7));
    EXPECT_TRUE(is_blank_line(text, 11));
    EXPECT_FALSE(is_blank_line(text, text.size())) << "behind the end there is no line";
    const TomlLayout layout;
    EXPECT_TRUE(follows_blank_line(text, layout, 0)) << "nothing is above";
    EXPECT_FALSE(follows_blank_line(text, layout, 2));
    EXPECT_TRUE(follows_blank_line(text, layout, 6));
    EXPECT_TRUE(follows_blank_line(text, layout, 7));
    EXPECT_FALSE(follows_blank_line(text, layout, 11));
}

/// Text of a statement with its comments.
std::string with_comments(const std::string& text, std::size_t statement) {
    const TomlLayout layout = layout_of(text);
    const std::size_t begin = begin_with_comments(text, layout, statement);
    return text.substr(begin, end_with_comments(text, layout, statement) - begin);
}

TEST(Comments, GoWithTheStatementTheyTouch) {
    const std::string text =
        "# head\n\n# of a\n  # too\na = 1 # beside\n# below a\n\n# of b\nb = [ # open\n 2 ] # shut\n# last\n\n# far\n";
    EXPECT_EQ(with_comments(text, 0), "# of a\n  # too\na = 1 # beside\n# below a\n");
    EXPECT_EQ(with_comments(text, 1), "# of b\nb = [ # open\n 2 ] # shut\n# last\n");
    // Between two statements without a blank line, comments are those of the second.
    const std::string close = "a = 1\n# between\n# both\nb = 2";
    EXPECT_EQ(with_comments(close, 0), "a = 1\n");
    EXPECT_EQ(with_comments(close, 1), "# between\n# both\nb = 2");
    const std::string marked = "\xEF\xBB\xBF# first\na = 1\n#end";
    EXPECT_EQ(with_comments(marked, 0), "# first\na = 1\n#end") << "the byte order mark stays in front";
}

TEST(InsertedLines, GetTheLineEndsOfTheText) {
    const auto inserted = [](const std::string& text, std::size_t at, const std::string& lines) {
        return replaced(text, {inserted_lines(text, at, lines)});
    };
    EXPECT_EQ(inserted("a = 1\nc = 3\n", 6, "b = 2\n"), "a = 1\nb = 2\nc = 3\n");
    EXPECT_EQ(inserted("a = 1\r\nc = 3\r\n", 7, "b = 2\nd = 4\n"), "a = 1\r\nb = 2\r\nd = 4\r\nc = 3\r\n");
    EXPECT_EQ(inserted("a = 1\n", 6, "b = 2\n"), "a = 1\nb = 2\n");
    EXPECT_EQ(inserted("a = 1", 5, "b = 2\n"), "a = 1\nb = 2") << "without line end, as before";
    EXPECT_EQ(inserted("a = 1\r\nb = 2", 12, "c = 3\n"), "a = 1\r\nb = 2\r\nc = 3");
    EXPECT_EQ(inserted("", 0, "a = 1\n"), "a = 1\n");
}

/// Paths of all statements in the order of a text.
std::vector<std::string> paths_of(const TomlLayout& layout) {
    std::vector<std::string> paths;
    for (const Statement& statement : layout.statements) paths.push_back(path_text(statement.path));
    return paths;
}

TEST(Layout, CountsElementsOfArraysOfTables) {
    const TomlLayout layout = layout_of(
        "k = 0\n[[e]]\nq.r = 1\n[[e.f]]\n[[e.f]]\ns = 2\n[e.t]\nu = 3\n[[e]]\n[[e.f]]\nv = 4\n[ \"x y\" . z ]\nw = "
        "5\n");
    EXPECT_EQ(paths_of(layout),
              (std::vector<std::string>{"k", "e[0]", "e[0].q.r", "e[0].f[0]", "e[0].f[1]", "e[0].f[1].s", "e[0].t",
                                        "e[0].t.u", "e[1]", "e[1].f[0]", "e[1].f[0].v", "x y.z", "x y.z.w"}));
    EXPECT_TRUE(layout.statements[1].is_header());
    EXPECT_EQ(layout.statements[1].kind, Statement::Kind::element);
    EXPECT_EQ(layout.statements[6].kind, Statement::Kind::table);
    EXPECT_EQ(path_text(layout.statements[2].section()), "e[0]") << "without its own keys";
    ASSERT_EQ(layout.statements[2].keys.size(), 2u);
    EXPECT_EQ(layout.statements[2].keys[0].depth, 3u) << "e, 0, q";
    EXPECT_EQ(layout.statements[2].keys[1].depth, 4u);
}

/// Quotes, brackets, commas and # within strings end nothing.
TEST(Layout, RangesAreWhatStandsThere) {
    const std::string text =
        "a = \"]#,\\\"=\" # c\nb = '''one\n'two''''\nc = [1, [2, 3], {d = \"}\", e.f = 4}, # end\n]\n g =  5.5  \nh = "
        "1979-05-27 07:32:00\n";
    const TomlLayout layout = layout_of(text);
    const auto part = [&](const TextRange& range) { return text.substr(range.begin, range.end - range.begin); };
    ASSERT_EQ(layout.statements.size(), 5u);
    std::string all;
    for (const Statement& statement : layout.statements) all += part(statement.lines);
    EXPECT_EQ(all, text) << "lines follow each other";
    const std::vector<std::string> values{"\"]#,\\\"=\"", "'''one\n'two''''",
                                          "[1, [2, 3], {d = \"}\", e.f = 4}, # end\n]", "5.5", "1979-05-27 07:32:00"};
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_EQ(part(layout.statements[i].value.range), values[i]);
    const ValuePlace& array = layout.statements[2].value;
    ASSERT_EQ(array.entries.size(), 3u);
    EXPECT_EQ(array.kind, ValuePlace::Kind::array);
    EXPECT_EQ(part(array.entries[1].range), "[2, 3]");
    const ValuePlace& table = array.entries[2];
    EXPECT_EQ(table.kind, ValuePlace::Kind::table);
    ASSERT_EQ(table.entries.size(), 2u);
    EXPECT_EQ(part(table.entries[0].range), "\"}\"");
    ASSERT_EQ(table.entries[1].keys.size(), 2u);
    EXPECT_EQ(table.entries[1].keys[1].name, "f");
    EXPECT_EQ(text.substr(table.entries[1].begin(), 7), "e.f = 4");
}

}  // namespace
}  // namespace myo::toml::toml_lines_test
