#pragma once

#include <Eigen/Core>

#include <vector>

namespace myo::statistics {

/// One coordinate of one marker in one trial: entries [begin, end) of the flattened vectors, in time order.
struct ResidualSeries {
    int trial = 0;
    int marker = 0;
    int axis = 0;  // 0 x, 1 y, 2 z
    Eigen::Index begin = 0;
    Eigen::Index end = 0;

    Eigen::Index size() const { return end - begin; }
};

/// What the entries of a flattened residual vector are.
///
/// Throughout this module a residual r (N) is (measured - predicted) / sigma, and Jacobians (N x p) are derivatives of
/// the prediction over sigma: noise alone is white with standard deviation 1, and r - J d is the residual after a step
/// d. Where r is (predicted - measured), the steps change sign and nothing else does. Samples that were not seen are
/// left out.
struct ResidualLayout {
    std::vector<ResidualSeries> series;  // one after the other, together all entries
    std::vector<int> sample;     // per entry: sample number of its trial, rising within a series; gaps skip numbers
    std::vector<double> time_s;  // per entry

    Eigen::Index size() const { return static_cast<Eigen::Index>(sample.size()); }
};

/// Whether the series follow each other, cover all entries and have rising sample numbers.
bool is_consistent(const ResidualLayout& layout);

/// Trials that have series, rising.
std::vector<int> trials_of(const ResidualLayout& layout);

/// A series on the full grid of sample numbers, zero where not seen.
struct GriddedSeries {
    Eigen::VectorXd values;  // T
    Eigen::VectorXd seen;    // T, 1 or 0

    Eigen::Index count() const { return static_cast<Eigen::Index>(seen.sum() + 0.5); }
};

/// One series from its first to its last sample.
GriddedSeries gridded(const Eigen::VectorXd& r, const ResidualLayout& layout, const ResidualSeries& series);

/// One value per sample, NaN where not seen.
GriddedSeries gridded(const Eigen::VectorXd& values);

/// All series of a trial on its common grid of samples.
struct GriddedTrial {
    int trial = 0;
    int first_sample = 0;
    std::vector<int> series;  // rows: indices into the layout's series
    Eigen::MatrixXd values;   // rows x T, zero where not seen
    Eigen::VectorXd time_s;   // T; between seen samples interpolated
};
GriddedTrial gridded_trial(const Eigen::VectorXd& r, const ResidualLayout& layout, int trial);

}  // namespace myo::statistics
