#include "diagnosis/linear_cross_validation.hpp"

#include <Eigen/Eigenvalues>

#include <cassert>
#include <cmath>
#include <limits>

namespace myo {
namespace {

// Of the normal equations with unit diagonal: squares of directions of J, so 1e-6 of its length.
constexpr double relative_tolerance = 1e-12;

struct NormalEquations {
    Eigen::MatrixXd matrix;   // J'J
    Eigen::VectorXd right;    // J'r
};

struct Step {
    Eigen::VectorXd change;
    int undetermined = 0;
};

// Least squares by the eigenvectors of the scaled matrix; directions that it does not determine stay.
Step solved(const NormalEquations& equations) {
    const Eigen::Index p = equations.right.size();
    const Eigen::VectorXd diagonal = equations.matrix.diagonal();
    const Eigen::VectorXd scale = (diagonal.array() > 0.0).select(diagonal.cwiseSqrt().cwiseInverse(), 0.0);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scale.asDiagonal() * equations.matrix * scale.asDiagonal());
    Step step{Eigen::VectorXd::Zero(p), 0};
    for (Eigen::Index k = 0; k < p; ++k) {
        if (eigen.eigenvalues()(k) <= relative_tolerance * eigen.eigenvalues()(p - 1)) {
            ++step.undetermined;
            continue;
        }
        const Eigen::VectorXd direction = scale.asDiagonal() * eigen.eigenvectors().col(k);
        step.change += direction * (direction.dot(equations.right) / eigen.eigenvalues()(k));
    }
    return step;
}

NormalEquations of_prior(const ParameterPrior& prior, Eigen::Index p) {
    NormalEquations equations{Eigen::MatrixXd::Zero(p, p), Eigen::VectorXd::Zero(p)};
    if (prior.precision.size() == 0) return equations;
    assert(prior.precision.size() == p && (prior.offset.size() == 0 || prior.offset.size() == p));
    equations.matrix.diagonal() = prior.precision;
    if (prior.offset.size() == p) equations.right = prior.precision.cwiseProduct(prior.offset);
    return equations;
}

std::vector<std::vector<Eigen::Index>> entries_of(const Folds& folds) {
    std::vector<std::vector<Eigen::Index>> entries(static_cast<std::size_t>(folds.count));
    for (std::size_t k = 0; k < folds.of_entry.size(); ++k)
        if (folds.of_entry[k] >= 0) entries[static_cast<std::size_t>(folds.of_entry[k])].push_back(static_cast<Eigen::Index>(k));
    return entries;
}

}  // namespace

LinearCrossValidation linear_cross_validation(const Eigen::VectorXd& r, const Eigen::MatrixXd& J, const Folds& folds,
                                              const ParameterPrior& prior) {
    assert(J.rows() == r.size() && folds.of_entry.size() == static_cast<std::size_t>(r.size()));
    const std::vector<std::vector<Eigen::Index>> entries = entries_of(folds);
    std::vector<NormalEquations> parts;
    for (const std::vector<Eigen::Index>& fold : entries) {
        const Eigen::MatrixXd own = J(fold, Eigen::all);
        parts.push_back({own.transpose() * own, own.transpose() * r(fold)});
    }
    LinearCrossValidation result;
    result.residual.setConstant(r.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t f = 0; f < entries.size(); ++f) {
        // Summed anew rather than subtracted from all: what only this fold determines leaves no rounding behind.
        NormalEquations others = of_prior(prior, J.cols());
        for (std::size_t g = 0; g < parts.size(); ++g) {
            if (g == f) continue;
            others.matrix += parts[g].matrix;
            others.right += parts[g].right;
        }
        LinearCrossValidation::Fold fold;
        const Step step = J.cols() > 0 ? solved(others) : Step{Eigen::VectorXd(0), 0};
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

}  // namespace myo
