#include <gtest/gtest.h>

#include <numbers>

#include "base/cross_matrix.hpp"
#include "dynamics/natural_modes.hpp"
#include "dynamics/simulate.hpp"
#include "dynamics/statics.hpp"
#include "model/mount_forces.hpp"
#include "support/beam.hpp"
#include "support/figures.hpp"
#include "support/run.hpp"
#include "support/turning_mount.hpp"

namespace myo::dynamics {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// A body without supports in a tumbling frame falls freely in the laboratory: the inertia forces cancel the frame.
/// Differences between its nodes and the fall, over the distance fallen.
double departure_from_fall(const TimeScheme& scheme, double h) {
    test::BeamSpec spec;
    spec.cells = {2, 1, 1};
    spec.clamped = false;
    spec.gravity_m_s2 = 9.81;
    spec.poissons_ratio = 0.3;
    spec.damping_s = 0.002;
    model::Model model = test::make_beam(spec);
    const auto mount = test::tumbling_mount();
    const Matrix3Xd X = model.body->mesh.nodes;
    // At rest in the laboratory at t = 0, where both frames coincide.
    const Matrix3Xd against = -mount->at(0.0).velocities_in_laboratory(X, Matrix3Xd::Zero(3, X.cols()));
    model.force_elements.push_back(model::mount_forces(model, mount));
    SimulationOptions options = test::short_steps(StartKind::straight, h, 0.16);
    options.integrator = scheme;
    options.initial.velocities = against;
    const Trace trace = simulate(model, options);
    EXPECT_TRUE(trace.complete()) << trace.message;
    const double t = trace.times_s.back();
    const Vector3d fall = 0.5 * t * t * model.gravity_m_s2;
    const Matrix3Xd seen = mount->at(t).in_laboratory(trace.positions.back());
    return (seen - (X.colwise() + fall)).norm() / (fall.norm() * std::sqrt(static_cast<double>(X.cols())));
}

TEST(MovingMount, LetsAFreeBodyFallStraightOfSecondOrder) {
    for (const test::NamedScheme& scheme : test::all_schemes()) {
        if (scheme.scheme.integrator == Integrator::implicit_euler) continue;
        SCOPED_TRACE(scheme.name);
        const double coarse = departure_from_fall(scheme.scheme, 0.004),
                     fine = departure_from_fall(scheme.scheme, 0.002);
        test::record(std::string("order_") + scheme.name, std::log2(coarse / fine));
        test::record(std::string("error_") + scheme.name, fine);
        EXPECT_LT(fine, 2e-2);
        EXPECT_GT(std::log2(coarse / fine), 1.7);
    }
}

/// Steady motion of a shaken cantilever by superposition of modes of the same mesh; a mode of momentum P along the
/// shaking obeys q'' + w^2 q = P W^2 sin(W t + phase). Modes above follow statically.
struct ModalCantilever {
    model::Model model;
    test::BeamSpec spec;
    std::vector<NaturalMode> modes;
    Matrix3Xd momentum;  // M times the amplitude
    Matrix3Xd flexure;   // K^-1 of that

    ModalCantilever(const model::Model& of, const test::BeamSpec& beam, const Vector3d& amplitude_m)
        : model(of), spec(beam) {
        StageSolver solver(model);
        const Matrix3Xd& X = model.body->mesh.nodes;
        modes = natural_modes(solver, X, 10).modes;
        momentum = model::times_mass(amplitude_m.replicate(1, X.cols()), model::mass_matrix(model));
        const Stage stage = static_stage(*model.body, 0.0);
        flexure = model::scatter(
            model.body->pattern,
            solver.solve_linear(solver.hessian(stage, X), stage, X, model::gather(model.body->pattern, momentum)));
        for (const NaturalMode& mode : modes)
            flexure -= mode.shape.cwiseProduct(momentum).sum() / std::pow(mode.omega_rad_s, 2) * mode.shape;
    }

    /// Displacements over sin(W t + phase).
    Matrix3Xd shape(double W) const {
        Matrix3Xd u = W * W * flexure;
        for (const NaturalMode& mode : modes)
            u += mode.shape.cwiseProduct(momentum).sum() * W * W / (std::pow(mode.omega_rad_s, 2) - W * W) * mode.shape;
        return u;
    }
};

TEST(MovingMount, ShakesACantileverAsItsModesSuperpose) {
    test::BeamSpec spec;
    spec.cells = {4, 1, 1};
    spec.size = {0.1, 0.01, 0.02};
    spec.poissons_ratio = 0.3;
    const model::Model model = test::make_beam(spec);
    const Vector3d amplitude_m(0.0, 0.0, 1e-7);
    const ModalCantilever modal(model, spec, amplitude_m);
    ASSERT_EQ(modal.modes.size(), 10u);
    double first_Hz = 0.0;
    const Matrix3Xd up = Vector3d::UnitZ().replicate(1, model.body->node_count());
    for (const NaturalMode& mode : modal.modes)
        if (first_Hz == 0.0 && std::abs(mode.shape.cwiseProduct(up).sum()) > 0.5 * mode.shape.cwiseAbs().sum())
            first_Hz = mode.omega_rad_s / (2.0 * std::numbers::pi);
    ASSERT_GT(first_Hz, 0.0);
    // Below the first bending mode, beside it, and above it.
    for (const double ratio : {0.3, 0.95, 2.7}) {
        const model::MountVibration shaking{amplitude_m, ratio * first_Hz, 0.6};
        model::Model moved = model;
        moved.force_elements.push_back(model::mount_forces(moved, model::with_vibrations(nullptr, {shaking})));
        const double W = 2.0 * std::numbers::pi * shaking.frequency_Hz, end = 1.2 / shaking.frequency_Hz;
        const Matrix3Xd& X = model.body->mesh.nodes;
        const Matrix3Xd shape = modal.shape(W);
        std::vector<double> errors;
        for (const double steps : {60.0, 120.0}) {
            SimulationOptions options = test::short_steps(StartKind::straight, end / steps, end);
            options.initial.positions = X + std::sin(shaking.phase_rad) * shape;
            options.initial.velocities = W * std::cos(shaking.phase_rad) * shape;
            const Trace trace = simulate(moved, options);
            ASSERT_TRUE(trace.complete()) << trace.message;
            const double amplitude = test::tip_displacement(model, spec, X + shape).z();
            double error = 0.0, largest = std::abs(amplitude);
            for (std::size_t k = 0; k < trace.times_s.size(); ++k)
                error = std::max(error, std::abs(test::tip_displacement(model, spec, trace.positions[k]).z() -
                                                 amplitude * std::sin(W * trace.times_s[k] + shaking.phase_rad)));
            errors.push_back(error / largest);
        }
        test::record("error_at_" + std::to_string(ratio), errors[1]);
        test::record("order_at_" + std::to_string(ratio), std::log2(errors[0] / errors[1]));
        EXPECT_LT(errors[1], 1e-3);
        EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2.0, 0.3);
    }
}

/// A bar that turns about its clamp, its weight turning with it or not: u(L) = rho W^2 L^3 / (3 E).
TEST(MovingMount, StretchesATurningBarByItsCentrifugalForce) {
    test::BeamSpec spec;
    spec.cells = {8, 1, 1};
    spec.size = {0.1, 0.01, 0.01};
    spec.poissons_ratio = 0.0;
    spec.damping_s = 0.05;
    model::Model model = test::make_beam(spec);
    auto mount = std::make_shared<test::TurningMount>();
    mount->axis = Vector3d::UnitZ();
    mount->pivot_m = {0.0, 0.005, 0.005};
    mount->spin_rad_s = 2.0;
    model.force_elements.push_back(model::mount_forces(model, mount));
    const Trace trace = test::run(model, {Integrator::implicit_euler}, 0.05, 5.0);
    const double stretch = test::tip_displacement(model, spec, trace.positions.back()).x();
    const double L = spec.size(0), expected = spec.density_kg_m3 * 4.0 * L * L * L / (3.0 * spec.youngs_modulus_Pa);
    test::record("relative_error", stretch / expected - 1.0);
    EXPECT_NEAR(stretch / expected, 1.0, 2e-3);
}

/// At rest against the mount a body feels no inertia, only where down is.
TEST(MovingMount, StartsFromTheEquilibriumOfItsPose) {
    test::BeamSpec spec;
    spec.cells = {4, 1, 1};
    spec.poissons_ratio = 0.3;
    spec.gravity_m_s2 = 9.81;
    model::Model model = test::make_beam(spec);
    auto mount = std::make_shared<test::TurningMount>(*test::tumbling_mount());
    mount->axis = Vector3d::UnitX();
    mount->swing_rad = 0.0;
    mount->spin_rad_s = 100.0;
    class Later : public model::MountMotion {
    public:
        explicit Later(model::MountMotionPointer motion) : motion_(std::move(motion)) {}
        model::MountPose at(double t) const override { return motion_->at(t + 0.02); }
        bool turns() const override { return true; }

    private:
        model::MountMotionPointer motion_;
    };
    model::Model turned = model;
    turned.gravity_m_s2 = mount->at(0.02).rotation.transpose() * model.gravity_m_s2;
    model.force_elements.push_back(model::mount_forces(model, std::make_shared<Later>(mount)));
    SimulationOptions options = test::short_steps(StartKind::equilibrium, 0.01, 0.0);
    const Trace on_mount = simulate(model, options), plain = simulate(turned, options);
    ASSERT_TRUE(on_mount.complete() && plain.complete());
    EXPECT_LT((on_mount.positions[0] - plain.positions[0]).norm(), 1e-9);
    EXPECT_GT((plain.positions[0] - model.body->mesh.nodes).norm(), 1e-3);
}

TEST(MountPose, HasTheDerivativesOfItsPlaces) {
    const auto mount = test::tumbling_mount();
    const model::MountMotionPointer motion = model::by_clock(
        model::with_vibrations(mount, {{{1e-3, 2e-3, 0.0}, 7.0, 0.4}}), 0.013, 1.02);
    const Matrix3Xd X = Vector3d(0.1, 0.03, -0.02);
    const double t = 0.21, d = 1e-4;
    const auto place = [&](double at) { return motion->at(at).in_laboratory(X); };
    const model::MountPose pose = motion->at(t);
    const Matrix3Xd v = pose.velocities_in_laboratory(X, Matrix3Xd::Zero(3, 1));
    EXPECT_LT((v - (place(t + d) - place(t - d)) / (2.0 * d)).norm(), 1e-5 * v.norm());
    const Eigen::Matrix3d W = cross_matrix(pose.spin_rad_s), A = cross_matrix(pose.spin_rate_rad_s2) + W * W;
    const Vector3d r = X.col(0) - pose.pivot_m, a = pose.acceleration_m_s2 + pose.rotation * A * r;
    EXPECT_LT((a - (place(t + d) - 2.0 * place(t) + place(t - d)) / (d * d)).norm(), 1e-5 * a.norm());
}

}  // namespace
}  // namespace myo::dynamics
