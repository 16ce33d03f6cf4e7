#include "sweep/case_numbers.hpp"

#include <cmath>

#include "base/text.hpp"
#include "report/json.hpp"

namespace myo::sweep {
namespace {

using report::Json;

/// Number of a key; NaN if it is missing or null.
double number_at(const Json& json, const std::string& key) {
    const auto found = json.find(key);
    return found != json.end() && found->is_number() ? found->get<double>() : std::nan("");
}

/// Text of a key; empty if it is missing or no text.
std::string text_at(const Json& json, const std::string& key) {
    const auto found = json.find(key);
    return found != json.end() && found->is_string() ? found->get<std::string>() : "";
}

/// Whether a key holds true; a missing one does not.
bool true_at(const Json& json, const std::string& key) {
    const auto found = json.find(key);
    return found != json.end() && found->is_boolean() && found->get<bool>();
}

/// Child of an object; an empty object if it is missing.
const Json& child_at(const Json& json, const std::string& key) {
    static const Json none = Json::object();
    const auto found = json.find(key);
    return found != json.end() ? *found : none;
}

/// Numbers in the order of the table; what a report does not hold is left out.
class Numbers {
public:
    void add(const std::string& name, const std::string& unit, double value, double deviation = std::nan(""),
             bool shown = true) {
        if (!std::isnan(value)) list_.push_back({name, unit, value, deviation, shown});
    }
    void add_hidden(const std::string& name, const std::string& unit, double value) {
        add(name, unit, value, std::nan(""), false);
    }
    std::vector<CaseNumber> list() && { return std::move(list_); }

private:
    std::vector<CaseNumber> list_;
};

/// Where the markers of a trial come to rest.
void add_places(const Json& trial, Numbers& numbers) {
    static constexpr const char* axes[] = {"x", "y", "z"};
    for (const auto& [marker, score] : child_at(trial, "markers").items()) {
        const Json& place = child_at(score, "steady_state_m");
        for (std::size_t axis = 0; axis < 3 && axis < place.size(); ++axis)
            if (place.is_array() && place.at(axis).is_number())
                numbers.add_hidden(marker + " " + axes[axis] + " at rest in " + text_at(trial, "name"), "m",
                                   place.at(axis).get<double>());
    }
}

/// Errors of all trials and places of their markers.
///
/// @param rms_key  key of the rms, which depends on the report
/// @param shown    whether the rms are shown on the page
void add_trials(const Json& json, const char* rms_key, bool shown, Numbers& numbers) {
    for (const Json& trial : child_at(json, "trials")) {
        numbers.add("rms of " + text_at(trial, "name"), "m", number_at(trial, rms_key), std::nan(""), shown);
        numbers.add_hidden("mean distance of " + text_at(trial, "name"), "m", number_at(trial, "mean_distance_m"));
        add_places(trial, numbers);
    }
}

// One function per report. The order in which numbers are added is that of the columns.
CaseNumbers of_simulation(const Json& json) {
    Numbers numbers;
    add_trials(json, "rms_m", true, numbers);
    numbers.add_hidden("steps", "", number_at(json, "steps"));
    numbers.add_hidden("degrees of freedom", "", number_at(json, "dofs"));
    return {"", std::move(numbers).list()};
}

/// Fitted values first, then errors; whether the fit converged is the verdict.
CaseNumbers of_calibration(const Json& json) {
    Numbers numbers;
    for (const auto& [name, parameter] : child_at(json, "parameters").items())
        numbers.add(name, text_at(parameter, "unit"), number_at(parameter, "value"), number_at(parameter, "std"));
    numbers.add("rms of the fit", "m", number_at(json, "rms_after_m"));
    numbers.add("rms of the validation trials", "m", number_at(json, "validation_rms_after_m"));
    add_trials(json, "rms_after_m", false, numbers);
    numbers.add_hidden("rms before the fit", "m", number_at(json, "rms_before_m"));
    numbers.add_hidden("evaluations", "", number_at(json, "evaluations"));
    numbers.add_hidden("degrees of freedom", "", number_at(json, "dofs"));
    return {true_at(json, "converged") ? "converged" : "not converged", std::move(numbers).list()};
}

/// Numbers and vectors among the parameters of an effect.
void add_effect(const Json& effect, Numbers& numbers) {
    for (const auto& [name, value] : child_at(effect, "parameters").items()) {
        const std::string whole = text_at(effect, "id") + "." + name;
        if (value.is_number()) numbers.add(whole, "", value.get<double>());
        for (std::size_t i = 0; value.is_array() && i < value.size(); ++i)
            if (value.at(i).is_number())
                numbers.add_hidden(whole + "[" + std::to_string(i) + "]", "", value.at(i).get<double>());
    }
}

/// Confidence and parameters of the verdict's effects, then errors; the effects are the verdict.
CaseNumbers of_diagnosis(const Json& json) {
    Numbers numbers;
    std::vector<std::string> effects;
    const Json& verdict = child_at(json, "verdict");
    numbers.add("confidence", "", number_at(verdict, "confidence"));
    for (const Json& effect : child_at(verdict, "effects")) {
        effects.push_back(text_at(effect, "id"));
        add_effect(effect, numbers);
    }
    numbers.add("rms of the declared fit", "m", number_at(child_at(json, "declared_fit"), "rms_m"));
    numbers.add("rms of the fit", "m", number_at(child_at(json, "augmented_fit"), "rms_m"));
    numbers.add("rms of the validation trials before", "m", number_at(child_at(json, "validation"), "before_rms_m"));
    numbers.add("rms of the validation trials", "m", number_at(child_at(json, "validation"), "after_rms_m"));
    // Material values of the fit with the effects, which may differ from the declared ones.
    for (const auto& [name, value] : child_at(child_at(json, "augmented_fit"), "parameters").items())
        if (value.is_number()) numbers.add_hidden(name, "", value.get<double>());
    add_trials(json, "after_rms_m", false, numbers);
    return {join(effects, " + "), std::move(numbers).list()};
}

/// Remaining distance and held signals; whether the target was reached is the verdict.
CaseNumbers of_optimization(const Json& json) {
    Numbers numbers;
    numbers.add("rms of the target", "m", number_at(json, "rms_after_m"));
    numbers.add("remaining distance", "noise levels", number_at(json, "noise_levels"));
    for (const Json& signal : child_at(json, "signals")) {
        // A signal over time is in its own file; one that is held is a number.
        const Json& values = child_at(signal, "values");
        const Json& deviations = child_at(signal, "std");
        if (values.size() != 1 || !values.at(0).is_number()) continue;
        const bool known = deviations.size() == 1 && deviations.at(0).is_number();
        numbers.add(text_at(signal, "name"), text_at(signal, "unit"), values.at(0).get<double>(),
                    known ? deviations.at(0).get<double>() : std::nan(""));
    }
    for (const Json& item : child_at(child_at(json, "design"), "items"))
        numbers.add(text_at(item, "item") + ".youngs_modulus_Pa", "", number_at(item, "youngs_modulus_Pa"));
    add_trials(json, "rms_m", false, numbers);
    numbers.add_hidden("rms before the search", "m", number_at(json, "rms_before_m"));
    numbers.add_hidden("evaluations", "", number_at(json, "evaluations"));
    return {true_at(json, "reached") ? "reached" : "not reached", std::move(numbers).list()};
}

}  // namespace

std::filesystem::path report_of(CaseCommand command, const std::filesystem::path& folder) {
    return folder / (command == CaseCommand::diagnose ? "report.json" : to_string(command) + ".json");
}

Result<CaseNumbers> read_case_numbers(CaseCommand command, const std::filesystem::path& folder) {
    const std::filesystem::path file = report_of(command, folder);
    const Result<Json> json = report::read_json(file);
    if (!json) return json.error();
    if (!json->is_object()) return Error{"is no report", file.string()};
    try {
        switch (command) {
            case CaseCommand::simulate: return of_simulation(*json);
            case CaseCommand::calibrate: return of_calibration(*json);
            case CaseCommand::diagnose: return of_diagnosis(*json);
            case CaseCommand::optimize: return of_optimization(*json);
        }
    } catch (const Json::exception& wrong) {
        return Error{std::string("has another form: ") + wrong.what(), file.string()};
    }
    return Error{"is no report", file.string()};
}

}  // namespace myo::sweep
