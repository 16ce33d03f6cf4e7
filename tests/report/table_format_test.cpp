#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "report/html_parts.hpp"
#include "support/markup_check.hpp"
#include "support/not_finite.hpp"

namespace myo::report::table_format_test {
namespace {

using test::infinity;
using test::nan;

/// Texts of the cells of a column of numbers, top to bottom, with a blank between.
std::string shown(const std::vector<double>& values, int digits = 4) {
    Table table{.columns = {{"a", "", digits}}};
    for (const double value : values) table.rows.push_back({value});
    const std::string html = html_table(table);
    EXPECT_EQ(test::markup_fault(html), "");
    std::string all;
    const std::string open = "<td class=\"n\">";
    for (std::size_t at = html.find(open); at != std::string::npos; at = html.find(open, at + 1)) {
        const std::size_t begin = at + open.size();
        all += (all.empty() ? "" : " ") + html.substr(begin, html.find("</td>", begin) - begin);
    }
    return all;
}

struct Shown {
    const char* why;
    std::vector<double> values;
    int digits;
    const char* text;
};

TEST(TableNumbers, HaveTheDecimalsThatTheirColumnNeeds) {
    for (const Shown& one :
         std::vector<Shown>{{"whole numbers", {3.0, -12.0, 0.0}, 4, "3 −12 0"},
                            {"whole numbers whatever the digits", {123456.0, 1.0}, 2, "123456 1"},
                            {"zeros and gaps only", {0.0, nan}, 4, "0 –"},
                            {"nothing known", {nan, infinity, -infinity}, 4, "– – –"},
                            {"digits of the largest", {12.3456, 0.5}, 4, "12.35 0.50"},
                            {"a power of ten has all its digits", {10.0, 0.29}, 3, "10.0 0.3"},
                            {"just below it there is one more", {9.99, 0.25}, 3, "9.99 0.25"},
                            {"no decimals beyond the digits", {12345.6, 99.7}, 3, "12346 100"},
                            {"zero has the decimals of the others", {0.0, 1.5}, 3, "0.00 1.50"},
                            {"gaps do not change them", {nan, 1.5}, 3, "– 1.50"},
                            {"the sign does not either", {-1.5, 0.29}, 2, "−1.5 0.3"},
                            {"a thousand apart is near enough", {1500.7, 1.51}, 4, "1501 2"},
                            {"more than a thousand is not", {1501.7, 1.5}, 3, "1502 1.50"},
                            {"at least one digit", {1.7, 2.2}, 0, "2 2"},
                            {"from 10⁷ on each by itself", {1.25e7, 1.5e5 + 0.4}, 3, "1.25 × 10⁷ 150000"},
                            {"below 10⁻⁴ too", {9.9e-5, 2e-4}, 2, "9.9 × 10⁻⁵ 0.00020"}})
        EXPECT_EQ(shown(one.values, one.digits), one.text) << one.why;
}

TEST(TableNumbers, OfTextColumnsAreNotAlignedInTheHeader) {
    const auto header = [](std::vector<std::vector<Cell>> rows) {
        const std::string html = html_table({.columns = {{"a"}}, .rows = std::move(rows)});
        return html.find("<th scope=\"col\" class=\"n\">a</th>") != std::string::npos;
    };
    EXPECT_TRUE(header({{1.0}, {2}}));
    EXPECT_TRUE(header({{nan}}));
    EXPECT_FALSE(header({{1.0}, {"none"}}));
    EXPECT_FALSE(header({{""}}));
    EXPECT_FALSE(header({})) << "no rows, no numbers";
    EXPECT_TRUE(header({{1.0}, {}})) << "cells that are not there";
}

TEST(TableNumbers, KeepTheirFormatApartByColumn) {
    const std::string html = html_table({.columns = {{"count"}, {"length", "mm"}}, .rows = {{1, 0.25}, {2000, 1.5}}});
    for (const char* cell : {">1</td>", ">2000</td>", ">0.250</td>", ">1.500</td>"})
        EXPECT_EQ(test::count_of(html, cell), 1) << cell;
}

TEST(TableCells, BeyondTheColumnsAreNotShown) {
    const std::string html = html_table({.columns = {{"a"}}, .rows = {{"shown", "beyond"}}});
    EXPECT_NE(html.find("shown"), std::string::npos);
    EXPECT_EQ(html.find("beyond"), std::string::npos);
    EXPECT_EQ(test::count_of(html_table({}), "<tr>"), 1) << "the header";
}

TEST(TableCells, TakeEveryKindOfNumber) {
    const std::vector<Cell> cells = {1, 2u, std::size_t{3}, 4.0f, std::int8_t{5}, 6.0};
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const double* value = std::get_if<double>(&cells[i].content);
        ASSERT_NE(value, nullptr) << i;
        EXPECT_EQ(*value, static_cast<double>(i + 1));
    }
    EXPECT_EQ(std::get<std::string>(Cell("7").content), "7");
}

}  // namespace
}  // namespace myo::report::table_format_test
