#include "measurement/excursions.hpp"

#include <algorithm>
#include <cassert>

#include "measurement/gaps.hpp"

namespace myo::measurement {
namespace {

using Eigen::Index;
using Eigen::Vector3d;

struct ExcursionsPolicy {
    /// Thresholds of the header; min_opposition is the least cosine between opposite jumps.
    double min_deviations = 20.0;
    double min_ratio = 6.0;
    double min_opposition = 0.5;
    double max_inequality = 2.0;
    std::size_t shortest = 4;
    /// Intervals on each side that measure the usual jumps of a track, and how many of them must be known.
    std::size_t nearby = 6;
    std::size_t min_nearby = 4;
    /// Intervals beside a jump whose velocities are affected by it.
    std::size_t touched = 1;
    /// Other markers that must be visible at a jump.
    std::size_t min_others = 2;
    /// Missing samples among the four of an interval: over a longer gap the velocities are not meaningful.
    Index max_missing = 3;
};
constexpr ExcursionsPolicy excursions_policy;

/// Interval between consecutive visible samples of a track.
struct Step {
    Index before = 0, after = 0;       // samples
    bool known = false;                // whether `jump` could be computed
    Vector3d jump = Vector3d::Zero();  // displacement minus that of the mean neighbouring velocity [m]
};

std::vector<Step> steps_of(const Eigen::Matrix3Xd& track, const Eigen::VectorXd& time_s) {
    std::vector<Index> seen;
    for (Index t = 0; t < track.cols(); ++t)
        if (is_seen(track, t)) seen.push_back(t);
    const auto velocity = [&](std::size_t i) -> Vector3d {
        return (track.col(seen[i + 1]) - track.col(seen[i])) / (time_s(seen[i + 1]) - time_s(seen[i]));
    };
    std::vector<Step> steps;
    for (std::size_t i = 0; i + 1 < seen.size(); ++i) {
        Step step{seen[i], seen[i + 1]};
        step.known = i >= 1 && i + 2 < seen.size() && seen[i + 2] - seen[i - 1] <= 3 + excursions_policy.max_missing;
        if (step.known)
            step.jump = track.col(step.after) - track.col(step.before) -
                        0.5 * (time_s(step.after) - time_s(step.before)) * (velocity(i - 1) + velocity(i + 1));
        steps.push_back(step);
    }
    return steps;
}

/// Whether interval i shares velocities with interval j.
bool is_beside(std::size_t i, std::size_t j) { return (i > j ? i - j : j - i) <= excursions_policy.touched; }

/// Whether the jump at `place` is much larger than those nearby, excluding the other end of the excursion.
bool stands_out(const std::vector<Step>& steps, std::size_t place, std::size_t other_end) {
    double largest = 0.0;
    std::size_t told = 0;
    for (std::size_t i = place - std::min(place, excursions_policy.nearby);
         i < std::min(place + excursions_policy.nearby + 1, steps.size()); ++i) {
        if (!steps[i].known || is_beside(i, place) || is_beside(i, other_end)) continue;
        largest = std::max(largest, steps[i].jump.norm());
        ++told;
    }
    return told >= excursions_policy.min_nearby && steps[place].jump.norm() > excursions_policy.min_ratio * largest;
}

/// Whether no other marker jumps at the same time, with enough markers visible.
bool is_alone(const std::vector<std::vector<Step>>& steps, std::size_t marker, const Step& own) {
    std::size_t told = 0;
    for (std::size_t m = 0; m < steps.size(); ++m) {
        if (m == marker) continue;
        for (const Step& step : steps[m]) {
            if (!step.known || step.after <= own.before || step.before >= own.after) continue;
            if (excursions_policy.min_ratio * step.jump.norm() > own.jump.norm()) return false;
            ++told;
            break;
        }
    }
    return told >= excursions_policy.min_others;
}

/// Whether two jumps are opposite and of similar length.
bool are_there_and_back(const Step& away, const Step& back) {
    const double there = away.jump.norm(), here = back.jump.norm();
    return away.jump.dot(back.jump) < -excursions_policy.min_opposition * there * here &&
           std::max(there, here) < excursions_policy.max_inequality * std::min(there, here);
}

/// Steps of marker m that are far above its noise while no other marker jumps.
std::vector<std::size_t> lone_jumps(const std::vector<std::vector<Step>>& steps, std::size_t m, double sigma_m) {
    const std::vector<Step>& own = steps[m];
    std::vector<std::size_t> jumps;
    for (std::size_t i = 0; i < own.size(); ++i)
        if (own[i].known && own[i].jump.norm() > excursions_policy.min_deviations * sigma_m &&
            is_alone(steps, m, own[i]))
            jumps.push_back(i);
    return jumps;
}

}  // namespace

std::vector<Excursion> find_excursions(const std::vector<Eigen::Matrix3Xd>& tracks, const Eigen::VectorXd& time_s,
                                       const Eigen::VectorXd& sigma_m) {
    assert(sigma_m.size() == static_cast<Index>(tracks.size()));
    std::vector<std::vector<Step>> steps;
    for (const Eigen::Matrix3Xd& track : tracks) steps.push_back(steps_of(track, time_s));
    std::vector<Excursion> excursions;
    for (std::size_t m = 0; m < tracks.size(); ++m) {
        const std::vector<Step>& own = steps[m];
        const std::vector<std::size_t> jumps = lone_jumps(steps, m, sigma_m(static_cast<Index>(m)));
        // Shortest first, so that a marker that slips between two excursions does not pair with either of them.
        for (std::size_t length = excursions_policy.shortest; 2 * length <= own.size(); ++length)
            for (const std::size_t away : jumps) {
                const std::size_t back = away + length;
                if (!std::binary_search(jumps.begin(), jumps.end(), back) || !are_there_and_back(own[away], own[back]))
                    continue;
                if (!stands_out(own, away, back) || !stands_out(own, back, away)) continue;
                // The excursion begins with the sample after the first jump and ends before the sample after the
                // second.
                const Excursion found{m, own[away].after, own[back].before + 1,
                                      std::max(own[away].jump.norm(), own[back].jump.norm())};
                // Excursions of one marker must not overlap.
                const bool apart = std::all_of(excursions.begin(), excursions.end(), [&](const Excursion& e) {
                    return e.marker != m || e.end <= found.first || found.end <= e.first;
                });
                if (apart) excursions.push_back(found);
            }
    }
    std::sort(excursions.begin(), excursions.end(),
              [](const Excursion& a, const Excursion& b) { return a.first < b.first; });
    return excursions;
}

}  // namespace myo::measurement
