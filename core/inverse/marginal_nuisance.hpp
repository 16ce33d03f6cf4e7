#pragma once

#include <Eigen/Core>

namespace myo::inverse {

/// Unknowns n ~ N(0, I) that add A n to the residuals of a least-squares problem and are marginalised out of it.
///
/// With residuals r in units of their noise, r + A n has the marginal covariance I + A A'. The minimum over n of
/// |r + A n|^2 + |n|^2 is |whitened(r)|^2, so a fit of the other parameters to whitened residuals with whitened
/// derivatives is the fit of all unknowns together.
/// Source: Rasmussen & Williams 2006, sec. 2.7 (explicit basis functions); Golub & Pereyra 1973 (separation).
class MarginalNuisance {
public:
    /// No unknowns: whitened() returns its argument.
    MarginalNuisance() = default;
    /// @param A  N x q, derivatives of the residuals over noise by the unknowns over their prior standard deviations
    explicit MarginalNuisance(Eigen::MatrixXd A);

    bool empty() const { return A_.cols() == 0; }
    const Eigen::MatrixXd& derivatives() const { return A_; }

    /// (I + A A')^(-1/2) X for X of N rows.
    Eigen::MatrixXd whitened(const Eigen::MatrixXd& X) const;
    /// Most probable unknowns, q, for residuals r: -(I + A'A)^-1 A'r.
    ///
    /// @param whitened  whitened(r)
    Eigen::VectorXd mean(const Eigen::VectorXd& whitened) const;
    /// Covariance of the unknowns, q x q: (I + A'A)^-1 + B C B' with B = (I + A'A)^-1 A'J.
    ///
    /// @param whitened    N x p: whitened(J) of the derivatives J by the other parameters
    /// @param covariance  C, p x p, of the other parameters
    Eigen::MatrixXd covariance(const Eigen::MatrixXd& whitened, const Eigen::MatrixXd& covariance) const;

private:
    /// (I + A'A)^power X.
    Eigen::MatrixXd power(double power, const Eigen::MatrixXd& X) const;

    Eigen::MatrixXd A_;        // N x q
    Eigen::MatrixXd vectors_;  // q x q, eigenvectors of A'A
    Eigen::VectorXd values_;   // q, its eigenvalues
};

}  // namespace myo::inverse
