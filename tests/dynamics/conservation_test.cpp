#include <gtest/gtest.h>

#include "dynamics/energy.hpp"
#include "support/beam.hpp"
#include "support/differences.hpp"
#include "support/figures.hpp"
#include "support/run.hpp"

namespace myo::dynamics {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using test::run;

constexpr double gravity = 9.81;

test::BeamSpec free_body(const char* element) {
    test::BeamSpec spec;
    spec.kind = test::element(element);
    spec.cells = {2, 1, 1};
    spec.clamped = false;
    return spec;
}

/// Fibres along an oblique line in one half of the body contract along a ramp: it bends and twists.
void add_muscle(model::Model& model) {
    auto fibres = std::make_shared<std::vector<fibre::FibreGroup>>();
    const Box half{{0.0, 0.0, 0.0}, {0.06, 0.02, 0.015}};
    fibres->push_back(fibre::fibres_in_box(model.body->mesh, half, Vector3d(2.0, 1.0, 0.5).normalized(), 2e5, "half"));
    model.fibres = fibres;
    model.activation = {fibre::Signal{{0.0, 0.1}, {1.0, 0.6}}};
}

Vector3d angular_momentum(const Matrix3Xd& x, const Matrix3Xd& momentum) {
    Vector3d sum = Vector3d::Zero();
    for (Eigen::Index i = 0; i < x.cols(); ++i) sum += x.col(i).head<3>().cross(momentum.col(i).head<3>());
    return sum;
}

/// Under gravity alone the body falls without deforming: the schemes of second order exactly, implicit Euler by its own
/// sum gravity h^2 n (n + 1) / 2.
TEST(FreeFlight, CentreOfMassFallsAsTheSchemeSays) {
    for (const char* element : {"hex8", "tet10"})
        for (const Integrator integrator :
             {Integrator::tr_bdf2, Integrator::bdf2, Integrator::trapezoidal, Integrator::implicit_euler}) {
            model::Model model = test::make_beam(free_body(element));
            model.gravity_m_s2 = {0.0, 0.0, -gravity};
            const double h = 0.01;
            const Trace trace = run(model, integrator, h, 0.3);
            for (std::size_t n = 0; n < trace.times_s.size(); ++n) {
                const double t = trace.times_s[n], k = static_cast<double>(n);
                const double fall = integrator == Integrator::implicit_euler ? 0.5 * gravity * h * h * k * (k + 1.0)
                                                                             : 0.5 * gravity * t * t;
                Matrix3Xd expected = model.body->mesh.nodes;
                expected.row(2).array() -= fall;
                EXPECT_LT((trace.positions[n] - expected).cwiseAbs().maxCoeff(), 1e-9) << element << " " << t;
                EXPECT_LT((trace.velocities[n].row(2).array() + gravity * t).abs().maxCoeff(), 1e-7)
                    << element << " " << t;
            }
        }
}

TEST(FreeFlight, InnerForcesLeaveLinearMomentumZeroAndAngularMomentumToTheOrderOfTheScheme) {
    for (const auto& [name, scheme] : test::all_schemes()) {
        model::Model model = test::make_beam(free_body("hex8"));
        add_muscle(model);
        model.damping_s = 0.005;
        const auto mass = model::mass_matrix(model);
        std::vector<double> steps{0.004, 0.002, 0.001}, drift;
        for (const double h : steps) {
            const Trace trace = run(model, scheme, h, 0.1);
            double largest_linear = 0.0, momentum_scale = 0.0, angular_scale = 0.0;
            for (std::size_t n = 0; n < trace.times_s.size(); ++n) {
                const Matrix3Xd p = model::times_mass(trace.velocities[n], mass);
                largest_linear = std::max(largest_linear, p.rowwise().sum().norm());
                momentum_scale = std::max(momentum_scale, p.colwise().norm().sum());
                angular_scale = std::max(angular_scale, p.colwise().norm().sum() * 0.05);  // half the length as arm
            }
            EXPECT_GT(momentum_scale, 1e-4);  // it does move
            EXPECT_LT(largest_linear, 1e-7 * momentum_scale) << name;
            drift.push_back(
                angular_momentum(trace.positions.back(), model::times_mass(trace.velocities.back(), mass)).norm() /
                angular_scale);
        }
        const std::vector<double> orders = test::observed_orders(steps, drift);
        test::record(name + std::string("_angular_drift"), drift);
        test::record(name + std::string("_angular_orders"), orders);
        EXPECT_GT(orders.back(), scheme.integrator == Integrator::implicit_euler ? 0.8 : 1.8) << name;
    }
}

/// Kinetic, elastic and potential energy.
std::vector<double> total_energy(const model::Model& model, const Trace& trace) {
    const auto mass = model::mass_matrix(model);
    std::vector<double> total;
    for (std::size_t n = 0; n < trace.times_s.size(); ++n)
        total.push_back(energy(model, mass, trace.positions[n], trace.velocities[n], trace.times_s[n]).total_J());
    return total;
}

/// The undamped soft beam let go under gravity, five periods: TR-BDF2 takes a little energy, the less the smaller h,
/// most of it from the higher modes that the release excites.
TEST(EnergyDrift, TrBdf2LosesLittleAndNeverGains) {
    test::BeamSpec spec;
    spec.cells = {5, 1, 1};
    spec.gravity_m_s2 = gravity;
    const model::Model model = test::make_beam(spec);
    const auto mass = model::mass_matrix(model);
    std::vector<double> steps{0.005, 0.0025, 0.00125}, loss, rise;
    for (const double h : steps) {
        const Trace trace = run(model, Integrator::tr_bdf2, h, 0.65);
        const std::vector<double> energy = total_energy(model, trace);
        double swing = 0.0, lowest = energy.front(), largest_rise = 0.0;
        for (std::size_t n = 0; n < energy.size(); ++n) {
            swing = std::max(
                swing, 0.5 * (model::times_mass(trace.velocities[n], mass)).cwiseProduct(trace.velocities[n]).sum());
            largest_rise = std::max(largest_rise, energy[n] - lowest);
            lowest = std::min(lowest, energy[n]);
        }
        loss.push_back((energy.front() - energy.back()) / swing);
        rise.push_back(largest_rise / swing);
    }
    const std::vector<double> orders = test::observed_orders(steps, loss);
    test::record("loss_of_swing", loss);
    test::record("rise_of_swing", rise);
    test::record("loss_orders", orders);
    for (const double r : rise) EXPECT_LT(r, 3e-4);
    EXPECT_LT(loss[0], 0.015);
    EXPECT_GT(loss.back(), 0.0);
    EXPECT_GT(orders.back(), 1.8);
    EXPECT_GT(test::observed_orders(steps, rise).back(), 1.0);
}

}  // namespace
}  // namespace myo::dynamics
