#include <cmath>

#include "calibration/calibrate.hpp"
#include "effect/direction.hpp"
#include "report/json.hpp"

namespace myo::calibration {

namespace {

namespace fs = std::filesystem;

/// Value of a parameter as the file holds it; NaN if there is none.
double held_value(const report::Json& parameters, const std::string& name) {
    if (!parameters.contains(name)) return std::nan("");
    const report::Json& entry = parameters.at(name);
    const bool held = entry.is_object() && entry.contains("value") && entry.at("value").is_number();
    return held ? entry.at("value").get<double>() : std::nan("");
}

/// Replaces the three components of fitted directions, which were written before directions had two angles, by the
/// angles. Notes say which.
void read_components_as_angles(const std::vector<prediction::ModelParameter>& wanted, report::Json& parameters,
                               std::vector<std::string>& notes) {
    for (std::size_t i = 0; i + 1 < wanted.size(); ++i) {
        if (!wanted[i].is_angle() || wanted[i].component != 0) continue;
        const std::string& first = wanted[i].parameter.name;
        const std::string stem = first.substr(0, first.rfind('.'));
        const Eigen::Vector3d direction(held_value(parameters, stem + ".x"), held_value(parameters, stem + ".y"),
                                        held_value(parameters, stem + ".z"));
        if (parameters.contains(first) || !direction.allFinite() || direction.isZero(0.0)) continue;
        const Eigen::Vector2d angles = effect::direction_angles(wanted[i].base, direction);
        for (const char* axis : {".x", ".y", ".z"}) parameters.erase(stem + axis);
        parameters[first] = {{"value", angles(0)}};
        parameters[wanted[i + 1].parameter.name] = {{"value", angles(1)}};
        notes.push_back(stem + ": the components x, y and z of an earlier version are read as two angles");
    }
}

}  // namespace

Result<EarlierCalibration> read_calibration(const fs::path& folder, const setup::Setup& setup,
                                            const CalibrationSettings& settings) {
    const fs::path file = folder / "calibrate.json";
    std::error_code code;
    if (!fs::exists(file, code)) return Error{"there is nothing to resume: no calibrate.json", folder.string()};
    const Result<report::Json> json = report::read_json(file);
    if (!json) return json.error();
    // A file that does not match is an error: continuing from other parameters would give a wrong start silently.
    const auto refuse = [&](const std::string& what) {
        return Error{what + "; without --resume it starts again", file.string()};
    };
    if (!json->is_object() || !json->contains("schema") || json->at("schema") != "calibrate/1" ||
        !json->contains("parameters"))
        return refuse("is not of the form calibrate/1");
    report::Json parameters = json->at("parameters");
    const std::vector<prediction::ModelParameter> wanted = prediction::free_parameters(setup, settings.names);
    EarlierCalibration earlier;
    if (parameters.is_object()) read_components_as_angles(wanted, parameters, earlier.notes);
    if (!parameters.is_object() || parameters.size() != wanted.size()) return refuse("has other parameters");
    for (const prediction::ModelParameter& p : wanted) {
        const std::string& name = p.parameter.name;
        if (!parameters.contains(name)) return refuse("has no value of " + name);
        const report::Json& entry = parameters.at(name);
        if (!entry.is_object() || !entry.contains("value") || !entry.at("value").is_number())
            return refuse("has no number as the value of " + name);
        earlier.values[name] = entry.at("value").get<double>();
    }
    // Files of earlier versions lack this count; it then begins at 0.
    if (json->contains("evaluations_in_all") && json->at("evaluations_in_all").is_number_integer())
        earlier.evaluations = json->at("evaluations_in_all").get<int>();
    return earlier;
}

}  // namespace myo::calibration
