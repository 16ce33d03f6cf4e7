#include "measurement/actuation_csv.hpp"

#include <algorithm>
#include <cmath>

#include "base/files.hpp"
#include "base/text.hpp"
#include "measurement/text_table.hpp"

namespace myo::measurement {
namespace {

/// Muscle names of the header line; the first column must be time_s.
Result<std::vector<std::string>> muscle_names(const TextLine& header, const std::filesystem::path& path) {
    const std::vector<std::string_view> names = split_fields(header.text, ',');
    const std::string where = at_line(path, header.number);
    if (names[0] != "time_s")
        return Error{"the first column is '" + std::string(names[0]) + "', expected 'time_s'", where};
    if (names.size() < 2) return Error{"names no muscle", where};
    std::vector<std::string> muscles;
    for (std::size_t column = 1; column < names.size(); ++column) {
        const std::string name(names[column]);
        if (name.empty()) return Error{"column " + std::to_string(column + 1) + " has no name", where};
        if (std::find(muscles.begin(), muscles.end(), name) != muscles.end())
            return Error{"column '" + name + "' appears twice", where};
        muscles.push_back(name);
    }
    return muscles;
}

/// Reads the time and the values of a row.
Result<void> read_row(ActuationTable& table, Eigen::Index row, const TextLine& line,
                      const std::filesystem::path& path) {
    const std::vector<std::string_view> fields = split_fields(line.text, ',');
    if (fields.size() != table.muscles.size() + 1) {
        return Error{
            "has " + std::to_string(fields.size()) + " fields, expected " + std::to_string(table.muscles.size() + 1),
            at_line(path, line.number)};
    }
    for (std::size_t column = 0; column < fields.size(); ++column) {
        double value = 0.0;
        if (!parse_sample(fields[column], value) || std::isnan(value)) {
            return Error{"column " + std::to_string(column + 1) + " (" +
                             (column == 0 ? std::string("time_s") : table.muscles[column - 1]) + ") is '" +
                             std::string(fields[column]) + "', expected a number",
                         at_line(path, line.number)};
        }
        if (column == 0)
            table.time_s(row) = value;
        else
            table.values(static_cast<Eigen::Index>(column) - 1, row) = value;
    }
    return {};
}

/// Equal times of two rows are a jump; of three, the middle one would never act.
Result<void> check_jump(const ActuationTable& table, Eigen::Index row, const std::string& where) {
    const bool jump = row > 0 && table.time_s(row) == table.time_s(row - 1);
    if (jump && row > 1 && table.time_s(row) == table.time_s(row - 2))
        return Error{"is the third row of time " + format_number(table.time_s(row), 9) +
                         " s; two rows of one time are a jump, a third has no meaning",
                     where};
    return {};
}

Error does_not_ascend(const ActuationTable& table, Eigen::Index row, const std::string& where) {
    return {"time " + format_number(table.time_s(row), 9) + " s does not ascend from " +
                format_number(table.time_s(row - 1), 9) + " s in the row before",
            where};
}

/// Leaves out the last row, with a warning.
void drop_closing_row(ActuationTable& table, Eigen::Index row, const std::string& where) {
    table.warnings.push_back(where + ": the last row goes back to " + format_number(table.time_s(row), 9) +
                             " s and repeats the values before it; it is left out");
    table.time_s.conservativeResize(row);
    table.values.conservativeResize(Eigen::NoChange, row);
    table.lines.pop_back();
}

}  // namespace

Result<ActuationTable> read_actuation_csv(const std::filesystem::path& path) {
    const Result<std::string> content = read_file(path);
    if (!content) return content.error();
    const std::vector<TextLine> lines = split_lines(*content);
    if (lines.empty()) return Error{"is empty, expected a header 'time_s,...'", at_line(path, 1)};
    Result<std::vector<std::string>> muscles = muscle_names(lines[0], path);
    if (!muscles) return muscles.error();
    if (lines.size() < 2) return Error{"holds no rows of data", path.string()};

    ActuationTable table;
    table.muscles = std::move(*muscles);
    const auto rows = static_cast<Eigen::Index>(lines.size() - 1);
    table.time_s.resize(rows);
    table.values.resize(static_cast<Eigen::Index>(table.muscles.size()), rows);
    for (Eigen::Index row = 0; row < rows; ++row) {
        const TextLine& line = lines[static_cast<std::size_t>(row) + 1];
        if (const Result<void> read = read_row(table, row, line, path); !read) return read.error();
        // Line numbers are kept for messages of later checks.
        table.lines.push_back(line.number);
        if (const Result<void> jump = check_jump(table, row, at_line(path, line.number)); !jump) return jump.error();
        // Only a last row that repeats its predecessor may go back in time, see the header.
        if (row > 0 && !(table.time_s(row) >= table.time_s(row - 1))) {
            if (row < rows - 1 || table.values.col(row) != table.values.col(row - 1))
                return does_not_ascend(table, row, at_line(path, line.number));
            drop_closing_row(table, row, at_line(path, line.number));
        }
    }
    return table;
}

Result<void> write_actuation_csv(const std::filesystem::path& path, const ActuationTable& table) {
    std::string text = "time_s";
    for (const std::string& muscle : table.muscles) text.append(",").append(muscle);
    text += '\n';
    for (Eigen::Index row = 0; row < table.time_s.size(); ++row) {
        text += exact_number(table.time_s(row));
        for (Eigen::Index m = 0; m < table.values.rows(); ++m)
            text.append(",").append(exact_number(table.values(m, row)));
        text += '\n';
    }
    return write_file(path, text);
}

}  // namespace myo::measurement
