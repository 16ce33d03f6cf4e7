#include "results/optimize_output.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "calibration/sought_signals.hpp"
#include "experiment/actuators.hpp"
#include "measurement/actuation_csv.hpp"
#include "measurement/trace_csv.hpp"
#include "results/finding_output.hpp"
#include "results/output_files.hpp"
#include "results/output_motion.hpp"
#include "results/robot_tables.hpp"

namespace myo::results {
namespace {
namespace fs = std::filesystem;

using Eigen::Index;
using Eigen::MatrixXd;

/// Word of the schema for how signals run between their knots.
const char* interpolation(bool hold) { return hold ? "hold" : "linear"; }

/// Actuator that a signal drives; a muscle that follows none, a chamber or a tendon.
experiment::Actuator actuator_of(const setup::Setup& setup, const inverse::SoughtSignal& signal) {
    return experiment::actuators(setup.experiment)[*experiment::find_actuator(setup.experiment, signal.name)];
}

/// The signals at their own knots; a jump takes two rows with the same time.
measurement::ActuationTable actuation_table(const setup::Setup& setup, const inverse::SoughtSignals& sought,
                                            const MatrixXd& values) {
    std::vector<double> times;
    std::vector<std::vector<double>> rows;
    inverse::SoughtSignals alone = sought;  // each signal as its own group, without followers
    alone.groups.clear();
    for (std::size_t s = 0; s < sought.signals.size(); ++s) alone.groups.push_back({s, 1.0});
    const std::vector<fibre::Signal> signals = calibration::found_commands(alone, values);
    for (std::size_t k = 0; k < signals.front().times_s.size(); ++k) {
        const double t = signals.front().times_s[k];
        if (t < 0.0) continue;  // the level before the start equals that at the start
        times.push_back(t);
        rows.emplace_back();
        for (const fibre::Signal& signal : signals) rows.back().push_back(signal.values[k]);
    }
    measurement::ActuationTable table;
    table.time_s = Eigen::Map<const Eigen::VectorXd>(times.data(), static_cast<Index>(times.size()));
    table.values.resize(static_cast<Index>(signals.size()), static_cast<Index>(rows.size()));
    for (std::size_t s = 0; s < signals.size(); ++s) {
        table.muscles.push_back(actuator_of(setup, sought.signals[s]).column);
        for (std::size_t k = 0; k < rows.size(); ++k)
            table.values(static_cast<Index>(s), static_cast<Index>(k)) = rows[k][s];
    }
    return table;
}

constexpr const char* actuation_ending = "_actuation.csv";

/// What was sought: words of the items, and what became of the body.
report::Json sought_json(const std::vector<calibration::SoughtItem>& seek) {
    report::Json words = report::Json::array();
    for (const calibration::SoughtItem& item : seek) words.push_back(calibration::to_string(item));
    return words;
}
report::Json design_json(const calibration::Optimization& optimization) {
    report::Json items = report::Json::array();
    for (const calibration::FoundItem& found : optimization.found) {
        items.push_back({{"item", calibration::to_string(found.item)}, {"change", found.change}});
        if (found.youngs_modulus_Pa > 0.0) items.back()["youngs_modulus_Pa"] = found.youngs_modulus_Pa;
        if (found.fibre) items.back()["fibre"] = report::json_array(Eigen::VectorXd(*found.fibre));
    }
    return {{"items", items}, {"values", report::json_array(optimization.fit.design)}};
}

/// Bounds, values and standard deviations per signal; "from_markers" is the part of the deviation due to the markers.
report::Json signals_json(const setup::Setup& setup, const inverse::SoughtSignals& sought, const MatrixXd& values,
                          const inverse::ActuationDeviations& deviations) {
    report::Json signals = report::Json::array();
    const auto row = [](const MatrixXd& of, std::size_t s) {
        return report::json_array(Eigen::VectorXd(of.row(static_cast<Index>(s)).transpose()));
    };
    for (std::size_t s = 0; s < sought.signals.size(); ++s) {
        const experiment::Actuator actuator = actuator_of(setup, sought.signals[s]);
        signals.push_back({{"name", actuator.name},
                           {"quantity", experiment::quantity_word(actuator.kind)},
                           {"unit", actuator.unit},
                           {"lower", sought.signals[s].lower},
                           {"upper", sought.signals[s].upper},
                           {"before", sought.seek_before ? values(static_cast<Index>(s), 0) : sought.signals[s].before},
                           {"before_sought", sought.seek_before},
                           {"values", row(values, s)}});
        // The reason is stated once for all signals, under "std".
        if (!deviations.found) continue;
        signals.back()["std"] = row(deviations.deviations, s);
        signals.back()["from_markers"] = row(deviations.from_target, s);
    }
    return signals;
}

/// Signal and factor of each muscle that does not keep its own, so that followers can be reconstructed.
report::Json muscles_json(const setup::Setup& setup, const inverse::SoughtSignals& sought) {
    report::Json muscles = report::Json::array();
    for (std::size_t g = 0; g < setup.experiment.muscles.size() && g < sought.groups.size(); ++g)
        if (!sought.groups[g].own)
            muscles.push_back({{"name", setup.experiment.muscles[g].name},
                               {"signal", sought.signals[sought.groups[g].signal].name},
                               {"factor", sought.groups[g].factor}});
    return muscles;
}

/// Every evaluation of the best start.
report::Json history_json(const std::vector<inverse::ActuationIterate>& log) {
    report::Json history = report::Json::array();
    for (const inverse::ActuationIterate& line : log) {
        report::Json entry{{"ok", line.ok}, {"seconds", line.seconds}};
        if (line.ok) {
            entry["loss_m2"] = report::json_number(line.loss_m2);
            entry["rms_m"] = report::json_number(line.rms_m);
            entry["gradient_norm_m2"] = report::json_number(line.gradient_norm_m2);
        }
        history.push_back(std::move(entry));
    }
    return history;
}

/// Outcome of each start; losses are left out if nothing could be run.
report::Json starts_json(const std::vector<calibration::StartEnding>& starts) {
    report::Json list = report::Json::array();
    for (const calibration::StartEnding& start : starts) {
        report::Json entry{{"ended", ending_word(start.status)}, {"evaluations", start.evaluations}};
        // A loss of exactly 0 is that of a start that was not run.
        if (start.loss_before_m2 > 0.0) {
            entry["loss_before_m2"] = report::json_number(start.loss_before_m2);
            entry["loss_after_m2"] = report::json_number(start.loss_after_m2);
        }
        if (!start.message.empty()) entry["message"] = start.message;
        list.push_back(std::move(entry));
    }
    return list;
}

/// Remaining distance to the target, with the worst markers and times.
report::Json miss_json(const calibration::TargetMiss& miss) {
    report::Json markers = report::Json::array();
    for (const calibration::TargetMiss::Marker& marker : miss.markers)
        markers.push_back({{"name", marker.name}, {"rms_m", marker.rms_m}});
    return {{"rms_m", report::json_number(miss.rms_m)},
            {"noise_levels", report::json_number(miss.noise_levels)},
            {"markers", markers},
            {"from_s", miss.from_s},
            {"until_s", miss.until_s},
            {"worst_s", miss.worst_s},
            {"worst_rms_m", report::json_number(miss.worst_rms_m)}};
}

/// Root mean square of each coordinate over all markers; null if none was visible.
report::Json rms_of_axes(const prediction::TrialPrediction& prediction) {
    Eigen::Vector3d axes;
    // prediction::rms() leaves NaN out: the other two coordinates are blanked.
    for (Index axis = 0; axis < 3; ++axis) {
        std::vector<Eigen::Matrix3Xd> rows;
        for (const Eigen::Matrix3Xd& residual : prediction.residual_m) {
            rows.emplace_back(Eigen::Matrix3Xd::Constant(3, residual.cols(), std::nan("")));
            rows.back().row(axis) = residual.row(axis);
        }
        axes(axis) = prediction::rms(rows);
    }
    return report::json_array(Eigen::VectorXd(axes));
}

/// Values of a signal as written. Files from before the level before t = 0 was sought hold it as `before` only; where
/// it is the first of the values now, it is put in front.
/// @return  whether it was
bool put_level_in_front(report::Json& signal, const inverse::SoughtSignals& sought) {
    if (!sought.seek_before || signal.contains("before_sought")) return false;
    if (!signal.contains("before") || !signal.contains("values") || !signal.at("values").is_array()) return false;
    report::Json& values = signal.at("values");
    values.insert(values.begin(), signal.at("before"));
    return true;
}

/// Settings, errors and values of the search.
report::Json search_json(const setup::Setup& setup, const calibration::Optimization& optimization) {
    const inverse::SoughtSignals& sought = optimization.problem.sought;
    const inverse::ActuationFit& fit = optimization.fit;
    const int evaluations = optimization.evaluations();
    return {{"schema", "optimize/1"},
            {"trial", setup.trials.front().name},
            {"target", optimization.miss.goals ? "goals" : "recording"},
            {"seek", sought_json(optimization.settings.seek)},
            {"frequency_Hz", sought.frequency_Hz},
            {"interpolation", interpolation(sought.hold)},
            {"smoothness_m_s", optimization.problem.smoothness_m_s},
            {"rms_before_m", report::json_number(optimization.before.fit_rms_m)},
            {"rms_after_m", report::json_number(optimization.after.fit_rms_m)},
            {"rms_after_xyz_m", rms_of_axes(optimization.after.predictions.front())},
            {"loss_before_m2", report::json_number(fit.first.loss_m2)},
            {"loss_after_m2", report::json_number(fit.best.loss_m2)},
            {"gradient_norm_m2", report::json_number(fit.gradient_norm_m2)},
            {"evaluations", evaluations},
            {"evaluations_in_all", evaluations + optimization.earlier_evaluations},
            {"seconds", optimization.seconds},
            {"converged", fit.converged()},
            {"reached", optimization.miss.reached},
            {"noise_levels", report::json_number(optimization.miss.noise_levels)},
            {"stopped", optimization.stopped},
            {"message", fit.message},
            {"knot_times_s",
             sought.signals.empty() ? report::Json::array() : report::json_array(inverse::knot_times(sought))},
            {"signals", signals_json(setup, sought, fit.values, optimization.deviations)},
            {"muscles", muscles_json(setup, sought)},
            {"starts", starts_json(optimization.starts)},
            {"history", history_json(fit.log)}};
}

/// What was sought and found besides the signals: placement, misses and deviations.
void add_outcome(const setup::Setup& setup, const calibration::Optimization& optimization, report::Json& json) {
    const inverse::ActuationFit& fit = optimization.fit;
    if (!optimization.problem.sought.signals.empty()) json["actuation"] = actuation_file_name(setup).string();
    if (!optimization.found.empty()) json["design"] = design_json(optimization);
    if (optimization.problem.placement_bounds) {
        const inverse::MarkerPlacement& placement = fit.best.placement;
        json["registration"] = {{"translation_m", report::json_array(Eigen::VectorXd(placement.translation_m))},
                                {"rotation_rad", report::json_array(Eigen::VectorXd(placement.rotation_rad))},
                                {"at_bound", inverse::at_bound(placement, *optimization.problem.placement_bounds)}};
    }
    if (!optimization.miss.reached) json["missed"] = miss_json(optimization.miss);
    if (optimization.deviations.found)
        json["std_noise_m"] = optimization.deviations.noise_m;
    else
        json["std"] = optimization.deviations.reason;
    if (optimization.settings.starts > 1) json["seed"] = optimization.settings.seed;
}

}  // namespace

Result<EarlierOptimization> read_optimization(const fs::path& folder, const setup::Setup& setup,
                                              const inverse::ActuationProblem& problem) {
    const fs::path file = folder / "optimize.json";
    std::error_code code;
    if (!fs::exists(file, code)) return Error{"there is nothing to resume: no optimize.json", folder.string()};
    const Result<report::Json> json = report::read_json(file);
    if (!json) return json.error();
    // Values are only valid for the same trial, signals and knots; any difference is an error instead of a silent
    // restart.
    const auto refuse = [&](const std::string& what) {
        return Error{what + "; without --resume it starts again", file.string()};
    };
    const auto is = [&](const char* key, const report::Json& value) {
        return json->contains(key) && json->at(key) == value;
    };
    if (!json->is_object() || !is("schema", "optimize/1")) return refuse("is not of the form optimize/1");
    if (!is("trial", setup.trials.front().name)) return refuse("is of another trial than " + setup.trials.front().name);
    if (!is("frequency_Hz", problem.sought.frequency_Hz) || !is("interpolation", interpolation(problem.sought.hold)))
        return refuse("has signals with other knots");
    EarlierOptimization earlier;
    earlier.values = inverse::unmoved_values(problem.sought);
    // Without the key the array check below fails, and the file is refused.
    report::Json signals = json->contains("signals") ? json->at("signals") : *json;
    if (!signals.is_array() || signals.size() != problem.sought.signals.size()) return refuse("has other signals");
    for (std::size_t s = 0; s < signals.size(); ++s) {
        report::Json& signal = signals[s];
        if (!signal.is_object() || !signal.contains("name") || signal.at("name") != problem.sought.signals[s].name)
            return refuse("has other signals");
        if (put_level_in_front(signal, problem.sought))
            earlier.notes.push_back(problem.sought.signals[s].name +
                                    ": the level before t = 0, which an earlier version did not seek, is where the "
                                    "search for it begins");
        if (!signal.contains("values") || !signal.at("values").is_array() ||
            static_cast<Index>(signal.at("values").size()) != earlier.values.cols())
            return refuse("has signals with other knots");
        for (Index k = 0; k < earlier.values.cols(); ++k) {
            const report::Json& value = signal.at("values")[static_cast<std::size_t>(k)];
            if (!value.is_number()) return refuse("has a value that is no number");
            earlier.values(static_cast<Index>(s), k) = value.get<double>();
        }
    }
    // Sized by what is sought now, which the file must match.
    earlier.design = inverse::declared_design(problem.design);
    if (earlier.design.size() > 0) {
        const report::Json* const values = json->contains("design") && json->at("design").contains("values")
                                               ? &json->at("design").at("values")
                                               : nullptr;
        if (!values || !values->is_array() || static_cast<Index>(values->size()) != earlier.design.size() ||
            !std::all_of(values->begin(), values->end(), [](const report::Json& value) { return value.is_number(); }))
            return refuse("sought other quantities of the body");
        for (Index k = 0; k < earlier.design.size(); ++k)
            earlier.design(k) = values->at(static_cast<std::size_t>(k)).get<double>();
    }
    // Missing in files of earlier versions: the count then begins again.
    if (json->contains("evaluations_in_all") && json->at("evaluations_in_all").is_number_integer())
        earlier.evaluations = json->at("evaluations_in_all").get<int>();
    return earlier;
}

report::Json optimize_json(const setup::Setup& setup, const calibration::Optimization& optimization,
                           const RunFacts& facts) {
    // Stable keys: scripts read this file, and --resume does as well.
    assert(optimization.usable());
    report::Json json = search_json(setup, optimization);
    add_outcome(setup, optimization, json);
    std::vector<std::string> warnings = setup.warnings;
    warnings.insert(warnings.end(), optimization.warnings.begin(), optimization.warnings.end());
    json["warnings"] = warnings;
    json.update(setup_size_json(setup));
    json.update(robot_json(setup));
    json["steps"] = optimization.fit.best.steps;
    json["setup_s"] = facts.setup_s;
    json["peak_memory_bytes"] = facts.peak_memory_bytes;
    json["version"] = facts.version;
    json["command"] = facts.command;
    json["checks"] = findings_json(facts.findings);
    const prediction::TrialScore& before = optimization.before.scores.front();
    const prediction::TrialScore& after = optimization.after.scores.front();
    json["trials"] = report::Json::array({{{"name", after.name},
                                           {"rms_before_m", report::json_number(before.rms_m)},
                                           {"rms_m", report::json_number(after.rms_m)},
                                           {"markers", marker_scores_json(after)}}});
    return json;
}

fs::path actuation_file_name(const setup::Setup& setup) {
    return trial_file_names(setup.experiment).front() + actuation_ending;
}

Result<void> write_actuation(const fs::path& folder, const setup::Setup& setup,
                             const calibration::Optimization& optimization) {
    // A search for the body alone has no signals to write.
    if (optimization.problem.sought.signals.empty()) return write_traces(folder, setup, optimization.after);
    if (const Result<void> written = measurement::write_actuation_csv(
            folder / actuation_file_name(setup),
            actuation_table(setup, optimization.problem.sought, optimization.fit.values));
        !written)
        return written.error();
    return write_traces(folder, setup, optimization.after);
}

std::vector<fs::path> actuation_files(const fs::path& folder, const experiment::Experiment& experiment) {
    std::vector<fs::path> files;
    for (const std::string& name : trial_file_names(experiment)) files.push_back(folder / (name + actuation_ending));
    return files;
}

}  // namespace myo::results
