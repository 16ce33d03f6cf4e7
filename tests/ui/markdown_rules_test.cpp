#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "help/field_links.hpp"
#include "help/markdown.hpp"

// Rules of the markdown that the help shows, one by one.

namespace myo::ui::markdown_rules {
namespace {

using help::Block;

/// Blocks in short: the first letter of the kind, its level or sign, and the text; rows of tables by bars.
std::vector<std::string> outline(const std::string& page) {
    std::vector<std::string> lines;
    for (const Block& block : help::read_markdown(page)) {
        std::string line;
        switch (block.kind) {
            case Block::Kind::heading: line = "h" + std::to_string(block.level) + " " + block.text; break;
            case Block::Kind::paragraph: line = "p " + block.text; break;
            case Block::Kind::item:
                line = "i" + std::to_string(block.level) + " " + block.sign + " " + block.text;
                break;
            case Block::Kind::code: line = "c " + block.text; break;
            case Block::Kind::table:
                line = "t";
                for (const std::vector<std::string>& row : block.rows) {
                    line += " /";
                    for (const std::string& cell : row) line += " " + cell + " |";
                }
                break;
        }
        lines.push_back(line);
    }
    return lines;
}

using Lines = std::vector<std::string>;

TEST(MarkdownRules, HeadingsHaveLevelsAndEndWhatStandsBefore) {
    EXPECT_EQ(outline("# One\n## Two\n###### Six\n"), (Lines{"h1 One", "h2 Two", "h6 Six"}));
    EXPECT_EQ(outline("text\n# One\nmore"), (Lines{"p text", "h1 One", "p more"}));
    EXPECT_EQ(outline("text\n  # no heading"), (Lines{"p text # no heading"})) << "it is indented";
}

TEST(MarkdownRules, ParagraphsGoOnUntilAnEmptyLine) {
    EXPECT_EQ(outline("one\ntwo\n\n\nthree"), (Lines{"p one two", "p three"}));
    EXPECT_EQ(outline("one  \r\n two\r\n\r\nthree\r\n"), (Lines{"p one two", "p three"})) << "line ends of Windows";
    EXPECT_EQ(outline("*one\ntwo* three"), (Lines{"p one two three"})) << "emphasis over two lines";
    EXPECT_EQ(outline(""), Lines{});
    EXPECT_EQ(outline("\n \n\n"), Lines{});
    EXPECT_EQ(outline("![a picture](x.png)\n\ntext"), (Lines{"p text"})) << "pictures are left out";
}

TEST(MarkdownRules, ItemsHaveSignsLevelsAndSeveralLines) {
    EXPECT_EQ(outline("* a\n* b\n  goes on\n- c"), (Lines{"i0 • a", "i0 • b goes on", "i0 • c"}));
    EXPECT_EQ(outline("1. a\n12. b"), (Lines{"i0 1. a", "i0 12. b"}));
    EXPECT_EQ(outline("* a\n  * inner\n* b"), (Lines{"i0 • a", "i1 • inner", "i0 • b"}));
    EXPECT_EQ(outline("1.5 mm\n\n*not* an item\n\n-5 neither"), (Lines{"p 1.5 mm", "p not an item", "p -5 neither"}));
    // In a list four blanks begin no code; after it they do.
    EXPECT_EQ(outline("* a\n\n    more\n\nend\n\n    code"), (Lines{"i0 • a", "p more", "p end", "c code"}));
}

TEST(MarkdownRules, CodeIsKeptAsItIs) {
    EXPECT_EQ(outline("```\n# no heading\n* no item\n\n| no | table |\n```\ntext"),
              (Lines{"c # no heading\n* no item\n\n| no | table |", "p text"}));
    EXPECT_EQ(outline("```toml\na = 1\n```\n```\nb = 2\n```"), (Lines{"c a = 1", "c b = 2"})) << "two of them";
    EXPECT_EQ(outline("    a\n      b\n\ntext"), (Lines{"c a\n  b", "p text"})) << "its own indent stays";
    EXPECT_EQ(outline("text\n    goes on"), (Lines{"p text goes on"})) << "code needs an empty line before it";
    EXPECT_EQ(outline("```\nnever closed"), (Lines{"c never closed"}));
}

TEST(MarkdownRules, TablesHaveRowsOfCells) {
    EXPECT_EQ(outline("| a | b |\n|:--|--:|\n| 1 | `x * y` |"), (Lines{"t / a | b | / 1 | x * y |"}));
    EXPECT_EQ(outline("text\n| a |\n|---|\n| 1 |\ntext"), (Lines{"p text", "t / a | / 1 |", "p text"}));
    EXPECT_EQ(outline("| a |\n|---|\n\n| b |\n|---|"), (Lines{"t / a |", "t / b |"})) << "an empty line ends a table";
    EXPECT_EQ(outline("| \\|F m\\| | |\n"), (Lines{"t / |F m| |  |"})) << "bars of a formula, and an empty cell";
}

TEST(PlainText, HasNoMarksButThoseThatMeanThemselves) {
    const std::vector<std::pair<const char*, const char*>> texts{{"**bold** and *thin*", "bold and thin"},
                                                                 {"2 * 3 * 4", "2 * 3 * 4"},
                                                                 {"`a * b` * *c*", "a * b * c"},
                                                                 {"`[a](b)`", "[a](b)"},
                                                                 {"`never closed * it", "`never closed * it"},
                                                                 {"see [the *page*](x.md#y), too", "see the page, too"},
                                                                 {"![picture](p.png)text", "text"},
                                                                 {"in [0, 1] or [a](b)", "in [0, 1] or a"},
                                                                 {"in [0, 1]", "in [0, 1]"},
                                                                 {"a! [b](c)", "a! b"},
                                                                 {R"(\*no emphasis\* \[x\])", "*no emphasis* [x]"},
                                                                 {R"(C:\folder)", R"(C:\folder)"},
                                                                 {R"(at the end \)", R"(at the end \)"},
                                                                 {"", ""}};
    for (const auto& [marked, plain] : texts) EXPECT_EQ(help::plain_text(marked), plain) << marked;
}

TEST(FindBlock, LooksInTextsAndCellsAndKeepsCapitals) {
    const std::vector<Block> blocks = help::read_markdown("# Title\n\ntext\n\n| cell |\n|---|\n| Deep |\n\nDeep text");
    ASSERT_EQ(blocks.size(), 4u);
    EXPECT_EQ(help::find_block(blocks, "Title"), 0u);
    EXPECT_EQ(help::find_block(blocks, "text"), 1u) << "the first that has it";
    EXPECT_EQ(help::find_block(blocks, "Deep"), 2u) << "in a cell";
    EXPECT_EQ(help::find_block(blocks, "deep"), 4u);
    EXPECT_EQ(help::find_block({}, "text"), 0u);
}

TEST(FieldLinks, TheLongestNameCountsAndGroupsEndWithASlash) {
    const auto phrase = [](const char* field) {
        const help::FieldLink* const link = help::link_of(field);
        return link ? std::string(link->phrase) : "none";
    };
    for (std::size_t i = 1; i < help::field_links().size(); ++i)
        EXPECT_GE(std::string(help::field_links()[i - 1].field).size(),
                  std::string(help::field_links()[i].field).size());
    EXPECT_EQ(phrase("model/gent_limit"), phrase("model/whatever")) << "parameters of laws share a paragraph";
    EXPECT_NE(phrase("model/density"), phrase("model/whatever"));
    EXPECT_NE(phrase("model/velocity_force"), phrase("model/whatever"));
    EXPECT_EQ(phrase("model"), "none") << "the group itself is no field";
    EXPECT_EQ(phrase("model/density/unit"), phrase("model/whatever")) << "a name without a slash is no beginning";
    EXPECT_EQ(phrase("body/elements"), "none");
    EXPECT_EQ(phrase(""), "none");
}

}  // namespace
}  // namespace myo::ui::markdown_rules
