#include "statistics/linear_cross_validation.hpp"

#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/decompositions.hpp"

namespace myo::statistics {
namespace {

struct LinearCrossValidationPolicy {
    /// On squares of the directions of J, with unit diagonal: 1e-6 of the length of a direction.
    double relative_tolerance = 1e-12;
    /// Smallest information of the remaining folds, relative to all data. Derivatives are not exact, and a step of many
    /// standard deviations leaves the linear range.
    double min_information = 1e-3;
};
constexpr LinearCrossValidationPolicy linear_cross_validation_policy;

/// Gauss-Newton normal equations J'J d = J'r of a subset of the data.
struct NormalEquations {
    Eigen::MatrixXd matrix;  // J'J
    Eigen::VectorXd right;   // J'r
};

// Columns: directions determined by all data, scaled to unit information (whitening). Eigenvalues of a subset in this
// basis are shares of the total information.
Eigen::MatrixXd unit_directions(const Eigen::MatrixXd& matrix) {
    const Eigen::VectorXd diagonal = matrix.diagonal();
    const Eigen::VectorXd scale = (diagonal.array() > 0.0).select(diagonal.cwiseSqrt().cwiseInverse(), 0.0);
    const SymmetricEigen eigen = symmetric_eigen(scale.asDiagonal() * matrix * scale.asDiagonal());
    const Eigen::VectorXd& values = eigen.values;
    const Eigen::Index p = values.size();
    const Eigen::Index free = (values.array() <= linear_cross_validation_policy.relative_tolerance * values(p - 1))
                                  .count();
    const Eigen::Index known = p - free;
    return scale.asDiagonal() * eigen.vectors.rightCols(known) *
           values.tail(known).cwiseSqrt().cwiseInverse().asDiagonal();
}

/// Solution of the normal equations.
struct Step {
    Eigen::VectorXd change;  // p
    int undetermined = 0;    // directions left at zero
};

// Least squares in the whitened basis. Directions with less than min_information are not changed.
Step solved(const NormalEquations& equations, const Eigen::MatrixXd& directions) {
    const Eigen::Index p = equations.right.size(), known = directions.cols();
    Step step{Eigen::VectorXd::Zero(p), static_cast<int>(p - known)};
    if (known == 0) return step;
    const SymmetricEigen eigen = symmetric_eigen(directions.transpose() * equations.matrix * directions);
    for (Eigen::Index k = 0; k < known; ++k) {
        if (eigen.values(k) < linear_cross_validation_policy.min_information) {
            ++step.undetermined;
            continue;
        }
        const Eigen::VectorXd direction = directions * eigen.vectors.col(k);
        step.change += direction * (direction.dot(equations.right) / eigen.values(k));
    }
    return step;
}

// Entries of each fold.
std::vector<std::vector<Eigen::Index>> entries_of(const Folds& folds) {
    std::vector<std::vector<Eigen::Index>> entries(static_cast<std::size_t>(folds.count));
    for (std::size_t k = 0; k < folds.of_entry.size(); ++k)
        if (folds.of_entry[k] >= 0)
            entries[static_cast<std::size_t>(folds.of_entry[k])].push_back(static_cast<Eigen::Index>(k));
    return entries;
}

}  // namespace

int LinearCrossValidation::undetermined() const {
    return std::accumulate(folds.begin(), folds.end(), 0,
                           [](int sum, const Fold& fold) { return sum + fold.undetermined; });
}

LinearCrossValidation linear_cross_validation(const Eigen::VectorXd& r, const Eigen::MatrixXd& J, const Folds& folds) {
    assert(J.rows() == r.size() && folds.of_entry.size() == static_cast<std::size_t>(r.size()));
    const Eigen::Index p = J.cols();
    const std::vector<std::vector<Eigen::Index>> entries = entries_of(folds);
    const NormalEquations nothing{Eigen::MatrixXd::Zero(p, p), Eigen::VectorXd::Zero(p)};
    std::vector<NormalEquations> parts;
    NormalEquations all = nothing;
    for (const std::vector<Eigen::Index>& fold : entries) {
        const Eigen::MatrixXd own = J(fold, Eigen::all);
        parts.push_back({own.transpose() * own, own.transpose() * r(fold)});
        all.matrix += parts.back().matrix;
    }
    const Eigen::MatrixXd directions = p > 0 ? unit_directions(all.matrix) : Eigen::MatrixXd(0, 0);
    LinearCrossValidation result;
    result.residual.setConstant(r.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t f = 0; f < entries.size(); ++f) {
        // Summed from the other parts instead of subtracted from the total: cancellation would leave rounding in
        // directions that only this fold determines.
        NormalEquations others = nothing;
        for (std::size_t g = 0; g < parts.size(); ++g) {
            if (g == f) continue;
            others.matrix += parts[g].matrix;
            others.right += parts[g].right;
        }
        LinearCrossValidation::Fold fold;
        const Step step = solved(others, directions);
        fold.change = step.change;
        fold.undetermined = step.undetermined;
        for (const Eigen::Index k : entries[f]) {
            result.residual(k) = r(k) - J.row(k).dot(fold.change);
            fold.squares += result.residual(k) * result.residual(k);
        }
        fold.samples = static_cast<Eigen::Index>(entries[f].size());
        result.squares += fold.squares;
        result.samples += fold.samples;
        result.folds.push_back(std::move(fold));
    }
    return result;
}

}  // namespace myo::statistics
