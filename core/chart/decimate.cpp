#include "chart/decimate.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace myo::chart {
namespace {

/// Appends point i of a curve.
void append(Polyline& out, const Polyline& in, std::size_t i) {
    out.x.push_back(in.x[i]);
    out.y.push_back(in.y[i]);
}

// Keeps the extremes and ends of the points [begin, end), which lie in one column and are finite.
void append_run(Polyline& out, const Polyline& in, std::size_t begin, std::size_t end) {
    std::size_t low = begin, high = begin;
    for (std::size_t i = begin; i < end; ++i) {
        if (in.y[i] < in.y[low]) low = i;
        if (in.y[i] > in.y[high]) high = i;
    }
    // In order of index, without duplicates.
    std::array<std::size_t, 4> keep = {begin, std::min(low, high), std::max(low, high), end - 1};
    for (std::size_t k = 0; k < keep.size(); ++k)
        if (k == 0 || keep[k] != keep[k - 1]) append(out, in, keep[k]);
}

}  // namespace

Polyline decimate(const Polyline& curve, double columns_per_px) {
    assert(curve.x.size() == curve.y.size());
    const std::size_t count = curve.x.size();
    // Short curves gain nothing.
    if (count < 400) return curve;
    const auto gap = [&](std::size_t i) { return !std::isfinite(curve.x[i]) || !std::isfinite(curve.y[i]); };
    // Only consecutive points of a column are merged, so that a curve may go back in x.
    const auto column = [&](std::size_t i) { return std::floor(curve.x[i] * columns_per_px); };
    Polyline out;
    for (std::size_t i = 0; i < count;) {
        if (gap(i)) {
            // Consecutive gaps are reduced to one.
            if (!out.x.empty() && std::isfinite(out.y.back())) {
                out.x.push_back(std::numeric_limits<double>::quiet_NaN());
                out.y.push_back(std::numeric_limits<double>::quiet_NaN());
            }
            ++i;
            continue;
        }
        std::size_t end = i + 1;
        while (end < count && !gap(end) && column(end) == column(i)) ++end;
        append_run(out, curve, i, end);
        i = end;
    }
    return out;
}

}  // namespace myo::chart
