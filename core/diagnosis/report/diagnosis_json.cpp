#include "diagnosis/report/diagnosis_json.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "diagnosis/screening/confusion.hpp"
#include "diagnosis/selection/judgement.hpp"
#include "diagnosis/verdict/deviations.hpp"
#include "diagnosis/verdict/probabilities.hpp"
#include "results/output_json.hpp"
#include "results/robot_tables.hpp"

namespace myo::diagnosis {
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

/// Values of a fit under the names of the schema; those of effects under the names of their parameters, with the id of
/// the effect in front if a name is taken.
report::Json parameters_json(const JointFit& fit) {
    report::Json json = report::Json::object();
    for (const prediction::ModelParameter& p : fit.parameters)
        if (p.kind != prediction::ModelParameter::Kind::effect)
            json[p.parameter.name] = report::json_number(prediction::value_of(p, fit.values));
    for (const effect::EffectDeclaration& effect : fit.values.effects) {
        const report::Json parameters = effect_parameters_json(effect.parameters);
        for (const auto& [name, value] : parameters.items()) {
            // Two effects may share the name of a parameter, such as position_m.
            const std::string key = json.contains(name) ? effect.id + "." + name : name;
            json[key] = value;
        }
    }
    return json;
}

/// Values and rms of a fit, as the schema states them for both fits.
report::Json fit_json(const JudgedFit& fit) {
    return {{"parameters", parameters_json(fit.fit)}, {"rms_m", report::json_number(fit.rms_m)}};
}

/// Standard deviation of each fitted number under its name; null where it is unknown.
report::Json deviations_json(const JointFit& fit) {
    report::Json json = report::Json::object();
    for (std::size_t i = 0; i < fit.parameters.size(); ++i)
        if (static_cast<Index>(i) < fit.report.deviations.size())
            json[fit.parameters[i].parameter.name] = report::json_number(fit.report.deviations(static_cast<Index>(i)));
    return json;
}

/// Results of the residual tests; a p-value below p_threshold is significant.
report::Json tests_json(const statistics::ResidualTests& tests) {
    return {{"samples", tests.samples},
            {"p_threshold", report::json_number(tests.threshold)},
            {"variance_ratio", report::json_number(tests.variance.ratio)},
            {"variance_p", report::json_number(tests.variance.p)},
            {"ljung_box_p", report::json_number(tests.ljung_box.p)},
            {"periodicity_p", report::json_number(tests.periodicity.p)},
            {"space_p", report::json_number(tests.space.p)},
            {"systematic_over_noise", report::json_number(tests.systematic.rms)},
            {"systematic_over_noise_std", report::json_number(tests.systematic.deviation)},
            {"significant", tests.significant()}};
}

/// Fit with its assessment, for `details`.
report::Json judged_json(const JudgedFit& fit) {
    report::Json json = fit_json(fit);
    json["effects"] = report::Json::array();
    for (const effect::EffectDeclaration& effect : fit.fit.effects)
        json["effects"].push_back({{"id", effect.id}, {"parameters", effect_parameters_json(effect.parameters)}});
    json["std"] = deviations_json(fit.fit);
    json["held_out_rms_over_noise"] = report::json_number(fit.held_out_rms);
    json["held_out_in_time_rms_over_noise"] = report::json_number(fit.held_out_in_time_rms);
    json["criterion"] = report::json_number(fit.criterion);
    json["weight"] = report::json_number(fit.weight);
    json["tests"] = tests_json(fit.tests);
    json["tests"]["each_marker_by_itself"] = {{"p", report::json_number(fit.independence.p)},
                                              {"typical_share", report::json_number(fit.independence.typical_share)},
                                              {"constant_share", report::json_number(fit.independence.constant_share)},
                                              {"wander", fit.drifts()}};
    json["evaluations"] = fit.fit.report.evaluations;
    json["seconds"] = report::json_number(fit.fit.seconds);
    return json;
}

/// Effect that was tried: score, and fit if there was one.
report::Json candidate_json(const Candidate& candidate) {
    report::Json json{{"id", candidate.score.id}};
    if (!candidate.score.failure.empty()) json["failure"] = candidate.score.failure;
    json["explained"] = report::json_number(candidate.score.test.explained);
    json["statistic"] = report::json_number(candidate.score.test.statistic);
    json["p"] = report::json_number(candidate.adjusted_p);
    json["score_seconds"] = report::json_number(candidate.score.seconds);
    json["start"] = effect_parameters_json(candidate.score.best.effect);
    if (!candidate.confounded_with.empty()) json["indistinguishable_from"] = candidate.confounded_with;
    if (candidate.judged) json["fit"] = judged_json(*candidate.judged);
    return json;
}

/// Sources of numerical error, with the names of the schema.
report::Json numerics_json(const Diagnosis& d) {
    const NumericalError& n = d.numerics;
    return {
        {"numerical_damping",
         {{"half_step_rms_m", report::json_number(n.step_rms_m)},
          {"damping_ratio_of_the_scheme", report::json_number(n.numerical_damping)}}},
        {"discretisation",
         {{"finer_mesh_rms_m", report::json_number(n.mesh_rms_m)}, {"mesh_ratio", report::json_number(n.mesh_ratio)}}},
        {"made_up_for_by_the_modulus",
         {{"modulus_factor", n.effective_modulus.factor()}, {"rest_rms_m", report::json_number(n.rest_rms_m)}}},
        {"left_after_extrapolation_rms_m", report::json_number(n.left_rms_m)},
        {"allowance_over_noise", report::json_number(numerical_allowance(d.data, n, d.settings.policy.judgement))},
        {"message", n.message}};
}

/// Rms of each marker in each trial, before and after.
report::Json markers_json(const setup::Setup& setup, const Diagnosis& d) {
    report::Json json = report::Json::object();
    for (const setup::PreparedTrial& trial : setup.trials) {
        const prediction::TrialScore* const before = results::find_score(d.before, trial.name);
        const prediction::TrialScore* const after = results::find_score(d.after, trial.name);
        for (std::size_t m = 0; m < setup.marker_names.size(); ++m) {
            const auto rms = [&](const prediction::TrialScore* score) {
                return report::json_number(score ? score->markers[m].rms_m : std::nan(""));
            };
            const auto distance = [&](const prediction::TrialScore* score) {
                return report::json_number(score ? score->markers[m].distance_m : std::nan(""));
            };
            json[trial.name][setup.marker_names[m]] = {
                {"before_rms_m", rms(before)},
                {"after_rms_m", rms(after)},
                {"before_mean_distance_m", distance(before)},
                {"after_mean_distance_m", distance(after)},
                {"noise_m", report::json_number(setup.noise_m(static_cast<Index>(m)))}};
        }
    }
    return json;
}

/// The missing force with its modes; its unit is in the key, places are shares of the body's length.
report::Json missing_force_json(const MissingForce& force) {
    report::Json json{{"trial", force.trial}};
    if (!force.failure.empty()) json["failure"] = force.failure;
    json["before_over_noise"] = report::json_number(force.before_over_noise);
    json["after_over_noise"] = report::json_number(force.after_over_noise);
    json["removed"] = report::json_number(force.removed());
    json["time_s"] = report::json_array(force.time_s);
    json["modes"] = report::Json::array();
    for (const ForceMode& mode : force.modes) {
        report::Json entry{{"where", mode.where},
                           {"share", report::json_number(mode.share)},
                           {"place", report::json_number(mode.place)}};
        entry["centroid_m"] = report::json_array(mode.centroid_m);
        entry["direction"] = report::json_array(mode.direction);
        entry["aligned"] = report::json_number(mode.aligned);
        entry["steady"] = report::json_number(mode.steady);
        entry["rms_N"] = report::json_number(mode.rms_N());
        entry["peak_N"] = report::json_number(mode.peak_N());
        entry["amplitude_N"] = report::json_array(mode.amplitude_N);
        entry["correlates"] = report::Json::array();
        for (const statistics::Correlate& c : mode.correlates)
            entry["correlates"].push_back({{"with", c.name},
                                           {"correlation", report::json_number(c.correlation)},
                                           {"effective_samples", report::json_number(c.effective_samples)},
                                           {"p", report::json_number(c.p)}});
        json["modes"].push_back(std::move(entry));
    }
    return json;
}

/// Groups of effects that neither the experiment separates nor the fits decide between.
report::Json not_told_apart_json(const Diagnosis& d) {
    report::Json json = report::Json::array();
    for (const std::vector<std::string>& group : d.verdict.twins) json.push_back(group);
    const auto in_one_group = [&](const Confusion& c) {
        return std::any_of(d.verdict.twins.begin(), d.verdict.twins.end(), [&](const std::vector<std::string>& group) {
            return std::count(group.begin(), group.end(), c.first) > 0 &&
                   std::count(group.begin(), group.end(), c.second) > 0;
        });
    };
    for (const Confusion& confusion : confusions_of_verdict(d))
        if (!is_decided(d, confusion) && !in_one_group(confusion)) json.push_back({confusion.first, confusion.second});
    return json;
}

/// Evidence for the verdict. Its keys are those of report/1, also where the code has other words by now.
report::Json details_json(const setup::Setup& setup, const Diagnosis& d) {
    report::Json json{{"verdict", kind_word(d.verdict.kind)},
                      {"because", d.verdict.reason},
                      {"false_alarm_rate", report::json_number(d.settings.alpha)},
                      {"suspects_ruled_out", numerics_json(d)}};
    json["declared"] = judged_json(d.declared);
    json["augmented"] = judged_json(d.augmented);
    json["candidates"] = report::Json::array();
    for (const Candidate& candidate : d.candidates) json["candidates"].push_back(candidate_json(candidate));
    json["sets"] = report::Json::array();
    for (const JudgedFit& set : d.sets) {
        report::Json entry{{"ids", report::Json::array()}};
        for (const effect::EffectDeclaration& effect : set.fit.effects) entry["ids"].push_back(effect.id);
        entry["fit"] = judged_json(set);
        json["sets"].push_back(std::move(entry));
    }
    json["not_to_be_told_apart"] = report::Json::array();
    for (const Confusion& c : d.confusions)
        json["not_to_be_told_apart"].push_back({{"ids", {c.first, c.second}},
                                                {"cosine", report::json_number(c.cosine)},
                                                {"fits_decide", is_decided(d, c)},
                                                {"next_experiment", c.next_experiment}});
    json["markers"] = markers_json(setup, d);
    json["cost"] = report::Json::array();
    for (const PhaseCost& cost : d.cost)
        json["cost"].push_back(
            {{"phase", cost.phase}, {"seconds", report::json_number(cost.seconds)}, {"runs", cost.runs}});
    if (d.missing_force) json["missing_force"] = missing_force_json(*d.missing_force);
    json["seconds"] = report::json_number(d.seconds);
    json["search_complete"] = d.search_complete;
    if (d.settings.search_limit_s) json["search_limit_s"] = report::json_number(*d.settings.search_limit_s);
    json["notes"] = d.notes;
    return json;
}

}  // namespace

report::Json intervals_json(const JointFit& fit, const std::string& effect) {
    report::Json json = report::Json::object();
    for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
        const prediction::ModelParameter& p = fit.parameters[i];
        if (p.kind != prediction::ModelParameter::Kind::effect || p.is_angle() ||
            fit.values.effects[p.index].id != effect || static_cast<Index>(i) >= fit.report.deviations.size())
            continue;
        const std::optional<Interval> interval = interval_95(p.parameter, prediction::value_of(p, fit.values),
                                                             fit.report.deviations(static_cast<Index>(i)));
        report::Json pair;
        if (interval) pair = {report::json_number(interval->low), report::json_number(interval->high)};
        if (p.component < 0)
            json[p.of_effect] = std::move(pair);
        else
            json[p.of_effect].push_back(std::move(pair));
    }
    return json;
}

report::Json effect_parameters_json(const effect::EffectParameters& parameters) {
    report::Json json = report::Json::object();
    for (const auto& [name, value] : parameters) {
        if (const auto* const number = std::get_if<double>(&value))
            // An axis is a number in memory and an integer in files.
            json[name] = name == "axis" ? report::Json(static_cast<int>(*number)) : report::json_number(*number);
        else if (const auto* const vector = std::get_if<Eigen::VectorXd>(&value))
            json[name] = report::json_array(*vector);
        else if (const auto* const word = std::get_if<std::string>(&value))
            json[name] = *word;
        else
            json[name] = std::get<std::vector<std::string>>(value);
    }
    return json;
}

report::Json diagnosis_json(const setup::Setup& setup, const Diagnosis& d, const std::string& folder) {
    assert(d.complete());
    report::Json json{{"schema", "report/1"},
                      {"experiment", folder},
                      {"declared_fit", fit_json(d.declared)},
                      {"noise_floor_m", report::json_number(d.noise_m)}};
    report::Json effects = report::Json::array();
    // `none` and `unknown` stand in the list of effects as an effect without parameters.
    if (d.verdict.kind != VerdictKind::effects)
        effects.push_back({{"id", kind_word(d.verdict.kind)},
                           {"confidence", report::json_number(d.verdict.confidence)},
                           {"parameters", report::Json::object()}});
    for (const effect::EffectDeclaration& effect : d.verdict.effects)
        effects.push_back({{"id", effect.id},
                           {"confidence", report::json_number(confidence_in(d, effect.id))},
                           {"parameters", effect_parameters_json(effect.parameters)},
                           {"intervals", intervals_json(d.augmented.fit, effect.id)}});
    json["verdict"] = {{"effects", effects},
                       {"ranking", d.verdict.ranking},
                       {"confidence", report::json_number(d.verdict.confidence)},
                       {"not_told_apart", not_told_apart_json(d)}};
    for (const auto& [id, probability] : effect_probabilities(d))
        json["verdict"]["probabilities"][id] = report::json_number(probability);
    if (d.repeatability.known()) json["verdict"]["floor_m"] = report::json_number(d.repeatability.rms_m);
    json["augmented_fit"] = fit_json(d.augmented);
    json["validation"] = {{"before_rms_m", report::json_number(d.before.validation_rms_m)},
                          {"after_rms_m", report::json_number(d.after.validation_rms_m)}};
    json["trials"] = report::Json::array();
    for (const setup::PreparedTrial& trial : setup.trials) {
        const prediction::TrialScore* const before = results::find_score(d.before, trial.name);
        const prediction::TrialScore* const after = results::find_score(d.after, trial.name);
        const auto rms = [](const prediction::TrialScore* score) {
            return report::json_number(score ? score->rms_m : std::nan(""));
        };
        json["trials"].push_back({{"name", trial.name},
                                  {"role", to_string(trial.role)},
                                  {"before_rms_m", rms(before)},
                                  {"after_rms_m", rms(after)}});
        if (before != nullptr && !before->sensors.empty())
            json["trials"].back()["sensors_before"] = results::sensor_scores_json(*before);
        if (after != nullptr && !after->sensors.empty())
            json["trials"].back()["sensors"] = results::sensor_scores_json(*after);
    }
    json.update(results::robot_json(setup));
    // The places that the fit of the verdict found, where markers.placement_m leaves them open.
    for (std::size_t m = 0; m < d.after.values.places_m.size(); ++m)
        if (!setup.experiment.markers.on_body[m].probe)
            json["marker_places"][setup.marker_names[m]] = {
                {"shift_m", report::json_array(d.after.values.places_m[m])}};
    json["details"] = details_json(setup, d);
    return json;
}

}  // namespace myo::diagnosis
