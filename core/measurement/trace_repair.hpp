#pragma once

#include <Eigen/Core>

#include <string>

#include "base/result.hpp"
#include "measurement/recording.hpp"

namespace myo::measurement {

/// What a person does to a marker's trace that no automatic correction can know.
enum class RepairKind { cut, swap, fill, smooth };
/// The word of the declaration: "cut", "swap", "fill" or "smooth".
std::string to_string(RepairKind kind);

/// One repair of a trace, over the samples from_s <= t <= to_s.
struct TraceRepair {
    RepairKind kind = RepairKind::cut;
    std::string marker;
    std::string with;       // swap: the other marker
    double from_s = 0.0;    // file time
    double to_s = 0.0;      // file time, >= from_s
    double window_s = 0.0;  // smooth: width of the window of the local polynomial, > 0

    bool operator==(const TraceRepair&) const = default;
};

struct TraceRepairPolicy {
    /// Tolerance of the ends of a span, over the mean interval of the samples: a time that was written and read again
    /// still names its sample.
    double edge_intervals = 0.01;
    /// Degree of the polynomials that fill and smooth. Cubic: the least that follows a value and a slope on both sides.
    int degree = 3;
    /// Seen samples on each side of a gap that the filling polynomial follows. More average the noise, fewer follow
    /// fast motions: gap and neighbours together should last less than a period.
    Eigen::Index neighbours = 5;
};
inline constexpr TraceRepairPolicy trace_repair_policy;

/// Makes one repair.
///
/// cut: the samples become a gap. swap: two markers exchange their samples. fill: gaps get the values of a cubic
/// polynomial, fitted per gap to the five seen samples on each side of it by least squares; a gap without samples on
/// both sides stays. smooth: every seen sample gets the value at its time of the cubic polynomial that fits the seen
/// samples within half a window on each side best (Savitzky & Golay 1964, here for any sample times); samples with
/// fewer than five of them stay, and so do gaps.
///
/// @param recording  in/out: 3 x T per marker [m]; unchanged after an error
/// @return           number of changed samples, of both markers for swap
/// Errors, one sentence: a name that the recording does not contain, a marker with itself, a span without samples, and
/// a repair that would change nothing.
Result<Eigen::Index> repair_trace(Recording& recording, const TraceRepair& repair);

/// The repair in words: "smoothed \"tip\" from 0.2 s to 0.4 s (window 0.05 s)".
///
/// @param shift_s  added to the times, e.g. from file time to trial time
std::string repair_words(const TraceRepair& repair, double shift_s = 0.0);

/// Whether the samples are no longer independent measurements: filled and smoothed ones.
inline bool makes_samples(RepairKind kind) { return kind == RepairKind::fill || kind == RepairKind::smooth; }

/// Samples [first, end) of a span.
struct SampleSpan {
    Eigen::Index first = 0, end = 0;
};
/// Samples with from_s <= t <= to_s, within the tolerance of the policy.
///
/// @param time_s  ascending
SampleSpan samples_within(const Eigen::VectorXd& time_s, double from_s, double to_s);

}  // namespace myo::measurement
