#include "statistics/independence_test.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <vector>

#include "base/decompositions.hpp"
#include "statistics/distributions.hpp"
#include "statistics/residual_tests.hpp"

namespace myo::statistics {
namespace {

using Eigen::Index;

struct IndependenceTestPolicy {
    std::size_t min_markers = 3;  // fewer markers share no pattern that could be compared with chance
};
constexpr IndependenceTestPolicy independence_test_policy;

// Square of the largest singular value.
double strongest(const Eigen::MatrixXd& values) {
    const Eigen::MatrixXd gram = smaller_gram(values);
    return symmetric_eigenvalues(gram)(gram.rows() - 1);
}

/// Rows of a grid that belong to each marker.
std::map<int, std::vector<Index>> rows_of_markers(const GriddedTrial& grid, const ResidualLayout& layout) {
    std::map<int, std::vector<Index>> rows;
    for (std::size_t i = 0; i < grid.series.size(); ++i)
        rows[layout.series[static_cast<std::size_t>(grid.series[i])].marker].push_back(static_cast<Index>(i));
    return rows;
}

/// p-value of the strongest pattern under independent marker courses; empty if the trial cannot be tested.
std::optional<double> chance(const GriddedTrial& grid, const ResidualLayout& layout, int draws,
                             std::mt19937_64& random) {
    const std::map<int, std::vector<Index>> rows = rows_of_markers(grid, layout);
    const Index samples = grid.values.cols();
    if (rows.size() < independence_test_policy.min_markers || samples < 2) return std::nullopt;
    Eigen::ArrayXd drawn(draws);
    Eigen::MatrixXd shifted(grid.values.rows(), samples);
    for (double& value : drawn) {
        // Circular shift: keeps the autocorrelation of a marker, removes its synchronisation with the others.
        for (const auto& [marker, own] : rows) {
            const auto by = static_cast<Index>(random() % static_cast<std::uint64_t>(samples));
            for (const Index row : own) {
                shifted.row(row).tail(samples - by) = grid.values.row(row).head(samples - by);
                shifted.row(row).head(by) = grid.values.row(row).tail(by);
            }
        }
        value = strongest(shifted);
    }
    const double mean = drawn.mean(), deviation = std::sqrt((drawn - mean).square().sum() / (draws - 1));
    if (!(deviation > 0.0)) return std::nullopt;
    // The sample skewness of few draws is noisy; the bounds keep the gamma tail well defined.
    const double skewness = std::clamp((drawn - mean).cube().mean() / std::pow(deviation, 3), 0.1, 2.0);
    return shifted_gamma_tail(strongest(grid.values), mean, deviation, skewness);
}

/// Systematic mean square of one marker: systematic_rms() on its series only.
double systematic_square(const Eigen::VectorXd& r, const ResidualLayout& layout, int marker) {
    ResidualLayout own;
    std::vector<Index> entries;
    for (ResidualSeries series : layout.series) {
        if (series.marker != marker) continue;
        const Index begin = own.size();
        for (Index k = series.begin; k < series.end; ++k) {
            entries.push_back(k);
            own.sample.push_back(layout.sample[static_cast<std::size_t>(k)]);
            own.time_s.push_back(layout.time_s[static_cast<std::size_t>(k)]);
        }
        series.begin = begin;
        series.end = own.size();
        own.series.push_back(series);
    }
    return systematic_rms(r(entries), own).mean_square;
}

// Median over markers divided by the mean. The lower median is used for an even number.
double typical_share(const Eigen::VectorXd& r, const ResidualLayout& layout) {
    std::map<int, double> squares;
    for (const ResidualSeries& series : layout.series) squares.emplace(series.marker, 0.0);
    std::vector<double> sorted;
    double sum = 0.0;
    for (const auto& [marker, unused] : squares) {
        sorted.push_back(systematic_square(r, layout, marker));
        sum += sorted.back();
    }
    if (sorted.empty() || !(sum > 0.0)) return 0.0;
    std::sort(sorted.begin(), sorted.end());
    return sorted[(sorted.size() - 1) / 2] * static_cast<double>(sorted.size()) / sum;
}

// Mean of each series at all its entries.
Eigen::VectorXd means(const Eigen::VectorXd& r, const ResidualLayout& layout) {
    Eigen::VectorXd result(r.size());
    for (const ResidualSeries& series : layout.series)
        result.segment(series.begin, series.size())
            .setConstant(series.size() > 0 ? r.segment(series.begin, series.size()).mean() : 0.0);
    return result;
}

}  // namespace

IndependenceTest independence_test(const Eigen::VectorXd& r, const ResidualLayout& layout, int draws, unsigned seed) {
    assert(r.size() == layout.size() && draws > 1);
    IndependenceTest test;
    std::mt19937_64 random(seed);
    const Eigen::VectorXd constant = means(r, layout), varying = r - constant;
    std::vector<double> chances;
    for (const int trial : trials_of(layout))
        if (const std::optional<double> p = chance(gridded_trial(varying, layout, trial), layout, draws, random))
            chances.push_back(*p);
    if (!chances.empty())
        test.p = std::min(1.0, *std::min_element(chances.begin(), chances.end()) * static_cast<double>(chances.size()));
    test.typical_share = typical_share(r, layout);
    const double systematic = systematic_rms(r, layout).mean_square * static_cast<double>(r.size());
    if (systematic > 0.0) test.constant_share = constant.squaredNorm() / systematic;
    return test;
}

}  // namespace myo::statistics
