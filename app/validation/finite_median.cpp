#include "validation/finite_median.hpp"

#include <Eigen/Core>

#include <cmath>
#include <limits>

#include "measurement/robust.hpp"

namespace myo::validation {

double finite_median(std::vector<double> values) {
    std::erase_if(values, [](double value) { return !std::isfinite(value); });
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    return measurement::median(Eigen::VectorXd::Map(values.data(), static_cast<Eigen::Index>(values.size())));
}

}  // namespace myo::validation
