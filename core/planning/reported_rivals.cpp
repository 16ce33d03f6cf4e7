#include "planning/reported_rivals.hpp"

#include <algorithm>

#include "diagnosis/screening/confusion.hpp"
#include "effect/catalogue.hpp"
#include "report/json.hpp"

namespace myo::planning {
namespace {

using report::Json;

/// A fit of a report with its share of the evidence.
struct ReportedFit {
    RivalStart start;
    double weight = 0.0;

    bool holds(const std::string& id) const {
        return std::find(start.ids.begin(), start.ids.end(), id) != start.ids.end();
    }
};

/// The value of an effect's parameter as effect_parameters_json() writes it.
/// Throws Json::exception if the value has another form.
effect::EffectParameter parameter_in(const Json& json) {
    if (json.is_string()) return json.get<std::string>();
    if (json.is_number()) return json.get<double>();
    if (!json.empty() && json.front().is_string()) return json.get<std::vector<std::string>>();
    const auto numbers = json.get<std::vector<double>>();
    return Eigen::VectorXd(
        Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size())));
}

/// Reports of earlier versions hold no effects with their fits; these are then fitted again.
ReportedFit fit_in(std::vector<std::string> ids, const Json& json) {
    ReportedFit fit{{std::move(ids)}, json.value("weight", 0.0)};
    if (!json.contains("effects")) return fit;
    for (const Json& effect : json.at("effects")) {
        effect::EffectDeclaration declared;
        declared.id = effect.at("id").get<std::string>();
        for (const auto& [name, value] : effect.at("parameters").items())
            declared.parameters[name] = parameter_in(value);
        fit.start.effects.push_back(std::move(declared));
    }
    for (const auto& [name, value] : json.at("parameters").items())
        if (value.is_number()) fit.start.parameters[name] = value.get<double>();
    return fit;
}

/// All fits of a report, the declared one included, by decreasing weight. Throws Json::exception.
std::vector<ReportedFit> fits_in(const Json& report) {
    const Json& details = report.at("details");
    std::vector<ReportedFit> fits{fit_in({}, details.at("declared"))};
    for (const Json& candidate : details.at("candidates"))
        if (candidate.contains("fit"))
            fits.push_back(fit_in({candidate.at("id").get<std::string>()}, candidate.at("fit")));
    for (const Json& set : details.at("sets"))
        fits.push_back(fit_in(set.at("ids").get<std::vector<std::string>>(), set.at("fit")));
    std::stable_sort(fits.begin(), fits.end(),
                     [](const ReportedFit& a, const ReportedFit& b) { return a.weight > b.weight; });
    return fits;
}

/// First fit that holds one effect and not the other; the effect alone, to be fitted, where there is none.
RivalStart start_with(const std::vector<ReportedFit>& fits, const std::string& id, const std::string& without) {
    for (const ReportedFit& fit : fits)
        if (fit.holds(id) && !fit.holds(without)) return fit.start;
    return {{id}};
}

/// See reported_rivals(). Throws Json::exception if the report has another form.
Result<std::array<RivalStart, 2>> rivals_in(const Json& report, const std::filesystem::path& file,
                                            const effect::Laws& laws) {
    const std::vector<ReportedFit> fits = fits_in(report);
    // A report may name a law that the experiment no longer lists.
    for (const ReportedFit& fit : fits)
        for (const std::string& id : fit.start.ids)
            if (!effect::find_effect(id, laws))
                return Error{"names an effect that is not known: \"" + id + "\"", file.string()};
    const Json& groups = report.at("verdict").at("not_told_apart");
    // Effects that the diagnosis could not separate come before fits that merely have similar weights.
    if (!groups.empty() && groups.front().size() > 1) {
        const auto first = groups.front().at(0).get<std::string>(), second = groups.front().at(1).get<std::string>();
        for (const std::string& id : {first, second})
            if (!effect::find_effect(id, laws))
                return Error{"names an effect that is not known: \"" + id + "\"", file.string()};
        return std::array{start_with(fits, first, second), start_with(fits, second, first)};
    }
    if (fits.size() < 2) return Error{"holds no two fits that could be told apart", file.string()};
    return std::array{fits[0].start, fits[1].start};
}

/// Heaviest fit that holds one effect and not the other; null if there is none.
const diagnosis::JudgedFit* heaviest(const diagnosis::Diagnosis& d, const std::string& id, const std::string& without) {
    const auto holds = [](const diagnosis::JudgedFit& fit, const std::string& wanted) {
        return std::any_of(fit.fit.effects.begin(), fit.fit.effects.end(),
                           [&](const effect::EffectDeclaration& effect) { return effect.id == wanted; });
    };
    const diagnosis::JudgedFit* best = nullptr;
    const auto consider = [&](const diagnosis::JudgedFit& fit) {
        if (fit.usable() && holds(fit, id) && !holds(fit, without) && (!best || fit.weight > best->weight)) best = &fit;
    };
    for (const diagnosis::Candidate& candidate : d.candidates)
        if (candidate.judged) consider(*candidate.judged);
    for (const diagnosis::JudgedFit& set : d.sets) consider(set);
    return best;
}

}  // namespace

Result<std::array<RivalStart, 2>> reported_rivals(const std::filesystem::path& file, const effect::Laws& laws) {
    const Result<Json> json = report::read_json(file);
    if (!json) return json.error();
    try {
        return rivals_in(*json, file, laws);
    } catch (const Json::exception&) {
        // Missing keys and wrong types throw in the library that reads JSON.
        return Error{"is no report of a diagnosis", file.string()};
    }
}

std::optional<std::array<Rival, 2>> diagnosed_rivals(const diagnosis::Diagnosis& d) {
    for (const diagnosis::Confusion& confusion : diagnosis::confusions_of_verdict(d)) {
        if (diagnosis::is_decided(d, confusion)) continue;
        const diagnosis::JudgedFit* const first = heaviest(d, confusion.first, confusion.second);
        const diagnosis::JudgedFit* const second = heaviest(d, confusion.second, confusion.first);
        if (first && second) return std::array{rival_of(first->fit, d.data), rival_of(second->fit, d.data)};
    }
    return std::nullopt;
}

}  // namespace myo::planning
