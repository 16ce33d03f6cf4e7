#include "model/taking_in.hpp"

#include <algorithm>

namespace myo::model {
namespace {

/// How far a command must go back to count as a reversal.
struct TakingInPolicy {
    double min_reversal = 0.01;  // of the range of the command
};
constexpr TakingInPolicy taking_in_policy;

}  // namespace

TakingIn::TakingIn(const fibre::Signal& command) : times_s_(command.times_s), senses_{1.0} {
    const std::vector<double>& values = command.values;
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const double band = taking_in_policy.min_reversal * (*high - *low);
    // Hysteresis: the sense changes when the command has gone back by the band from its farthest value.
    double sense = 1.0, farthest = values.front();  // in the present sense
    for (std::size_t k = 0; k + 1 < values.size(); ++k) {
        const double next = values[k + 1];
        if (sense * (next - farthest) >= 0.0)
            farthest = next;
        else if (sense * (farthest - next) > band) {
            sense = -sense;
            farthest = next;
        }
        senses_.push_back(sense);
    }
    senses_.push_back(sense);
}

double TakingIn::at(double time_s, bool before) const {
    // Number of knots up to the time, which is the index of the sense that holds there.
    const auto passed = before ? std::lower_bound(times_s_.begin(), times_s_.end(), time_s)
                               : std::upper_bound(times_s_.begin(), times_s_.end(), time_s);
    return senses_[static_cast<std::size_t>(passed - times_s_.begin())];
}

std::vector<double> TakingIn::turns() const {
    std::vector<double> turns;
    for (std::size_t k = 0; k + 1 < senses_.size(); ++k)
        if (senses_[k + 1] != senses_[k]) turns.push_back(times_s_[k]);
    return turns;
}

}  // namespace myo::model
