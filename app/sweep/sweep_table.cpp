#include "sweep/sweep_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "measurement/text_table.hpp"
#include "sweep/readable_number.hpp"
#include "sweep/run_sweep.hpp"

namespace myo::sweep {
namespace {

/// A field of a CSV file; quoted only if it has to be.
std::string csv_field(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + "\"";
}

/// Shortest text of the same double; empty if it is not finite.
std::string csv_number(double value) { return std::isfinite(value) ? measurement::exact_number(value) : ""; }

/// Head of a column: "rms of drop [m]".
std::string title_of(const SweepColumn& column) {
    return column.unit.empty() ? column.name : column.name + " [" + column.unit + "]";
}

/// Appends columns of numbers that no row before had. Cases may have different numbers, such as those of other effects.
void add_columns(const SweepRow& row, std::vector<SweepColumn>& columns) {
    for (const CaseNumber& number : row.result.numbers) {
        auto column = std::find_if(columns.begin(), columns.end(),
                                   [&](const SweepColumn& c) { return c.name == number.name; });
        if (column == columns.end())
            column = columns.insert(columns.end(), {number.name, number.unit, false, number.shown});
        column->has_deviation = column->has_deviation || std::isfinite(number.deviation);
    }
}

/// A varied value as JSON, in the unit of the sweep file.
report::Json value_json(const toml::TomlValue& value) {
    switch (value.kind) {
        case toml::TomlValue::Kind::number: return report::json_number(value.number);
        case toml::TomlValue::Kind::boolean: return value.truth;
        case toml::TomlValue::Kind::text: return value.text;
        case toml::TomlValue::Kind::array: {
            report::Json list = report::Json::array();
            for (const toml::TomlValue& item : value.items) list.push_back(value_json(item));
            return list;
        }
        default: {
            report::Json table = report::Json::object();
            for (std::size_t i = 0; i < value.items.size(); ++i) table[value.keys[i]] = value_json(value.items[i]);
            return table;
        }
    }
}

/// A case as JSON; its folder is relative to that of the sweep.
report::Json row_json(const SweepTable& table, const SweepRow& row) {
    report::Json json{{"case", row.number}, {"values", report::Json::object()}, {"state", to_string(row.state)}};
    for (std::size_t k = 0; k < table.sweep.varied.size(); ++k)
        json["values"][table.sweep.varied[k].name] = value_json(table.sweep.varied[k].values[row.choice[k]]);
    if (!row.message.empty()) json["message"] = row.message;
    if (!row.result.verdict.empty()) json["verdict"] = row.result.verdict;
    json["numbers"] = report::Json::object();
    for (const CaseNumber& number : row.result.numbers) {
        json["numbers"][number.name] = {{"value", report::json_number(number.value)}, {"unit", number.unit}};
        if (std::isfinite(number.deviation)) json["numbers"][number.name]["std"] = number.deviation;
    }
    json["seconds"] = row.seconds;
    json["folder"] = case_folder("", row.number).string();
    return json;
}

}  // namespace

const CaseNumber* SweepRow::find(const std::string& name) const {
    const auto found = std::find_if(result.numbers.begin(), result.numbers.end(),
                                    [&](const CaseNumber& n) { return n.name == name; });
    return found != result.numbers.end() ? &*found : nullptr;
}

int SweepTable::count(CaseState state) const {
    return static_cast<int>(
        std::count_if(rows.begin(), rows.end(), [&](const SweepRow& row) { return row.state == state; }));
}

int SweepTable::missing() const {
    return static_cast<int>(
        std::count_if(rows.begin(), rows.end(), [](const SweepRow& row) { return !has_ended(row.state); }));
}

SweepRow sweep_row(const PreparedSweep& sweep, const SweepCase& sweep_case, const CaseMarker& marker,
                   const std::filesystem::path& out) {
    SweepRow row{sweep_case.number, sweep_case.choice, marker.state, marker.message, marker.seconds, {}};
    // A folder of a running case may hold half a report.
    if (!has_ended(marker.state)) return row;
    Result<CaseNumbers> numbers = read_case_numbers(sweep.sweep.command, case_folder(out, sweep_case.number));
    if (numbers) {
        row.result = *std::move(numbers);
    } else if (marker.state != CaseState::failed) {
        // A case that failed need not have a report, and its own message says more.
        row.state = CaseState::failed;
        row.message = numbers.error().text();
    }
    return row;
}

SweepTable sweep_table(const PreparedSweep& sweep, const std::filesystem::path& out) {
    SweepTable table{.sweep = sweep.sweep, .experiment_name = sweep.experiment_name, .rows = {}, .columns = {}};
    const std::vector<CaseMarker> markers = case_markers(sweep, out);
    for (std::size_t i = 0; i < sweep.cases.size(); ++i) {
        table.rows.push_back(sweep_row(sweep, sweep.cases[i], markers[i], out));
        add_columns(table.rows.back(), table.columns);
    }
    return table;
}

std::string csv_text(const SweepTable& table) {
    std::string text = "case";
    for (const Varied& varied : table.sweep.varied) text += "," + csv_field(varied.name);
    text += ",state,verdict";
    for (const SweepColumn& column : table.columns) {
        text += "," + csv_field(title_of(column));
        if (column.has_deviation) text += "," + csv_field("std of " + title_of(column));
    }
    // Line ends as RFC 4180 has them.
    text += ",seconds [s],message\r\n";
    for (const SweepRow& row : table.rows) {
        text += std::to_string(row.number);
        for (std::size_t k = 0; k < table.sweep.varied.size(); ++k)
            text += "," + csv_field(value_words(table.sweep.varied[k], row.choice[k]));
        text += "," + to_string(row.state) + "," + csv_field(row.result.verdict);
        for (const SweepColumn& column : table.columns) {
            const CaseNumber* number = row.find(column.name);
            text += "," + (number != nullptr ? csv_number(number->value) : "");
            if (column.has_deviation) text += "," + (number != nullptr ? csv_number(number->deviation) : "");
        }
        text += "," + csv_number(row.seconds) + "," + csv_field(row.message) + "\r\n";
    }
    return text;
}

report::Json sweep_json(const SweepTable& table, const std::string& version, const std::vector<std::string>& command) {
    report::Json json{{"schema", "sweep_result/1"},
                      {"version", version},
                      {"call", command},
                      {"experiment", table.experiment_name},
                      {"command", to_string(table.sweep.command)},
                      {"arguments", table.sweep.arguments},
                      {"varied", report::Json::array()},
                      {"cases", table.rows.size()},
                      {"done", table.count(CaseState::done)},
                      {"not_converged", table.count(CaseState::unconverged)},
                      {"failed", table.count(CaseState::failed)},
                      {"missing", table.missing()},
                      {"rows", report::Json::array()}};
    for (const Varied& varied : table.sweep.varied) {
        report::Json values = report::Json::array();
        for (const toml::TomlValue& value : varied.values) values.push_back(value_json(value));
        json["varied"].push_back({{"name", varied.name}, {"together", varied.together}, {"values", values}});
    }
    for (const SweepRow& row : table.rows) json["rows"].push_back(row_json(table, row));
    return json;
}

std::string row_line(const Sweep& sweep, const SweepRow& row) {
    char start[16], end[32];
    std::snprintf(start, sizeof start, "%5d  ", row.number);
    std::snprintf(end, sizeof end, "  %.1f s", row.seconds);
    std::string text = start;
    for (std::size_t k = 0; k < sweep.varied.size(); ++k)
        text += (k > 0 ? ", " : "") + sweep.varied[k].name + " = " + value_words(sweep.varied[k], row.choice[k]);
    text += "  " + to_string(row.state);
    if (!row.result.verdict.empty()) text += "  " + row.result.verdict;
    for (const CaseNumber& number : row.result.numbers)
        if (number.shown) text += "  " + number.name + " " + words_of(number);
    if (!row.message.empty()) text += "  " + row.message;
    return has_ended(row.state) ? text + end : text;
}

}  // namespace myo::sweep
