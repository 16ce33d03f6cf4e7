#include "measurement/zeros.hpp"

#include <algorithm>
#include <limits>

#include "measurement/gaps.hpp"

namespace myo::measurement {

std::vector<Eigen::Index> find_zero_gaps(const Eigen::Matrix3Xd& track) {
    std::vector<Eigen::Index> zeros;
    double nearest_m = std::numeric_limits<double>::infinity(), largest_step_m = 0.0;
    const auto is_measured = [&](Eigen::Index t) { return is_seen(track, t) && !track.col(t).isZero(0.0); };
    for (Eigen::Index t = 0; t < track.cols(); ++t) {
        if (is_measured(t)) {
            nearest_m = std::min(nearest_m, track.col(t).norm());
            if (t > 0 && is_measured(t - 1))
                largest_step_m = std::max(largest_step_m, (track.col(t) - track.col(t - 1)).norm());
        } else if (is_seen(track, t)) {
            zeros.push_back(t);
        }
    }
    const bool passes_origin = nearest_m <= largest_step_m;
    return passes_origin || nearest_m == std::numeric_limits<double>::infinity() ? std::vector<Eigen::Index>{} : zeros;
}

}  // namespace myo::measurement
