#include "results/output_json.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/text.hpp"
#include "calibration/values_at_bounds.hpp"
#include "prediction/predict_trials.hpp"
#include "results/finding_output.hpp"
#include "results/marker_places.hpp"
#include "results/robot_tables.hpp"
#include "setup/actuator_signals.hpp"
#include "setup/mesh_suitability.hpp"

namespace myo::results {
namespace {

/// Adds the keys of the time integration, from the check of the integration.
/// Null if no mode was found; critical_velocity_force_1_s only if the model has a velocity force.
void add_integration(const setup::Setup& setup, report::Json& json) {
    if (setup.settings.integrator == dynamics::Integrator::generalized_alpha)
        json["spectral_radius"] = setup.settings.spectral_radius;
    if (!setup.integration) return;
    const setup::IntegrationCheck& check = *setup.integration;
    const auto known = [&](double value) {
        return check.frequency_Hz > 0.0 ? report::json_number(value) : report::Json();
    };
    json["first_frequency_Hz"] = known(check.frequency_Hz);
    json["numerical_damping_ratio"] = known(check.numerical_damping_ratio);
    if (check.critical_velocity_force_1_s)
        json["critical_velocity_force_1_s"] = report::json_number(*check.critical_velocity_force_1_s);
}

/// Mesh, material and integration keys that all result files share.
/// Degrees of freedom (dofs) are those of all nodes, clamped ones included.
report::Json size_json(const setup::Setup& setup) {
    // Trials can have different steps; dt_s of the file is that of the first, dt_s of a trial its own.
    const double h = setup.settings.h_s.value_or(setup.trials.front().options.h_s);
    const setup::WallLayers layers = setup::wall_layers({setup.surface, setup.mesh, setup.experiment.effects});
    report::Json json{{"dofs", 3 * setup.mesh.mesh.node_count()},
                      {"nodes", setup.mesh.mesh.node_count()},
                      {"elements", setup.mesh.mesh.cell_count()},
                      {"element", to_string(setup.body->kind)},
                      {"resolution_m", setup.mesh.resolution_m},
                      {"layers", layers.count},
                      {"layers_across_m", layers.thickness_m},
                      {"material", setup.settings.material.value_or(setup.experiment.material.model)},
                      {"as_published", setup.settings.as_published},
                      {"mass", to_string(setup.settings.mass_model)},
                      {"voxels", to_string(setup.settings.mesh.voxels)},
                      {"integrator", to_string(setup.settings.integrator)},
                      {"strategy", to_string(setup.settings.strategy)},
                      {"dt_s", h},
                      {"threads", setup.settings.threads}};
    add_integration(setup, json);
    return json;
}

/// Keys about the run itself.
void add_facts(const RunFacts& facts, report::Json& json) {
    json["version"] = facts.version;
    json["command"] = facts.command;
    if (facts.seed) json["seed"] = *facts.seed;
    json["checks"] = findings_json(facts.findings);
}

/// Material values used in the run.
report::Json values_json(const setup::Setup& setup, const prediction::ParameterValues& values) {
    report::Json json{{"youngs_modulus_Pa", values.youngs_modulus_Pa},
                      {"poissons_ratio", setup.experiment.material.poissons_ratio},
                      {"density_kg_m3", setup.experiment.material.density_kg_m3},
                      {"damping_s", values.damping_s},
                      {"damping_declared", setup.experiment.material.damping_s.has_value()},
                      {"velocity_force_1_s", setup.settings.velocity_force_1_s}};
    // Parameters of the law have their own names; the law is that of all trials.
    const std::vector<material::LawParameter> law = setup.trials.front().model.material->parameters();
    for (std::size_t k = 0; k < values.law.size(); ++k) json[law[k].name] = values.law[k];
    for (std::size_t k = 0; k < setup.experiment.parts.size(); ++k) {
        const experiment::PartDeclaration& part = setup.experiment.parts[k];
        const double damping_s = values.part_damping_s[k];
        // NaN: a part without a damping of its own has that of the body.
        json["parts"].push_back({{"name", part.name},
                                 {"youngs_modulus_Pa", values.part_modulus_Pa[k]},
                                 {"poissons_ratio", part.poissons_ratio},
                                 {"density_kg_m3", part.density_kg_m3},
                                 {"damping_s", std::isnan(damping_s) ? values.damping_s : damping_s}});
    }
    return json;
}

/// Scores per marker, keyed by name.
report::Json markers_json(const prediction::TrialScore& score) {
    report::Json markers = report::Json::object();
    for (const prediction::MarkerScore& marker : score.markers)
        markers[marker.name] = {{"rms_m", report::json_number(marker.rms_m)},
                                {"mean_distance_m", report::json_number(marker.distance_m)},
                                {"steady_state_m", report::json_array(Eigen::VectorXd(marker.steady_simulated_m))},
                                {"steady_measured_m", report::json_array(Eigen::VectorXd(marker.steady_measured_m))},
                                {"steady_error_m", report::json_number(marker.steady_error_m)}};
    return markers;
}

/// Keys of a trial that do not depend on the result.
report::Json trial_facts(const setup::Setup& setup, std::size_t index) {
    const setup::PreparedTrial& trial = setup.trials[index];
    report::Json json{{"name", trial.name},
                      {"role", to_string(trial.role)},
                      {"start_s", trial.start_s},
                      {"start_found", trial.start_found}};
    if (trial.registration_rms_m) json["registration_rms_m"] = report::json_number(*trial.registration_rms_m);
    // The step of this trial, which may differ from that of the file.
    json["dt_s"] = trial.options.h_s;
    return json;
}

/// Actuation levels of a trial, if it has free ones.
void add_levels(const setup::Setup& setup, std::size_t trial, const prediction::ParameterValues& values,
                report::Json& json) {
    for (const auto& [actuator, level] : values.levels[trial])
        json["actuation_level"][setup::actuator_names(setup.experiment)[actuator]] = level;
}

/// Volume of every chamber after each step of a run.
void add_chamber_volumes(const setup::Setup& setup, const dynamics::Trace& trace, report::Json& json) {
    for (const setup::Chamber& chamber : setup.chambers) {
        report::Json& volumes = json["chamber_volume_m3"][chamber.name] = report::Json::array();
        for (const Eigen::Matrix3Xd& x : trace.positions)
            volumes.push_back(report::json_number(setup::chamber_volume(*setup.body, chamber, x)));
    }
    if (!setup.chambers.empty()) json["chamber_volume_times_s"] = trace.times_s;
}

/// Null if the trial did not complete.
report::Json rms_json(const prediction::TrialScore* score) {
    return score != nullptr ? report::json_number(score->rms_m) : report::Json();
}

/// Optional keys: `reason` if the data do not determine the parameter, `at_bound` if it ended at one, `direction` with
/// the vector that an angle belongs to.
report::Json parameters_json(const calibration::Calibration& calibration) {
    report::Json parameters = report::Json::object();
    for (std::size_t i = 0; i < calibration.parameters.size(); ++i) {
        const prediction::ModelParameter& p = calibration.parameters[i];
        const auto row = static_cast<Eigen::Index>(i);
        // "std" is the root of the sum of squares of the parts by noise, mesh and step.
        report::Json& entry = parameters[p.parameter.name];
        entry = {{"value", report::json_number(calibration.fit.values(row))},
                 {"std", report::json_number(calibration.deviation(i))},
                 {"std_noise", report::json_number(calibration.fit.deviations(row))},
                 {"start", report::json_number(calibration.fit.start(row))},
                 {"unit", p.unit}};
        // Null if a part is unknown; "std" then leaves it out.
        const calibration::NumericalDeviations& numerical = calibration.numerical;
        entry["std_mesh"] = numerical.mesh.size() > 0 ? report::json_number(numerical.mesh(row)) : report::Json();
        entry["std_step"] = numerical.step.size() > 0 ? report::json_number(numerical.step(row)) : report::Json();
        if (const std::string reason = calibration.undetermined_reason(i); !reason.empty()) entry["reason"] = reason;
        // A fit moves angles, which mean nothing without the fitted direction itself.
        if (p.is_angle())
            entry["direction"] = report::json_array(
                effect::vector(calibration.after.values.effects[p.index].parameters, p.of_effect));
    }
    for (const calibration::ValueAtBound& at : calibration::values_at_bounds(calibration))
        parameters[calibration.parameters[at.parameter].parameter.name]["at_bound"] = at.upper ? "upper" : "lower";
    return parameters;
}

/// Every evaluation of every start, in order; values in the order of "parameters".
report::Json history_json(const calibration::Calibration& calibration) {
    report::Json history = report::Json::array();
    for (std::size_t s = 0; s < calibration.starts.size(); ++s)
        for (const inverse::FitIterate& iterate : calibration.starts[s].history) {
            report::Json entry{
                {"ok", iterate.ok()}, {"values", report::json_array(iterate.values)}, {"seconds", iterate.seconds}};
            if (iterate.ok()) entry["cost"] = iterate.cost;
            if (calibration.starts.size() > 1) entry["start"] = s + 1;
            history.push_back(std::move(entry));
        }
    return history;
}

/// Outcome of each start; values and costs are left out if nothing could be run.
report::Json starts_json(const calibration::Calibration& calibration) {
    report::Json list = report::Json::array();
    for (const calibration::CalibrationStart& start : calibration.starts) {
        report::Json entry{{"ended", ending_word(start.status)},
                           {"evaluations", start.history.size()},
                           {"start", report::json_array(start.start)}};
        if (start.cost_before > 0.0) {
            entry["values"] = report::json_array(start.values);
            entry["cost_before"] = start.cost_before;
            entry["cost_after"] = start.cost_after;
        }
        if (!start.message.empty()) entry["message"] = start.message;
        list.push_back(std::move(entry));
    }
    return list;
}

/// Correlation matrix with the order of its parameters.
report::Json correlation_json(const calibration::Calibration& calibration) {
    report::Json names = report::Json::array();
    for (const prediction::ModelParameter& p : calibration.parameters) names.push_back(p.parameter.name);
    return {{"parameters", names}, {"matrix", report::json_columns(calibration.fit.correlation)}};
}

/// Values, errors and cost of the fit.
report::Json fit_json(const setup::Setup& setup, const calibration::Calibration& calibration) {
    report::Json json{{"schema", "calibrate/1"},
                      {"parameters", parameters_json(calibration)},
                      {"rms_before_m", report::json_number(calibration.before.fit_rms_m)},
                      {"rms_after_m", report::json_number(calibration.after.fit_rms_m)},
                      {"evaluations", calibration.evaluations()},
                      {"evaluations_in_all", calibration.evaluations() + calibration.earlier_evaluations},
                      {"seconds", calibration.seconds},
                      {"numerical_error_s", calibration.numerical.seconds},
                      {"converged", calibration.fit.converged()},
                      {"stopped", calibration.stopped},
                      {"message", calibration.fit.message}};
    // Null if no predicted trial completed; no key if there is none to predict.
    if (!prediction::trials_with_role(setup, experiment::TrialRole::validate).empty()) {
        json["validation_rms_before_m"] = report::json_number(calibration.before.validation_rms_m);
        json["validation_rms_after_m"] = report::json_number(calibration.after.validation_rms_m);
    }
    if (!calibration.places.empty()) json["marker_places"] = places_json(calibration.places);
    return json;
}

/// Errors of the trials with the declared and with the fitted values.
report::Json fitted_trials_json(const setup::Setup& setup, const calibration::Calibration& calibration) {
    report::Json trials = report::Json::array();
    for (std::size_t t = 0; t < setup.trials.size(); ++t) {
        report::Json trial = trial_facts(setup, t);
        trial["start_fitted_s"] = setup.trials[t].start_s + calibration.after.values.start_shift_s[t];
        add_levels(setup, t, calibration.after.values, trial);
        const prediction::TrialScore* before = find_score(calibration.before, setup.trials[t].name);
        const prediction::TrialScore* after = find_score(calibration.after, setup.trials[t].name);
        trial["rms_before_m"] = rms_json(before);
        trial["rms_after_m"] = rms_json(after);
        // Under the name that simulate.json uses, too, so that one reader serves both.
        trial["rms_m"] = rms_json(after);
        trial["mean_distance_before_m"] = before != nullptr ? report::json_number(before->distance_m) : report::Json();
        trial["mean_distance_m"] = after != nullptr ? report::json_number(after->distance_m) : report::Json();
        trial["markers"] = after != nullptr ? markers_json(*after) : report::Json::object();
        if (before != nullptr && !before->sensors.empty()) trial["sensors_before"] = sensor_scores_json(*before);
        if (after != nullptr && !after->sensors.empty()) trial["sensors"] = sensor_scores_json(*after);
        if (before == nullptr) trial["failure_before"] = calibration.before.predictions[t].message;
        if (after == nullptr) trial["failure_after"] = calibration.after.predictions[t].message;
        trials.push_back(std::move(trial));
    }
    return trials;
}

}  // namespace

const char* ending_word(inverse::FitStatus status) {
    switch (status) {
        case inverse::FitStatus::not_run: return "not_run";
        case inverse::FitStatus::converged: return "converged";
        case inverse::FitStatus::not_converged: return "not_converged";
        case inverse::FitStatus::cancelled: return "stopped";
        case inverse::FitStatus::failed: return "failed";
    }
    return "";
}

report::Json setup_size_json(const setup::Setup& setup) { return size_json(setup); }

report::Json marker_scores_json(const prediction::TrialScore& score) { return markers_json(score); }

report::Json sensor_scores_json(const prediction::TrialScore& score) {
    report::Json sensors = report::Json::array();
    for (const prediction::SensorScore& sensor : score.sensors)
        sensors.push_back({{"column", sensor.column},
                           {"unit", sensor.unit},
                           {"noise", report::json_number(sensor.noise)},
                           {"rms", report::json_number(sensor.rms)}});
    return sensors;
}

std::string sensor_lines(const prediction::SetupRun& run, const std::string& when) {
    std::string text;
    for (const prediction::TrialScore& score : run.scores)
        for (const prediction::SensorScore& sensor : score.sensors)
            text += "\nsensor " + sensor.column + " in " + score.name + (when.empty() ? "" : ", " + when) + ": " +
                    format_number(sensor.rms, 3) + " " + sensor.unit + " rms, noise " + format_number(sensor.noise, 3) +
                    " " + sensor.unit;
    return text;
}

const prediction::TrialScore* find_score(const prediction::SetupRun& run, const std::string& trial) {
    const auto found = std::find_if(run.scores.begin(), run.scores.end(),
                                    [&](const prediction::TrialScore& s) { return s.name == trial; });
    return found != run.scores.end() ? &*found : nullptr;
}

report::Json simulate_json(const setup::Setup& setup, const prediction::SetupRun& run, const RunFacts& facts) {
    report::Json json{{"schema", "simulate/1"}};
    json.update(size_json(setup));
    std::size_t steps = 0;
    int iterations = 0;
    // Trials without a score did not complete; `failure` names the first of them.
    report::Json trials = report::Json::array();
    for (std::size_t t = 0; t < setup.trials.size(); ++t) {
        const prediction::TrialScore* score = find_score(run, setup.trials[t].name);
        if (score == nullptr) continue;
        const dynamics::Trace& trace = run.predictions[t].trace;
        // The first entry is the start.
        steps += trace.times_s.size() - 1;
        iterations += trace.newton_iterations;
        report::Json trial = trial_facts(setup, t);
        trial["steps"] = trace.times_s.size() - 1;
        trial["newton_iterations"] = trace.newton_iterations;
        add_levels(setup, t, run.values, trial);
        add_chamber_volumes(setup, trace, trial);
        trial["rms_m"] = report::json_number(score->rms_m);
        trial["mean_distance_m"] = report::json_number(score->distance_m);
        trial["markers"] = markers_json(*score);
        if (!score->sensors.empty()) trial["sensors"] = sensor_scores_json(*score);
        trials.push_back(std::move(trial));
    }
    json["steps"] = steps;
    json["forward_s"] = run.seconds;
    json["setup_s"] = facts.setup_s;
    json["iterations_mean"] = steps > 0 ? static_cast<double>(iterations) / static_cast<double>(steps) : 0.0;
    json["peak_memory_bytes"] = facts.peak_memory_bytes;
    json["values"] = values_json(setup, run.values);
    if (!run.ok()) json["failure"] = run.failure;
    json["warnings"] = setup.warnings;
    add_facts(facts, json);
    json.update(robot_json(setup));
    json["trials"] = std::move(trials);
    return json;
}

report::Json calibrate_json(const setup::Setup& setup, const calibration::Calibration& calibration,
                            const RunFacts& facts) {
    // Stable keys: scripts read this file, and --resume does as well.
    assert(calibration.usable());
    report::Json json = fit_json(setup, calibration);
    json["correlation"] = correlation_json(calibration);
    json["starts"] = starts_json(calibration);
    json["history"] = history_json(calibration);
    for (std::size_t m = 0; m < setup.marker_names.size(); ++m)
        if (!setup.experiment.markers.on_body[m].probe)
            json["noise_m"][setup.marker_names[m]] = report::json_number(setup.noise_m(static_cast<Eigen::Index>(m)));
    json["noise_declared"] = setup.experiment.markers.noise_m.has_value();
    std::vector<std::string> warnings = setup.warnings;
    warnings.insert(warnings.end(), calibration.warnings.begin(), calibration.warnings.end());
    json["warnings"] = warnings;
    json["values"] = values_json(setup, calibration.after.values);
    json.update(size_json(setup));
    json["setup_s"] = facts.setup_s;
    json["peak_memory_bytes"] = facts.peak_memory_bytes;
    add_facts(facts, json);
    if (calibration.settings.starts > 1) json["seed"] = calibration.settings.seed;
    json["trials"] = fitted_trials_json(setup, calibration);
    return json;
}

}  // namespace myo::results
