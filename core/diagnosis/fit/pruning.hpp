#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

namespace myo::diagnosis {

/// What decides whether a candidate fit continues.
struct OpenFit {
    double squares = 0.0;              // squared residual; infinite if the fit is not usable
    double predicted_reduction = 0.0;  // predicted share of the squared residual that the effect removes
    bool open = false;                 // unfinished and not continued yet
};

/// Limits of the continuation of candidate fits.
struct PruningInput {
    std::vector<OpenFit> fits;
    double least_so_far = 0.0;          // smallest squared residual of the candidates fitted before
    double samples = 0.0;               // expected squared residual of noise alone
    double pruning_factor = 1.0;        // of the smallest squared residual, above which a fit ends
    double comparable_reduction = 0.9;  // see CandidateFitPolicy
    double promising_squares = 0.0;     // an unfinished fit below is promising; see fits_worth_continuing()
    double noise_like = 0.0;            // see CandidateFitPolicy
    /// Squared residual above which a fit has made no progress.
    double stuck_squares = std::numeric_limits<double>::infinity();
};

/// Indices of the open fits that may still become the best, ascending.
///
/// A fit continues if its squared residual is below pruning_factor times the smallest, or if `predicted_squares`, its
/// squared residual after the best step, is. The limit is higher, at most by pruning_factor squared, while the smallest
/// is far above the noise: the fit that leaves it may be the wrong effect. It is at least pruning_factor squared for
/// fits whose predicted reduction is comparable to that of the best fit. Such a fit that is promising continues
/// whatever its squares, unless the smallest is like noise: with derivatives of the base it is far from where its own
/// would lead. No higher limit holds for fits without progress.
/// @param predicted_squares  called for the fits above their limit only: it costs a bounded step
std::vector<std::size_t> fits_worth_continuing(const PruningInput& in,
                                               const std::function<double(std::size_t)>& predicted_squares);

}  // namespace myo::diagnosis
