#include "statistics/folds.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <set>

namespace myo::statistics {
namespace {

// Removes folds without entries and renumbers the others in order.
Folds without_empty(Folds folds) {
    std::set<int> used(folds.of_entry.begin(), folds.of_entry.end());
    used.erase(-1);
    folds.count = static_cast<int>(used.size());
    for (int& fold : folds.of_entry)
        if (fold >= 0) fold = static_cast<int>(std::distance(used.begin(), used.find(fold)));
    return folds;
}

// One fold per trial.
Folds by_trial(const ResidualLayout& layout, const std::vector<int>& trials) {
    Folds folds{static_cast<int>(trials.size()), std::vector<int>(layout.sample.size()), true};
    for (const ResidualSeries& series : layout.series) {
        const auto place = std::lower_bound(trials.begin(), trials.end(), series.trial);
        std::fill(folds.of_entry.begin() + series.begin, folds.of_entry.begin() + series.end,
                  static_cast<int>(place - trials.begin()));
    }
    return without_empty(std::move(folds));
}

}  // namespace

Folds time_folds(const ResidualLayout& layout, const FoldOptions& options) {
    assert(is_consistent(layout) && options.blocks > 1 && options.guard_s >= 0.0);
    Folds folds{0, std::vector<int>(layout.sample.size(), -1), false};
    if (layout.size() == 0) return folds;
    const auto [first, last] = std::minmax_element(layout.time_s.begin(), layout.time_s.end());
    const auto [first_sample, last_sample] = std::minmax_element(layout.sample.begin(), layout.sample.end());
    const int blocks = std::min(options.blocks, *last_sample - *first_sample + 1);
    const double length = (*last - *first) / blocks;
    for (std::size_t k = 0; k < layout.sample.size(); ++k) {
        const double place = length > 0.0 ? (layout.time_s[k] - *first) / length : 0.0;
        const int block = std::min(static_cast<int>(place), blocks - 1);
        // Half of the guard on each side of an inner boundary.
        const double nearest = std::round(place);
        const bool inner = nearest > 0.5 && nearest < blocks - 0.5;
        if (inner && std::abs(place - nearest) * length < 0.5 * options.guard_s) continue;
        folds.of_entry[k] = block;
    }
    return without_empty(std::move(folds));
}

Folds make_folds(const ResidualLayout& layout, const FoldOptions& options) {
    const std::vector<int> trials = trials_of(layout);
    return trials.size() > 1 ? by_trial(layout, trials) : time_folds(layout, options);
}

}  // namespace myo::statistics
