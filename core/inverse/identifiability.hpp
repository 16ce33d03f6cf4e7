#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace myo::inverse {

struct Parameter;

/// Thresholds that separate directions without any influence on the residuals from those with little.
struct IdentifiabilityPolicy {
    /// Relative accuracy of the columns of a Jacobian. Smaller singular values are errors of the derivatives: tangents
    /// are solved to 1e-8 (SolverOptions::tangent_tolerance), differences of models lose another digit, and rounding of
    /// the sums of J'J hides singular values below sqrt(m eps), 5e-7 for a thousand residuals (Golub & Van Loan 2013,
    /// section 5.3).
    double derivative_accuracy = 1e-6;
    /// Least component of a parameter in the null space that makes it undetermined, in units of its column norm. Errors
    /// of the derivatives rotate the null space by about derivative_accuracy over the smallest significant singular
    /// value, usually far less than this.
    double participation = 1e-2;
};

/// Parameters that the data do not determine because they can change together without changing the residuals.
struct Undetermined {
    /// One index: the parameter has no influence. Several: only combinations of them influence the data.
    std::vector<Eigen::Index> parameters;
    Eigen::Index combinations = 0;  // number of independent combinations that the data determine
    Eigen::VectorXd
        gradient;  // for one combination: its gradient with respect to the parameters, of any length; else empty
};

/// Standard deviations of fitted parameters, as far as the data determine them.
struct Identifiability {
    Eigen::VectorXd deviations;   // n; NaN: undetermined, 0: fixed
    Eigen::MatrixXd correlation;  // n x n; identity rows for undetermined and fixed parameters
    std::vector<Undetermined> undetermined;
};

/// Separates the parameters that the Gauss-Newton matrix J'J determines from those in its null space.
///
/// Columns without influence, measured in the scales of their parameters, are removed first. The others are normalised,
/// so that the eigenvalues of J'J measure linear dependence and not scale (van der Sluis 1969, Numer. Math. 14).
/// Deviations use the remaining eigenvectors: a parameter outside the null space has the same deviation whatever else
/// is undetermined.
///
/// @param J         m x n, residuals in units of their standard deviation
/// @param variance  of the residuals; deviations are multiplied by its square root
Identifiability identifiability(const std::vector<Parameter>& parameters, const Eigen::MatrixXd& J, double variance,
                                const IdentifiabilityPolicy& policy = {});

/// A subset of parameters that suffices for all first-order changes of the residuals: those of `first`, then others in
/// order of their additional influence, in the scales of the parameters. Fixed parameters and those without influence
/// are excluded. Column pivoting as in Golub & Van Loan 2013, 5.4.2.
std::vector<Eigen::Index> sufficient_parameters(const std::vector<Parameter>& parameters, const Eigen::MatrixXd& J,
                                                const std::vector<Eigen::Index>& first,
                                                const IdentifiabilityPolicy& policy = {});

/// Per column of J: whether the parameter has no influence on the residuals. Fixed parameters give false.
std::vector<bool> without_influence(const std::vector<Parameter>& parameters, const Eigen::MatrixXd& J,
                                    const IdentifiabilityPolicy& policy = {});

/// Reason why a parameter is undetermined, as a clause; empty if it is determined: "it has no influence on the data",
/// "the data determine only its combination with b: a · b". Combinations of positive parameters are written as products
/// of powers, others as sums.
std::string undetermined_reason(const std::vector<Parameter>& parameters, const std::vector<Undetermined>& undetermined,
                                const Eigen::VectorXd& values, Eigen::Index parameter);

}  // namespace myo::inverse
