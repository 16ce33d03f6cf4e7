#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "base/markup.hpp"
#include "chart/svg.hpp"
#include "report/length.hpp"
#include "results/calibration_report_parts.hpp"
#include "results/output_json.hpp"
#include "results/output_motion.hpp"
#include "setup/actuator_signals.hpp"

namespace myo::results {
namespace {

using Eigen::Matrix3Xd;

/// Data of the charts of one trial.
struct MarkerFigure {
    const setup::Setup& setup;
    const calibration::Calibration& calibration;
    std::size_t trial;
    std::optional<ComparedMotion> before;  // empty if the trial could not be run with the declared values
    ComparedMotion after;

    chart::Chart chart(std::size_t marker) const;
};

/// Chart of one marker: x, y, z before and after the fit, and the distance to the measurement.
chart::Chart MarkerFigure::chart(std::size_t marker) const {
    const bool displacement = setup.experiment.markers.compare == experiment::Comparison::displacement;
    const std::vector<double> time(after.time_s.begin(), after.time_s.end());
    chart::Chart chart{setup.marker_names[marker], {.label = "time", .unit = "s"}, {}};
    const auto compared_axis = [&](Eigen::Index axis) {
        chart::Panel panel{
            {.label = std::string(displacement ? "displacement " : "") + "xyz"[axis], .unit = "mm"}, {}, 130.0};
        const auto row = [&](const std::vector<Matrix3Xd>& tracks) {
            return report::curve_in_mm(tracks[marker].row(axis).transpose());
        };
        // Measured dots are drawn last, on top of the curves.
        if (before)
            panel.series.push_back({"before the fit", time, row(before->simulated_m), chart::SeriesStyle::dashed, 1});
        panel.series.push_back({"after the fit", time, row(after.simulated_m), chart::SeriesStyle::line, 0});
        panel.series.push_back({"measured", time, row(after.measured_m), chart::SeriesStyle::dots, chart::ink_colour});
        return panel;
    };
    for (Eigen::Index axis = 0; axis < 3; ++axis) chart.panels.push_back(compared_axis(axis));

    const auto distance = [&](const ComparedMotion& motion, const prediction::TrialPrediction& prediction) {
        Eigen::VectorXd d = (motion.simulated_m[marker] - motion.measured_m[marker]).colwise().norm().transpose();
        for (Eigen::Index t = 0; t < d.size(); ++t)  // samples before the start are not compared
            if (!prediction.residual_m[marker].col(t).allFinite()) d(t) = std::nan("");
        return report::curve_in_mm(d);
    };
    chart::Panel residual{{.label = "distance, simulated to measured", .unit = "mm", .lowest = 0.0}, {}, 110.0};
    if (before)
        residual.series.push_back({"before the fit", time, distance(*before, calibration.before.predictions[trial]),
                                   chart::SeriesStyle::dashed, 1});
    residual.series.push_back(
        {"after the fit", time, distance(after, calibration.after.predictions[trial]), chart::SeriesStyle::line, 0});
    // The distance of three coordinates with noise sigma has a root mean square of sqrt(3) sigma.
    residual.horizontal.push_back({1e3 * std::sqrt(3.0) * setup.noise_m(static_cast<Eigen::Index>(marker)), "noise"});
    chart.panels.push_back(std::move(residual));
    return chart;
}

/// Unit after the value of a level: " Pa"; empty for muscles.
std::string level_unit(const setup::Setup& setup, std::size_t actuator) {
    const std::string unit = setup::signal_unit(setup.experiment, actuator);
    return unit.empty() ? "" : " " + unit;
}

/// Start, registration, occlusion and levels of a trial in words.
std::string start_paragraph(const setup::Setup& setup, const calibration::Calibration& calibration, std::size_t index) {
    const setup::PreparedTrial& trial = setup.trials[index];
    std::string text = trial.start_message.empty() ? "" : "Start: " + trial.start_message + ".";
    const double shift = calibration.after.values.start_shift_s[index];
    // Exactly 0 where the start is no parameter of the fit.
    if (shift != 0.0) text += " The fit moved it by " + readable_number(1e3 * shift, 3) + " ms.";
    if (trial.registration_rms_m)
        text += " Registration: the rest positions of the markers fit the recording to " +
                readable_number(1e3 * *trial.registration_rms_m, 3) + " mm rms.";
    for (std::size_t m = 0; m < trial.occluded_fraction.size(); ++m)
        // Less than half a percent is not worth a sentence.
        if (trial.occluded_fraction[m] > 0.005 && !setup.experiment.markers.on_body[m].probe)
            text += " " + setup.marker_names[m] + " was hidden in " +
                    readable_number(100.0 * trial.occluded_fraction[m], 2) + " % of the samples.";
    for (const auto& [actuator, level] : calibration.after.values.levels[index])
        text += " Level of " + setup::actuator_names(setup.experiment)[actuator] + ": " + readable_number(level, 4) +
                level_unit(setup, actuator) +
                (trial.role == experiment::TrialRole::fit ? ", fitted." : ", predicted from the fit trials.");
    return text;
}

/// Three components in mm.
std::string vector_words(const Eigen::Vector3d& metres) {
    if (!metres.allFinite()) return "–";
    const char* const apart = ",\u00a0";  // no-break space keeps the vector on one line
    return fixed_decimals(1e3 * metres.x(), 2) + apart + fixed_decimals(1e3 * metres.y(), 2) + apart +
           fixed_decimals(1e3 * metres.z(), 2);
}

/// Steady state per marker, measured and simulated, and rms over the trial.
report::Table steady_table(const prediction::TrialScore* before, const prediction::TrialScore& after,
                           bool displacement) {
    report::Table table{
        std::string("Steady state, the mean over the last fifth of the samples, and rms of the whole trial; ") +
            (displacement ? "displacement" : "position") + " x, y, z.",
        {{"Marker"},
         {"Measured", "mm"},
         {"Simulated", "mm"},
         {"Error", "mm", 3},
         {"Error before", "mm", 3},
         {"rms", "mm", 3}},
        {}};
    for (std::size_t m = 0; m < after.markers.size(); ++m) {
        const prediction::MarkerScore& marker = after.markers[m];
        table.rows.push_back({marker.name, vector_words(marker.steady_measured_m),
                              vector_words(marker.steady_simulated_m), 1e3 * marker.steady_error_m,
                              1e3 * (before != nullptr ? before->markers[m].steady_error_m : std::nan("")),
                              1e3 * marker.rms_m});
    }
    return table;
}

/// Markers in the order in which they are shown, most informative first.
struct ShownOrder {
    std::vector<std::size_t> markers;
    std::string reason;
};

/// @param before  null: the trial could not be run with the declared values
ShownOrder shown_order(const prediction::TrialScore* before, const prediction::TrialScore& after) {
    ShownOrder shown;
    double least = std::numeric_limits<double>::infinity(), most = 0.0;
    for (const prediction::MarkerScore& marker : after.markers)
        if (std::isfinite(marker.rms_m)) least = std::min(least, marker.rms_m), most = std::max(most, marker.rms_m);
    // If all errors after the fit are within a quarter, their order is noise; the error before the fit is more
    // informative.
    const bool alike = before != nullptr && !(most > 1.25 * least);
    shown.reason = alike ? ", the marker with the largest error before the fit; after it all errors are similar."
                         : ", the marker with the largest error.";
    shown.markers.resize(after.markers.size());
    std::iota(shown.markers.begin(), shown.markers.end(), std::size_t{0});
    const auto badness = [&](std::size_t m) {
        const double rms_m = (alike ? *before : after).markers[m].rms_m;
        return std::isfinite(rms_m) ? rms_m : -1.0;  // markers that were never visible come last
    };
    std::stable_sort(shown.markers.begin(), shown.markers.end(),
                     [&](std::size_t a, std::size_t b) { return badness(a) > badness(b); });
    return shown;
}

}  // namespace

report::Section trial_section(const setup::Setup& setup, const calibration::Calibration& calibration,
                              std::size_t index) {
    const setup::PreparedTrial& trial = setup.trials[index];
    const prediction::TrialScore* before = find_score(calibration.before, trial.name);
    const prediction::TrialScore* after = find_score(calibration.after, trial.name);
    report::Section section{trial.name + " (" + result_word(trial.role) + ")", {}};
    if (before == nullptr)
        section.blocks.push_back(report::Paragraph{
            "Not run with the declared values: " + calibration.before.predictions[index].message + "."});
    // Without a run after the fit there is nothing to draw.
    if (after == nullptr) {
        section.blocks.push_back(
            report::Paragraph{"Not run with the fitted values: " + calibration.after.predictions[index].message + "."});
        return section;
    }

    const auto motion = [&](const prediction::SetupRun& run) {
        return compared_motion(setup, index, run.values, run.predictions[index]);
    };
    // Tracks are compared once per trial, not per marker.
    const MarkerFigure figures{setup, calibration, index,
                               before != nullptr ? std::optional(motion(calibration.before)) : std::nullopt,
                               motion(calibration.after)};
    // Only the most informative marker is visible at once; the others are collapsed.
    const ShownOrder shown = shown_order(before, *after);
    const std::vector<std::size_t>& order = shown.markers;
    section.blocks.push_back(report::Paragraph{
        std::string(trial.role == experiment::TrialRole::validate   ? "Not used in the fit: a prediction. "
                    : trial.role == experiment::TrialRole::simulate ? "Without a recording: simulated only. "
                                                                    : "") +
        start_paragraph(setup, calibration, index)});
    section.blocks.push_back(report::Figure{
        chart::svg(figures.chart(order.front())),
        setup.marker_names[order.front()] + shown.reason + (order.size() > 1 ? " The others are below." : "")});
    section.blocks.push_back(
        steady_table(before, *after, setup.experiment.markers.compare == experiment::Comparison::displacement));
    report::Details others{"Figures of the other markers", {}};
    for (std::size_t i = 1; i < order.size(); ++i)
        others.blocks.push_back(
            report::Figure{chart::svg(figures.chart(order[i])), setup.marker_names[order[i]] + "."});
    if (!others.blocks.empty()) section.blocks.push_back(std::move(others));
    return section;
}

}  // namespace myo::results
