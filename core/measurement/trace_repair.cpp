#include "measurement/trace_repair.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "base/text.hpp"
#include "measurement/gaps.hpp"
#include "measurement/recording_edit.hpp"

namespace myo::measurement {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;

/// Value at `at_s` of the polynomial that fits these samples best, in each coordinate.
Eigen::Vector3d fitted_value(const Eigen::VectorXd& time_s, const Matrix3Xd& track, const std::vector<Index>& samples,
                             double at_s) {
    const auto count = static_cast<Index>(samples.size());
    const Index terms = std::min<Index>(trace_repair_policy.degree + 1, count);
    // Times relative to `at_s` over their extent: the constant term is the value, and the powers stay near 1.
    double extent_s = 0.0;
    for (const Index k : samples) extent_s = std::max(extent_s, std::abs(time_s(k) - at_s));
    Eigen::MatrixXd powers(count, terms), values(count, 3);
    for (Index row = 0; row < count; ++row) {
        const Index k = samples[static_cast<std::size_t>(row)];
        const double x = extent_s > 0.0 ? (time_s(k) - at_s) / extent_s : 0.0;
        powers(row, 0) = 1.0;
        for (Index power = 1; power < terms; ++power) powers(row, power) = powers(row, power - 1) * x;
        values.row(row) = track.col(k).transpose();
    }
    return powers.colPivHouseholderQr().solve(values).row(0).transpose();
}

/// Up to `count` seen samples from `from` on, in steps of `by`.
std::vector<Index> seen_beside(const Matrix3Xd& track, Index from, Index by, Index count) {
    std::vector<Index> found;
    for (Index t = from; t >= 0 && t < track.cols() && static_cast<Index>(found.size()) < count; t += by)
        if (is_seen(track, t)) found.push_back(t);
    return found;
}

Index fill(const Eigen::VectorXd& time_s, const SampleSpan& span, Matrix3Xd& track) {
    const Matrix3Xd before = track;
    Index changed = 0;
    for (Index t = span.first; t < span.end; ++t) {
        if (is_seen(before, t)) continue;
        std::vector<Index> samples = seen_beside(before, t, -1, trace_repair_policy.neighbours);
        const std::vector<Index> after = seen_beside(before, t, 1, trace_repair_policy.neighbours);
        if (samples.empty() || after.empty()) continue;
        samples.insert(samples.end(), after.begin(), after.end());
        track.col(t) = fitted_value(time_s, before, samples, time_s(t));
        ++changed;
    }
    return changed;
}

Index smooth(const Eigen::VectorXd& time_s, const SampleSpan& span, double window_s, Matrix3Xd& track) {
    const Matrix3Xd before = track;
    Index changed = 0;
    for (Index t = span.first; t < span.end; ++t) {
        if (!is_seen(before, t)) continue;
        const SampleSpan near = samples_within(time_s, time_s(t) - 0.5 * window_s, time_s(t) + 0.5 * window_s);
        std::vector<Index> samples;
        for (Index k = near.first; k < near.end; ++k)
            if (is_seen(before, k)) samples.push_back(k);
        // As many samples as terms would be met exactly.
        if (static_cast<Index>(samples.size()) <= trace_repair_policy.degree + 1) continue;
        track.col(t) = fitted_value(time_s, before, samples, time_s(t));
        ++changed;
    }
    return changed;
}

Index cut(const SampleSpan& span, Matrix3Xd& track) {
    Index changed = 0;
    for (Index t = span.first; t < span.end; ++t) changed += is_seen(track, t) ? 1 : 0;
    track.middleCols(span.first, span.end - span.first).setConstant(std::numeric_limits<double>::quiet_NaN());
    return changed;
}

Index swap(const SampleSpan& span, Matrix3Xd& one, Matrix3Xd& other) {
    const Index count = span.end - span.first;
    one.middleCols(span.first, count).swap(other.middleCols(span.first, count));
    Index changed = 0;
    for (const Matrix3Xd* track : {&one, &other})
        for (Index t = span.first; t < span.end; ++t) changed += is_seen(*track, t) ? 1 : 0;
    return changed;
}

/// Index of a marker, or a sentence with the closest name.
Result<std::size_t> marker_of(const Recording& recording, const std::string& name) {
    if (const std::optional<std::size_t> i = label_index(recording, name)) return *i;
    const std::string near = closest_word(name, recording.labels);
    return Error{"no marker \"" + name + "\"; " +
                     (near.empty() ? "there are " + join(recording.labels) : "the closest one is \"" + near + "\""),
                 ""};
}

std::string span_words(const TraceRepair& repair, double shift_s) {
    return " from " + format_number(repair.from_s + shift_s, 4) + " s to " + format_number(repair.to_s + shift_s, 4) +
           " s";
}

/// Why a repair changes nothing.
std::string idle_words(const TraceRepair& repair) {
    switch (repair.kind) {
        case RepairKind::fill:
            return "\"" + repair.marker + "\" has no gap" + span_words(repair, 0.0) + " with samples on both sides";
        case RepairKind::smooth:
            return "a window of " + format_number(repair.window_s, 4) + " s holds fewer than " +
                   std::to_string(trace_repair_policy.degree + 2) + " samples of \"" + repair.marker + "\"" +
                   span_words(repair, 0.0);
        default: return "\"" + repair.marker + "\" is not seen" + span_words(repair, 0.0);
    }
}

}  // namespace

std::string to_string(RepairKind kind) {
    switch (kind) {
        case RepairKind::cut: return "cut";
        case RepairKind::swap: return "swap";
        case RepairKind::fill: return "fill";
        case RepairKind::smooth: return "smooth";
    }
    return "";
}

SampleSpan samples_within(const Eigen::VectorXd& time_s, double from_s, double to_s) {
    const Index last = time_s.size() - 1;
    const double interval = last > 0 ? (time_s(last) - time_s(0)) / static_cast<double>(last) : 0.0;
    const double margin = trace_repair_policy.edge_intervals * interval;
    const auto begin = time_s.begin();
    const Index first = std::lower_bound(begin, time_s.end(), from_s - margin) - begin;
    const Index end = std::upper_bound(begin, time_s.end(), to_s + margin) - begin;
    return {first, std::max(first, end)};
}

Result<Index> repair_trace(Recording& recording, const TraceRepair& repair) {
    const Result<std::size_t> marker = marker_of(recording, repair.marker);
    if (!marker) return marker.error();
    const SampleSpan span = samples_within(recording.time_s, repair.from_s, repair.to_s);
    if (span.first == span.end) return Error{"no sample lies" + span_words(repair, 0.0), ""};
    Recording result = recording;
    Matrix3Xd& track = result.tracks[*marker];
    Index changed = 0;
    switch (repair.kind) {
        case RepairKind::cut: changed = cut(span, track); break;
        case RepairKind::fill: changed = fill(result.time_s, span, track); break;
        case RepairKind::smooth: changed = smooth(result.time_s, span, repair.window_s, track); break;
        case RepairKind::swap: {
            const Result<std::size_t> other = marker_of(recording, repair.with);
            if (!other) return other.error();
            if (*other == *marker) return Error{"\"" + repair.marker + "\" cannot be swapped with itself", ""};
            changed = swap(span, track, result.tracks[*other]);
            // What the file says of the samples moves with them.
            if (!result.residual_m.empty())
                result.residual_m[*marker]
                    .segment(span.first, span.end - span.first)
                    .swap(result.residual_m[*other].segment(span.first, span.end - span.first));
            break;
        }
    }
    if (changed == 0) return Error{idle_words(repair), ""};
    recording = std::move(result);
    return changed;
}

std::string repair_words(const TraceRepair& repair, double shift_s) {
    const std::string marker = "\"" + repair.marker + "\"", span = span_words(repair, shift_s);
    switch (repair.kind) {
        case RepairKind::cut: return "cut " + marker + span;
        case RepairKind::swap: return "swapped " + marker + " and \"" + repair.with + "\"" + span;
        case RepairKind::fill: return "filled the gaps of " + marker + span;
        case RepairKind::smooth:
            return "smoothed " + marker + span + " (window " + format_number(repair.window_s, 4) + " s)";
    }
    return "";
}

}  // namespace myo::measurement
