#include <gtest/gtest.h>

#include <Eigen/Core>

#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "base/files.hpp"
#include "report/html_report.hpp"
#include "report/length.hpp"
#include "support/folder.hpp"
#include "support/markup_check.hpp"
#include "support/not_finite.hpp"

namespace myo::report::page_parts_test {
namespace {

/// Page of one section with one block.
std::string page_with(Block block, const std::string& heading = "") {
    HtmlReport report{.title = "t"};
    report.sections.push_back({heading, {std::move(block)}});
    const std::string page = html(report);
    EXPECT_EQ(test::markup_fault(page), "");
    return page;
}

bool holds(const std::string& page, const std::string& part) { return page.find(part) != std::string::npos; }

TEST(PageParts, StandInTheOrderOfTheReport) {
    HtmlReport report{.title = "the title",
                      .summary = {"summary 1", "summary 2"},
                      .key_figures = {{"label", "value", "unit", "note"}},
                      .warnings = {{"careful"}},
                      .footer = "the footer"};
    report.sections = {{"section 1", {Paragraph{"text 1"}, Preformatted{"text 2"}}},
                       {"section 2", {Paragraph{"text 3"}}}};
    const std::string page = html(report);
    EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
    std::size_t last = page.find("<body>");
    for (const char* part : {"the title", "summary 1", "summary 2", "label", "value", "unit", "note", "careful",
                             "section 1", "text 1", "text 2", "section 2", "text 3", "the footer"}) {
        const std::size_t at = page.find(part, last);
        ASSERT_NE(at, std::string::npos) << part;
        last = at;
    }
    EXPECT_TRUE(holds(page, "<title>the title</title>"));
    EXPECT_TRUE(holds(page, "<h1>the title</h1>"));
}

TEST(PageParts, TilesLeaveOutUnitAndNoteThatAreEmpty) {
    HtmlReport report{.title = "t", .key_figures = {{"bare", "1"}, {"full", "2", "mm", "± 1"}}};
    const std::string page = html(report);
    EXPECT_TRUE(holds(page, "<dt>bare</dt><dd>1</dd>"));
    EXPECT_TRUE(holds(page, "<dt>full</dt><dd>2 <span class=\"unit\">mm</span><span class=\"note\">± 1</span></dd>"));
}

TEST(PageParts, WarningsAreOneSentenceOrAList) {
    const std::string one = page_with(WarningBox{{"first"}}), two = page_with(WarningBox{{"first", "second"}});
    EXPECT_TRUE(holds(one, "<strong>Warning</strong>first</div>"));
    EXPECT_TRUE(holds(two, "<strong>Warnings</strong><ul><li>first</li>\n<li>second</li>\n</ul>"));
    EXPECT_FALSE(holds(page_with(WarningBox{}), "<div"));
}

TEST(PageParts, ThatAreEmptyLeaveNoElement) {
    EXPECT_FALSE(holds(page_with(BulletList{}), "<ul"));
    EXPECT_FALSE(holds(page_with(Paragraph{""}), "<p>"));
    EXPECT_FALSE(holds(page_with(Figure{"<svg/>", ""}), "<figcaption"));
    EXPECT_FALSE(holds(page_with(Table{}), "<caption"));
    EXPECT_FALSE(holds(page_with(Paragraph{"x"}), "<h2"));
    EXPECT_TRUE(holds(page_with(Paragraph{"x"}, "heading"), "<h2>heading</h2>"));
    EXPECT_TRUE(holds(page_with(Figure{"<svg/>", "words"}), "<figure>\n<svg/><figcaption>words</figcaption>"));
}

TEST(PageParts, ParagraphsKeepSingleLineEndsAndDropBlankOnes) {
    for (const auto& [text, expected] :
         std::vector<std::pair<std::string, std::string>>{{"a", "<p>a</p>\n"},
                                                          {"a\nb", "<p>a\nb</p>\n"},
                                                          {"a\n\nb", "<p>a</p>\n<p>b</p>\n"},
                                                          {"a\n\n\n\nb\n\nc", "<p>a</p>\n<p>b</p>\n<p>c</p>\n"},
                                                          {"a\n\n", "<p>a</p>\n"},
                                                          {"a <b>\n\n&", "<p>a &lt;b&gt;</p>\n<p>&amp;</p>\n"}})
        EXPECT_TRUE(holds(page_with(Paragraph{text}), "<section>\n" + expected + "</section>")) << text;
}

TEST(PageParts, DetailsHoldBlocksAndOtherDetails) {
    const std::string page = page_with(Details{"outer", {Paragraph{"one"}, Details{"inner", {Preformatted{"two"}}}}});
    EXPECT_TRUE(holds(page,
                      "<details><summary>outer</summary>\n<p>one</p>\n"
                      "<details><summary>inner</summary>\n<pre>two</pre>\n</details>\n</details>\n"));
}

TEST(PageParts, AreWrittenAsTheyAre) {
    const test::Folder folder("page_parts");
    const HtmlReport report{.title = "written", .summary = {"ä"}};
    ASSERT_TRUE(write_html(folder.path() / "deep" / "page.html", report));
    EXPECT_EQ(read_file(folder.path() / "deep" / "page.html").value(), html(report));
    ASSERT_TRUE(write_file(folder.path() / "file", "no folder"));
    EXPECT_FALSE(write_html(folder.path() / "file" / "page.html", report));
}

TEST(Lengths, AreInMillimetresWithThreeDigits) {
    for (const auto& [metres, text] : std::vector<std::pair<double, std::string>>{{0.0012345, "1.23"},
                                                                                  {1.5, "1500"},
                                                                                  {0.1, "100"},
                                                                                  {0.00999, "9.99"},
                                                                                  {-0.02, "−20.0"},
                                                                                  {0.0, "0"},
                                                                                  {2e-8, "2.00 × 10⁻⁵"},
                                                                                  {test::nan, "–"}}) {
        EXPECT_EQ(in_mm(metres), text);
        EXPECT_EQ(length_words(metres), text + " mm");
    }
    const std::vector<double> curve = curve_in_mm(Eigen::Vector3d(0.25, -1.0, test::nan));
    ASSERT_EQ(curve.size(), 3u);
    EXPECT_EQ(curve[0], 250.0);
    EXPECT_EQ(curve[1], -1000.0);
    EXPECT_TRUE(std::isnan(curve[2]));
    EXPECT_TRUE(curve_in_mm(Eigen::VectorXd()).empty());
}

TEST(JsonText, KeepsTheOrderOfKeysAndWholeNumbers) {
    Json json;
    json["z"] = 1;
    json["a"] = -2;
    json["m"] = json_number(3.0);
    json["z"] = 9;
    EXPECT_EQ(json_line(json), R"({"z":9,"a":-2,"m":3.0})");
    EXPECT_EQ(json_text(Json::array()), "[]\n");
}

TEST(JsonText, NamesTheLineOfAFault) {
    const test::Folder folder("json_line");
    const std::filesystem::path path = folder.path() / "a.json";
    struct Fault {
        const char* text;
        int line;
    };
    for (const Fault& fault : {Fault{"{\"a\" 1}", 1}, {"\n\n{\"a\": ]\n}\n", 3}, {"[1,\n2,\n3\n", 4}, {"{} {}", 1}}) {
        ASSERT_TRUE(write_file(path, fault.text));
        const Result<Json> read = read_json(path);
        ASSERT_FALSE(read) << fault.text;
        EXPECT_EQ(read.error().where, path.string() + ":" + std::to_string(fault.line)) << fault.text;
        EXPECT_EQ(read.error().what, "is not valid JSON near this line");
    }
    // A number beyond the range of a double has no place in the text.
    ASSERT_TRUE(write_file(path, "[1e999]"));
    EXPECT_EQ(read_json(path).error().what, "holds JSON that cannot be read");
    EXPECT_EQ(read_json(path).error().where, path.string());
}

TEST(JsonText, HoldsMatricesByColumnsWhateverTheirShape) {
    Eigen::MatrixXd wide(2, 3);
    wide << 1.0, 2.0, 3.0, 4.0, test::nan, 6.0;
    EXPECT_EQ(json_line(json_columns(wide)), "[[1.0,4.0],[2.0,null],[3.0,6.0]]");
    // A block of a larger matrix has gaps between its columns.
    EXPECT_EQ(json_line(json_columns(wide.topRows(1))), "[[1.0],[2.0],[3.0]]");
    EXPECT_EQ(json_line(json_array(Eigen::VectorXd())), "[]");
    EXPECT_EQ(json_line(json_array(std::vector<double>{})), "[]");
}

}  // namespace
}  // namespace myo::report::page_parts_test
