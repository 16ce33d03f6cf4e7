#include "dynamics/numerical_damping.hpp"

#include <Eigen/Eigenvalues>

#include <cassert>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

namespace myo::dynamics {
namespace {

struct NumericalDampingPolicy {
    /// Steps of the continuation from h = 0: at h / 32 the parasitic roots of two-step schemes are still far from the
    /// principal root.
    int parts = 32;
};
constexpr NumericalDampingPolicy numerical_damping_policy;

using Eigen::Matrix3Xd;
using Eigen::Matrix4d;
using Eigen::Vector4d;
using Eigen::VectorXd;

/// Model of one node that moves along x, with mass 1 and h as the unit of time. Its strain is x itself.
Matrix3Xd node(double value) { return Matrix3Xd(Eigen::Vector3d(value, 0.0, 0.0)); }

Kinematics kinematics(const Vector4d& y, const Oscillator& o) {
    Kinematics s;
    // Consistent state: the force (M = 1) follows from the equation of motion.
    s.x = node(y(0));
    s.v = node(y(1));
    s.force = node((o.velocity_force_1_s - 2.0 * o.damping_ratio * o.omega_rad_s) * y(1) -
                   o.omega_rad_s * o.omega_rad_s * y(0));
    s.strain = VectorXd::Constant(1, y(0));
    s.rate = VectorXd::Constant(1, y(1));
    s.step_before_s = 1.0;
    s.v_lag = node(y(2));
    s.force_lag = node(y(3));
    s.rate_lag = VectorXd::Constant(1, y(2));
    return s;
}

double first(const Matrix3Xd& m) { return m.size() > 0 ? m(0, 0) : 0.0; }

double spectral_radius(const Matrix4d& A) { return A.eigenvalues().cwiseAbs().maxCoeff(); }

}  // namespace

Matrix4d amplification(const TimeScheme& scheme, const Oscillator& oscillator, double h_s) {
    const Oscillator o{oscillator.omega_rad_s * h_s, oscillator.damping_ratio, oscillator.velocity_force_1_s * h_s};
    model::MassMatrix mass{Eigen::SparseMatrix<double>(1, 1), {}, {}};
    mass.isotropic.insert(0, 0) = 1.0;
    const auto solve = [&](const Stage& stage, StageSolution& solution) {
        // Stage equation of the test equation: (inertia + omega^2 + 2 zeta omega f) x = constant - 2 zeta omega
        // history.
        const double stiffness = o.omega_rad_s * o.omega_rad_s, viscosity = 2.0 * o.damping_ratio * o.omega_rad_s;
        const double x = (first(stage.constant) - viscosity * stage.rate_history(0)) /
                         (stage.inertia_1_s2 + stiffness + viscosity * stage.rate_factor_1_s);
        solution = {node(x), VectorXd::Constant(1, x)};
        return true;
    };
    const StepProblem<decltype(solve)> problem{mass, 0.0, 1.0, o.velocity_force_1_s, solve};
    Matrix4d A;
    for (int column = 0; column < 4; ++column) {
        Kinematics next;
        take_step(scheme, problem, kinematics(Vector4d::Unit(column), o), next);
        A.col(column) << first(next.x), first(next.v), first(next.v_lag), first(next.force_lag);
    }
    return A;
}

DiscreteVibration discrete_vibration(const TimeScheme& scheme, const Oscillator& o, double h_s) {
    const double damping = o.damping_ratio - 0.5 * o.velocity_force_1_s / o.omega_rad_s;
    assert(o.omega_rad_s > 0.0 && h_s > 0.0 && std::abs(damping) < 1.0);
    std::complex<double> root = 1.0;
    Matrix4d A;
    // Continuation in h: the root closest to that of the previous, shorter step is the principal one.
    for (int k = 1; k <= numerical_damping_policy.parts; ++k) {
        A = amplification(scheme, o, h_s * k / numerical_damping_policy.parts);
        const Eigen::Vector4cd roots = A.eigenvalues();
        // Schemes without memory have zero roots, which represent no vibration.
        const std::complex<double> before = root;
        double nearest = std::numeric_limits<double>::infinity();
        for (int i = 0; i < 4; ++i)
            if (std::abs(roots(i)) > 1e-12 && std::abs(roots(i) - before) < nearest) {
                nearest = std::abs(roots(i) - before);
                root = roots(i);
            }
        root = {root.real(), std::abs(root.imag())};
    }
    // Exponent of the discrete motion, exp(s h) = root, and the exact damped frequency to compare with.
    const std::complex<double> s = std::log(root) / h_s;
    const double exact = o.omega_rad_s * std::sqrt(1.0 - damping * damping);
    return {-s.real() / std::abs(s), s.imag() / exact - 1.0, spectral_radius(A)};
}

double implicit_euler_numerical_damping(double omega_rad_s, double h_s) {
    const double wh = omega_rad_s * h_s;
    if (wh == 0.0) return 0.0;
    const double delta = std::numbers::pi * std::log1p(wh * wh) / std::atan(wh);
    return delta / std::hypot(2.0 * std::numbers::pi, delta);
}

double implicit_euler_critical_velocity_force(double omega_rad_s, double h_s, double damping_ratio) {
    return h_s * omega_rad_s * omega_rad_s + 2.0 * damping_ratio * omega_rad_s;
}

double critical_velocity_force(const TimeScheme& scheme, double omega_rad_s, double h_s, double damping_ratio) {
    const auto grows = [&](double lambda) {
        // The undamped roots of the trapezoidal rule lie on the unit circle to rounding.
        return spectral_radius(amplification(scheme, {omega_rad_s, damping_ratio, lambda}, h_s)) > 1.0 + 1e-12;
    };
    // Bracket in small ratios: growth may end again at larger Lambda, where the scheme damps by the size of h Lambda.
    double stable = 0.0, unstable = 1e-6 * omega_rad_s;
    while (!grows(unstable)) {
        stable = unstable;
        unstable *= 1.1;
        if (unstable > 1e3 * (omega_rad_s + 1.0 / h_s)) return std::numeric_limits<double>::infinity();
    }
    while (unstable - stable > 1e-9 * omega_rad_s) {
        const double middle = 0.5 * (stable + unstable);
        (grows(middle) ? unstable : stable) = middle;
    }
    return 0.5 * (stable + unstable);
}

}  // namespace myo::dynamics
