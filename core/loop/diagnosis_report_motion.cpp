#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "loop/diagnosis_report_parts.hpp"
#include "project/output_json.hpp"
#include "project/output_motion.hpp"
#include "project/study_report_parts.hpp"
#include "report/chart.hpp"
#include "report/length.hpp"

namespace myo {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;

/// Trials that are shown at once, and markers of each; the others are folded away.
constexpr std::size_t open_trials = 3, folded_markers = 3;

/// A trial's motion with the declared model and with what the verdict stands on; either may have failed.
struct TrialMotion {
    std::optional<ComparedMotion> before, after;
    std::vector<double> time_s;
};

TrialMotion motion_of(const Study& study, const Diagnosis& d, std::size_t trial) {
    const auto of = [&](const StudyRun& run) -> std::optional<ComparedMotion> {
        if (trial >= run.predictions.size() || !run.predictions[trial].ok()) return std::nullopt;
        return compared_motion(study, trial, run.values, run.predictions[trial]);
    };
    TrialMotion motion;
    motion.before = of(d.before);
    if (has_two_fits(d)) motion.after = of(d.after);
    const Eigen::VectorXd& time = study.trials[trial].measured.time_s;
    motion.time_s = {time.begin(), time.end()};
    return motion;
}

/// Root mean square over the markers' coordinates at every sample, in units of the noise; NaN where none was seen.
std::vector<double> rms_over_markers(const Study& study, const TrialPrediction& prediction, Index samples) {
    std::vector<double> rms;
    for (Index t = 0; t < samples; ++t) {
        double sum = 0.0;
        int count = 0;
        for (std::size_t m = 0; m < prediction.residual_m.size(); ++m) {
            const Eigen::Vector3d r = prediction.residual_m[m].col(t) / study.noise_m(static_cast<Index>(m));
            if (!r.allFinite()) continue;
            sum += r.squaredNorm();
            count += 3;
        }
        rms.push_back(count > 0 ? std::sqrt(sum / count) : std::numeric_limits<double>::quiet_NaN());
    }
    return rms;
}

std::string overlay(const Study& study, const Diagnosis& d, const TrialMotion& motion, std::size_t marker) {
    const bool displacement = study.experiment.markers.compare == Comparison::displacement;
    const ComparedMotion& any = motion.before ? *motion.before : *motion.after;
    LineChart chart{study.marker_names[marker], {.label = "time", .unit = "s"}, {}};
    for (Index axis = 0; axis < 3; ++axis) {
        ChartPanel panel{{.label = std::string(displacement ? "displacement " : "") + "xyz"[axis], .unit = "mm"}, {}, 120.0};
        const auto row = [&](const std::vector<Matrix3Xd>& tracks) { return curve_in_mm(tracks[marker].row(axis).transpose()); };
        if (motion.before) panel.series.push_back({"declared model", motion.time_s, row(motion.before->simulated_m), SeriesStyle::dashed, before_colour});
        if (motion.after) panel.series.push_back({after_words(d), motion.time_s, row(motion.after->simulated_m), SeriesStyle::line, after_colour});
        panel.series.push_back({"measured", motion.time_s, row(any.measured_m), SeriesStyle::dots, ink_colour});
        chart.panels.push_back(std::move(panel));
    }
    return svg(chart);
}

std::string residual_over_time(const Study& study, const Diagnosis& d, std::size_t trial, const std::vector<double>& time) {
    const auto samples = static_cast<Index>(time.size());
    LineChart chart{"", {.label = "time", .unit = "s"}, {}};
    ChartPanel panel{{.label = "residual, rms over the markers", .unit = "× noise", .logarithmic = true}, {}, 150.0};
    const auto add = [&](const StudyRun& run, const std::string& name, SeriesStyle style, int colour) {
        if (run.predictions[trial].ok()) panel.series.push_back({name, time, rms_over_markers(study, run.predictions[trial], samples), style, colour});
    };
    add(d.before, "declared model", SeriesStyle::line, before_colour);
    if (has_two_fits(d)) add(d.after, after_words(d), SeriesStyle::line, after_colour);
    panel.horizontal.push_back({1.0, "noise"});
    chart.panels.push_back(std::move(panel));
    return svg(chart);
}

/// Markers by their error before, the largest first; those that were never seen last.
std::vector<std::size_t> by_error(const TrialScore* score, std::size_t count) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (score == nullptr) return order;
    const auto error = [&](std::size_t m) { return std::isfinite(score->markers[m].rms_m) ? score->markers[m].rms_m : -1.0; };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return error(a) > error(b); });
    return order;
}

std::vector<Block> trial_blocks(const Study& study, const Diagnosis& d, std::size_t trial) {
    const StudyTrial& t = study.trials[trial];
    const std::string name = t.name + " (" + role_words(t.role) + ")";
    const TrialMotion motion = motion_of(study, d, trial);
    if (!motion.before && !motion.after) return {Paragraph{name + ": the trial could not be run."}};
    const TrialScore* score = find_score(d.before, t.name);
    const std::vector<std::size_t> order = by_error(score != nullptr ? score : find_score(d.after, t.name), study.marker_names.size());
    std::vector<Block> blocks{Figure{overlay(study, d, motion, order.front()), name + ": " + study.marker_names[order.front()] + (motion.time_s.size() > 0 && score != nullptr && std::isfinite(score->rms_m) ? ", the marker with the largest error." : "; nothing was seen to compare with.")},
                              Figure{residual_over_time(study, d, trial, motion.time_s), name + ": what is left at each moment."}};
    Details others{name + ": other markers", {}};
    for (std::size_t i = 1; i < std::min(order.size(), 1 + folded_markers); ++i) others.blocks.push_back(Figure{overlay(study, d, motion, order[i]), study.marker_names[order[i]] + "."});
    if (!others.blocks.empty()) blocks.push_back(std::move(others));
    return blocks;
}

}  // namespace

Section motion_section(const Study& study, const Diagnosis& d) {
    Section section{"Motion", {}};
    // Predictions tell the most; then the trials as they were declared.
    std::vector<std::size_t> order;
    for (const TrialRole role : {TrialRole::validate, TrialRole::fit})
        for (std::size_t t = 0; t < study.trials.size(); ++t)
            if (study.trials[t].role == role) order.push_back(t);
    Details folded{"Other trials", {}};
    for (std::size_t i = 0; i < order.size(); ++i) {
        std::vector<Block>& where = i < open_trials ? section.blocks : folded.blocks;
        for (Block& block : trial_blocks(study, d, order[i])) where.push_back(std::move(block));
    }
    if (!folded.blocks.empty()) section.blocks.push_back(std::move(folded));
    return section;
}

}  // namespace myo
