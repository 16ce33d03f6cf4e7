#include "statistics/evidence.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace myo::statistics {
namespace {

struct EvidenceConstants {
    /// The cross entropy is convex in 1 / temperature: golden-section search.
    double golden = 0.6180339887498949;
};
constexpr EvidenceConstants evidence_constants;

// Mean negative log weight of the true model (cross entropy).
double surprise(const std::vector<JudgedComparison>& comparisons, double temperature) {
    double sum = 0.0;
    for (const JudgedComparison& comparison : comparisons) {
        assert(comparison.truth < comparison.criteria.size());
        // Computed from the criteria, because the weight may underflow to 0.
        const double best = *std::min_element(comparison.criteria.begin(), comparison.criteria.end());
        double total = 0.0;
        for (const double criterion : comparison.criteria) total += std::exp(-0.5 * (criterion - best) / temperature);
        sum += 0.5 * (comparison.criteria[comparison.truth] - best) / temperature + std::log(total);
    }
    return sum / static_cast<double>(comparisons.size());
}

}  // namespace

double information_criterion(double squared_norm, double samples, double effective_samples, int parameters) {
    assert(samples > 0.0 && effective_samples > 0.0);
    return effective_samples * std::log(squared_norm / samples) + parameters * std::log(effective_samples);
}

double information_criterion_known_noise(double squared_norm, double samples, double effective_samples,
                                         int parameters) {
    assert(samples > 0.0 && effective_samples > 0.0);
    return squared_norm * effective_samples / samples + parameters * std::log(effective_samples);
}

std::vector<double> evidence_weights(const std::vector<double>& criteria, double temperature) {
    assert(temperature > 0.0);
    double best = std::numeric_limits<double>::infinity();
    for (const double criterion : criteria)
        if (std::isfinite(criterion)) best = std::min(best, criterion);
    std::vector<double> weights(criteria.size(), 0.0);
    double total = 0.0;
    for (std::size_t k = 0; k < criteria.size(); ++k) {
        if (!std::isfinite(criteria[k])) continue;
        weights[k] = std::exp(-0.5 * (criteria[k] - best) / temperature);
        total += weights[k];
    }
    if (total > 0.0)
        for (double& weight : weights) weight /= total;
    return weights;
}

double calibrated_temperature(const std::vector<JudgedComparison>& comparisons) {
    if (comparisons.empty()) return 1.0;
    double low = 1.0 / 1000.0, high = 1.0 / 0.05;  // bounds of 1 / temperature
    double left = high - evidence_constants.golden * (high - low),
           right = low + evidence_constants.golden * (high - low);
    double at_left = surprise(comparisons, 1.0 / left), at_right = surprise(comparisons, 1.0 / right);
    while (high - low > 1e-6 * high) {
        if (at_left < at_right) {
            high = right;
            right = left;
            at_right = at_left;
            left = high - evidence_constants.golden * (high - low);
            at_left = surprise(comparisons, 1.0 / left);
        } else {
            low = left;
            left = right;
            at_left = at_right;
            right = low + evidence_constants.golden * (high - low);
            at_right = surprise(comparisons, 1.0 / right);
        }
    }
    return 2.0 / (low + high);
}

}  // namespace myo::statistics
