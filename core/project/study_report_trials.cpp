#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "project/output_json.hpp"
#include "project/output_motion.hpp"
#include "project/study_report_parts.hpp"
#include "report/chart.hpp"
#include "report/length.hpp"
#include "report/markup.hpp"

namespace myo {
namespace {

using Eigen::Matrix3Xd;

struct MarkerFigure {
    const Study& study;
    const Calibration& calibration;
    std::size_t trial;
    std::optional<ComparedMotion> before;   // none: it could not be run with the declared values
    ComparedMotion after;

    LineChart chart(std::size_t marker) const;
};

LineChart MarkerFigure::chart(std::size_t marker) const {
    const bool displacement = study.experiment.markers.compare == Comparison::displacement;
    const std::vector<double> time(after.time_s.begin(), after.time_s.end());
    LineChart chart{study.marker_names[marker], {.label = "time", .unit = "s"}, {}};
    const auto compared_axis = [&](Eigen::Index axis) {
        ChartPanel panel{{.label = std::string(displacement ? "displacement " : "") + "xyz"[axis], .unit = "mm"}, {}, 130.0};
        const auto row = [&](const std::vector<Matrix3Xd>& tracks) { return curve_in_mm(tracks[marker].row(axis).transpose()); };
        // Measured last: it lies on top where both agree.
        if (before) panel.series.push_back({"before the fit", time, row(before->simulated_m), SeriesStyle::dashed, 1});
        panel.series.push_back({"after the fit", time, row(after.simulated_m), SeriesStyle::line, 0});
        panel.series.push_back({"measured", time, row(after.measured_m), SeriesStyle::dots, ink_colour});
        return panel;
    };
    for (Eigen::Index axis = 0; axis < 3; ++axis) chart.panels.push_back(compared_axis(axis));

    const auto distance = [&](const ComparedMotion& motion, const TrialPrediction& prediction) {
        Eigen::VectorXd d = (motion.simulated_m[marker] - motion.measured_m[marker]).colwise().norm().transpose();
        for (Eigen::Index t = 0; t < d.size(); ++t)   // samples before the start are not compared
            if (!prediction.residual_m[marker].col(t).allFinite()) d(t) = std::nan("");
        return curve_in_mm(d);
    };
    ChartPanel residual{{.label = "distance, simulated to measured", .unit = "mm", .lowest = 0.0}, {}, 110.0};
    if (before) residual.series.push_back({"before the fit", time, distance(*before, calibration.before.predictions[trial]), SeriesStyle::dashed, 1});
    residual.series.push_back({"after the fit", time, distance(after, calibration.after.predictions[trial]), SeriesStyle::line, 0});
    // Three coordinates of noise sigma lie sqrt(3) sigma apart on average (root mean square).
    residual.horizontal.push_back({1e3 * std::sqrt(3.0) * study.noise_m(static_cast<Eigen::Index>(marker)), "noise"});
    chart.panels.push_back(std::move(residual));
    return chart;
}

std::string start_paragraph(const Study& study, const Calibration& calibration, std::size_t index) {
    const StudyTrial& trial = study.trials[index];
    std::string text = trial.start_message.empty() ? "" : "Start: " + trial.start_message + ".";
    const double shift = calibration.after.values.start_shift_s[index];
    if (shift != 0.0) text += " The fit moved it by " + readable_number(1e3 * shift, 3) + " ms.";
    if (trial.registration_rms_m)
        text += " Registration: the rest positions of the markers fit the recording to " + readable_number(1e3 * *trial.registration_rms_m, 3) + " mm rms.";
    for (std::size_t m = 0; m < trial.occluded_fraction.size(); ++m)
        if (trial.occluded_fraction[m] > 0.005)
            text += " " + study.marker_names[m] + " was hidden in " + readable_number(100.0 * trial.occluded_fraction[m], 2) + " % of the samples.";
    for (const auto& [muscle, level] : calibration.after.values.levels[index])
        text += " Level of " + study.experiment.muscles[muscle].name + ": " + readable_number(level, 4) +
                (trial.role == TrialRole::fit ? ", fitted." : ", predicted from the fit trials.");
    return text;
}

std::string vector_words(const Eigen::Vector3d& metres) {
    if (!metres.allFinite()) return "–";
    const char* const apart = ",\u00a0";   // stays on one line
    return fixed_decimals(1e3 * metres.x(), 2) + apart + fixed_decimals(1e3 * metres.y(), 2) + apart + fixed_decimals(1e3 * metres.z(), 2);
}

Table steady_table(const TrialScore* before, const TrialScore& after, bool displacement) {
    Table table{std::string("Steady state, the mean over the last fifth of the samples, and rms of the whole trial; ") + (displacement ? "displacement" : "position") + " x, y, z.",
                {{"Marker"}, {"Measured", "mm"}, {"Simulated", "mm"}, {"Error", "mm", 3}, {"Error before", "mm", 3}, {"rms", "mm", 3}},
                {}};
    for (std::size_t m = 0; m < after.markers.size(); ++m) {
        const MarkerScore& marker = after.markers[m];
        table.rows.push_back({marker.name, vector_words(marker.steady_measured_m), vector_words(marker.steady_simulated_m), 1e3 * marker.steady_error_m,
                              1e3 * (before != nullptr ? before->markers[m].steady_error_m : std::nan("")), 1e3 * marker.rms_m});
    }
    return table;
}

/// The markers, the most telling first.
struct ShownOrder {
    std::vector<std::size_t> markers;
    std::string reason;
};

ShownOrder shown_order(const TrialScore* before, const TrialScore& after) {
    ShownOrder shown;
    double least = std::numeric_limits<double>::infinity(), most = 0.0;
    for (const MarkerScore& marker : after.markers)
        if (std::isfinite(marker.rms_m)) least = std::min(least, marker.rms_m), most = std::max(most, marker.rms_m);
    // Alike within a quarter, the errors only rank the noise; what the fit had to do tells more.
    const bool alike = before != nullptr && !(most > 1.25 * least);
    shown.reason = alike ? ", the marker with the largest error before the fit; after it all are alike." : ", the marker with the largest error.";
    shown.markers.resize(after.markers.size());
    std::iota(shown.markers.begin(), shown.markers.end(), std::size_t{0});
    const auto badness = [&](std::size_t m) {
        const double rms_m = (alike ? *before : after).markers[m].rms_m;
        return std::isfinite(rms_m) ? rms_m : -1.0;   // markers that were never seen go last
    };
    std::stable_sort(shown.markers.begin(), shown.markers.end(), [&](std::size_t a, std::size_t b) { return badness(a) > badness(b); });
    return shown;
}

}  // namespace

Section trial_section(const Study& study, const Calibration& calibration, std::size_t index) {
    const StudyTrial& trial = study.trials[index];
    const TrialScore* before = find_score(calibration.before, trial.name);
    const TrialScore* after = find_score(calibration.after, trial.name);
    Section section{trial.name + " (" + role_words(trial.role) + ")", {}};
    if (before == nullptr) section.blocks.push_back(Paragraph{"Not run with the declared values: " + calibration.before.predictions[index].message + "."});
    if (after == nullptr) {
        section.blocks.push_back(Paragraph{"Not run with the fitted values: " + calibration.after.predictions[index].message + "."});
        return section;
    }

    const auto motion = [&](const StudyRun& run) { return compared_motion(study, index, run.values, run.predictions[index]); };
    const MarkerFigure figures{study, calibration, index, before != nullptr ? std::optional(motion(calibration.before)) : std::nullopt,
                               motion(calibration.after)};
    const ShownOrder shown = shown_order(before, *after);
    const std::vector<std::size_t>& order = shown.markers;
    section.blocks.push_back(Paragraph{std::string(trial.role == TrialRole::fit ? "" : "Not used in the fit: a prediction. ") +
                                       start_paragraph(study, calibration, index)});
    section.blocks.push_back(Figure{svg(figures.chart(order.front())), study.marker_names[order.front()] + shown.reason + (order.size() > 1 ? " The others are below." : "")});
    section.blocks.push_back(steady_table(before, *after, study.experiment.markers.compare == Comparison::displacement));
    Details others{"Figures of the other markers", {}};
    for (std::size_t i = 1; i < order.size(); ++i) others.blocks.push_back(Figure{svg(figures.chart(order[i])), study.marker_names[order[i]] + "."});
    if (!others.blocks.empty()) section.blocks.push_back(std::move(others));
    return section;
}

}  // namespace myo
