#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text.hpp"
#include "experiment/read_experiment_tables.hpp"
#include "measurement/units.hpp"

namespace myo::experiment {
namespace {

/// Name of a trial that is valid as a file name without a folder.
std::string read_trial_name(const toml::TomlReader& table) {
    std::string name = table.name("name");
    // Results are written to <trial>.csv.
    if (name.find_first_of("/\\") != std::string::npos || name == "." || name == "..")
        table.fail("name", "names the trial's result file, so it must not hold a slash");
    return name;
}

/// Declared format, or that of the file's content.
std::string read_format(const toml::TomlReader& table, const std::filesystem::path& trace) {
    if (!table.has("format")) {
        const Result<measurement::TraceSource> content = measurement::guess_trace_source(trace);
        if (!content)
            table.fail("format", "required key is missing, and the content does not tell it: " +
                                     trace.filename().string() + " " + content.error().what);
        return content->format;
    }
    const std::string format = table.text("format");
    if (!measurement::find_trace_reader(format))
        table.fail("format",
                   "unknown format \"" + format + "\"; " + toml::suggest(format, measurement::trace_formats()));
    return format;
}

/// Rotation of axes = ["x", "-z", "y"]: mesh x, y, z in terms of the recording's axes.
Eigen::Matrix3d read_axes(const toml::TomlReader& table) {
    const std::vector<std::string> axes = table.texts("axes");
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const bool is_signed = axes[i].starts_with('-') || axes[i].starts_with('+');
        const std::size_t axis = std::string("xyz").find(axes[i].substr(is_signed ? 1 : 0));
        if (axes.size() != 3 || axes[i].size() != (is_signed ? 2u : 1u) || axis > 2)
            table.fail("axes", "must be three axes of the recording such as [\"x\", \"-z\", \"y\"]");
        rotation(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(axis)) = axes[i].starts_with('-') ? -1.0 : 1.0;
    }
    // A signed permutation has the determinant 1 or -1; an axis that is named twice makes it 0.
    const double determinant = rotation.determinant();
    if (std::abs(determinant) < 0.5) table.fail("axes", "must name each of x, y and z once");
    if (determinant < 0.0)
        table.fail("axes", "mirrors the recording: reverse one axis or exchange two, for a right-handed frame");
    return rotation;
}

/// A unit by its word, in m or s; empty if the key is absent.
template <std::size_t size>
std::optional<double> read_unit(const toml::TomlReader& table, const std::string& key,
                                const std::array<std::pair<const char*, double>, size>& units) {
    if (!table.has(key)) return std::nullopt;
    return table.choice<double>(key, {units.begin(), units.end()});
}

/// Keys of a recording, which a trial that is only simulated lacks.
constexpr std::array recording_keys{"trace", "format",  "columns", "unit",  "time_unit",
                                    "axes",  "start_s", "end_s",   "repair"};

/// How long a trial without a recording runs.
void read_duration(const toml::TomlReader& table, TrialDeclaration& trial) {
    for (const char* key : recording_keys)
        table.reject(key, "belongs to a recording, which a trial of role \"simulate\" does not have");
    if (trial.hold)
        table.reject("duration_s", "does not belong to a hold, which is one pose");
    else
        trial.duration_s = table.number("duration_s", toml::positive());
}

/// The recording's file and how to read it.
void read_trace_keys(const toml::TomlReader& table, const std::filesystem::path& folder, TrialDeclaration& trial) {
    table.reject("duration_s", "belongs to a trial of role \"simulate\"; a recording ends at end_s");
    trial.trace = table.file("trace", folder);
    trial.format = read_format(table, trial.trace);
    if (trial.format == "columns") {
        trial.columns = read_columns_declaration(table);
    } else {
        table.reject("columns", "belongs to format = \"columns\" only");
    }
    trial.metres_per_unit = read_unit(table, "unit", measurement::length_units);
    // Both keys may state the unit of a columns file; they must then agree.
    if (trial.columns && trial.metres_per_unit && *trial.metres_per_unit != trial.columns->metres_per_unit)
        table.fail("unit", "contradicts columns.unit");
    trial.seconds_per_unit = read_unit(table, "time_unit", measurement::time_units);
    if (trial.seconds_per_unit && !measurement::find_trace_reader(trial.format)->has_times)
        table.fail("time_unit", "a recording of format \"" + trial.format + "\" has a rate instead of times");
    if (table.has("axes")) trial.axes = read_axes(table);
    trial.repairs = read_repairs(table);
}

/// One [[trial]], without references to other tables.
TrialDeclaration read_trial(const toml::TomlReader& table, const std::filesystem::path& folder) {
    TrialDeclaration trial;
    trial.name = read_trial_name(table);
    trial.role = table.choice<TrialRole>("role", {{to_string(TrialRole::fit), TrialRole::fit},
                                                  {to_string(TrialRole::validate), TrialRole::validate},
                                                  {to_string(TrialRole::simulate), TrialRole::simulate}});
    // Commands before the duration, which a hold must not have; goals last, which must lie within both.
    if (trial.role != TrialRole::simulate) read_trace_keys(table, folder, trial);
    read_commands(table, folder, trial);
    if (trial.role == TrialRole::simulate) read_duration(table, trial);
    trial.session_time_s = table.number_or("session_time_s", 0.0);
    trial.start_s = table.optional_number("start_s");
    trial.end_s = table.optional_number("end_s");
    // Only the order is checked here; whether the window meets the recording is known after reading the trace.
    if (trial.start_s && trial.end_s && *trial.start_s >= *trial.end_s)
        table.fail("end_s", "lies before start_s (" + format_number(*trial.start_s) +
                                " >= " + format_number(*trial.end_s) + ")");
    // Names and numbers are free: effects, laws and predicted levels read those that they need.
    if (table.has("condition")) {
        const toml::TomlReader condition = table.table_of_names("condition");
        for (const std::string& key : condition.keys()) trial.condition[key] = condition.number(key);
    }
    trial.loads = read_loads(table);
    trial.goals = read_goals(table, folder, trial);
    return trial;
}

}  // namespace

std::string to_string(TrialRole role) {
    if (role == TrialRole::simulate) return "simulate";
    return role == TrialRole::fit ? "fit" : "validate";
}

std::string result_word(TrialRole role) {
    if (role == TrialRole::simulate) return "simulated";
    return role == TrialRole::fit ? "fit" : "predicted";
}

measurement::ColumnLayout read_columns_declaration(const toml::TomlReader& trial) {
    const toml::TomlReader table = trial.table("columns", {"markers", "unit", "separator", "rate_Hz"});
    measurement::ColumnLayout columns;
    columns.labels = table.texts("markers");
    for (auto name = columns.labels.begin(); name != columns.labels.end(); ++name)
        if (std::find(columns.labels.begin(), name, *name) != name)
            table.fail("markers", "names \"" + *name + "\" twice");
    columns.metres_per_unit = table.choice<double>(
        "unit", {measurement::length_units.begin(), measurement::length_units.end()});
    if (table.has("separator")) {
        const std::string separator = table.text("separator");
        // A separator that occurs in numbers or in "nan" makes the columns ambiguous.
        const bool part_of_a_number = separator.find_first_of("0123456789+-.eEnaN") != std::string::npos;
        if (separator.size() != 1 || part_of_a_number || separator == "\n" || separator == "\r")
            table.fail("separator", "must be one character that no number contains, such as \",\", \";\" or \"\\t\"");
        columns.separator = separator.front();
    }
    columns.rate_Hz = table.number("rate_Hz", toml::positive());
    return columns;
}

std::vector<TrialDeclaration> read_trials(const toml::TomlReader& document, const std::filesystem::path& folder) {
    std::vector<TrialDeclaration> trials;
    if (!document.has("trial"))
        document.fail("trial", "required key is missing: at least one [[trial]], to fit or to simulate");
    std::vector<std::string> keys{"name", "role", "duration_s", "session_time_s", "condition", "load", "goal"};
    // Keys of recordings are known for all roles, so that a simulated trial is refused with a reason.
    keys.insert(keys.end(), recording_keys.begin(), recording_keys.end());
    for (const std::string& key : command_keys()) keys.push_back(key);
    for (const toml::TomlReader& table : document.tables("trial", keys)) trials.push_back(read_trial(table, folder));
    if (trials.empty()) document.fail("trial", "at least one [[trial]] is needed");
    return trials;
}

}  // namespace myo::experiment
