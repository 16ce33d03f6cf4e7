#include "statistics/score_test.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/decompositions.hpp"
#include "statistics/autocorrelation.hpp"
#include "statistics/distributions.hpp"

namespace myo::statistics {
namespace {

// Mean over the basis of S~, because all directions enter the statistic with equal weight.
double mean_inflation(const ProjectedCandidate& candidate, const Eigen::VectorXd& r, const ResidualLayout& layout) {
    double sum = 0.0;
    for (Eigen::Index k = 0; k < candidate.rank(); ++k) sum += variance_inflation(r, candidate.basis.col(k), layout);
    return sum / static_cast<double>(candidate.rank());
}

// F-test p-value of the share explained by `rank` directions of n independent samples.
double share_tail(double share, double rank, double n) {
    const double below = std::max(1.0, n - rank);
    return fisher_f_tail(share / rank / ((1.0 - share) / below), rank, below);
}

}  // namespace

ProjectedCandidate project_candidate(const NuisanceSpace& nuisance, const Eigen::MatrixXd& S,
                                     double relative_tolerance) {
    assert(S.rows() == nuisance.rows());
    const Eigen::Index q = S.cols();
    ProjectedCandidate candidate;
    candidate.length = S.colwise().norm();
    candidate.kept.setZero(q);
    candidate.determined.assign(static_cast<std::size_t>(q), false);
    candidate.basis.resize(S.rows(), 0);
    candidate.to_step.resize(q, 0);
    if (q == 0 || S.rows() == 0) return candidate;

    // Columns scaled by |S_j|, so that one tolerance serves parameters of all units.
    const Eigen::VectorXd scale = (candidate.length.array() > 0.0).select(candidate.length, 1.0);
    const Eigen::MatrixXd rest = nuisance.outside(S * scale.cwiseInverse().asDiagonal());
    candidate.kept = rest.colwise().norm();
    // Column pivoting sorts the directions by independence; the first `rank` pivots are determined, the others get step
    // 0.
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(rest);
    Eigen::Index rank = 0;
    while (rank < std::min(q, S.rows()) && std::abs(qr.matrixQR()(rank, rank)) > relative_tolerance) ++rank;
    if (rank == 0) return candidate;

    // S~ = Q R on the pivoted columns, hence step = R^-1 Q' r in scaled units.
    candidate.basis = qr.householderQ() * Eigen::MatrixXd::Identity(S.rows(), rank);
    const Eigen::MatrixXd inverse = qr.matrixQR()
                                        .topLeftCorner(rank, rank)
                                        .triangularView<Eigen::Upper>()
                                        .solve(Eigen::MatrixXd::Identity(rank, rank));
    candidate.to_step.setZero(q, rank);
    for (Eigen::Index k = 0; k < rank; ++k) {
        const Eigen::Index j = qr.colsPermutation().indices()(k);
        candidate.to_step.row(j) = inverse.row(k) / scale(j);
        candidate.determined[static_cast<std::size_t>(j)] = true;
    }
    return candidate;
}

ScoreTest score_test(const ProjectedCandidate& candidate, const Eigen::VectorXd& r_outside,
                     const ResidualLayout& layout) {
    assert(r_outside.size() == layout.size() && candidate.basis.rows() == layout.size());
    ScoreTest test;
    test.step.setZero(candidate.parameters());
    test.deviation.setConstant(candidate.parameters(), std::numeric_limits<double>::infinity());
    test.effective_samples = static_cast<double>(r_outside.size());
    const double energy = r_outside.squaredNorm();
    if (candidate.rank() == 0 || !(energy > 0.0)) return test;

    const Eigen::VectorXd scores = candidate.basis.transpose() * r_outside;
    test.statistic = scores.squaredNorm();
    test.freedom = static_cast<int>(candidate.rank());
    test.p_white = chi_squared_tail(test.statistic, test.freedom);
    test.log_p_white = log_chi_squared_tail(test.statistic, test.freedom);
    test.explained = std::min(1.0, test.statistic / energy);
    const double inflation = mean_inflation(candidate, r_outside, layout);
    test.effective_samples /= inflation;
    test.p = share_tail(test.explained, test.freedom, test.effective_samples);
    test.step = candidate.to_step * scores;
    for (Eigen::Index j = 0; j < candidate.parameters(); ++j)
        if (candidate.determined[static_cast<std::size_t>(j)])
            test.deviation(j) = candidate.to_step.row(j).norm() * std::sqrt(inflation);
    return test;
}

double principal_cosine(const ProjectedCandidate& a, const ProjectedCandidate& b) {
    assert(a.basis.rows() == b.basis.rows());
    if (a.rank() == 0 || b.rank() == 0) return 0.0;
    const Eigen::MatrixXd product = a.basis.transpose() * b.basis;
    // The sign of a single basis vector relative to its tangent is that of to_step.
    if (a.parameters() == 1 && b.parameters() == 1)
        return std::clamp(product(0, 0) * (a.to_step(0, 0) * b.to_step(0, 0) < 0.0 ? -1.0 : 1.0), -1.0, 1.0);
    return std::min(1.0, std::sqrt(symmetric_eigenvalues(smaller_gram(product)).maxCoeff()));
}

Eigen::MatrixXd principal_cosines(const std::vector<ProjectedCandidate>& candidates) {
    const auto count = static_cast<Eigen::Index>(candidates.size());
    Eigen::MatrixXd cosines = Eigen::MatrixXd::Identity(count, count);
    for (Eigen::Index i = 0; i < count; ++i)
        for (Eigen::Index j = 0; j < i; ++j)
            cosines(i, j) = cosines(j, i) = principal_cosine(candidates[static_cast<std::size_t>(i)],
                                                             candidates[static_cast<std::size_t>(j)]);
    return cosines;
}

std::vector<double> holm_adjusted(const std::vector<double>& p) {
    std::vector<std::size_t> order(p.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });
    std::vector<double> adjusted(p.size());
    double largest = 0.0;
    for (std::size_t k = 0; k < order.size(); ++k) {
        // Step-down with enforced monotonicity: no adjusted p below that of a smaller p.
        largest = std::max(largest, std::min(1.0, p[order[k]] * static_cast<double>(p.size() - k)));
        adjusted[order[k]] = largest;
    }
    return adjusted;
}

}  // namespace myo::statistics
