#include "solver/conjugate_gradient.hpp"

namespace myo {

ConjugateGradientReport conjugate_gradient(const LinearOperator& A, const LinearOperator& preconditioner, const Eigen::VectorXd& b,
                                           double tolerance, int max_iterations) {
    ConjugateGradientReport report;
    report.solution = Eigen::VectorXd::Zero(b.size());
    const double scale = b.norm();
    if (scale == 0.0) {
        report.relative_residual = 0.0;
        report.converged = true;
        return report;
    }
    Eigen::VectorXd r = b;
    Eigen::VectorXd z = preconditioner(r);
    Eigen::VectorXd p = z;
    double rz = r.dot(z);
    while (report.iterations < max_iterations) {
        const Eigen::VectorXd Ap = A(p);
        const double curvature = p.dot(Ap);
        ++report.iterations;
        if (!(curvature > 0.0)) {
            report.negative_curvature = true;
            return report;
        }
        const double alpha = rz / curvature;
        report.solution += alpha * p;
        r -= alpha * Ap;
        report.relative_residual = r.norm() / scale;
        if (report.relative_residual <= tolerance) {
            report.converged = true;
            return report;
        }
        z = preconditioner(r);
        const double rz_next = r.dot(z);
        p = z + rz_next / rz * p;
        rz = rz_next;
    }
    return report;
}

}  // namespace myo
