#pragma once

#include <Eigen/Core>

#include <vector>

#include "statistics/nuisance_space.hpp"
#include "statistics/residual_layout.hpp"

namespace myo::statistics {

/// Tangent of a candidate effect outside the nuisance space, S~ = (I - J J^+) S, with an orthonormal basis.
struct ProjectedCandidate {
    Eigen::MatrixXd basis;         // N x rank, basis of the columns of S~
    Eigen::MatrixXd to_step;       // q x rank: parameter step = to_step * basis' r
    Eigen::VectorXd length;        // q: |S_j|
    Eigen::VectorXd kept;          // q: |S~_j| / |S_j|; 0 if recalibration absorbs it all or S_j is zero
    std::vector<bool> determined;  // q: false if S~_j is linearly dependent on the others; its step is 0

    /// Dimension of S~.
    Eigen::Index rank() const { return basis.cols(); }
    /// q, parameters of the candidate.
    Eigen::Index parameters() const { return kept.size(); }
};

/// Projects a candidate out of the nuisance space.
///
/// @param nuisance            space of the recalibration
/// @param S                   N x q, derivatives of the prediction over sigma at the absent value
/// @param relative_tolerance  remainders below this share of |S_j| are rounding
ProjectedCandidate project_candidate(const NuisanceSpace& nuisance, const Eigen::MatrixXd& S,
                                     double relative_tolerance = 1e-6);

/// Lagrange multiplier (score) test of a candidate before it is fitted.
struct ScoreTest {
    double statistic = 0.0;          // |P r~|^2, P onto S~: chi^2 with `freedom` under white noise of variance 1
    int freedom = 0;                 // rank of S~; at 0 the candidate has no effect here and p is 1
    double p_white = 1.0;            // p-value of the statistic under white noise
    double log_p_white = 0.0;        // its natural logarithm, for ranking below the range of double
    double explained = 0.0;          // R^2 = statistic / |r~|^2
    double effective_samples = 0.0;  // N divided by Bartlett's variance inflation of r~ and S~
    double p = 1.0;                  // p-value (F test) of R^2 with effective_samples; independent of the noise level
    Eigen::VectorXd step;            // q: minimiser of |r~ - S~ step|
    Eigen::VectorXd deviation;  // q: standard deviations of the step, inflation included; infinite if not determined
};

/// Score test of one candidate.
///
/// @param r_outside  r~ = nuisance.outside(r), N
/// Source: Rao 1948, Proc. Camb. Phil. Soc. 44, 50; effective samples: Bartlett 1935 (see variance_inflation).
ScoreTest score_test(const ProjectedCandidate& candidate, const Eigen::VectorXd& r_outside,
                     const ResidualLayout& layout);

/// Largest canonical correlation between the spaces S~ of two candidates: 1 is indistinguishable, 0 is orthogonal.
/// Signed cosine for one parameter each. 0 if one of the spaces is empty.
double principal_cosine(const ProjectedCandidate& a, const ProjectedCandidate& b);

/// Pairwise principal_cosine(), symmetric; the diagonal is 1.
Eigen::MatrixXd principal_cosines(const std::vector<ProjectedCandidate>& candidates);

/// Holm's step-down adjusted p-values, in the given order. Rejecting those below alpha bounds the family-wise error
/// rate by alpha under any dependence.
/// Source: Holm 1979, Scand. J. Statistics 6, 65.
std::vector<double> holm_adjusted(const std::vector<double>& p);

}  // namespace myo::statistics
