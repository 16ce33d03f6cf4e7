#include "statistics/residual_tests.hpp"

#include <cassert>
#include <cmath>

#include "statistics/autocorrelation.hpp"

namespace myo::statistics {

SystematicRms systematic_rms(const Eigen::VectorXd& r, const ResidualLayout& layout) {
    assert(r.size() == layout.size());
    SystematicRms result;
    const Autocovariance pooled = pooled_autocovariance(r, layout, 2);
    if (!(pooled.pairs(1) > 0.0 && pooled.pairs(2) > 0.0)) return result;
    // The parabola c(k) = a - b k^2 through k = 1 and 2 has a = (4 c1 - c2) / 3.
    result.mean_square = (4.0 * pooled.sums(1) / pooled.pairs(1) - pooled.sums(2) / pooled.pairs(2)) / 3.0;
    result.rms = std::sqrt(std::max(0.0, result.mean_square));
    // Variance of the estimate: products of white noise w contribute w^2 per pair; products of w with a smooth signal s
    // contribute 4 s^2 w^2 and are common to both lags.
    const double total = pooled.sums(0) / pooled.pairs(0);
    const double smooth = std::min(result.rms * result.rms, total);
    const double white = total - smooth;
    result.mean_square_deviation = std::sqrt((16.0 / pooled.pairs(1) + 1.0 / pooled.pairs(2)) / 9.0 * white * white +
                                             4.0 * smooth * white / pooled.pairs(0));
    // Delta method. It fails near zero, where the square root of the deviation of the square bounds the rms.
    if (result.mean_square_deviation > 0.0)
        result.deviation = result.mean_square_deviation /
                           (2.0 * std::max(result.rms, std::sqrt(result.mean_square_deviation)));
    return result;
}

ResidualTests test_residuals(const Eigen::VectorXd& r, const ResidualLayout& layout, int parameters,
                             const ResidualTestOptions& options) {
    assert(is_consistent(layout) && r.size() == layout.size());
    ResidualTests tests;
    tests.samples = r.size();
    tests.alpha = options.alpha;
    tests.threshold = options.alpha / 4.0;
    tests.variance = variance_test(r, parameters, options.noise_tolerance);
    tests.ljung_box = ljung_box_test(r, layout, options.lags, options.draws, options.seed);
    tests.periodicity = periodicity_test(r, layout);
    tests.space = space_test(r, layout, options.draws, options.seed);
    tests.systematic = systematic_rms(r, layout);
    return tests;
}

}  // namespace myo::statistics
