#include <algorithm>

#include "base/text.hpp"
#include "experiment/read_experiment_tables.hpp"

namespace myo::experiment {
namespace {

std::string read_trial_name(const toml::TomlReader& table) {
    std::string name = table.name("name");
    // Results are written to <trial>.csv.
    if (name.find_first_of("/\\") != std::string::npos || name == "." || name == "..")
        table.fail("name", "names the trial's result file, so it must not hold a slash");
    return name;
}

TrialDeclaration read_trial(const toml::TomlReader& table, const std::filesystem::path& folder) {
    TrialDeclaration trial;
    trial.name = read_trial_name(table);
    trial.role = table.choice<TrialRole>("role", {{"fit", TrialRole::fit}, {"validate", TrialRole::validate}});
    trial.trace = table.file("trace", folder);
    trial.format = table.text("format");
    if (!measurement::find_trace_reader(trial.format))
        table.fail("format", "unknown format \"" + trial.format + "\"; " +
                                 toml::suggest(trial.format, measurement::trace_formats()));
    if (trial.format == "columns") {
        trial.columns = read_columns_declaration(table);
    } else {
        table.reject("columns", "belongs to format = \"columns\" only");
    }
    read_commands(table, folder, trial);
    trial.session_time_s = table.number_or("session_time_s", 0.0);
    trial.start_s = table.optional_number("start_s");
    trial.end_s = table.optional_number("end_s");
    // Only the order is checked here; whether the window meets the recording is known after reading the trace.
    if (trial.start_s && trial.end_s && *trial.start_s >= *trial.end_s)
        table.fail("end_s", "lies before start_s (" + format_number(*trial.start_s) +
                                " >= " + format_number(*trial.end_s) + ")");
    if (table.has("condition")) {
        const toml::TomlReader condition = table.table_of_names("condition");
        for (const std::string& key : condition.keys()) trial.condition[key] = condition.number(key);
    }
    trial.loads = read_loads(table);
    return trial;
}

}  // namespace

measurement::ColumnLayout read_columns_declaration(const toml::TomlReader& trial) {
    const toml::TomlReader table = trial.table("columns", {"markers", "unit", "separator", "rate_Hz"});
    measurement::ColumnLayout columns;
    columns.labels = table.texts("markers");
    for (auto name = columns.labels.begin(); name != columns.labels.end(); ++name)
        if (std::find(columns.labels.begin(), name, *name) != name)
            table.fail("markers", "names \"" + *name + "\" twice");
    columns.metres_per_unit = table.choice<double>("unit", {{"m", 1.0}, {"mm", 1e-3}});
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
        document.fail("trial", "required key is missing: at least one [[trial]] with role \"fit\"");
    std::vector<std::string> keys{"name",           "role",    "trace", "format",    "columns",
                                  "session_time_s", "start_s", "end_s", "condition", "load"};
    for (const std::string& key : command_keys()) keys.push_back(key);
    for (const toml::TomlReader& table : document.tables("trial", keys)) trials.push_back(read_trial(table, folder));
    if (trials.empty()) document.fail("trial", "at least one [[trial]] with role \"fit\" is needed");
    return trials;
}

}  // namespace myo::experiment
