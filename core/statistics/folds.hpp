#pragma once

#include <vector>

#include "statistics/residual_layout.hpp"

namespace myo::statistics {

/// Parts of the data that are left out in turn.
struct Folds {
    int count = 0;
    std::vector<int> of_entry;  // N: 0 ... count - 1; -1: in none, used neither for fitting nor for judging
    bool by_trial = false;
};

struct FoldOptions {
    int blocks = 5;        // of time, when there is one trial
    double guard_s = 0.0;  // left out between blocks, so that coloured noise does not tell of its neighbour
};

/// One fold per trial when there are two or more; else time_folds().
Folds make_folds(const ResidualLayout& layout, const FoldOptions& options = {});

/// Blocks of equal time, the same for all series of all trials, less the guard: for what one trial alone tells of.
/// There are no more blocks than samples; a block in which no marker was seen does not count.
Folds time_folds(const ResidualLayout& layout, const FoldOptions& options = {});

}  // namespace myo::statistics
