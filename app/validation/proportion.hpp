#pragma once

#include <string>

#include "report/json.hpp"

namespace myo::validation {

/// A share that was counted, with what the count says of the true one.
struct Proportion {
    int count = 0, of = 0;

    void add(bool hit) {
        ++of;
        count += hit ? 1 : 0;
    }
    double share() const;  // NaN of none
    /// One-sided bounds of the true share at this confidence; 0 and 1 of none.
    /// Source: Clopper & Pearson 1934, Biometrika 26, 404.
    double upper(double confidence = 0.95) const;
    double lower(double confidence = 0.95) const;
};

/// "47 of 50, 94 % (at least 85 %)", with the lower bound or the upper one.
std::string at_least_words(const Proportion& p);
std::string at_most_words(const Proportion& p);
/// Count, share and both bounds.
report::Json proportion_json(const Proportion& p);

}  // namespace myo::validation
