#include "diagnosis/discretisation/longer_steps.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <string>

#include "base/text.hpp"
#include "prediction/predict_trials.hpp"

namespace myo::diagnosis {

LongerSteps longer_steps(const setup::Setup& setup, const prediction::ParameterValues& values, double max_m,
                         const Progress& progress) {
    LongerSteps found;
    found.factors.assign(setup.trials.size(), 1.0);
    std::vector<std::size_t> open(setup.trials.size());
    std::iota(open.begin(), open.end(), std::size_t{0});
    std::erase_if(open, [&](std::size_t t) { return setup.trials[t].hold; });  // a pose has no steps
    if (open.empty()) return found;
    setup::Setup longer = setup;
    for (setup::PreparedTrial& trial : longer.trials) trial.options.keep_path = false;  // no run starts from these
    std::vector<prediction::TrialPrediction> fine(setup.trials.size());
    {
        std::vector<prediction::TrialPrediction> runs = prediction::predict_trials_with(longer, values, open, progress);
        for (std::size_t i = 0; i < open.size(); ++i) fine[open[i]] = std::move(runs[i]);
    }
    found.runs = static_cast<int>(open.size());
    for (;;) {
        // A step longer than the sampling interval would interpolate the recording's own motion.
        std::erase_if(open, [&](std::size_t t) {
            const double longest_s = (1.0 + 1e-9) * setup::sampling_interval_s(setup.trials[t]);
            return !fine[t].ok() || 2.0 * longer.trials[t].options.h_s > longest_s;
        });
        if (open.empty() || progress.cancelled()) return found;
        // Doubled steps are compared with those of the setup, not with the previous ones: errors must not add up.
        for (const std::size_t t : open) longer.trials[t].options.h_s *= 2.0;
        const std::vector<prediction::TrialPrediction> coarse = prediction::predict_trials_with(longer, values, open,
                                                                                                progress);
        found.runs += static_cast<int>(open.size());
        std::vector<std::size_t> serve;
        for (std::size_t i = 0; i < open.size(); ++i) {
            const std::size_t t = open[i];
            if (coarse[i].ok() && prediction::rms_between(coarse[i], fine[t]) <= max_m) {
                found.factors[t] *= 2.0;
                serve.push_back(t);
            }
        }
        open = std::move(serve);
    }
}

bool any_longer(const std::vector<double>& factors) {
    return std::any_of(factors.begin(), factors.end(), [](double factor) { return factor > 1.0; });
}

std::string steps_in_words(const setup::Setup& setup, const std::vector<double>& factors) {
    double shortest_s = std::numeric_limits<double>::infinity(), longest_s = 0.0;
    for (std::size_t t = 0; t < setup.trials.size(); ++t) {
        const double h_s = setup.trials[t].options.h_s * (factors.empty() ? 1.0 : factors[t]);
        shortest_s = std::min(shortest_s, h_s);
        longest_s = std::max(longest_s, h_s);
    }
    const std::string least = format_number(1e3 * shortest_s, 4), most = format_number(1e3 * longest_s, 4);
    return (least == most ? least : least + " to " + most) + " ms";
}

}  // namespace myo::diagnosis
