#include "validation/proportion.hpp"

#include <boost/math/distributions/binomial.hpp>

#include <cstdio>
#include <limits>

namespace myo::validation {
namespace {

using boost::math::binomial_distribution;

/// Count and share with one bound in percent.
std::string words(const Proportion& p, const char* bound, double value) {
    if (p.of == 0) return "none of none";
    char text[96];
    std::snprintf(text, sizeof text, "%d of %d, %.1f %% (at %s %.1f %%)", p.count, p.of, 100.0 * p.share(), bound,
                  100.0 * value);
    return text;
}

}  // namespace

double Proportion::share() const {
    return of > 0 ? static_cast<double>(count) / of : std::numeric_limits<double>::quiet_NaN();
}

double Proportion::upper(double confidence) const {
    return of == 0 || count == of ? 1.0 : binomial_distribution<>::find_upper_bound_on_p(of, count, 1.0 - confidence);
}

double Proportion::lower(double confidence) const {
    return of == 0 || count == 0 ? 0.0 : binomial_distribution<>::find_lower_bound_on_p(of, count, 1.0 - confidence);
}

std::string at_least_words(const Proportion& p) { return words(p, "least", p.lower()); }
std::string at_most_words(const Proportion& p) { return words(p, "most", p.upper()); }

report::Json proportion_json(const Proportion& p) {
    return {{"count", p.count},
            {"of", p.of},
            {"share", report::json_number(p.share())},
            {"lower_95", report::json_number(p.lower())},
            {"upper_95", report::json_number(p.upper())}};
}

}  // namespace myo::validation
