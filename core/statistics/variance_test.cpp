#include <algorithm>
#include <cassert>

#include "statistics/distributions.hpp"
#include "statistics/residual_tests.hpp"

namespace myo::statistics {

VarianceTest variance_test(const Eigen::VectorXd& r, int parameters, double tolerance) {
    assert(parameters >= 0 && tolerance >= 0.0);
    VarianceTest test;
    test.freedom = static_cast<double>(std::max<Eigen::Index>(r.size() - parameters, 0));
    if (!(test.freedom > 0.0)) return test;
    test.ratio = r.squaredNorm() / test.freedom;
    // Smallest p over the accepted noise levels, attained at (1 + tolerance).
    test.p = chi_squared_tail(r.squaredNorm() / ((1.0 + tolerance) * (1.0 + tolerance)), test.freedom);
    return test;
}

}  // namespace myo::statistics
