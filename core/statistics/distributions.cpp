#include "statistics/distributions.hpp"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/gamma.hpp>
#include <boost/math/distributions/non_central_chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <cassert>
#include <cmath>

namespace myo::statistics {
namespace {

using boost::math::cdf;
using boost::math::complement;
using boost::math::quantile;

struct DistributionsPolicy {
    double tiny = 1e-300;
    /// Deviations of a noncentral chi^2 from its mean beyond which its tail is 1 to rounding; the series converge
    /// slowly there.
    double surely = 40.0;
};
constexpr DistributionsPolicy distributions_policy;

// ln Gamma(a, z) by the Legendre continued fraction (modified Lentz algorithm), for z well above a.
// Source: Press et al. 2007, ch. 6.2.
double log_upper_gamma(double a, double z) {
    double b = z + 1.0 - a;
    double c = 1.0 / distributions_policy.tiny;
    double d = 1.0 / b;
    double fraction = d;
    for (int i = 1; i < 10'000; ++i) {
        const double numerator = -i * (i - a);
        b += 2.0;
        d = numerator * d + b;
        if (std::abs(d) < distributions_policy.tiny) d = distributions_policy.tiny;
        c = b + numerator / c;
        if (std::abs(c) < distributions_policy.tiny) c = distributions_policy.tiny;
        d = 1.0 / d;
        fraction *= d * c;
        if (std::abs(d * c - 1.0) < 1e-15) break;
    }
    return a * std::log(z) - z + std::log(fraction);
}

}  // namespace

double chi_squared_tail(double x, double freedom) {
    assert(freedom > 0.0);
    if (!(x > 0.0)) return 1.0;
    if (std::isinf(x)) return 0.0;
    return cdf(complement(boost::math::chi_squared(freedom), x));
}

double log_chi_squared_tail(double x, double freedom) {
    const double tail = chi_squared_tail(x, freedom);
    // Below 1e-280 the tail approaches the denormal range, where its logarithm is inaccurate.
    if (tail > 1e-280 || std::isinf(x)) return std::log(tail);
    return log_upper_gamma(0.5 * freedom, 0.5 * x) - std::lgamma(0.5 * freedom);
}

double chi_squared_upper_quantile(double tail, double freedom) {
    assert(freedom > 0.0 && tail > 0.0 && tail < 1.0);
    return quantile(complement(boost::math::chi_squared(freedom), tail));
}

double noncentral_chi_squared_tail(double x, double freedom, double noncentrality) {
    assert(freedom > 0.0 && noncentrality >= 0.0);
    if (!(x > 0.0)) return 1.0;
    if (!(noncentrality > 0.0)) return chi_squared_tail(x, freedom);
    const double mean = freedom + noncentrality, deviation = std::sqrt(2.0 * (freedom + 2.0 * noncentrality));
    if (std::isinf(noncentrality) || mean - x > distributions_policy.surely * deviation) return 1.0;
    return cdf(complement(boost::math::non_central_chi_squared(freedom, noncentrality), x));
}

double fisher_f_tail(double x, double above, double below) {
    assert(above > 0.0 && below > 0.0);
    if (!(x > 0.0)) return 1.0;
    if (std::isinf(x)) return 0.0;
    return cdf(complement(boost::math::fisher_f(above, below), x));
}

double student_two_sided(double t, double freedom) {
    assert(freedom > 0.0);
    if (std::isinf(t)) return 0.0;
    return 2.0 * cdf(complement(boost::math::students_t(freedom), std::abs(t)));
}

double normal_tail(double x) { return 0.5 * std::erfc(x / std::sqrt(2.0)); }

double normal_upper_quantile(double tail) {
    assert(tail > 0.0 && tail < 1.0);
    return quantile(complement(boost::math::normal(), tail));
}

double shifted_gamma_tail(double x, double mean, double deviation, double skewness) {
    assert(skewness > 0.0);
    if (!(deviation > 0.0)) return x > mean ? 0.0 : 1.0;
    const double shape = 4.0 / (skewness * skewness);  // shape of a gamma variable with this skewness, 2 / sqrt(shape)
    const double scaled = shape + std::sqrt(shape) * (x - mean) / deviation;
    if (!(scaled > 0.0)) return 1.0;
    return cdf(complement(boost::math::gamma_distribution<>(shape, 1.0), scaled));
}

}  // namespace myo::statistics
