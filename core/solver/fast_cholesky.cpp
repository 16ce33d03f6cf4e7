#include "solver/fast_cholesky.hpp"

#include <algorithm>
#include <cassert>

namespace myo::solver {

bool FastCholesky::knows_pattern(const SymmetricSparse& lower) const {
    return !starts_.empty() &&
           std::equal(starts_.begin(), starts_.end(), lower.outerIndexPtr(),
                      lower.outerIndexPtr() + lower.cols() + 1) &&
           std::equal(rows_.begin(), rows_.end(), lower.innerIndexPtr(), lower.innerIndexPtr() + lower.nonZeros());
}

void FastCholesky::analyse(const SymmetricSparse& lower) {
    assert(lower.isCompressed() && lower.rows() == lower.cols());
    if (knows_pattern(lower)) return;
    starts_.assign(lower.outerIndexPtr(), lower.outerIndexPtr() + lower.cols() + 1);
    rows_.assign(lower.innerIndexPtr(), lower.innerIndexPtr() + lower.nonZeros());
    pattern_ = analyse_pattern(lower);
    if (pattern_.size() != lower.rows()) starts_.clear();  // without a result, the next call tries again
    flops_ = myo::solver::factor_flops(pattern_);
    factor_ = {};
}

bool FastCholesky::factorize(const SymmetricSparse& lower) {
    analyse(lower);
    if (pattern_.size() != lower.rows()) return false;  // the analysis ran out of memory
    if (myo::solver::factorize(pattern_, lower, factor_)) return true;
    // A matrix whose smallest scaled pivots are below single-precision rounding: repeat in double and round the factor.
    SupernodalFactor<double> exact;
    if (!myo::solver::factorize(pattern_, lower, exact)) return false;
    factor_.values.resize(exact.values.size());
    std::transform(exact.values.begin(), exact.values.end(), factor_.values.begin(),
                   [](double value) { return static_cast<float>(value); });
    factor_.scale = std::move(exact.scale);
    return true;
}

}  // namespace myo::solver
