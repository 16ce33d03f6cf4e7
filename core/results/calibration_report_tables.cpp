#include <algorithm>
#include <cmath>
#include <limits>

#include "base/markup.hpp"
#include "mesh/quality.hpp"
#include "results/calibration_report.hpp"
#include "results/calibration_report_parts.hpp"
#include "results/output_json.hpp"
#include "results/readable_parameter.hpp"
#include "results/robot_tables.hpp"
#include "setup/mesh_words.hpp"

namespace myo::results {
namespace {

/// Two significant digits; a dash if unknown.
report::Cell deviation_cell(double deviation) {
    return std::isfinite(deviation) ? report::Cell(readable_number(deviation, 2)) : report::Cell("–");
}

// NaN for a trial that did not complete; a table shows it as a dash.
double rms_mm(const prediction::TrialScore* score) {
    return score != nullptr ? 1e3 * score->rms_m : std::numeric_limits<double>::quiet_NaN();
}

// Largest steady-state error over the visible markers.
double worst_steady_mm(const prediction::TrialScore* score) {
    double worst = std::numeric_limits<double>::quiet_NaN();
    if (score == nullptr) return worst;
    for (const prediction::MarkerScore& marker : score->markers)
        // The negation lets a first value replace NaN; a marker that was never visible is skipped.
        if (!(marker.steady_error_m <= worst))
            worst = std::isfinite(marker.steady_error_m) ? marker.steady_error_m : worst;
    return 1e3 * worst;
}

}  // namespace

report::Table parameter_table(const setup::Setup& setup, const calibration::Calibration& calibration) {
    report::Table table{
        "", {{"Parameter"}, {"Unit"}, {"Fitted"}, {"±"}, {"by noise"}, {"by mesh"}, {"by step"}, {"Start"}}, {}};
    for (std::size_t i = 0; i < calibration.parameters.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        const ReadableParameter shown = readable_parameter(calibration.parameters[i], setup);
        const double deviation = shown.factor * calibration.deviation(i);
        const auto part = [&](const Eigen::VectorXd& parts) {
            return deviation_cell(parts.size() > 0 ? shown.factor * parts(row)
                                                   : std::numeric_limits<double>::quiet_NaN());
        };
        const ReadableEstimate estimate = readable_estimate(shown.factor * calibration.fit.values(row), deviation);
        table.rows.push_back({shown.name, shown.unit.empty() ? "1" : shown.unit, estimate.value,
                              estimate.deviation.empty() ? deviation_cell(deviation) : report::Cell(estimate.deviation),
                              part(calibration.fit.deviations), part(calibration.numerical.mesh),
                              part(calibration.numerical.step),
                              readable_number(shown.factor * calibration.fit.start(row), 4)});
    }
    return table;
}

report::Table starts_table(const setup::Setup& setup, const calibration::Calibration& calibration) {
    report::Table table{"The cost is half the sum of the squared differences in units of the noise.",
                        {{"Start"}, {"Ended"}, {"Evaluations"}, {"Cost before"}, {"Cost after"}},
                        {}};
    for (const prediction::ModelParameter& p : calibration.parameters) {
        const ReadableParameter shown = readable_parameter(p, setup);
        table.columns.push_back({shown.name, shown.unit});
    }
    for (std::size_t s = 0; s < calibration.starts.size(); ++s) {
        const calibration::CalibrationStart& start = calibration.starts[s];
        std::string ended = ending_word(start.status);
        std::replace(ended.begin(), ended.end(), '_', ' ');
        const double none = std::numeric_limits<double>::quiet_NaN();
        // The cost stays 0 if not even the first values could be run.
        const bool ran = start.cost_before > 0.0;
        table.rows.push_back(
            {s + 1, ended, start.history.size(), ran ? start.cost_before : none, ran ? start.cost_after : none});
        for (std::size_t i = 0; i < calibration.parameters.size(); ++i)
            table.rows.back().emplace_back(ran ? readable_parameter(calibration.parameters[i], setup).factor *
                                                     start.values(static_cast<Eigen::Index>(i))
                                               : none);
    }
    return table;
}

report::Table trial_table(const setup::Setup& setup, const calibration::Calibration& calibration) {
    report::Table table{
        "Root mean square over all marker coordinates, simulation against measurement.",
        {{"Trial"}, {"Role"}, {"Before", "mm", 3}, {"After", "mm", 3}, {"Steady state, worst marker", "mm", 3}},
        {}};
    for (const setup::PreparedTrial& trial : setup.trials) {
        // Null for a trial that did not complete, which has a row of dashes.
        const prediction::TrialScore* before = find_score(calibration.before, trial.name);
        const prediction::TrialScore* after = find_score(calibration.after, trial.name);
        table.rows.push_back(
            {trial.name, result_word(trial.role), rms_mm(before), rms_mm(after), worst_steady_mm(after)});
    }
    return table;
}

report::Section model_section(const setup::Setup& setup, const calibration::Calibration& calibration) {
    const mesh::QualityReport quality = mesh::mesh_quality(setup.mesh.mesh, &setup.surface);
    const prediction::ParameterValues& values = calibration.after.values;
    report::Table facts{"", {{"Model"}, {""}}, {}};
    const auto add = [&](const std::string& name, const std::string& value) { facts.rows.push_back({name, value}); };
    // Mass from the volume of the mesh, as in the run.
    add("Body", readable_number(1e6 * quality.volume, 4) + " cm³, " +
                    readable_number(1e3 * setup.experiment.material.density_kg_m3 * quality.volume, 4) + " g");
    add("Mesh",
        setup::mesh_words(setup) + ", edges of " + readable_number(1e3 * quality.mean_edge, 3) + " mm on average");
    // An exact fill leaves rounding only, which is not worth a number.
    if (quality.volume_error)
        add("Volume of the mesh", std::abs(*quality.volume_error) < 1e-8
                                      ? "that of the surface"
                                      : readable_number(100.0 * *quality.volume_error, 2) + " % from the surface’s");
    add("Shape of the elements", quality.measure + " at least " + readable_number(quality.least, 3) + ", " +
                                     readable_number(quality.mean, 3) + " on average");
    add("Material", setup.settings.material.value_or(setup.experiment.material.model) +
                        ", E = " + readable_number(1e-3 * values.youngs_modulus_Pa, 4) + " kPa, Poisson's ratio " +
                        readable_number(setup.experiment.material.poissons_ratio, 4) + ", density " +
                        readable_number(setup.experiment.material.density_kg_m3, 4) + " kg/m³");
    add("Time", to_string(setup.settings.integrator) + ", steps of " +
                    readable_number(1e3 * setup.trials.front().options.h_s, 3) + " ms");
    if (setup.settings.velocity_force_1_s != 0.0)
        add("Velocity force Λ", readable_number(setup.settings.velocity_force_1_s, 4) + " 1/s");

    report::Table noise{std::string("Noise of each marker and coordinate, ") +
                            (setup.experiment.markers.noise_m ? "as declared." : "estimated from the traces."),
                        {{"Marker"}, {"Noise", "mm", 3}},
                        {}};
    for (std::size_t m = 0; m < setup.marker_names.size(); ++m)
        // Probes have no noise: no camera sees them.
        if (!setup.experiment.markers.on_body[m].probe)
            noise.rows.push_back({setup.marker_names[m], 1e3 * setup.noise_m(static_cast<Eigen::Index>(m))});
    report::Section section{"Model and data", {facts}};
    for (report::Block& table : robot_tables(setup, values)) section.blocks.push_back(std::move(table));
    section.blocks.emplace_back(noise);
    return section;
}

}  // namespace myo::results
