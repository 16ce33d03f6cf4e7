#include <algorithm>
#include <cmath>

#include "base/markup.hpp"
#include "report/html_parts.hpp"

namespace myo::report {
namespace {

// Number format of a column: common decimals, so that decimal points align, unless the magnitudes differ so much that
// small numbers would lose their digits.
struct NumberFormat {
    bool numeric = false;  // all cells are numbers
    int digits = 4;
    int decimals = -1;  // common number of decimals; -1: each number separately
    std::string operator()(double value) const {
        if (!std::isfinite(value)) return "–";
        return decimals < 0 ? readable_number(value, digits) : fixed_decimals(value, decimals);
    }
};

/// Chooses the format from the magnitudes of the numbers in the column.
NumberFormat format_of_column(const Table& table, std::size_t column) {
    NumberFormat format{.numeric = !table.rows.empty(), .digits = std::max(1, table.columns[column].digits)};
    double smallest = INFINITY, largest = 0.0;
    bool whole = true;
    for (const std::vector<Cell>& row : table.rows) {
        if (column >= row.size()) continue;
        const double* value = std::get_if<double>(&row[column].content);
        // A single text cell makes the column a text column; zero and NaN do not influence the format.
        if (value == nullptr) format.numeric = false;
        if (value == nullptr || !std::isfinite(*value) || *value == 0.0) continue;
        smallest = std::min(smallest, std::abs(*value));
        largest = std::max(largest, std::abs(*value));
        whole = whole && *value == std::round(*value);
    }
    if (largest == 0.0 || (whole && largest < 1e15)) {
        format.decimals = 0;  // integers, e.g. counts
        // Common decimals for magnitudes within a factor of 1000 only.
    } else if (largest < 1e7 && smallest >= 1e-4 && largest / smallest <= 1e3) {
        format.decimals = std::max(0, format.digits - 1 - static_cast<int>(std::floor(std::log10(largest))));
    }
    return format;
}

/// Header cell; class "n" aligns numbers to the right.
std::string header_cell(const Column& column, bool numeric) {
    std::string out = numeric ? "<th scope=\"col\" class=\"n\">" : "<th scope=\"col\">";
    out += escape_markup(column.title);
    if (!column.unit.empty()) out += " <span class=\"unit\">" + escape_markup(column.unit) + "</span>";
    return out + "</th>";
}

/// Cell of a row in the format of its column.
std::string body_cell(const std::vector<Cell>& row, std::size_t column, const NumberFormat& format) {
    // Short rows are filled.
    if (column >= row.size()) return "<td></td>";
    const auto& content = row[column].content;
    const double* value = std::get_if<double>(&content);
    const std::string text = value != nullptr ? format(*value) : escape_markup(std::get<std::string>(content));
    return (value != nullptr ? "<td class=\"n\">" : "<td>") + text + "</td>";
}

}  // namespace

std::string html_table(const Table& table) {
    std::vector<NumberFormat> formats;
    std::string out = "<div class=\"table\"><table>\n";
    if (!table.caption.empty()) out += "<caption>" + escape_markup(table.caption) + "</caption>\n";
    out += "<thead><tr>";
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        formats.push_back(format_of_column(table, c));
        out += header_cell(table.columns[c], formats[c].numeric);
    }
    out += "</tr></thead>\n<tbody>\n";
    for (const std::vector<Cell>& row : table.rows) {
        out += "<tr>";
        for (std::size_t c = 0; c < table.columns.size(); ++c) out += body_cell(row, c, formats[c]);
        out += "</tr>\n";
    }
    return out + "</tbody></table></div>\n";
}

}  // namespace myo::report
