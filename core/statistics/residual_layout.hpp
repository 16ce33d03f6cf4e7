#pragma once

#include <Eigen/Core>

#include <cmath>
#include <vector>

namespace myo::statistics {

/// One coordinate of one marker in one trial: entries [begin, end) of the flattened vectors, in time order.
struct ResidualSeries {
    int trial = 0;           // trial number
    int marker = 0;          // marker number
    int axis = 0;            // 0 x, 1 y, 2 z
    Eigen::Index begin = 0;  // first entry
    Eigen::Index end = 0;    // one past the last entry

    Eigen::Index size() const { return end - begin; }
};

/// Meaning of the entries of a flattened residual vector.
///
/// Convention of this module: a residual r (N) is (measured - predicted) / sigma, and Jacobians (N x p) are derivatives
/// of the prediction over sigma. Pure noise is then white with standard deviation 1, and r - J d is the residual after
/// a step d. If r is (predicted - measured), only the steps change sign. Unseen samples are omitted.
struct ResidualLayout {
    std::vector<ResidualSeries> series;  // contiguous, together all N entries
    std::vector<int> sample;             // N: sample number within the trial, ascending in a series; gaps skip numbers
    std::vector<double> time_s;          // N: time of each entry

    Eigen::Index size() const { return static_cast<Eigen::Index>(sample.size()); }
};

/// True if the series are contiguous, cover all entries and have ascending sample numbers.
bool is_consistent(const ResidualLayout& layout);

/// Trials that have series, ascending.
std::vector<int> trials_of(const ResidualLayout& layout);

/// One series on the complete grid of sample numbers, zero at unseen samples.
struct GriddedSeries {
    Eigen::VectorXd values;  // T
    Eigen::VectorXd seen;    // T: 1 if seen, else 0

    /// Number of seen samples.
    Eigen::Index count() const { return std::lround(seen.sum()); }
};

/// Grid from the first to the last sample of one series. Empty for an empty series.
GriddedSeries gridded(const Eigen::VectorXd& r, const ResidualLayout& layout, const ResidualSeries& series);

/// Grid from one value per sample, NaN at unseen samples.
GriddedSeries gridded(const Eigen::VectorXd& values);

/// All series of a trial on a common sample grid.
struct GriddedTrial {
    int trial = 0;            // trial number
    int first_sample = 0;     // sample number of column 0
    std::vector<int> series;  // rows: indices into the layout's series
    Eigen::MatrixXd values;   // rows x T, zero at unseen samples
    Eigen::VectorXd time_s;   // T: linear interpolation between seen samples
};
/// Common grid of the given trial; no rows if the trial has no samples.
GriddedTrial gridded_trial(const Eigen::VectorXd& r, const ResidualLayout& layout, int trial);

}  // namespace myo::statistics
