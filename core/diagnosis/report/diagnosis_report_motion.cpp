#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "chart/svg.hpp"
#include "diagnosis/report/diagnosis_report_parts.hpp"
#include "report/length.hpp"
#include "results/calibration_report_parts.hpp"
#include "results/output_json.hpp"
#include "results/output_motion.hpp"

namespace myo::diagnosis {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;

/// Motion of a trial with the declared model and with the verdict's fit; empty if the run failed.
struct TrialMotion {
    std::optional<results::ComparedMotion> before, after;
    std::vector<double> time_s;
};

TrialMotion motion_of(const setup::Setup& setup, const Diagnosis& d, std::size_t trial) {
    const auto of = [&](const prediction::SetupRun& run) -> std::optional<results::ComparedMotion> {
        if (trial >= run.predictions.size() || !run.predictions[trial].ok()) return std::nullopt;
        return results::compared_motion(setup, trial, run.values, run.predictions[trial]);
    };
    TrialMotion motion;
    motion.before = of(d.before);
    if (has_two_fits(d)) motion.after = of(d.after);
    const Eigen::VectorXd& time = setup.trials[trial].measured.time_s;
    motion.time_s = {time.begin(), time.end()};
    return motion;
}

/// Rms over the coordinates of the markers at every sample [noise levels]; NaN if no marker was seen.
std::vector<double> rms_over_markers(const setup::Setup& setup, const prediction::TrialPrediction& prediction,
                                     Index samples) {
    std::vector<double> rms;
    for (Index t = 0; t < samples; ++t) {
        double sum = 0.0;
        int count = 0;
        for (std::size_t m = 0; m < prediction.residual_m.size(); ++m) {
            const Eigen::Vector3d r = prediction.residual_m[m].col(t) / setup.noise_m(static_cast<Index>(m));
            if (!r.allFinite()) continue;
            sum += r.squaredNorm();
            count += 3;
        }
        rms.push_back(count > 0 ? std::sqrt(sum / count) : std::numeric_limits<double>::quiet_NaN());
    }
    return rms;
}

/// Chart (SVG) of one marker in a trial: measured and simulated courses per axis [mm].
std::string overlay(const setup::Setup& setup, const Diagnosis& d, const TrialMotion& motion, std::size_t marker) {
    const bool displacement = setup.experiment.markers.compare == experiment::Comparison::displacement;
    const results::ComparedMotion& any = motion.before ? *motion.before : *motion.after;
    chart::Chart chart{setup.marker_names[marker], {.label = "time", .unit = "s"}, {}};
    for (Index axis = 0; axis < 3; ++axis) {
        chart::Panel panel{
            {.label = std::string(displacement ? "displacement " : "") + "xyz"[axis], .unit = "mm"}, {}, 120.0};
        const auto row = [&](const std::vector<Matrix3Xd>& tracks) {
            return report::curve_in_mm(tracks[marker].row(axis).transpose());
        };
        if (motion.before)
            panel.series.push_back({"declared model", motion.time_s, row(motion.before->simulated_m),
                                    chart::SeriesStyle::dashed, before_colour});
        if (motion.after)
            panel.series.push_back({after_words(d), motion.time_s, row(motion.after->simulated_m),
                                    chart::SeriesStyle::line, after_colour});
        panel.series.push_back(
            {"measured", motion.time_s, row(any.measured_m), chart::SeriesStyle::dots, chart::ink_colour});
        chart.panels.push_back(std::move(panel));
    }
    return chart::svg(chart);
}

/// Chart (SVG) of the rms over all markers at each sample [noise levels].
std::string residual_over_time(const setup::Setup& setup, const Diagnosis& d, std::size_t trial,
                               const std::vector<double>& time) {
    const auto samples = static_cast<Index>(time.size());
    chart::Chart chart{"", {.label = "time", .unit = "s"}, {}};
    chart::Panel panel{{.label = "residual, rms over the markers", .unit = "× noise", .logarithmic = true}, {}, 150.0};
    const auto add = [&](const prediction::SetupRun& run, const std::string& name, chart::SeriesStyle style,
                         int colour) {
        if (run.predictions[trial].ok())
            panel.series.push_back(
                {name, time, rms_over_markers(setup, run.predictions[trial], samples), style, colour});
    };
    add(d.before, "declared model", chart::SeriesStyle::line, before_colour);
    if (has_two_fits(d)) add(d.after, after_words(d), chart::SeriesStyle::line, after_colour);
    panel.horizontal.push_back({1.0, "noise"});
    chart.panels.push_back(std::move(panel));
    return chart::svg(chart);
}

/// Markers by decreasing error before; markers that were never seen are last.
std::vector<std::size_t> by_error(const prediction::TrialScore* score, std::size_t count) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (score == nullptr) return order;
    const auto error = [&](std::size_t m) {
        return std::isfinite(score->markers[m].rms_m) ? score->markers[m].rms_m : -1.0;
    };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return error(a) > error(b); });
    return order;
}

/// Figures of a trial: its worst marker, the residual over time, and further markers folded.
std::vector<report::Block> trial_blocks(const setup::Setup& setup, const Diagnosis& d, std::size_t trial) {
    const setup::PreparedTrial& t = setup.trials[trial];
    const std::string name = t.name + " (" + result_word(t.role) + ")";
    const TrialMotion motion = motion_of(setup, d, trial);
    if (!motion.before && !motion.after) return {report::Paragraph{name + ": the trial could not be run."}};
    const prediction::TrialScore* score = results::find_score(d.before, t.name);
    const std::vector<std::size_t> order = by_error(score != nullptr ? score : results::find_score(d.after, t.name),
                                                    setup.marker_names.size());
    std::vector<report::Block> blocks{
        report::Figure{overlay(setup, d, motion, order.front()),
                       name + ": " + setup.marker_names[order.front()] +
                           (!motion.time_s.empty() && score != nullptr && std::isfinite(score->rms_m)
                                ? ", the marker with the largest error."
                                : "; nothing was seen to compare with.")},
        report::Figure{residual_over_time(setup, d, trial, motion.time_s), name + ": residual over time."}};
    report::Details others{name + ": other markers", {}};
    for (std::size_t i = 1; i < std::min(order.size(), 1 + diagnosis_report_policy.further_markers); ++i)
        others.blocks.push_back(
            report::Figure{overlay(setup, d, motion, order[i]), setup.marker_names[order[i]] + "."});
    if (!others.blocks.empty()) blocks.push_back(std::move(others));
    return blocks;
}

}  // namespace

report::Section motion_section(const setup::Setup& setup, const Diagnosis& d) {
    report::Section section{"Motion", {}};
    // Predicted trials are the most informative and come first, then the fit trials.
    std::vector<std::size_t> order;
    for (const experiment::TrialRole role : {experiment::TrialRole::validate, experiment::TrialRole::fit})
        for (std::size_t t = 0; t < setup.trials.size(); ++t)
            if (setup.trials[t].role == role) order.push_back(t);
    report::Details folded{"Other trials", {}};
    for (std::size_t i = 0; i < order.size(); ++i) {
        std::vector<report::Block>& where = i < diagnosis_report_policy.trials ? section.blocks : folded.blocks;
        for (report::Block& block : trial_blocks(setup, d, order[i])) where.push_back(std::move(block));
    }
    if (!folded.blocks.empty()) section.blocks.push_back(std::move(folded));
    return section;
}

}  // namespace myo::diagnosis
