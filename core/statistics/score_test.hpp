#pragma once

#include <Eigen/Core>

#include <vector>

#include "statistics/nuisance_space.hpp"
#include "statistics/residual_layout.hpp"

namespace myo::statistics {

/// The part of a candidate's tangents that recalibration cannot absorb, S~ = (I - J J^+) S, as an orthonormal basis.
struct ProjectedCandidate {
    Eigen::MatrixXd basis;         // N x rank
    Eigen::MatrixXd to_step;       // q x rank: step of the parameters = to_step * basis' r
    Eigen::VectorXd length;        // q: |S_j|
    Eigen::VectorXd kept;          // q: |S~_j| / |S_j|; 0: recalibration absorbs it all, or it does nothing
    std::vector<bool> determined;  // q: false where S~_j adds no direction to the others; its step is 0 then

    Eigen::Index rank() const { return basis.cols(); }
    Eigen::Index parameters() const { return kept.size(); }
};

/// @param S                   N x q, derivatives of the prediction over sigma at "absent"
/// @param relative_tolerance  of |S_j|: shorter remainders are rounding
ProjectedCandidate project_candidate(const NuisanceSpace& nuisance, const Eigen::MatrixXd& S,
                                     double relative_tolerance = 1e-6);

/// Lagrange multiplier (score) test of a candidate before it is fitted.
struct ScoreTest {
    double statistic = 0.0;          // |P r~|^2, P onto S~: chi^2 with `freedom` for white noise of variance 1
    int freedom = 0;                 // rank of S~; 0: the candidate does nothing here, and p is 1
    double p_white = 1.0;            // of the statistic
    double log_p_white = 0.0;        // natural logarithm, for ranking beyond the smallest number
    double explained = 0.0;          // R^2 = statistic / |r~|^2
    double effective_samples = 0.0;  // N over Bartlett's variance inflation of r~ and S~
    double p = 1.0;                  // of R^2 with so many independent samples (F); free of the noise's size
    Eigen::VectorXd step;            // q: parameters that minimise |r~ - S~ step|
    Eigen::VectorXd deviation;  // q: standard deviations of the step, with the inflation; infinite where not determined
};

/// @param r_outside  r~ = nuisance.outside(r)
/// Source: Rao 1948, Proc. Camb. Phil. Soc. 44, 50; effective samples: Bartlett 1935 (see variance_inflation).
ScoreTest score_test(const ProjectedCandidate& candidate, const Eigen::VectorXd& r_outside,
                     const ResidualLayout& layout);

/// Largest canonical correlation of two candidates' S~: 1 cannot be told apart, 0 do not interfere. With one direction
/// each, their cosine with its sign. 0 where one of them has no direction.
double principal_cosine(const ProjectedCandidate& a, const ProjectedCandidate& b);

/// All pairs; the diagonal is 1.
Eigen::MatrixXd principal_cosines(const std::vector<ProjectedCandidate>& candidates);

/// Holm's p-values: those below alpha keep the chance of any false one below alpha, however the tests depend on each
/// other. Order as given. Source: Holm 1979, Scand. J. Statistics 6, 65.
std::vector<double> holm_adjusted(const std::vector<double>& p);

}  // namespace myo::statistics
