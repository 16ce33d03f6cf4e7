#include "commands/marker_csv.hpp"

#include <cassert>
#include <limits>

#include "base/text.hpp"

namespace myo::ui::commands {
namespace {

constexpr int written_digits = 9;  // significant digits: a nanometre in a metre, far below the noise of any camera

/// Quotes a CSV field if it contains a character that would end it; quotes inside are doubled.
/// Source: RFC 4180, section 2.
std::string quoted(const std::string& name) {
    if (name.find_first_of(",\"\n\r") == std::string::npos) return name;
    std::string field = "\"";
    for (const char letter : name) field += letter == '"' ? "\"\"" : std::string(1, letter);
    return field + "\"";
}

/// One group of three columns of the table.
struct Curve {
    std::string name;                         // heads its columns
    const Eigen::VectorXd* time_s = nullptr;  // T
    Eigen::Matrix3Xd position_m;              // 3 x T
};

/// Adds the curves of a trial: measured, and with a run simulated and residual. `before` is the prefix of their names.
void add_trial(std::vector<Curve>& curves, const std::string& before, const SceneTrial& trial, std::size_t marker,
               const Eigen::Matrix3Xd* simulated_m) {
    const Eigen::Matrix3Xd& measured_m = trial.measured[marker];
    curves.push_back({before + "measured", &trial.time_s, measured_m});
    if (!simulated_m) return;
    curves.push_back({before + "simulated", &trial.time_s, *simulated_m});
    curves.push_back({before + "residual", &trial.time_s, *simulated_m - measured_m});
}

/// Simulated path of a marker at the sample times of its trial; null if the run does not have it.
const Eigen::Matrix3Xd* simulated_way(const SceneTrial& trial, const RunResult* run, std::size_t t,
                                      std::size_t marker) {
    if (!run || t >= run->trials.size() || marker >= run->trials[t].markers.size()) return nullptr;
    const Eigen::Matrix3Xd& way = run->trials[t].markers[marker];
    return way.cols() == trial.time_s.size() ? &way : nullptr;
}

/// Table of the curves in a range of time.
std::string table_of(const std::vector<Curve>& curves, double first_s, double last_s) {
    // Trials have different sample times. The table has a line for each time of any of them, with gaps as nan.
    std::set<double> times;
    for (const Curve& curve : curves) times.insert(curve.time_s->begin(), curve.time_s->end());
    std::string text = "time_s";
    for (const Curve& curve : curves) {
        for (const char* const axis : {"_x_m", "_y_m", "_z_m"}) text += "," + quoted(curve.name + axis);
    }
    text += "\n";
    std::vector<Eigen::Index> next(curves.size(), 0);
    for (const double time : times) {
        std::string line = format_number(time, written_digits);
        for (std::size_t c = 0; c < curves.size(); ++c) {
            const Eigen::VectorXd& at = *curves[c].time_s;
            // Times ascend in the table and in each trial, so one pass with an index per trial suffices.
            while (next[c] < at.size() && at(next[c]) < time) ++next[c];
            const bool sampled = next[c] < at.size() && at(next[c]) == time;
            for (int axis = 0; axis < 3; ++axis)
                line += "," + format_number(sampled ? curves[c].position_m(axis, next[c])
                                                    : std::numeric_limits<double>::quiet_NaN(),
                                            written_digits);
        }
        // Lines outside of the range are made as well, as each advances the indices.
        if (time >= first_s && time <= last_s) text += line + "\n";
    }
    return text;
}

}  // namespace

std::vector<ComparedMarker> compared_markers(const WorkbenchState& state) {
    std::vector<ComparedMarker> compared;
    const SceneTrial* const trial = state.scene_trial();
    const auto m = static_cast<std::size_t>(state.marker);
    for (std::size_t k = 0; trial && k < state.history.size(); ++k) {
        const JobRecord& record = state.history[k];
        // The shown run has columns of its own.
        const SimulatedTrial* const other = record.compared && record.run != state.run
                                                ? state.trial_of(record.run.get())
                                                : nullptr;
        // A run of an earlier version of the experiment has other sample times.
        if (!other || m >= other->markers.size() || other->markers[m].cols() != trial->time_s.size()) continue;
        compared.push_back({k, record.name + " " + record.clock, &other->markers[m]});
    }
    return compared;
}

std::vector<OverlaidMarker> overlaid_markers(const WorkbenchState& state, const std::set<int>& trials) {
    std::vector<OverlaidMarker> overlaid;
    const auto m = static_cast<std::size_t>(state.marker);
    const std::shared_ptr<const RunResult> run = state.shown_run();
    for (std::size_t t = 0; state.scene && t < state.scene->trials.size(); ++t) {
        const SceneTrial& trial = state.scene->trials[t];
        if (static_cast<int>(t) == state.trial || trials.count(static_cast<int>(t)) == 0 || m >= trial.measured.size())
            continue;
        overlaid.push_back({t, &trial, simulated_way(trial, run.get(), t, m)});
    }
    return overlaid;
}

std::string marker_curves_csv(const WorkbenchState& state, double first_s, double last_s,
                              const std::set<int>& overlaid) {
    const SceneTrial* const trial = state.scene_trial();
    const auto m = static_cast<std::size_t>(state.marker);
    assert(trial && m < trial->measured.size());
    const std::shared_ptr<const RunResult> run = state.shown_run();
    std::vector<Curve> curves;
    add_trial(curves, "", *trial, m, simulated_way(*trial, run.get(), static_cast<std::size_t>(state.trial), m));
    for (const ComparedMarker& other : compared_markers(state))
        curves.push_back({other.name, &trial->time_s, *other.position_m});
    for (const OverlaidMarker& other : overlaid_markers(state, overlaid))
        add_trial(curves, other.measured->name + "_", *other.measured, m, other.simulated_m);
    return table_of(curves, first_s, last_s);
}

std::string marker_errors_csv(const std::vector<MarkerError>& errors) {
    std::string text =
        "marker,rms_m,largest_m,rms_x_m,rms_y_m,rms_z_m,largest_x_m,largest_y_m,largest_z_m,bias_x_m,bias_y_m,bias_z_m,"
        "seen\n";
    for (const MarkerError& error : errors) {
        text += quoted(error.name);
        for (const double value : {error.rms_m, error.largest_m}) text += "," + format_number(value, written_digits);
        for (const Eigen::Vector3d* const axes : {&error.rms_axis_m, &error.largest_axis_m, &error.bias_m}) {
            for (const double value : *axes) text += "," + format_number(value, written_digits);
        }
        text += "," + format_number(error.seen, written_digits) + "\n";
    }
    return text;
}

}  // namespace myo::ui::commands
