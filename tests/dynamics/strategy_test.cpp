#include <gtest/gtest.h>

#include "base/parallel.hpp"
#include "dynamics/simulate.hpp"
#include "support/beam.hpp"
#include "support/figures.hpp"
#include "support/run.hpp"

namespace myo::dynamics {
namespace {

Trace run(const model::Model& model, Strategy strategy, Integrator integrator, double tolerance) {
    SimulationOptions options;
    options.integrator = integrator;
    options.h_s = 0.01;
    options.end_s = 0.2;
    options.solver.strategy = strategy;
    options.solver.tolerance = tolerance;
    Trace trace = simulate(model, options);
    EXPECT_TRUE(trace.complete()) << to_string(strategy) << ": " << trace.message;
    return trace;
}

TEST(Strategies, GiveTheSameTrajectory) {
    struct Case {
        const char* element;
        const char* material;
        double poisson, damping_s;
    };
    for (const Case& c : {Case{"hex8", "neo_hookean", 0.499, 0.003}, Case{"tet10", "neo_hookean", 0.49, 0.0},
                          Case{"hex8_full", "projective_corotational", 0.499, 0.0},
                          Case{"tet4", "corotational", 0.45, 0.0}, Case{"hex8", "st_venant_kirchhoff", 0.45, 0.003}})
        for (const Integrator integrator : {Integrator::tr_bdf2, Integrator::implicit_euler}) {
            test::BeamSpec spec;
            ASSERT_TRUE(fem::parse_element(c.element, spec.kind));
            spec.material = c.material;
            spec.poissons_ratio = c.poisson;
            spec.damping_s = c.damping_s;
            spec.cells = {6, 2, 2};
            spec.gravity_m_s2 = 9.81;
            const model::Model model = test::make_beam(spec);
            const Trace newton = run(model, Strategy::newton, integrator, 1e-9);
            for (const Strategy strategy : {Strategy::automatic, Strategy::lagged_newton, Strategy::projective}) {
                const double found = test::relative_difference(newton, run(model, strategy, integrator, 1e-9));
                test::record(std::string(c.element) + "_" + to_string(integrator) + "_" + to_string(strategy), found);
                EXPECT_LT(found, 1e-6) << c.element << " " << c.material << " " << to_string(integrator) << " "
                                       << to_string(strategy);
            }
        }
}

TEST(Strategies, TheLaggedFactorServesManySteps) {
    test::BeamSpec spec;
    spec.cells = {10, 3, 3};
    spec.gravity_m_s2 = 9.81;
    spec.damping_s = 0.003;
    const model::Model model = test::make_beam(spec);
    const Trace lagged = run(model, Strategy::lagged_newton, Integrator::tr_bdf2, 1e-7);
    const Trace newton = run(model, Strategy::newton, Integrator::tr_bdf2, 1e-7);
    test::record("factorisations_per_stage", {static_cast<double>(lagged.factorisations) / lagged.stages,
                                              static_cast<double>(newton.factorisations) / newton.stages});
    EXPECT_LT(lagged.factorisations, newton.factorisations);
    EXPECT_LT(lagged.factorisations, lagged.stages / 2);
}

/// Sums are taken in an order that the mesh gives, so that threads change no bit of a run.
TEST(Strategies, GiveTheSameBitsOnAnyNumberOfThreads) {
    for (const fem::ElementKind kind :
         {fem::ElementKind::hex8, fem::ElementKind::hex8_full, fem::ElementKind::tet4, fem::ElementKind::tet10})
        for (const Strategy strategy : {Strategy::lagged_newton, Strategy::newton, Strategy::projective}) {
            test::BeamSpec spec;
            spec.kind = kind;
            spec.cells = kind == fem::ElementKind::tet10 ? Eigen::Vector3i(8, 3, 3)
                                                         : Eigen::Vector3i(16, 5, 5);  // enough for several threads
            spec.gravity_m_s2 = 9.81;
            spec.damping_s = 0.003;
            if (kind == fem::ElementKind::hex8_full) spec.material = "projective_corotational";
            const model::Model model = test::make_beam(spec);
            SimulationOptions options;
            options.h_s = 0.01;
            options.end_s = 0.03;
            options.solver.strategy = strategy;
            const auto on = [&](int threads) {
                Trace trace;
                parallel_tasks(1, threads, [&](int) { trace = simulate(model, options); });
                EXPECT_TRUE(trace.complete()) << trace.message;
                return trace;
            };
            const Trace one = on(1);
            for (const int threads : {2, 4}) {
                const Trace many = on(threads);
                EXPECT_EQ(many.newton_iterations, one.newton_iterations);
                EXPECT_TRUE((many.positions.back().array() == one.positions.back().array()).all())
                    << to_string(kind) << " " << to_string(strategy) << " " << threads;
            }
        }
}

/// A body too large for one factor is factored in parts; its motion is the same.
TEST(Strategies, PartsGiveTheSameTrajectoryAsTheWholeFactor) {
    test::BeamSpec spec;
    spec.cells = {40, 13, 13};  // 24 thousand unknowns: two parts
    spec.gravity_m_s2 = 9.81;
    spec.damping_s = 0.003;
    const model::Model model = test::make_beam(spec);
    SimulationOptions options;
    options.h_s = 0.01;
    options.end_s = 0.02;
    options.solver.tolerance = 1e-8;
    const Trace whole = simulate(model, options);
    options.solver.max_factor_entries = 1e6;
    const Trace parts = simulate(model, options);
    ASSERT_TRUE(whole.complete() && parts.complete()) << parts.message;
    test::record("conjugate_gradients_per_newton_step",
                 static_cast<double>(parts.linear_iterations) / parts.newton_iterations);
    EXPECT_EQ(whole.linear_iterations, 0);
    EXPECT_GT(parts.linear_iterations, 0);
    EXPECT_LT(test::relative_difference(whole, parts), 1e-6);
}

TEST(Strategies, NamesAreFoundAgain) {
    for (const std::string& id : strategy_ids()) {
        Strategy strategy{};
        ASSERT_TRUE(parse_strategy(id, strategy));
        EXPECT_EQ(to_string(strategy), id);
    }
    Strategy unused{};
    EXPECT_FALSE(parse_strategy("newton_raphson", unused));
}

}  // namespace
}  // namespace myo::dynamics
