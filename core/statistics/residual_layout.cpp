#include "statistics/residual_layout.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <set>

namespace myo::statistics {
namespace {

int first_sample(const ResidualLayout& layout, const ResidualSeries& series) {
    return layout.sample[static_cast<std::size_t>(series.begin)];
}

int last_sample(const ResidualLayout& layout, const ResidualSeries& series) {
    return layout.sample[static_cast<std::size_t>(series.end - 1)];
}

// Linear interpolation over NaN gaps; the first and the last value are known.
void fill_between(Eigen::VectorXd& values) {
    Eigen::Index known = 0;
    for (Eigen::Index t = 1; t < values.size(); ++t) {
        if (std::isnan(values(t))) continue;
        const double slope = (values(t) - values(known)) / static_cast<double>(t - known);
        for (Eigen::Index k = known + 1; k < t; ++k) values(k) = values(known) + slope * static_cast<double>(k - known);
        known = t;
    }
}

}  // namespace

bool is_consistent(const ResidualLayout& layout) {
    if (layout.time_s.size() != layout.sample.size()) return false;
    // Each series must begin where the previous one ended.
    Eigen::Index next = 0;
    for (const ResidualSeries& series : layout.series) {
        if (series.begin != next || series.end < series.begin || series.end > layout.size()) return false;
        for (Eigen::Index k = series.begin + 1; k < series.end; ++k)
            if (layout.sample[static_cast<std::size_t>(k)] <= layout.sample[static_cast<std::size_t>(k - 1)])
                return false;
        next = series.end;
    }
    return next == layout.size();
}

std::vector<int> trials_of(const ResidualLayout& layout) {
    std::set<int> trials;
    for (const ResidualSeries& series : layout.series) trials.insert(series.trial);
    return {trials.begin(), trials.end()};
}

GriddedSeries gridded(const Eigen::VectorXd& r, const ResidualLayout& layout, const ResidualSeries& series) {
    assert(r.size() == layout.size());
    if (series.size() == 0) return {};
    const int first = first_sample(layout, series);
    const Eigen::Index length = last_sample(layout, series) - first + 1;
    GriddedSeries result{Eigen::VectorXd::Zero(length), Eigen::VectorXd::Zero(length)};
    for (Eigen::Index k = series.begin; k < series.end; ++k) {
        const Eigen::Index t = layout.sample[static_cast<std::size_t>(k)] - first;
        result.values(t) = r(k);
        result.seen(t) = 1.0;
    }
    return result;
}

GriddedSeries gridded(const Eigen::VectorXd& values) {
    const auto known = values.array() == values.array();  // false for NaN
    return {known.select(values, 0.0), known.cast<double>()};
}

GriddedTrial gridded_trial(const Eigen::VectorXd& r, const ResidualLayout& layout, int trial) {
    assert(r.size() == layout.size());
    GriddedTrial result;
    result.trial = trial;
    int first = std::numeric_limits<int>::max();
    int last = std::numeric_limits<int>::min();
    for (std::size_t i = 0; i < layout.series.size(); ++i) {
        const ResidualSeries& series = layout.series[i];
        if (series.trial != trial || series.size() == 0) continue;
        result.series.push_back(static_cast<int>(i));
        first = std::min(first, first_sample(layout, series));
        last = std::max(last, last_sample(layout, series));
    }
    if (result.series.empty()) return result;
    result.first_sample = first;
    const Eigen::Index length = last - first + 1;
    result.values.setZero(static_cast<Eigen::Index>(result.series.size()), length);
    result.time_s.setConstant(length, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t row = 0; row < result.series.size(); ++row) {
        const ResidualSeries& series = layout.series[static_cast<std::size_t>(result.series[row])];
        for (Eigen::Index k = series.begin; k < series.end; ++k) {
            const Eigen::Index t = layout.sample[static_cast<std::size_t>(k)] - first;
            result.values(static_cast<Eigen::Index>(row), t) = r(k);
            result.time_s(t) = layout.time_s[static_cast<std::size_t>(k)];
        }
    }
    fill_between(result.time_s);
    return result;
}

}  // namespace myo::statistics
