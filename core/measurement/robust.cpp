#include "measurement/robust.hpp"

#include <algorithm>
#include <cassert>

namespace myo::measurement {

double median(Eigen::VectorXd values) {
    assert(values.size() > 0);
    const auto middle = values.begin() + values.size() / 2;
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) return *middle;
    // After nth_element the lower of the two middle values is the largest of the front part.
    return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

double median_deviation(const Eigen::VectorXd& values, double centre) {
    return 1.4826 * median((values.array() - centre).abs());
}

}  // namespace myo::measurement
