#pragma once

#include <string>

#include "report/json.hpp"

namespace myo::validation {

/// A counted share with confidence bounds of the true one.
struct Proportion {
    int count = 0, of = 0;

    void add(bool hit) {
        ++of;
        count += hit ? 1 : 0;
    }
    double share() const;  // NaN for an empty sample
    /// One-sided bounds of the true share at this confidence; 0 and 1 for an empty sample.
    /// Source: Clopper & Pearson 1934, Biometrika 26, 404.
    double upper(double confidence = 0.95) const;
    double lower(double confidence = 0.95) const;
};

/// "47 of 50, 94 % (at least 85 %)", with the lower or the upper bound.
std::string at_least_words(const Proportion& p);
std::string at_most_words(const Proportion& p);
/// Count, share and both bounds as JSON.
report::Json proportion_json(const Proportion& p);

}  // namespace myo::validation
