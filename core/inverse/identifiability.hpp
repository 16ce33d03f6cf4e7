#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace myo::inverse {

struct Parameter;

/// What separates a direction that the residuals do not see from one that they see little.
struct IdentifiabilityPolicy {
    /// Relative accuracy of the columns of a Jacobian, below which a singular value of it is an error of derivatives.
    /// Tangents are solved to 1e-8 (SolverOptions::tangent_tolerance), models on both sides of a value lose a digit
    /// more, and rounding of the sums of J'J hides singular values below sqrt(m eps), 5e-7 for a thousand residuals
    /// (Golub & Van Loan 2013, section 5.3).
    double derivative_accuracy = 1e-6;
    /// A parameter takes part in the unseen directions from this component on, in units of its column's length. Errors
    /// of the derivatives turn these directions by about derivative_accuracy over the smallest singular value seen,
    /// mostly far less.
    double participation = 1e-2;
};

/// Parameters that the data do not determine, because they can change together without changing the residuals.
struct Undetermined {
    /// One: it has no influence on the data; several: the data see combinations of them only.
    std::vector<Eigen::Index> parameters;
    Eigen::Index combinations = 0;  // how many independent ones the data determine
    Eigen::VectorXd gradient;       // where it is one: its derivative by each parameter, of any length; else empty
};

/// Standard deviations of fitted parameters, as far as the data determine them.
struct Identifiability {
    Eigen::VectorXd deviations;   // n; NaN for those that are not determined, 0 for those whose bounds are one value
    Eigen::MatrixXd correlation;  // n x n; unit rows for these
    std::vector<Undetermined> undetermined;
};

/// Splits the parameters into those that the Gauss-Newton matrix J'J determines and those that take part in its null
/// space.
///
/// Columns without influence are set aside first, measured in the scales of their parameters; the others are brought to
/// unit length, with which the eigenvalues of J'J tell dependence from a small scale (van der Sluis 1969, Numer. Math.
/// 14). The deviations of what is determined come from the other eigenvectors: a parameter outside of the null space
/// has the same ones whatever is undetermined beside it.
///
/// @param J         m x n, residuals in units of their standard deviations
/// @param variance  of the residuals: the deviations are enlarged by its root
Identifiability identifiability(const std::vector<Parameter>& parameters, const Eigen::MatrixXd& J, double variance,
                                const IdentifiabilityPolicy& policy = {});

/// Parameters that suffice to change the residuals in all ways that any of them can: those of `first`, then the others
/// by what they add, in the scales of the parameters; without fixed ones and those without influence. Column pivoting
/// as in Golub & Van Loan 2013, 5.4.2.
std::vector<Eigen::Index> sufficient_parameters(const std::vector<Parameter>& parameters, const Eigen::MatrixXd& J,
                                                const std::vector<Eigen::Index>& first,
                                                const IdentifiabilityPolicy& policy = {});

/// Per column, whether the parameter has no influence on the residuals.
std::vector<bool> without_influence(const std::vector<Parameter>& parameters, const Eigen::MatrixXd& J,
                                    const IdentifiabilityPolicy& policy = {});

/// Why a parameter is not determined, as a clause; empty for one that is: "it has no influence on the data", "the data
/// determine only its combination with b: a · b". Combinations of positive parameters are written as products of
/// powers, others as sums.
std::string undetermined_reason(const std::vector<Parameter>& parameters, const std::vector<Undetermined>& undetermined,
                                const Eigen::VectorXd& values, Eigen::Index parameter);

}  // namespace myo::inverse
