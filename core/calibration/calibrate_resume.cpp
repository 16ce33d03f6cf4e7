#include "calibration/calibrate.hpp"
#include "report/json.hpp"

namespace myo::calibration {

namespace fs = std::filesystem;

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
    const report::Json& parameters = json->at("parameters");
    const std::vector<prediction::ModelParameter> wanted = prediction::free_parameters(setup, settings.names);
    if (!parameters.is_object() || parameters.size() != wanted.size()) return refuse("has other parameters");
    EarlierCalibration earlier;
    for (const prediction::ModelParameter& p : wanted) {
        const std::string& name = p.parameter.name;
        if (!parameters.contains(name)) return refuse("has no value of " + name);
        const report::Json& entry = parameters.at(name);
        if (!entry.is_object() || !entry.contains("value") || !entry.at("value").is_number())
            return refuse("has no number as the value of " + name);
        earlier.values[name] = entry.at("value").get<double>();
    }
    if (json->contains("evaluations_in_all") && json->at("evaluations_in_all").is_number_integer())
        earlier.evaluations = json->at("evaluations_in_all").get<int>();
    return earlier;
}

}  // namespace myo::calibration
