#include <gtest/gtest.h>

#include <cmath>

#include "fibre/switches.hpp"
#include "support/beam.hpp"
#include "support/figures.hpp"
#include "support/run.hpp"

namespace myo::dynamics {
namespace {

using Eigen::Matrix3Xd;

constexpr double duration_s = 0.16;

model::Model muscled_beam() {
    test::BeamSpec spec;
    spec.damping_s = 0.004;
    model::Model model = test::make_beam(spec);
    auto fibres = std::make_shared<std::vector<fibre::FibreGroup>>();
    fibres->push_back(fibre::fibres_in_box(model.body->mesh, Box{{0, 0, 0.02}, {0.1, 0.03, 0.03}},
                                           Eigen::Vector3d::UnitX(), 1e5, "top"));
    model.fibres = fibres;
    return model;
}

/// Displacements every 10 ms, one column each.
Eigen::MatrixXd motion(const fibre::Signal& signal, double h) {
    model::Model model = muscled_beam();
    model.activation = {signal};
    const Trace trace = test::run(model, Integrator::tr_bdf2, h, duration_s);
    const Matrix3Xd& rest = model.body->mesh.nodes;
    Eigen::MatrixXd columns(rest.size(), 16);
    for (std::size_t k = 0; k < trace.times_s.size(); ++k) {
        const double t = trace.times_s[k] / 0.01;
        if (t > 0.5 && std::abs(t - std::round(t)) < 1e-9)
            columns.col(std::lround(t) - 1) = (trace.positions[k] - rest).reshaped();
    }
    return columns;
}

/// Errors at 5, 2.5 and 1.25 ms, relative to the motion.
std::vector<double> errors(const auto& signal_at, const Eigen::MatrixXd& exact, const std::string& name) {
    std::vector<double> list;
    for (const double h : {0.005, 0.0025, 0.00125})
        list.push_back((motion(signal_at(h), h) - exact).norm() / exact.norm());
    test::record(name, list);
    return list;
}

void expect_second_order(const std::vector<double>& list) {
    for (std::size_t k = 1; k < list.size(); ++k) {
        EXPECT_GT(list[k - 1] / list[k], 3.3) << k;
        EXPECT_LT(list[k - 1] / list[k], 4.7) << k;
    }
}

/// A rise within a step is as exact as a jump; sampled, it errs by the first power of the step and ten times as much.
TEST(Switching, ErrsByTheSquareOfTheStepLikeAJump) {
    const fibre::Signal rise{{0.0, 0.05, 0.050001}, {1.0, 1.0, 0.85}};
    const Eigen::MatrixXd exact = motion(fibre::Signal::step(0.05, 1.0, 0.85), 1.5625e-4);
    const std::vector<double> jump = errors([](double) { return fibre::Signal::step(0.05, 1.0, 0.85); }, exact, "jump");
    const std::vector<double> switched = errors([&](double h) { return fibre::with_switches_as_jumps(rise, h); }, exact,
                                                "switched");
    const std::vector<double> sampled = errors([&](double) { return rise; }, exact, "sampled");
    expect_second_order(switched);
    for (std::size_t k = 0; k < jump.size(); ++k) EXPECT_NEAR(switched[k] / jump[k], 1.0, 0.01) << k;
    EXPECT_GT(sampled[2], 10.0 * switched[2]);
}

/// Open, closed and half open again, logged at 1 kHz: rises of a millisecond anywhere between the steps.
TEST(Switching, OfALoggedValveErrsByTheSquareOfTheStep) {
    fibre::Signal log{{}, {}};
    for (int k = 0; k <= 160; ++k) {
        log.times_s.push_back(1e-3 * k);
        log.values.push_back(k < 34 ? 1.0 : k < 67 ? 0.85 : k < 103 ? 1.0 : 0.92);
    }
    const Eigen::MatrixXd exact = motion(log, 1.25e-4);  // its bends are ends of steps
    const std::vector<double> switched = errors([&](double h) { return fibre::with_switches_as_jumps(log, h); }, exact,
                                                "valve");
    expect_second_order(switched);
    const std::vector<double> sampled = errors([&](double) { return log; }, exact, "valve_sampled");
    EXPECT_GT(sampled[0], 2.0 * switched[0]);
}

}  // namespace
}  // namespace myo::dynamics
