#include "measurement/sample_table.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "base/text.hpp"
#include "measurement/units.hpp"

namespace myo::measurement {
namespace {

struct SampleTablePolicy {
    /// Largest ratio of a stated rate and that of the times for the two to agree: times with three decimals at 240 Hz
    /// are 4 % off.
    double same_rate = 1.1;
};
constexpr SampleTablePolicy sample_table_policy;

/// Decodes the fields of one row at a time; messages contain line and column.
class RowReader {
public:
    RowReader(const std::filesystem::path& path, const SampleTable& table) : path_(path), table_(table) {}

    // Splits a row.
    // Errors: wrong number of fields.
    Result<void> open(const TextLine& line) {
        line_ = line.number;
        fields_ = split_fields(line.text, table_.separator);
        // Some exports end every row with a separator.
        if (table_.trailing_separator && fields_.size() == table_.field_count + 1 && fields_.back().empty())
            fields_.pop_back();
        if (table_.ragged && !trimmed(line.text).empty()) {
            while (fields_.size() > table_.field_count && fields_.back().empty()) fields_.pop_back();
            if (fields_.size() < table_.field_count) fields_.resize(table_.field_count);
        }
        if (fields_.size() == table_.field_count) return {};
        if (trimmed(line.text).empty()) return Error{"is an empty line between rows", at_line(path_, line_)};
        // Every number takes two fields if the comma is its decimal mark as well.
        const bool commas = table_.separator == ',' && 2 * fields_.size() > 3 * table_.field_count;
        return Error{
            "has " + std::to_string(fields_.size()) + " fields, expected " + std::to_string(table_.field_count) +
                (commas ? ": the comma seems to be the decimal mark and the separator; write decimal points, or "
                          "separate the columns by ;"
                        : ""),
            at_line(path_, line_)};
    }

    /// Number in a column; NaN for a missing value if gaps are allowed.
    Result<double> number(std::size_t column, bool gaps_allowed) const {
        assert(column < fields_.size());
        const std::string_view field = fields_[column];
        double value = 0.0;
        if (gaps_allowed && table_.null_is_occluded && field == "NULL") return std::numeric_limits<double>::quiet_NaN();
        bool valid = false;
        if (table_.decimal_comma) {
            std::string with_point(field);
            std::replace(with_point.begin(), with_point.end(), ',', '.');
            valid = parse_sample(with_point, value);
        } else {
            valid = parse_sample(field, value);
        }
        if (valid && (gaps_allowed || !std::isnan(value))) return value;
        std::string name = "column " + std::to_string(column + 1);
        if (column < table_.column_names.size()) name += " (" + table_.column_names[column] + ")";
        if (field.empty()) return Error{name + " is empty, expected a number", at_line(path_, line_)};
        return Error{name + " is '" + std::string(field) + "', expected a number", at_line(path_, line_)};
    }

    /// Position of a marker [m]; NaN if occluded.
    Result<Eigen::Vector3d> position(const MarkerColumns& marker) const {
        Eigen::Vector3d position;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Result<double> coordinate = number(marker.columns[axis], true);
            if (!coordinate) return coordinate.error();
            position(static_cast<Eigen::Index>(axis)) = *coordinate;
        }
        // A point with a missing coordinate cannot be compared: occluded as a whole.
        const bool occluded = position.hasNaN() || (table_.zero_is_occluded && position.isZero(0.0));
        if (occluded) return Eigen::Vector3d(Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()));
        return Eigen::Vector3d(position * table_.metres_per_unit);
    }

private:
    const std::filesystem::path& path_;
    const SampleTable& table_;
    int line_ = 0;
    std::vector<std::string_view> fields_;
};

/// Labels and sizes of a recording with `count` samples.
Recording empty_recording(const SampleTable& table, Eigen::Index count) {
    Recording recording;
    for (const MarkerColumns& marker : table.markers) {
        recording.labels.push_back(marker.label);
        recording.tracks.emplace_back(3, count);
    }
    recording.time_s.resize(count);
    return recording;
}

Error time_does_not_ascend(const Recording& recording, Eigen::Index t, const std::string& where) {
    return {"time " + format_number(recording.time_s(t), 9) + " s does not ascend from " +
                format_number(recording.time_s(t - 1), 9) + " s in the row before",
            where};
}

}  // namespace

double median_rate(const Eigen::VectorXd& time_s) {
    // The median is not affected by dropped frames.
    const Eigen::Index steps = time_s.size() - 1;
    if (steps < 1) return 100.0;
    std::vector<double> step(static_cast<std::size_t>(steps));
    for (Eigen::Index t = 0; t < steps; ++t) step[static_cast<std::size_t>(t)] = time_s(t + 1) - time_s(t);
    const auto middle = step.begin() + steps / 2;
    std::nth_element(step.begin(), middle, step.end());
    // Times written with few decimals give rates like 99.9999999: round to nine digits, more than any clock resolves.
    double rate = 0.0;
    return parse_number(format_number(1.0 / *middle, 9), rate) ? rate : 1.0 / *middle;
}

Result<void> set_rate(Recording& recording, const std::string& field, double stated_Hz, const std::string& where,
                      bool time_unit_is_declared) {
    recording.rate_Hz = stated_Hz;
    if (recording.sample_count() < 2) return {};
    const double own_Hz = median_rate(recording.time_s);
    const auto agree = [&](double rate_Hz) {
        return std::abs(std::log(stated_Hz / rate_Hz)) < std::log(sample_table_policy.same_rate);
    };
    if (agree(own_Hz)) return {};
    const std::string differ = field + " says " + format_number(stated_Hz) + " Hz, but the times are " +
                               format_number(1.0 / own_Hz);
    for (const auto& [unit, seconds] : time_units)
        if (!time_unit_is_declared && seconds != 1.0 && agree(own_Hz / seconds))
            return Error{differ + " apart, as if they were in " + unit + "; state the trial's key time_unit = \"" +
                             unit + "\", or \"s\" if they are seconds",
                         where};
    recording.rate_Hz = own_Hz;
    recording.warnings.push_back(differ + " s apart, which is used");
    return {};
}

Result<Recording> read_samples(const std::filesystem::path& path, std::span<const TextLine> rows,
                               const SampleTable& table) {
    if (rows.empty()) return Error{"holds no rows of data", path.string()};
    const auto count = static_cast<Eigen::Index>(rows.size());
    Recording recording = empty_recording(table, count);
    RowReader reader(path, table);
    for (Eigen::Index t = 0; t < count; ++t) {
        const TextLine& line = rows[static_cast<std::size_t>(t)];
        if (const Result<void> opened = reader.open(line); !opened) return opened.error();
        if (table.frame_column)
            if (const Result<double> frame = reader.number(*table.frame_column, false); !frame) return frame.error();
        if (table.time_column) {
            const Result<double> time = reader.number(*table.time_column, false);
            if (!time) return time.error();
            recording.time_s(t) = *time * table.seconds_per_unit;
            if (t > 0 && !(recording.time_s(t) > recording.time_s(t - 1)))
                return time_does_not_ascend(recording, t, at_line(path, line.number));
        } else {
            assert(table.rate_Hz > 0.0);
            recording.time_s(t) = static_cast<double>(t) / table.rate_Hz;
        }
        for (std::size_t i = 0; i < table.markers.size(); ++i) {
            const Result<Eigen::Vector3d> position = reader.position(table.markers[i]);
            if (!position) return position.error();
            recording.tracks[i].col(t) = *position;
        }
    }
    recording.metres_per_unit = table.metres_per_unit;
    recording.rate_Hz = table.rate_Hz > 0.0 ? table.rate_Hz : median_rate(recording.time_s);
    return recording;
}

}  // namespace myo::measurement
