#pragma once

#include <Eigen/Dense>

#include <cassert>
#include <cmath>
#include <complex>

#include "dynamics/simulate.hpp"
#include "dynamics/statics.hpp"
#include "solver/sparse_cholesky.hpp"

namespace myo::test {

/// A mode of small vibration about the rest shape; shape' M shape = 1.
struct Mode {
    double omega = 0.0;      // [rad/s]
    Eigen::Matrix3Xd shape;
};

/// First bending mode along z by inverse iteration on K and M, without simulation.
inline Mode first_mode(const Model& model) {
    StageSolver solver(model);
    const BlockPattern& pattern = model.body->pattern;
    const Eigen::Matrix3Xd& X = model.body->mesh.nodes;
    const SymmetricSparse K = solver.hessian(static_stage(*model.body, 0.0), X);
    SparseCholesky factor;
    const bool definite = factor.factorize(K);
    assert(definite);
    (void)definite;
    const auto times_mass = [&](const Eigen::VectorXd& v) { return gather(pattern, scatter(pattern, v) * solver.mass()); };
    Eigen::Matrix3Xd start = Eigen::Matrix3Xd::Zero(3, X.cols());
    start.row(2) = X.row(0).cwiseAbs2();
    Eigen::VectorXd v = gather(pattern, start);
    Mode mode;
    for (int iteration = 0; iteration < 60; ++iteration) {
        v = factor.solve(times_mass(v));
        v /= std::sqrt(v.dot(times_mass(v)));
        mode.omega = std::sqrt(v.dot(K.selfadjointView<Eigen::Lower>() * v));
    }
    mode.shape = scatter(pattern, v);
    return mode;
}

/// Modal coordinate shape' M u of every recorded state.
inline Eigen::VectorXd modal_coordinate(const Model& model, const Mode& mode, const Trace& trace) {
    const Eigen::Matrix3Xd weight = mode.shape * mass_matrix(model);
    Eigen::VectorXd q(static_cast<Eigen::Index>(trace.positions.size()));
    for (std::size_t k = 0; k < trace.positions.size(); ++k)
        q(static_cast<Eigen::Index>(k)) = weight.cwiseProduct(trace.positions[k] - model.body->mesh.nodes).sum();
    return q;
}

struct Oscillation {
    double omega_damped = 0.0;   // [rad/s]
    double damping_ratio = 0.0;
};

/// Frequency and damping of a series sampled every h: least squares for q(n+1) = a q(n) + b q(n-1) (Prony's method).
inline Oscillation fit_oscillation(const Eigen::VectorXd& q, double h) {
    const Eigen::Index n = q.size() - 2;
    Eigen::MatrixXd A(n, 2);
    A << q.segment(1, n), q.head(n);
    const Eigen::Vector2d c = A.colPivHouseholderQr().solve(q.tail(n));
    const std::complex<double> z = 0.5 * (c(0) + std::sqrt(std::complex<double>(c(0) * c(0) + 4.0 * c(1))));
    const std::complex<double> s = std::log(z) / h;
    return {std::abs(s.imag()), -s.real() / std::abs(s)};
}

/// Lets go of a beam held by its present forces, which must end at t = 0, and returns its first modal coordinate.
inline Eigen::VectorXd ring(const Model& model, const Mode& mode, Integrator integrator, double h, int steps) {
    SimulationOptions options;
    options.start = StartKind::equilibrium;
    options.integrator = integrator;
    options.h_s = h;
    options.end_s = steps * h;
    options.solver.tolerance = 1e-8;
    const Trace trace = simulate(model, options);
    return trace.complete() ? modal_coordinate(model, mode, trace) : Eigen::VectorXd();
}

}  // namespace myo::test
