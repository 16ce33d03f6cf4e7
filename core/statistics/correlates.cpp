#include "statistics/correlates.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "statistics/autocorrelation.hpp"
#include "statistics/distributions.hpp"

namespace myo::statistics {
namespace {

// Removes the mean over the known samples. The remainder of a constant is rounding and is set to zero.
GriddedSeries centred(GriddedSeries series) {
    const double before = series.values.norm();
    series.values -= series.seen * (series.values.sum() / std::max(1.0, series.seen.sum()));
    if (series.values.norm() <= 1e-12 * before) series.values.setZero();
    return series;
}

Correlate correlate(const Eigen::VectorXd& amplitude, const Regressor& regressor) {
    assert(regressor.values.size() == amplitude.size());
    Correlate result;
    result.name = regressor.name;
    GriddedSeries a = gridded(amplitude), b = gridded(regressor.values);
    // Samples known to both only.
    a.seen = b.seen = a.seen.cwiseProduct(b.seen);
    a.values = a.values.cwiseProduct(a.seen);
    b.values = b.values.cwiseProduct(b.seen);
    a = centred(a);
    b = centred(b);
    result.effective_samples = a.seen.sum();
    const double lengths = a.values.norm() * b.values.norm();
    if (!(lengths > 0.0)) return result;
    result.correlation = std::clamp(a.values.dot(b.values) / lengths, -1.0, 1.0);
    result.effective_samples /= variance_inflation(a, b);
    // Two degrees of freedom are used by the mean and the slope.
    const double freedom = std::max(1.0, result.effective_samples - 2.0);
    const double rest = 1.0 - result.correlation * result.correlation;
    result.p = rest > 0.0 ? student_two_sided(result.correlation * std::sqrt(freedom / rest), freedom) : 0.0;
    return result;
}

}  // namespace

std::vector<Correlate> correlates(const Eigen::VectorXd& amplitude, const std::vector<Regressor>& regressors) {
    std::vector<Correlate> result;
    for (const Regressor& regressor : regressors) result.push_back(correlate(amplitude, regressor));
    std::stable_sort(result.begin(), result.end(), [](const Correlate& a, const Correlate& b) {
        return std::abs(a.correlation) > std::abs(b.correlation);
    });
    return result;
}

}  // namespace myo::statistics
