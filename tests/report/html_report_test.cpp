#include "report/html_report.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "chart/svg.hpp"
#include "support/markup_check.hpp"

namespace myo::report {
namespace {

const std::string nasty = "</script><script>alert(1)</script> & \"x\" 'y' <b>\x01\xFF";

HtmlReport report_with_everything() {
    const chart::Chart chart{
        .title = nasty, .x = {"time", "s"}, .panels = {{.y = {"z", "mm"}, .series = {{nasty, {0, 1}, {0, 1}}}}}};
    Json data;
    data[nasty] = nasty;
    data["value"] = std::numeric_limits<double>::quiet_NaN();
    HtmlReport report{.title = nasty,
                      .summary = {nasty},
                      .key_figures = {{nasty, nasty, nasty, nasty}},
                      .warnings = {{nasty, nasty}},
                      .footer = nasty};
    report.sections.push_back(
        {nasty,
         {Paragraph{nasty}, BulletList{{nasty}}, Table{nasty, {{nasty, nasty}}, {{nasty}}},
          Figure{chart::svg(chart), nasty}, WarningBox{{nasty}}, Preformatted{nasty}, EmbeddedJson{nasty, data},
          Details{nasty, {Paragraph{nasty}, Details{nasty, {Figure{chart::svg(chart), ""}}}}}}});
    return report;
}

TEST(HtmlReport, IsWellFormedWhateverTheTextSays) {
    const std::string page = html(report_with_everything());
    EXPECT_EQ(test::markup_fault(page), "");
    EXPECT_EQ(test::count_of(page, "<script"), 1);  // the data; nothing else
    EXPECT_EQ(page.find("alert(1)</script>"), std::string::npos);
    EXPECT_EQ(page, html(report_with_everything()));
}

TEST(HtmlReport, AsksTheNetworkForNothing) {
    std::string page = html(report_with_everything());
    const std::string name_space = "xmlns=\"http://www.w3.org/2000/svg\"";  // a name, not a request
    for (std::size_t i = page.find(name_space); i != std::string::npos; i = page.find(name_space))
        page.erase(i, name_space.size());
    for (const char* request : {"http:", "https:", "src=", "url(", "@import", "//"})
        EXPECT_EQ(page.find(request), std::string::npos) << request;
}

TEST(HtmlReport, EmbeddedJsonIsReadBackUnchanged) {
    Json data;
    data["text"] = "</script> & <!-- \\u003c \xE2\x80\xA8";
    data["values"] = {1.5, -2.0};
    HtmlReport report{.title = "t"};
    report.sections.push_back({"", {EmbeddedJson{"data", data}}});
    const std::string page = html(report);
    const std::string open = "<script type=\"application/json\" id=\"data\">";
    const std::size_t begin = page.find(open) + open.size();
    EXPECT_EQ(Json::parse(page.substr(begin, page.find("</script>", begin) - begin)), data);
}

TEST(HtmlReport, LeavesOutWhatIsEmpty) {
    const std::string page = html({.title = "t"});
    EXPECT_EQ(test::markup_fault(page), "");
    for (const char* element : {"<dl", "<section", "<footer", "<div", "<figure", "<script"})
        EXPECT_EQ(page.find(element), std::string::npos) << element;
}

TEST(HtmlReport, BlankLinesPartParagraphs) {
    HtmlReport report{.title = "t"};
    report.sections.push_back({"", {Paragraph{"one\n\n\ntwo\nstill two\n"}}});
    const std::string page = html(report);
    EXPECT_NE(page.find("<p>one</p>\n<p>two\nstill two\n</p>"), std::string::npos);
}

std::string page_of(const Table& table) {
    HtmlReport report{.title = "t"};
    report.sections.push_back({"", {table}});
    return html(report);
}

TEST(HtmlTable, NumbersOfAColumnShareTheirDecimals) {
    const std::string page = page_of(
        {"Errors",
         {{"marker"}, {"rms", "mm"}},
         {{"a", 0.12345}, {"b", 12.3456}, {"c", std::numeric_limits<double>::quiet_NaN()}}});
    EXPECT_NE(page.find("<td class=\"n\">0.12</td>"), std::string::npos);
    EXPECT_NE(page.find("<td class=\"n\">12.35</td>"), std::string::npos);
    EXPECT_NE(page.find("<td class=\"n\">–</td>"), std::string::npos);
    EXPECT_NE(page.find("<th scope=\"col\" class=\"n\">rms <span class=\"unit\">mm</span></th>"), std::string::npos);
    EXPECT_NE(page.find("<th scope=\"col\">marker</th>"), std::string::npos);
    EXPECT_NE(page.find("<caption>Errors</caption>"), std::string::npos);
}

TEST(HtmlTable, SmallNumbersBesideLargeOnesKeepTheirDigits) {
    const std::string page = page_of({"", {{"value"}}, {{0.001234}, {2345.6}}});
    EXPECT_NE(page.find(">0.001234<"), std::string::npos);
    EXPECT_NE(page.find(">2346<"), std::string::npos);
}

TEST(HtmlTable, CountsHaveNoDecimals) {
    const std::string page = page_of({"", {{"steps"}}, {{3}, {12000000}}});
    EXPECT_NE(page.find(">12000000<"), std::string::npos);
    EXPECT_NE(page.find(">3<"), std::string::npos);
}

TEST(HtmlTable, ShortRowsAreFilled) {
    const std::string page = page_of({"", {{"a"}, {"b"}}, {{"x"}}});
    EXPECT_NE(page.find("<tr><td>x</td><td></td></tr>"), std::string::npos);
}

}  // namespace
}  // namespace myo::report
