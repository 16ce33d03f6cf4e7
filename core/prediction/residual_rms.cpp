#include <cmath>
#include <limits>

#include "prediction/prediction.hpp"

namespace myo::prediction {

using Eigen::Matrix3Xd;

double rms(const std::vector<Matrix3Xd>& residual_m) {
    double sum = 0.0;
    long count = 0;
    for (const Matrix3Xd& marker : residual_m)
        for (const double r : marker.reshaped())
            if (std::isfinite(r)) {
                sum += r * r;
                ++count;
            }
    return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : std::numeric_limits<double>::quiet_NaN();
}

double rms_between(const TrialPrediction& a, const TrialPrediction& b) {
    std::vector<Matrix3Xd> all;
    for (std::size_t m = 0; m < a.residual_m.size(); ++m) all.push_back(a.residual_m[m] - b.residual_m[m]);
    return rms(all);
}

}  // namespace myo::prediction
