#include "commands/marker_csv.hpp"

#include <cassert>

#include "base/text.hpp"

namespace myo {
namespace {

constexpr int digits = 9;   // a nanometre in a metre, far below any camera's noise

/// In quotes when it holds what would end the field, quotes doubled.
/// Source: RFC 4180, section 2.
std::string quoted(const std::string& name) {
    if (name.find_first_of(",\"\n\r") == std::string::npos) return name;
    std::string field = "\"";
    for (const char letter : name) field += letter == '"' ? "\"\"" : std::string(1, letter);
    return field + "\"";
}

struct Curve {
    std::string name;
    Eigen::Matrix3Xd position_m;
};

}  // namespace

std::vector<ComparedMarker> compared_markers(const WorkbenchState& state) {
    std::vector<ComparedMarker> compared;
    const SceneTrial* const trial = state.scene_trial();
    const auto m = static_cast<std::size_t>(state.marker);
    for (std::size_t k = 0; trial && k < state.history.size(); ++k) {
        const JobRecord& record = state.history[k];
        const SimulatedTrial* const other = record.compared && record.run != state.run ? state.trial_of(record.run.get()) : nullptr;
        if (!other || m >= other->markers.size() || other->markers[m].cols() != trial->time_s.size()) continue;
        compared.push_back({k, record.name + " " + record.clock, &other->markers[m]});
    }
    return compared;
}

std::string marker_curves_csv(const WorkbenchState& state, double first_s, double last_s) {
    const SceneTrial* const trial = state.scene_trial();
    const auto m = static_cast<std::size_t>(state.marker);
    assert(trial && m < trial->measured.size());
    std::vector<Curve> curves{{"measured", trial->measured[m]}};
    const SimulatedTrial* const simulated = state.simulated_trial();
    if (simulated && m < simulated->markers.size() && simulated->markers[m].cols() == trial->time_s.size()) {
        curves.push_back({"simulated", simulated->markers[m]});
        curves.push_back({"residual", simulated->markers[m] - trial->measured[m]});
    }
    for (const ComparedMarker& other : compared_markers(state)) curves.push_back({other.name, *other.position_m});
    std::string text = "time_s";
    for (const Curve& curve : curves) {
        for (const char* const axis : {"_x_m", "_y_m", "_z_m"}) text += "," + quoted(curve.name + axis);
    }
    text += "\n";
    for (Eigen::Index t = 0; t < trial->time_s.size(); ++t) {
        if (trial->time_s(t) < first_s || trial->time_s(t) > last_s) continue;
        text += format_number(trial->time_s(t), digits);
        for (const Curve& curve : curves) {
            for (const double value : curve.position_m.col(t)) text += "," + format_number(value, digits);
        }
        text += "\n";
    }
    return text;
}

std::string marker_errors_csv(const std::vector<MarkerError>& errors) {
    std::string text = "marker,rms_m,largest_m,rms_x_m,rms_y_m,rms_z_m,bias_x_m,bias_y_m,bias_z_m,seen\n";
    for (const MarkerError& error : errors) {
        text += quoted(error.name);
        for (const double value : {error.rms_m, error.largest_m}) text += "," + format_number(value, digits);
        for (const Eigen::Vector3d* const axes : {&error.rms_axis_m, &error.bias_m}) {
            for (const double value : *axes) text += "," + format_number(value, digits);
        }
        text += "," + format_number(error.seen, digits) + "\n";
    }
    return text;
}

}  // namespace myo
