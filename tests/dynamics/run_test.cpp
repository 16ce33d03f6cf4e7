#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>

#include "dynamics/simulate.hpp"
#include "dynamics/statics.hpp"
#include "model/force_element.hpp"
#include "support/beam.hpp"
#include "support/figures.hpp"

namespace myo::dynamics {
namespace {

using Eigen::Matrix3Xd;

test::BeamSpec hanging_beam(const char* element) {
    test::BeamSpec spec;
    spec.kind = test::element(element);
    spec.cells = spec.kind == fem::ElementKind::tet10 ? Eigen::Vector3i(4, 1, 1) : Eigen::Vector3i(7, 2, 2);
    spec.gravity_m_s2 = 9.81;
    return spec;
}

SimulationOptions options_for(Integrator integrator, double h, int steps) {
    SimulationOptions options;
    options.integrator = integrator;
    options.h_s = h;
    options.end_s = steps * h;
    return options;
}

bool all_finite(const Trace& trace) {
    for (const Matrix3Xd& x : trace.positions)
        if (!x.allFinite()) return false;
    for (const Matrix3Xd& v : trace.velocities)
        if (!v.allFinite()) return false;
    return trace.positions.size() == trace.times_s.size() && trace.velocities.size() == trace.times_s.size();
}

TEST(Run, ConvergesFromTheStraightBeamNearIncompressibilityForAllSteps) {
    for (const char* element : {"hex8", "tet10"})
        for (const Integrator integrator : {Integrator::tr_bdf2, Integrator::implicit_euler})
            for (const double damping : {0.0, 0.003}) {
                test::BeamSpec spec = hanging_beam(element);
                spec.damping_s = damping;
                for (const Strategy strategy : {Strategy::automatic, Strategy::newton}) {
                    std::vector<double> iterations;
                    for (const double h : {1e-4, 1e-3, 1e-2, 5e-2}) {
                        SimulationOptions options = options_for(integrator, h, 8);
                        options.solver.strategy = strategy;
                        // At 50 ms a change of the modulus in its last digits, or of the processor, moves the count by
                        // two to four: the median of several counts, measured between 15.75 and 16.75, with room.
                        std::vector<double> counts(h > 0.02 && strategy == Strategy::automatic ? 11 : 1);
                        for (std::size_t sample = 0; sample < counts.size(); ++sample) {
                            spec.youngs_modulus_Pa = hanging_beam(element).youngs_modulus_Pa *
                                                     (1.0 + 2e-15 * static_cast<double>(sample));
                            const Trace trace = simulate(test::make_beam(spec), options);
                            EXPECT_TRUE(trace.complete()) << element << " " << h << ": " << trace.message;
                            EXPECT_EQ(trace.times_s.size(), 9u);
                            EXPECT_TRUE(all_finite(trace));
                            counts[sample] = static_cast<double>(trace.newton_iterations) / trace.stages;
                        }
                        std::sort(counts.begin(), counts.end());
                        iterations.push_back(counts[counts.size() / 2]);
                        EXPECT_LT(iterations.back(), strategy == Strategy::newton ? 8.0 : 20.0)
                            << element << " " << to_string(integrator) << " " << h << " " << to_string(strategy);
                    }
                    const std::string name = std::string(element) + "_" + to_string(integrator) +
                                             (damping > 0.0 ? "_damped" : "");
                    test::record(name + "_iterations_per_stage_" + to_string(strategy), iterations);
                }
            }
}

TEST(Run, ReleasedFromEquilibriumUnderTheSameLoadsStaysThere) {
    for (const char* element : {"hex8", "tet10"}) {
        const model::Model model = test::make_beam(hanging_beam(element));
        SimulationOptions options = options_for(Integrator::tr_bdf2, 0.01, 10);
        options.start = StartKind::equilibrium;
        const Trace trace = simulate(model, options);
        ASSERT_TRUE(trace.complete()) << trace.message;
        const double sag = (trace.positions.front() - model.body->mesh.nodes).cwiseAbs().maxCoeff();
        EXPECT_GT(sag, 5e-3);
        for (const Matrix3Xd& x : trace.positions)
            EXPECT_LT((x - trace.positions.front()).cwiseAbs().maxCoeff(), 1e-6 * sag);
    }
}

/// A load that no step can follow: the run says so, and keeps what was complete and finite.
TEST(Run, SaysClearlyWhenItDoesNotConverge) {
    for (const Integrator integrator : {Integrator::tr_bdf2, Integrator::implicit_euler}) {
        const test::BeamSpec spec = hanging_beam("hex8");
        model::Model model = test::make_beam(spec);
        test::push_tip(model, spec, {-1e9, 0.0, 0.0});
        model.forces.back().from_s = 0.03;
        const Trace trace = simulate(model, options_for(integrator, 0.01, 10));
        EXPECT_EQ(trace.status, RunStatus::failed) << to_string(integrator);
        EXPECT_NE(trace.message.find("did not converge"), std::string::npos) << trace.message;
        EXPECT_NE(trace.message.find("t = 0.03"), std::string::npos) << trace.message;
        ASSERT_EQ(trace.times_s.size(), 4u);
        EXPECT_DOUBLE_EQ(trace.times_s.back(), 0.03);
        EXPECT_TRUE(all_finite(trace));
    }
    const test::BeamSpec spec = hanging_beam("hex8");
    model::Model model = test::make_beam(spec);
    test::push_tip(model, spec, {-1e9, 0.0, 0.0});
    StageSolver solver(model);
    Matrix3Xd x = model.body->mesh.nodes;
    const StageReport report = solve_equilibrium(solver, 0.0, x);
    EXPECT_FALSE(report.ok());
    EXPECT_NE(report.message.find("no equilibrium was found"), std::string::npos) << report.message;
    EXPECT_TRUE(x.allFinite());
}

/// What was sought, how far it got, and what helps a problem of statics: no step, no integrator.
TEST(Run, SaysWhatHelpsWhereThereIsNoEquilibrium) {
    test::BeamSpec spec = hanging_beam("hex8");
    spec.youngs_modulus_Pa = 1.0;
    SimulationOptions options = options_for(Integrator::tr_bdf2, 0.005, 2);
    options.start = StartKind::equilibrium;
    const Trace trace = simulate(test::make_beam(spec), options);
    ASSERT_EQ(trace.status, RunStatus::failed);
    for (const char* words :
         {"no equilibrium was found under gravity, the loads and the activations at the start: after ",
          "Check the units of the modulus (E = 1 Pa)", "smaller loads or a finer mesh may help"})
        EXPECT_NE(trace.message.find(words), std::string::npos) << trace.message;
    for (const char* words : {"step", "integrator", "did not converge"})
        EXPECT_EQ(trace.message.find(words), std::string::npos) << trace.message;
}

TEST(Run, IsIdenticalWhenRepeated) {
    test::BeamSpec spec = hanging_beam("hex8");
    spec.damping_s = 0.002;
    const model::Model model = test::make_beam(spec);
    const SimulationOptions options = options_for(Integrator::tr_bdf2, 0.005, 20);
    const Trace a = simulate(model, options), b = simulate(model, options);
    ASSERT_EQ(a.times_s, b.times_s);
    for (std::size_t n = 0; n < a.times_s.size(); ++n) {
        EXPECT_EQ(a.positions[n], b.positions[n]);
        EXPECT_EQ(a.velocities[n], b.velocities[n]);
    }
    EXPECT_EQ(a.factorisations, b.factorisations);
}

/// A run beside another one, of a body a little stiffer, that starts its stages there: the same motion within the
/// tolerance, in fewer iterations.
TEST(Run, NearAnotherItTakesFewerIterations) {
    for (const char* element : {"hex8", "tet10"}) {
        test::BeamSpec spec = hanging_beam(element);
        spec.damping_s = 0.003;
        SimulationOptions options = options_for(Integrator::tr_bdf2, 0.01, 40);
        options.solver.tolerance = 1e-6;
        options.keep_path = true;
        const Trace first = simulate(test::make_beam(spec), options);
        ASSERT_TRUE(first.complete());
        ASSERT_EQ(first.path->times_s.size(), 81u);  // the start, and two stages a step
        spec.youngs_modulus_Pa *= 1.01;
        options.keep_path = false;
        const Trace alone = simulate(test::make_beam(spec), options);
        options.warm_start = first.path;
        const Trace beside = simulate(test::make_beam(spec), options);
        ASSERT_TRUE(alone.complete() && beside.complete());
        EXPECT_EQ(beside.path, nullptr);
        const double moved = (alone.positions.back() - alone.positions.front()).norm();
        EXPECT_LT((alone.positions.back() - beside.positions.back()).norm(), 1e-5 * moved);
        test::record(std::string("iterations_") + element,
                     static_cast<double>(beside.newton_iterations) / alone.newton_iterations);
        EXPECT_LT(beside.newton_iterations, 0.8 * alone.newton_iterations) << element;
    }
}

TEST(Run, IsGivenUpWhereItTakesTooManyIterations) {
    SimulationOptions options = options_for(Integrator::tr_bdf2, 0.01, 20);
    const model::Model model = test::make_beam(hanging_beam("hex8"));
    const Trace whole = simulate(model, options);
    ASSERT_TRUE(whole.complete());
    options.max_iterations = whole.newton_iterations / 2;
    const Trace given_up = simulate(model, options);
    EXPECT_EQ(given_up.status, RunStatus::failed);
    EXPECT_NE(given_up.message.find("more than " + std::to_string(options.max_iterations) + " iterations"),
              std::string::npos)
        << given_up.message;
    EXPECT_LT(given_up.times_s.size(), whole.times_s.size());
    options.max_iterations = whole.newton_iterations;
    EXPECT_TRUE(simulate(model, options).complete());
}

TEST(Run, StopsAfterTheCurrentStepWhenCancelled) {
    const model::Model model = test::make_beam(hanging_beam("hex8"));
    std::atomic<bool> stop{false};
    int reports = 0;
    const Progress progress(
        [&](const ProgressEvent& event) {
            EXPECT_EQ(event.unit, "s");
            EXPECT_DOUBLE_EQ(event.total, 0.05);
            if (++reports == 3) stop = true;
        },
        &stop);
    const Trace trace = simulate(model, options_for(Integrator::tr_bdf2, 0.005, 10), progress);
    EXPECT_EQ(trace.status, RunStatus::cancelled);
    EXPECT_EQ(trace.times_s.size(), 4u);
    EXPECT_FALSE(trace.message.empty());
    EXPECT_TRUE(all_finite(trace));
}

/// No force, but a count of how often it is asked; at the `last` time the run is to be stopped.
class CountedForce : public model::ForceElement {
public:
    CountedForce(int last, std::atomic<bool>& stop, std::atomic<int>& asked)
        : last_(last), stop_(stop), asked_(asked) {}
    void add(const model::Body&, const model::ForceState&, model::HessianKind, model::InternalEnergy&) const override {
        if (++asked_ == last_) stop_ = true;
    }
    std::vector<model::ForceParameter> parameters() const override { return {}; }
    std::shared_ptr<const model::ForceElement> changed(const Eigen::VectorXd&) const override {
        return std::make_shared<CountedForce>(last_, stop_, asked_);
    }
    void add_tangent(const model::Body&, const model::ForceState&, const Eigen::VectorXd&, Matrix3Xd&) const override {}

private:
    int last_;
    std::atomic<bool>& stop_;
    std::atomic<int>& asked_;
};

/// Steps of large bodies take seconds: a run that is stopped does not finish the one it is in, nor halves it.
TEST(Run, StopsWithinAStepOrTheStart) {
    for (const StartKind start : {StartKind::straight, StartKind::equilibrium})
        for (const Strategy strategy : {Strategy::lagged_newton, Strategy::newton, Strategy::projective}) {
            const auto run = [&](int last) {
                std::atomic<bool> stop{false};
                std::atomic<int> asked{0};
                model::Model model = test::make_beam(hanging_beam("hex8"));
                model.force_elements.push_back(std::make_shared<CountedForce>(last, stop, asked));
                SimulationOptions options = options_for(Integrator::tr_bdf2, 0.01, 3);
                options.start = start;
                options.solver.strategy = strategy;
                const Trace trace = simulate(model, options, Progress({}, &stop));
                return std::pair(trace, asked.load());
            };
            const int whole = run(-1).second;
            for (int last = 1; last < whole; last += 1 + whole / 17) {
                const auto [trace, asked] = run(last);
                if (trace.complete())
                    EXPECT_GE(last, whole - 4) << "the run was at its end";
                else
                    EXPECT_EQ(trace.status, RunStatus::cancelled) << trace.message;
                EXPECT_LE(asked - last, 2) << last << " of " << whole;
                EXPECT_TRUE(all_finite(trace));
            }
        }
}

TEST(Run, IntegratorNamesGoThereAndBack) {
    for (const std::string& id : integrator_ids()) {
        Integrator integrator{};
        ASSERT_TRUE(parse_integrator(id, integrator));
        EXPECT_EQ(to_string(integrator), id);
    }
    Integrator integrator{};
    EXPECT_FALSE(parse_integrator("euler", integrator));
    EXPECT_EQ(SimulationOptions{}.integrator, Integrator::tr_bdf2);
}

}  // namespace
}  // namespace myo::dynamics
