#include "diagnosis/fit/pruning.hpp"

#include <algorithm>

namespace myo::diagnosis {

std::vector<std::size_t> fits_worth_continuing(const PruningInput& in,
                                               const std::function<double(std::size_t)>& predicted_squares) {
    double least = in.least_so_far, reduction_of_best = 1.0;
    for (const OpenFit& fit : in.fits)
        if (fit.squares < least) {
            least = fit.squares;
            reduction_of_best = fit.predicted_reduction;
        }
    // least / samples is 1 for a fit that leaves noise only. The farther the best is from that, the less it proves.
    const double factor = in.pruning_factor, squared = factor * factor;
    const double limit = factor * std::clamp(least / in.samples, 1.0, squared);
    std::vector<std::size_t> next;
    for (std::size_t i = 0; i < in.fits.size(); ++i) {
        const OpenFit& fit = in.fits[i];
        if (!fit.open) continue;
        // Scores within a few percent do not rank effects: these fits get the highest limit.
        const bool comparable = fit.predicted_reduction > in.comparable_reduction * reduction_of_best;
        const bool promising = comparable && fit.squares < in.promising_squares && least > in.noise_like * in.samples;
        const double raised = fit.squares > in.stuck_squares ? factor : comparable ? std::max(squared, limit) : limit;
        if (promising || fit.squares < raised * least || predicted_squares(i) < factor * least) next.push_back(i);
    }
    return next;
}

}  // namespace myo::diagnosis
