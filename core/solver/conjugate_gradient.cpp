#include "solver/conjugate_gradient.hpp"

namespace myo {
namespace {

using Eigen::MatrixXd;
using Eigen::RowVectorXd;

RowVectorXd column_dots(const MatrixXd& A, const MatrixXd& B) { return A.cwiseProduct(B).colwise().sum(); }

/// Y = A X with the columns of a row side by side, K of them known to the compiler (Eigen::Dynamic: not).
template <int K>
MatrixXd product_of(const SymmetricSparse& lower, const MatrixXd& X) {
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, K, K == 1 ? Eigen::ColMajor : Eigen::RowMajor>;
    const Rows x = X;
    Rows y = Rows::Zero(X.rows(), X.cols());
    for (int j = 0; j < lower.outerSize(); ++j) {
        Eigen::Matrix<double, 1, K> sum = Eigen::Matrix<double, 1, K>::Zero(1, X.cols());
        for (SymmetricSparse::InnerIterator entry(lower, j); entry; ++entry) {
            const Eigen::Index i = entry.row();
            sum += entry.value() * x.row(i);
            if (i != j) y.row(i) += entry.value() * x.row(j);
        }
        y.row(j) += sum;
    }
    return y;
}

}  // namespace

ConjugateGradientReport conjugate_gradient(const LinearOperator& A, const LinearOperator& preconditioner, const MatrixXd& B,
                                           double tolerance, int max_iterations, const MatrixXd& guess) {
    ConjugateGradientReport report;
    MatrixXd& X = report.solution;
    X = guess.size() == 0 ? MatrixXd::Zero(B.rows(), B.cols()) : guess;
    const RowVectorXd scale = B.colwise().norm();
    for (Eigen::Index k = 0; k < B.cols(); ++k)
        if (scale(k) == 0.0) X.col(k).setZero();
    MatrixXd R = B;
    if (guess.size() > 0) R -= A(X);
    using Flags = Eigen::Array<bool, 1, Eigen::Dynamic>;
    Flags open;
    const auto look = [&]() {   // which columns are not yet there
        const RowVectorXd size = R.colwise().norm();
        open = size.array() > tolerance * scale.array();
        report.relative_residual = (scale.array() > 0.0).select(size.array() / scale.array(), 0.0).maxCoeff();
        return open.any();
    };
    if (!look()) {
        report.converged = true;
        return report;
    }
    MatrixXd Z = preconditioner(R);
    MatrixXd P = Z;
    RowVectorXd rz = column_dots(R, Z);
    while (report.iterations < max_iterations) {
        const MatrixXd AP = A(P);
        const RowVectorXd curvature = column_dots(P, AP);
        ++report.iterations;
        for (Eigen::Index k = 0; k < B.cols(); ++k) {
            if (!open(k)) continue;
            if (!(curvature(k) > 0.0)) {
                report.negative_curvature = true;
                return report;
            }
            const double alpha = rz(k) / curvature(k);
            X.col(k) += alpha * P.col(k);
            R.col(k) -= alpha * AP.col(k);
        }
        if (!look()) {
            report.converged = true;
            return report;
        }
        Z = preconditioner(R);
        const RowVectorXd rz_next = column_dots(R, Z);
        for (Eigen::Index k = 0; k < B.cols(); ++k)
            if (rz(k) != 0.0) P.col(k) = Z.col(k) + rz_next(k) / rz(k) * P.col(k);
        rz = rz_next;
    }
    return report;
}

MatrixXd symmetric_product(const SymmetricSparse& lower, const MatrixXd& X) {
    switch (X.cols()) {
        case 1: return product_of<1>(lower, X);
        case 2: return product_of<2>(lower, X);
        case 3: return product_of<3>(lower, X);
        case 4: return product_of<4>(lower, X);
        default: return product_of<Eigen::Dynamic>(lower, X);
    }
}

}  // namespace myo
