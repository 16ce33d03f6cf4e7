#include "project/output_json.hpp"

#include <algorithm>
#include <cassert>

#include "project/finding_output.hpp"
#include "project/mesh_suitability.hpp"
#include "project/predict_trials.hpp"
#include "project/values_at_bounds.hpp"

namespace myo {
namespace {

/// Null where it was not found; critical_velocity_force_1_s only where there is a velocity force to compare with it.
void add_integration(const Study& study, Json& json) {
    if (study.settings.integrator == Integrator::generalized_alpha) json["spectral_radius"] = study.settings.spectral_radius;
    if (!study.integration) return;
    const IntegrationCheck& check = *study.integration;
    const auto known = [&](double value) { return check.frequency_Hz > 0.0 ? json_number(value) : Json(); };
    json["first_frequency_Hz"] = known(check.frequency_Hz);
    json["numerical_damping_ratio"] = known(check.numerical_damping_ratio);
    if (check.critical_velocity_force_1_s) json["critical_velocity_force_1_s"] = json_number(*check.critical_velocity_force_1_s);
}

Json size_json(const Study& study) {
    const double h = study.settings.h_s.value_or(study.trials.front().options.h_s);
    const WallLayers layers = wall_layers({study.surface, study.mesh, study.experiment.effects});
    Json json{{"dofs", 3 * study.mesh.mesh.node_count()},
            {"nodes", study.mesh.mesh.node_count()},
            {"elements", study.mesh.mesh.cell_count()},
            {"element", to_string(study.body->kind)},
            {"resolution_m", study.mesh.resolution_m},
            {"layers", layers.count},
            {"layers_across_m", layers.thickness_m},
            {"material", study.settings.material.value_or(study.experiment.material.model)},
            {"as_published", study.settings.as_published},
            {"mass", to_string(study.settings.mass_model)},
            {"voxels", to_string(study.settings.mesh.voxels)},
            {"integrator", to_string(study.settings.integrator)},
            {"strategy", to_string(study.settings.strategy)},
            {"dt_s", h},
            {"threads", study.settings.threads}};
    add_integration(study, json);
    return json;
}

void add_facts(const RunFacts& facts, Json& json) {
    json["version"] = facts.version;
    json["command"] = facts.command;
    if (facts.seed) json["seed"] = *facts.seed;
    json["checks"] = findings_json(facts.findings);
}

Json values_json(const Study& study, const StudyValues& values) {
    return {{"youngs_modulus_Pa", values.youngs_modulus_Pa},
            {"poissons_ratio", study.experiment.material.poissons_ratio},
            {"density_kg_m3", study.experiment.material.density_kg_m3},
            {"damping_s", values.damping_s},
            {"damping_declared", study.experiment.material.damping_s.has_value()},
            {"velocity_force_1_s", study.settings.velocity_force_1_s}};
}

Json markers_json(const TrialScore& score) {
    Json markers = Json::object();
    for (const MarkerScore& marker : score.markers)
        markers[marker.name] = {{"rms_m", json_number(marker.rms_m)},
                                {"steady_state_m", json_array(Eigen::VectorXd(marker.steady_simulated_m))},
                                {"steady_measured_m", json_array(Eigen::VectorXd(marker.steady_measured_m))},
                                {"steady_error_m", json_number(marker.steady_error_m)}};
    return markers;
}

Json trial_facts(const Study& study, std::size_t index) {
    const StudyTrial& trial = study.trials[index];
    Json json{{"name", trial.name},
              {"role", trial.role == TrialRole::fit ? "fit" : "validate"},
              {"start_s", trial.start_s},
              {"start_found", trial.start_found}};
    if (trial.registration_rms_m) json["registration_rms_m"] = json_number(*trial.registration_rms_m);
    json["dt_s"] = trial.options.h_s;
    return json;
}

void add_levels(const Study& study, std::size_t trial, const StudyValues& values, Json& json) {
    for (const auto& [muscle, level] : values.levels[trial]) json["actuation_level"][study.experiment.muscles[muscle].name] = level;
}

/// Null where the trial did not complete.
Json rms_json(const TrialScore* score) { return score != nullptr ? json_number(score->rms_m) : Json(); }

/// `reason` where the data do not determine it, `at_bound` where it ended at one, `direction` of an angle of one: where
/// it points.
Json parameters_json(const Calibration& calibration) {
    Json parameters = Json::object();
    for (std::size_t i = 0; i < calibration.parameters.size(); ++i) {
        const StudyParameter& p = calibration.parameters[i];
        const auto row = static_cast<Eigen::Index>(i);
        Json& entry = parameters[p.parameter.name];
        entry = {{"value", json_number(calibration.fit.values(row))},
                 {"std", json_number(calibration.deviation(i))},
                 {"std_noise", json_number(calibration.fit.deviations(row))},
                 {"start", json_number(calibration.fit.start(row))},
                 {"unit", p.unit}};
        // Null where a part is not known; "std" is without it then.
        const NumericalDeviations& numerical = calibration.numerical;
        entry["std_mesh"] = numerical.mesh.size() > 0 ? json_number(numerical.mesh(row)) : Json();
        entry["std_step"] = numerical.step.size() > 0 ? json_number(numerical.step(row)) : Json();
        if (const std::string reason = calibration.undetermined_reason(i); !reason.empty()) entry["reason"] = reason;
        if (p.is_angle())
            entry["direction"] = json_array(vector(calibration.after.values.effects[p.index].parameters, p.of_effect));
    }
    for (const ValueAtBound& at : values_at_bounds(calibration))
        parameters[calibration.parameters[at.parameter].parameter.name]["at_bound"] = at.upper ? "upper" : "lower";
    return parameters;
}

/// Every evaluation of every start, in order; values in the order of "parameters".
Json history_json(const Calibration& calibration) {
    Json history = Json::array();
    for (std::size_t s = 0; s < calibration.starts.size(); ++s)
        for (const FitIterate& iterate : calibration.starts[s].history) {
            Json entry{{"ok", iterate.ok()}, {"values", json_array(iterate.values)}, {"seconds", iterate.seconds}};
            if (iterate.ok()) entry["cost"] = iterate.cost;
            if (calibration.starts.size() > 1) entry["start"] = s + 1;
            history.push_back(std::move(entry));
        }
    return history;
}

Json starts_json(const Calibration& calibration) {
    Json list = Json::array();
    for (const CalibrationStart& start : calibration.starts) {
        Json entry{{"ended", ending_word(start.status)}, {"evaluations", start.history.size()}, {"start", json_array(start.start)}};
        if (start.cost_before > 0.0) {
            entry["values"] = json_array(start.values);
            entry["cost_before"] = start.cost_before;
            entry["cost_after"] = start.cost_after;
        }
        if (!start.message.empty()) entry["message"] = start.message;
        list.push_back(std::move(entry));
    }
    return list;
}

Json correlation_json(const Calibration& calibration) {
    Json names = Json::array();
    for (const StudyParameter& p : calibration.parameters) names.push_back(p.parameter.name);
    return {{"parameters", names}, {"matrix", json_columns(calibration.fit.correlation)}};
}

}  // namespace

const char* ending_word(FitStatus status) {
    switch (status) {
        case FitStatus::not_run: return "not_run";
        case FitStatus::converged: return "converged";
        case FitStatus::not_converged: return "not_converged";
        case FitStatus::cancelled: return "stopped";
        case FitStatus::failed: return "failed";
    }
    return "";
}

Json study_size_json(const Study& study) { return size_json(study); }

Json marker_scores_json(const TrialScore& score) { return markers_json(score); }

const TrialScore* find_score(const StudyRun& run, const std::string& trial) {
    const auto found = std::find_if(run.scores.begin(), run.scores.end(), [&](const TrialScore& s) { return s.name == trial; });
    return found != run.scores.end() ? &*found : nullptr;
}

Json simulate_json(const Study& study, const StudyRun& run, const RunFacts& facts) {
    Json json{{"schema", "simulate/1"}};
    json.update(size_json(study));
    std::size_t steps = 0;
    int iterations = 0;
    Json trials = Json::array();
    for (std::size_t t = 0; t < study.trials.size(); ++t) {
        const TrialScore* score = find_score(run, study.trials[t].name);
        if (score == nullptr) continue;
        const Trace& trace = run.predictions[t].trace;
        steps += trace.times_s.size() - 1;
        iterations += trace.newton_iterations;
        Json trial = trial_facts(study, t);
        trial["steps"] = trace.times_s.size() - 1;
        trial["newton_iterations"] = trace.newton_iterations;
        add_levels(study, t, run.values, trial);
        trial["rms_m"] = json_number(score->rms_m);
        trial["markers"] = markers_json(*score);
        trials.push_back(std::move(trial));
    }
    json["steps"] = steps;
    json["forward_s"] = run.seconds;
    json["setup_s"] = facts.setup_s;
    json["iterations_mean"] = steps > 0 ? static_cast<double>(iterations) / static_cast<double>(steps) : 0.0;
    json["peak_memory_bytes"] = facts.peak_memory_bytes;
    json["values"] = values_json(study, run.values);
    if (!run.ok()) json["failure"] = run.failure;
    json["warnings"] = study.warnings;
    add_facts(facts, json);
    json["trials"] = std::move(trials);
    return json;
}

Json calibrate_json(const Study& study, const Calibration& calibration, const RunFacts& facts) {
    assert(calibration.usable());
    Json json{{"schema", "calibrate/1"},
              {"parameters", parameters_json(calibration)},
              {"rms_before_m", json_number(calibration.before.fit_rms_m)},
              {"rms_after_m", json_number(calibration.after.fit_rms_m)},
              {"evaluations", calibration.evaluations()},
              {"evaluations_in_all", calibration.evaluations() + calibration.earlier_evaluations},
              {"seconds", calibration.seconds},
              {"numerical_error_s", calibration.numerical.seconds},
              {"converged", calibration.fit.converged()},
              {"stopped", calibration.stopped},
              {"message", calibration.fit.message}};
    if (!trials_with_role(study, TrialRole::validate).empty()) {
        json["validation_rms_before_m"] = json_number(calibration.before.validation_rms_m);
        json["validation_rms_after_m"] = json_number(calibration.after.validation_rms_m);
    }
    json["correlation"] = correlation_json(calibration);
    json["starts"] = starts_json(calibration);
    json["history"] = history_json(calibration);
    for (std::size_t m = 0; m < study.marker_names.size(); ++m)
        json["noise_m"][study.marker_names[m]] = json_number(study.noise_m(static_cast<Eigen::Index>(m)));
    json["noise_declared"] = study.experiment.markers.noise_m.has_value();
    std::vector<std::string> warnings = study.warnings;
    warnings.insert(warnings.end(), calibration.warnings.begin(), calibration.warnings.end());
    json["warnings"] = warnings;
    json["values"] = values_json(study, calibration.after.values);
    json.update(size_json(study));
    json["setup_s"] = facts.setup_s;
    json["peak_memory_bytes"] = facts.peak_memory_bytes;
    add_facts(facts, json);
    if (calibration.settings.starts > 1) json["seed"] = calibration.settings.seed;
    Json trials = Json::array();
    for (std::size_t t = 0; t < study.trials.size(); ++t) {
        Json trial = trial_facts(study, t);
        trial["start_fitted_s"] = study.trials[t].start_s + calibration.after.values.start_shift_s[t];
        add_levels(study, t, calibration.after.values, trial);
        const TrialScore* before = find_score(calibration.before, study.trials[t].name);
        const TrialScore* after = find_score(calibration.after, study.trials[t].name);
        trial["rms_before_m"] = rms_json(before);
        trial["rms_after_m"] = rms_json(after);
        trial["rms_m"] = rms_json(after);
        trial["markers"] = after != nullptr ? markers_json(*after) : Json::object();
        if (before == nullptr) trial["failure_before"] = calibration.before.predictions[t].message;
        if (after == nullptr) trial["failure_after"] = calibration.after.predictions[t].message;
        trials.push_back(std::move(trial));
    }
    json["trials"] = std::move(trials);
    return json;
}

}  // namespace myo
