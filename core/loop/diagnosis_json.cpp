#include "loop/diagnosis_json.hpp"

#include <cassert>
#include <cmath>

#include "loop/confusion.hpp"
#include "loop/judge.hpp"
#include "project/output_json.hpp"

namespace myo {
namespace {

using Eigen::Index;

const char* kind_word(VerdictKind kind) {
    switch (kind) {
        case VerdictKind::none: return "none";
        case VerdictKind::effects: return "effects";
        case VerdictKind::unknown: return "unknown";
    }
    return "";
}

/// Values of a fit by the schema's names; an effect's by its parameters' own, which two effects may share.
Json parameters_json(const JointFit& fit) {
    Json json = Json::object();
    for (const StudyParameter& p : fit.parameters)
        if (p.kind != StudyParameter::Kind::effect) json[p.parameter.name] = json_number(value_of(p, fit.values));
    for (const EffectDeclaration& effect : fit.values.effects) {
        const Json parameters = effect_parameters_json(effect.parameters);
        for (const auto& [name, value] : parameters.items()) {
            const std::string key = json.contains(name) ? effect.id + "." + name : name;
            json[key] = value;
        }
    }
    return json;
}

Json fit_json(const JudgedFit& fit) { return {{"parameters", parameters_json(fit.fit)}, {"rms_m", json_number(fit.rms_m)}}; }

Json deviations_json(const JointFit& fit) {
    Json json = Json::object();
    for (std::size_t i = 0; i < fit.parameters.size(); ++i)
        if (static_cast<Index>(i) < fit.report.deviations.size()) json[fit.parameters[i].parameter.name] = json_number(fit.report.deviations(static_cast<Index>(i)));
    return json;
}

Json tests_json(const ResidualTests& tests) {
    return {{"samples", tests.samples},
            {"p_threshold", json_number(tests.threshold)},
            {"variance_ratio", json_number(tests.variance.ratio)},
            {"variance_p", json_number(tests.variance.p)},
            {"ljung_box_p", json_number(tests.ljung_box.p)},
            {"periodicity_p", json_number(tests.periodicity.p)},
            {"space_p", json_number(tests.space.p)},
            {"systematic_over_noise", json_number(tests.systematic.rms)},
            {"systematic_over_noise_std", json_number(tests.systematic.deviation)},
            {"significant", tests.significant()}};
}

Json judged_json(const JudgedFit& fit) {
    Json json = fit_json(fit);
    json["std"] = deviations_json(fit.fit);
    json["held_out_rms_over_noise"] = json_number(fit.held_out_rms);
    json["held_out_in_time_rms_over_noise"] = json_number(fit.held_out_in_time_rms);
    json["criterion"] = json_number(fit.criterion);
    json["weight"] = json_number(fit.weight);
    json["tests"] = tests_json(fit.tests);
    json["tests"]["each_marker_by_itself"] = {{"p", json_number(fit.independence.p)}, {"typical_share", json_number(fit.independence.typical_share)}, {"constant_share", json_number(fit.independence.constant_share)}, {"wander", fit.wanders()}};
    json["evaluations"] = fit.fit.report.evaluations;
    json["seconds"] = json_number(fit.fit.seconds);
    return json;
}

Json candidate_json(const Candidate& candidate) {
    Json json{{"id", candidate.score.id}};
    if (!candidate.score.failure.empty()) json["failure"] = candidate.score.failure;
    json["explained"] = json_number(candidate.score.test.explained);
    json["statistic"] = json_number(candidate.score.test.statistic);
    json["p"] = json_number(candidate.adjusted_p);
    json["score_seconds"] = json_number(candidate.score.seconds);
    json["start"] = effect_parameters_json(candidate.score.best.effect);
    if (!candidate.like.empty()) json["indistinguishable_from"] = candidate.like;
    if (candidate.judged) json["fit"] = judged_json(*candidate.judged);
    return json;
}

Json numerics_json(const Diagnosis& d) {
    const NumericalError& n = d.numerics;
    return {{"numerical_damping", {{"half_step_rms_m", json_number(n.step_rms_m)}, {"damping_ratio_of_the_scheme", json_number(n.numerical_damping)}}},
            {"discretisation", {{"finer_mesh_rms_m", json_number(n.mesh_rms_m)}, {"mesh_ratio", json_number(n.mesh_ratio)}}},
            {"made_up_for_by_the_modulus", {{"modulus_factor", n.stiffening.factor()}, {"rest_rms_m", json_number(n.rest_rms_m)}}},
            {"left_after_extrapolation_rms_m", json_number(n.left_rms_m)},
            {"allowance_over_noise", json_number(numerical_allowance(d.data, n))},
            {"message", n.message}};
}

/// rms of each marker in each trial, before and after.
Json markers_json(const Study& study, const Diagnosis& d) {
    Json json = Json::object();
    for (const StudyTrial& trial : study.trials) {
        const TrialScore* const before = find_score(d.before, trial.name);
        const TrialScore* const after = find_score(d.after, trial.name);
        for (std::size_t m = 0; m < study.marker_names.size(); ++m) {
            const auto rms = [&](const TrialScore* score) { return json_number(score ? score->markers[m].rms_m : std::nan("")); };
            json[trial.name][study.marker_names[m]] = {{"before_rms_m", rms(before)}, {"after_rms_m", rms(after)}, {"noise_m", json_number(study.noise_m(static_cast<Index>(m)))}};
        }
    }
    return json;
}

Json missing_force_json(const MissingForce& force) {
    Json json{{"trial", force.trial}};
    if (!force.failure.empty()) json["failure"] = force.failure;
    json["before_over_noise"] = json_number(force.before_over_noise);
    json["after_over_noise"] = json_number(force.after_over_noise);
    json["removed"] = json_number(force.removed());
    json["time_s"] = json_array(force.time_s);
    json["modes"] = Json::array();
    for (const ForceMode& mode : force.modes) {
        Json entry{{"where", mode.where}, {"share", json_number(mode.share)}, {"place", json_number(mode.place)}};
        entry["centroid_m"] = json_array(mode.centroid_m);
        entry["direction"] = json_array(mode.direction);
        entry["aligned"] = json_number(mode.aligned);
        entry["steady"] = json_number(mode.steady);
        entry["rms_N"] = json_number(mode.rms_N());
        entry["peak_N"] = json_number(mode.peak_N());
        entry["amplitude_N"] = json_array(mode.amplitude_N);
        entry["correlates"] = Json::array();
        for (const Correlate& c : mode.correlates)
            entry["correlates"].push_back({{"with", c.name}, {"correlation", json_number(c.correlation)}, {"effective_samples", json_number(c.effective_samples)}, {"p", json_number(c.p)}});
        json["modes"].push_back(std::move(entry));
    }
    return json;
}

Json details_json(const Study& study, const Diagnosis& d) {
    Json json{{"verdict", kind_word(d.verdict.kind)}, {"because", d.verdict.because}, {"false_alarm_rate", json_number(d.settings.alpha)}, {"suspects_ruled_out", numerics_json(d)}};
    json["declared"] = judged_json(d.declared);
    json["augmented"] = judged_json(d.augmented);
    json["candidates"] = Json::array();
    for (const Candidate& candidate : d.candidates) json["candidates"].push_back(candidate_json(candidate));
    json["pairs"] = Json::array();
    for (const JudgedFit& pair : d.pairs) {
        Json entry{{"ids", Json::array()}};
        for (const EffectDeclaration& effect : pair.fit.effects) entry["ids"].push_back(effect.id);
        entry["fit"] = judged_json(pair);
        json["pairs"].push_back(std::move(entry));
    }
    json["not_to_be_told_apart"] = Json::array();
    for (const Confusion& c : d.confusions)
        json["not_to_be_told_apart"].push_back({{"ids", {c.first, c.second}}, {"cosine", json_number(c.cosine)}, {"fits_decide", is_decided(d, c)}, {"next_experiment", c.next_experiment}});
    json["markers"] = markers_json(study, d);
    json["cost"] = Json::array();
    for (const StageCost& cost : d.cost) json["cost"].push_back({{"stage", cost.stage}, {"seconds", json_number(cost.seconds)}, {"runs", cost.runs}});
    if (d.missing_force) json["missing_force"] = missing_force_json(*d.missing_force);
    json["seconds"] = json_number(d.seconds);
    json["notes"] = d.notes;
    return json;
}

}  // namespace

Json effect_parameters_json(const EffectParameters& parameters) {
    Json json = Json::object();
    for (const auto& [name, value] : parameters) {
        if (const auto* const number = std::get_if<double>(&value)) json[name] = name == "axis" ? Json(static_cast<int>(*number)) : json_number(*number);
        else if (const auto* const vector = std::get_if<Eigen::VectorXd>(&value)) json[name] = json_array(*vector);
        else if (const auto* const word = std::get_if<std::string>(&value)) json[name] = *word;
        else json[name] = std::get<std::vector<std::string>>(value);
    }
    return json;
}

Json diagnosis_json(const Study& study, const Diagnosis& d, const std::string& folder) {
    assert(d.complete());
    Json json{{"schema", "report/1"}, {"experiment", folder}, {"declared_fit", fit_json(d.declared)}, {"noise_floor_m", json_number(d.noise_m)}};
    Json effects = Json::array();
    if (d.verdict.kind != VerdictKind::effects)
        effects.push_back({{"id", kind_word(d.verdict.kind)}, {"confidence", json_number(d.verdict.confidence)}, {"parameters", Json::object()}});
    for (const EffectDeclaration& effect : d.verdict.effects)
        effects.push_back({{"id", effect.id}, {"confidence", json_number(d.verdict.confidence)}, {"parameters", effect_parameters_json(effect.parameters)}});
    json["verdict"] = {{"effects", effects}, {"ranking", d.verdict.ranking}};
    json["augmented_fit"] = fit_json(d.augmented);
    json["validation"] = {{"before_rms_m", json_number(d.before.validation_rms_m)}, {"after_rms_m", json_number(d.after.validation_rms_m)}};
    json["trials"] = Json::array();
    for (const StudyTrial& trial : study.trials) {
        const TrialScore* const before = find_score(d.before, trial.name);
        const TrialScore* const after = find_score(d.after, trial.name);
        const auto rms = [](const TrialScore* score) { return json_number(score ? score->rms_m : std::nan("")); };
        json["trials"].push_back({{"name", trial.name}, {"role", trial.role == TrialRole::fit ? "fit" : "validate"}, {"before_rms_m", rms(before)}, {"after_rms_m", rms(after)}});
    }
    json["details"] = details_json(study, d);
    return json;
}

}  // namespace myo
