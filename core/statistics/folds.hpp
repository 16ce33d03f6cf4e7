#pragma once

#include <vector>

#include "statistics/residual_layout.hpp"

namespace myo::statistics {

/// Partition of the data for cross-validation.
struct Folds {
    int count = 0;  // number of folds
    std::vector<int>
        of_entry;           // N: fold 0 ... count - 1 of each entry; -1: used neither for fitting nor for evaluation
    bool by_trial = false;  // one fold per trial; otherwise blocks of time
};

/// Blocks of time for the case of one trial.
struct FoldOptions {
    int blocks = 5;        // number of blocks
    double guard_s = 0.0;  // [s] gap between blocks, which decouples them under coloured noise
};

/// One fold per trial for two or more trials, otherwise time_folds().
Folds make_folds(const ResidualLayout& layout, const FoldOptions& options = {});

/// Blocks of equal duration over the common time range of all trials, separated by the guard. For effects that only one
/// trial identifies.
///
/// At most as many blocks as samples; blocks without data are removed.
Folds time_folds(const ResidualLayout& layout, const FoldOptions& options = {});

}  // namespace myo::statistics
