#include "support/oscillation.hpp"

namespace myo::test {

std::array<std::complex<double>, 2> step_eigenvalues(const Eigen::Matrix2cd& A) {
    // Roots of the characteristic polynomial.
    const std::complex<double> half = 0.5 * A.trace(), root = std::sqrt(half * half - A.determinant());
    return {half + root, half - root};
}

dynamics::NaturalMode first_mode(const model::Model& model) {
    dynamics::StageSolver solver(model);
    const dynamics::NaturalModes modes = dynamics::natural_modes(solver, model.body->mesh.nodes, 1);
    // A failure here would otherwise appear as a wrong frequency.
    EXPECT_TRUE(modes.ok());
    return modes.modes.at(0);
}

void hold_until_zero(model::Model& model, const BeamSpec& spec) {
    // Cantilever with a force at the tip: deflection F L^3 / (3 E I), here 1 % of the length.
    const double force = 0.03 * spec.youngs_modulus_Pa * second_moment(spec) / (spec.size(0) * spec.size(0));
    push_tip(model, spec, {0.0, 0.0, -force});
    model.forces.back().until_s = 0.0;
}

BeamSpec ringing_beam() {
    BeamSpec spec;
    spec.cells = {7, 2, 2};
    spec.size = {0.1, 0.036, 0.03};
    return spec;
}

model::Model held(const BeamSpec& spec) {
    model::Model model = make_beam(spec);
    hold_until_zero(model, spec);
    return model;
}

Eigen::VectorXd modal_coordinate(const model::Model& model, const dynamics::NaturalMode& mode,
                                 const dynamics::Trace& trace) {
    // Modes are orthogonal with respect to the mass matrix, so this weight removes all other modes.
    const Eigen::Matrix3Xd weight = model::times_mass(mode.shape, model::mass_matrix(model));
    Eigen::VectorXd q(static_cast<Eigen::Index>(trace.positions.size()));
    for (std::size_t k = 0; k < trace.positions.size(); ++k)
        q(static_cast<Eigen::Index>(k)) = weight.cwiseProduct(trace.positions[k] - model.body->mesh.nodes).sum();
    return q;
}

Oscillation fit_oscillation(const Eigen::VectorXd& q, double h) {
    const Eigen::Index n = q.size() - 2;
    Eigen::MatrixXd A(n, 2);
    A << q.segment(1, n), q.head(n);
    const Eigen::Vector2d c = A.colPivHouseholderQr().solve(q.tail(n));
    // The roots of z^2 = a z + b are exp(s h) of the oscillation.
    const std::complex<double> z = 0.5 * (c(0) + std::sqrt(std::complex<double>(c(0) * c(0) + 4.0 * c(1))));
    const std::complex<double> s = std::log(z) / h;
    return {std::abs(s.imag()), -s.real() / std::abs(s)};
}

Eigen::VectorXd ring(const model::Model& model, const dynamics::NaturalMode& mode, const dynamics::TimeScheme& scheme,
                     double h, int steps) {
    dynamics::SimulationOptions options;
    options.start = dynamics::StartKind::equilibrium;
    options.integrator = scheme;
    options.h_s = h;
    options.end_s = steps * h;
    // Errors of the solver must stay below the errors in time that the tests measure.
    options.solver.tolerance = 1e-8;
    const dynamics::Trace trace = dynamics::simulate(model, options);
    return trace.complete() ? modal_coordinate(model, mode, trace) : Eigen::VectorXd();
}

}  // namespace myo::test
