#include "sensitivity/adjoint_run.hpp"

#include <gtest/gtest.h>

#include <string>

#include "fibre/switches.hpp"
#include "sensitivity/driven_beam.hpp"
#include "sensitivity/gradient_check.hpp"
#include "sensitivity/run_parts.hpp"
#include "sensitivity/tangent_run.hpp"
#include "support/differences.hpp"
#include "support/figures.hpp"

namespace myo::sensitivity {
namespace {

using test::driven_beam;
using test::rough_loss;
using test::short_run;

struct Case {
    fem::ElementKind kind;
    dynamics::TimeScheme integrator;
    dynamics::StartKind start;
    dynamics::Strategy strategy = dynamics::Strategy::automatic;
    const char* material = "neo_hookean";
};

class AdjointRun : public testing::TestWithParam<Case> {};

TEST_P(AdjointRun, EqualsCentralDifferencesForEveryParameter) {
    const auto [kind, integrator, start, strategy, material] = GetParam();
    const model::Model model = driven_beam(kind, material);
    dynamics::SimulationOptions options = short_run(integrator, start);
    options.solver.strategy = strategy;
    options.initial.velocities = 0.05 * test::rough_field(model.body->node_count(), 0.4);
    const std::vector<CheckedParameter> parameters = checked_parameters(model, options);
    EXPECT_GE(parameters.size(), 19u);
    const GradientCheck check = check_gradient(model, options, rough_loss(model), parameters);
    ASSERT_TRUE(check.complete()) << check.message;
    bool identical = true;
    for (const GradientCheckRow& row : check.rows) {
        EXPECT_NE(row.adjoint, 0.0) << row.name;
        EXPECT_LT(row.relative_error, 1e-5)
            << row.name << ": adjoint " << row.adjoint << ", difference " << row.difference;
        identical = identical && row.adjoint == row.difference;
    }
    EXPECT_FALSE(identical);
    EXPECT_LT(check.median_error(), 1e-6);
    test::record("median_error", check.median_error());
    test::record("worst_error", check.worst_error());
}

/// Half of the beam is held: the middle cell says nothing, and what has no influence is no error.
TEST(GradientCheckOfAHeldBody, AsksCellsThatCanDeform) {
    model::Model model = driven_beam(fem::ElementKind::hex8);
    const mesh::VolumeMesh mesh = model.body->mesh;
    std::vector<int> held;
    for (int i = 0; i < model.body->node_count(); ++i)
        if (mesh.nodes(0, i) < 0.7 * mesh.nodes.row(0).maxCoeff()) held.push_back(i);
    model.body = model::make_body(mesh, fem::ElementKind::hex8, held);
    const dynamics::SimulationOptions options = short_run(dynamics::Integrator::tr_bdf2, dynamics::StartKind::straight);
    std::vector<CheckedParameter> parameters = checked_parameters(model, options);
    parameters.push_back({"mu of a held cell", 1e-3 * model.moduli[0].mu,
                          [](model::Model& m, dynamics::SimulationOptions&, double by) { m.moduli[0].mu += by; },
                          [](const ModelGradient& g) { return g.moduli[0].mu; }});
    const GradientCheck check = check_gradient(model, options, rough_loss(model), parameters);
    ASSERT_TRUE(check.complete()) << check.message;
    for (const GradientCheckRow& row : check.rows)
        if (row.name.find("mu of cell") == 0) {
            EXPECT_NE(row.adjoint, 0.0) << row.name;
        }
    EXPECT_LT(check.worst_error(), 1e-5);
}

/// Along E, damping, the level of a signal and the parameters of the law, where tangents exist.
TEST_P(AdjointRun, EqualsTheTangents) {
    const auto [kind, integrator, start, strategy, material] = GetParam();
    model::Model model = driven_beam(kind, material);
    model.activation.front() = fibre::Signal::step(0.0, 1.0, 0.9);
    dynamics::SimulationOptions options = short_run(integrator, start);
    options.solver.strategy = strategy;
    options.solver.tangent_tolerance = 1e-12;
    const LossOfMotion loss = rough_loss(model);
    AdjointOptions adjoint;
    adjoint.tolerance = 1e-12;
    const GradientRun run = simulate_with_gradient(model, options, loss, adjoint);
    ASSERT_TRUE(run.complete()) << run.message;
    ModelTangent level;
    level.activation = {fibre::Signal::step(0.0, 0.0, 1.0), fibre::Signal::constant(0.0)};
    std::vector<ModelTangent> along_parameters{youngs_modulus_tangent(model, 2.6e5), damping_tangent(), level};
    std::vector<double> expected{young_gradient(model, run.gradient).youngs_modulus_Pa, run.gradient.damping_s,
                                 run.gradient.activation[0][1]};
    for (std::size_t k = 0; k < model.material->parameters().size(); ++k) {
        along_parameters.push_back(law_tangent(k));
        expected.push_back(run.gradient.law.at(k));
    }
    const SensitiveTrace tangents = simulate_with_tangents(model, options, along_parameters, loss.nodes);
    const MotionLoss derivative = loss.evaluate(run.motion);
    for (std::size_t p = 0; p < expected.size(); ++p) {
        const double along = test::along(derivative, tangents.tangents[p]);
        EXPECT_NE(along, 0.0);
        EXPECT_NEAR(expected[p] / along, 1.0, 1e-8) << "parameter " << p;
    }
}

/// One count for the way there and back: it grows to its total, also where a run in parts repeats some of its steps.
TEST(GradientRun, CountsItsStepsForwardsAndBackwards) {
    const model::Model model = driven_beam(fem::ElementKind::hex8);
    dynamics::SimulationOptions options = short_run(dynamics::Integrator::tr_bdf2, dynamics::StartKind::straight);
    options.end_s = 0.15;
    const LossOfMotion loss = rough_loss(model);
    const double whole_bytes = simulate_with_gradient(model, options, loss).tape_bytes;
    for (const double budget : {whole_bytes, 0.8 * whole_bytes}) {
        std::vector<ProgressEvent> seen;
        AdjointOptions adjoint;
        adjoint.memory_bytes = budget;
        const GradientRun run = simulate_with_gradient(model, options, loss, adjoint,
                                                       Progress([&](const auto& event) { seen.push_back(event); }));
        ASSERT_TRUE(run.complete()) << run.message;
        ASSERT_GT(seen.size(), 2u);
        for (std::size_t k = 1; k < seen.size(); ++k) {
            EXPECT_EQ(seen[k].task, seen[0].task);
            EXPECT_EQ(seen[k].total, 2.0 * run.steps);
            EXPECT_GE(seen[k].done, seen[k - 1].done);
        }
        EXPECT_LT(seen.front().done, run.steps);
        EXPECT_EQ(seen.back().done, seen.back().total);
    }
}

/// A rise within a step is a jump; its levels and those beside it are differentiated like any other knot's.
TEST(GradientRun, IsExactForASignalThatSwitches) {
    model::Model model = driven_beam(fem::ElementKind::hex8);
    model.activation.front() = fibre::with_switches_as_jumps(
        {{0.0, 0.011, 0.012, 0.02, 0.021, 0.03}, {0.95, 0.97, 0.85, 0.9, 1.05, 1.0}}, 0.005);
    ASSERT_EQ(model.activation.front().jumps().size(), 2u);
    const dynamics::SimulationOptions options = short_run(dynamics::Integrator::tr_bdf2,
                                                          dynamics::StartKind::equilibrium);
    const LossOfMotion loss = rough_loss(model);
    const GradientRun run = simulate_with_gradient(model, options, loss);
    ASSERT_TRUE(run.complete()) << run.message;
    const std::vector<double>& values = model.activation.front().values;
    const auto loss_of = [&](const Eigen::VectorXd& knots) {
        model::Model changed = model;
        changed.activation.front().values.assign(knots.begin(), knots.end());
        return Eigen::VectorXd::Constant(1, simulate_with_gradient(changed, options, loss).loss);
    };
    const Eigen::VectorXd here = Eigen::Map<const Eigen::VectorXd>(values.data(),
                                                                   static_cast<Eigen::Index>(values.size()));
    const Eigen::MatrixXd differences = test::central_differences(loss_of, here, 1e-4);
    const std::vector<double>& exact = run.gradient.activation.front();
    test::expect_derivative(Eigen::Map<const Eigen::RowVectorXd>(exact.data(), here.size()), differences, 1e-5,
                            "knots");
}

std::string case_name(const testing::TestParamInfo<Case>& info) {
    const Case& c = info.param;
    return to_string(c.kind) + "_" + to_string(c.integrator.integrator) +
           std::to_string(std::lround(10.0 * c.integrator.rho_inf)) +
           (c.start == dynamics::StartKind::equilibrium ? "_equilibrium_" : "_straight_") + to_string(c.strategy) +
           "_" + c.material;
}

INSTANTIATE_TEST_SUITE_P(
    All, AdjointRun,
    testing::Values(
        Case{fem::ElementKind::hex8, dynamics::Integrator::tr_bdf2, dynamics::StartKind::straight},
        Case{fem::ElementKind::hex8, dynamics::Integrator::tr_bdf2, dynamics::StartKind::equilibrium},
        Case{fem::ElementKind::hex8, dynamics::Integrator::implicit_euler, dynamics::StartKind::straight,
             dynamics::Strategy::newton},
        Case{fem::ElementKind::hex8, dynamics::Integrator::bdf2, dynamics::StartKind::equilibrium},
        Case{fem::ElementKind::hex8, dynamics::Integrator::trapezoidal, dynamics::StartKind::straight},
        Case{fem::ElementKind::hex8, dynamics::Integrator::generalized_alpha, dynamics::StartKind::straight},
        Case{fem::ElementKind::hex8_full, dynamics::Integrator::implicit_euler, dynamics::StartKind::straight,
             dynamics::Strategy::projective, "projective_corotational"},
        Case{fem::ElementKind::hex8_full, dynamics::Integrator::tr_bdf2, dynamics::StartKind::straight,
             dynamics::Strategy::lagged_newton, "corotational"},
        Case{fem::ElementKind::hex8_mean_dilatation, dynamics::Integrator::tr_bdf2, dynamics::StartKind::straight,
             dynamics::Strategy::lagged_newton, "st_venant_kirchhoff"},
        Case{fem::ElementKind::hex8, dynamics::Integrator::tr_bdf2, dynamics::StartKind::straight,
             dynamics::Strategy::automatic, "gent"},
        Case{fem::ElementKind::tet10, dynamics::Integrator::tr_bdf2, dynamics::StartKind::equilibrium,
             dynamics::Strategy::automatic, "mooney_rivlin"},
        Case{fem::ElementKind::tet10, {dynamics::Integrator::generalized_alpha, 0.2}, dynamics::StartKind::equilibrium},
        Case{fem::ElementKind::tet10, dynamics::Integrator::bdf2, dynamics::StartKind::straight,
             dynamics::Strategy::newton},
        Case{fem::ElementKind::tet4, dynamics::Integrator::implicit_euler, dynamics::StartKind::equilibrium}),
    case_name);

bool same(const ModelGradient& a, const ModelGradient& b) {
    for (std::size_t c = 0; c < a.moduli.size(); ++c)
        if (a.moduli[c].mu != b.moduli[c].mu || a.moduli[c].kappa != b.moduli[c].kappa) return false;
    return a.damping_s == b.damping_s && a.density_kg_m3 == b.density_kg_m3 &&
           a.velocity_force_1_s == b.velocity_force_1_s && a.activation == b.activation &&
           a.initial_positions == b.initial_positions && a.initial_velocities == b.initial_velocities &&
           a.forces_N == b.forces_N;
}

TEST(GradientRun, IsTheSameEveryTimeAndItsMotionThatOfTheRun) {
    const model::Model model = driven_beam(fem::ElementKind::hex8);
    const dynamics::SimulationOptions options = short_run(dynamics::Integrator::tr_bdf2, dynamics::StartKind::straight);
    const LossOfMotion loss = rough_loss(model);
    const GradientRun first = simulate_with_gradient(model, options, loss),
                      second = simulate_with_gradient(model, options, loss);
    ASSERT_TRUE(first.complete() && second.complete());
    EXPECT_TRUE(same(first.gradient, second.gradient));
    const dynamics::Trace trace = dynamics::simulate(model, options);
    EXPECT_EQ(first.motion.times_s, trace.times_s);
    EXPECT_EQ(first.motion.positions, trace.positions);
    EXPECT_EQ(first.motion.velocities, trace.velocities);
    EXPECT_EQ(first.loss, loss.evaluate({trace.times_s, trace.positions, trace.velocities}).value);
}

/// What a budget cuts away is made again: the same gradient up to the stages' tolerance.
TEST(GradientRun, OfARunInPartsIsThatOfTheWhole) {
    const model::Model model = driven_beam(fem::ElementKind::hex8);
    for (const dynamics::Integrator integrator :
         {dynamics::Integrator::tr_bdf2, dynamics::Integrator::bdf2, dynamics::Integrator::generalized_alpha}) {
        dynamics::SimulationOptions options = short_run(integrator, dynamics::StartKind::straight);
        options.end_s = 0.25;
        options.solver.tolerance = 1e-11;
        const LossOfMotion loss = rough_loss(model);
        AdjointOptions adjoint;
        adjoint.tolerance = 1e-11;
        const GradientRun whole = simulate_with_gradient(model, options, loss, adjoint);
        ASSERT_TRUE(whole.complete()) << whole.message;
        EXPECT_EQ(whole.parts, 1);
        adjoint.memory_bytes = 0.8 * whole.tape_bytes;
        const GradientRun cut = simulate_with_gradient(model, options, loss, adjoint);
        ASSERT_TRUE(cut.complete()) << cut.message;
        EXPECT_GT(cut.parts, 1);
        EXPECT_LE(cut.tape_bytes, adjoint.memory_bytes);
        EXPECT_EQ(cut.motion.times_s, whole.motion.times_s);
        EXPECT_NEAR(young_gradient(model, cut.gradient).youngs_modulus_Pa /
                        young_gradient(model, whole.gradient).youngs_modulus_Pa,
                    1.0, 1e-7);
        EXPECT_NEAR(cut.gradient.damping_s / whole.gradient.damping_s, 1.0, 1e-7);
        EXPECT_LT((cut.gradient.initial_velocities - whole.gradient.initial_velocities).norm(),
                  1e-7 * whole.gradient.initial_velocities.norm());
        adjoint.memory_bytes = 1e4;
        const GradientRun refused = simulate_with_gradient(model, options, loss, adjoint);
        EXPECT_EQ(refused.status, dynamics::RunStatus::failed);
        EXPECT_NE(refused.message.find("MB"), std::string::npos);
    }
}

/// Run again from where it was cut, a part repeats itself to the last bit, and a tape gives back the states it did not
/// keep.
TEST(GradientRun, RepeatsPartsAndStatesExactly) {
    const model::Model model = driven_beam(fem::ElementKind::hex8);
    dynamics::SimulationOptions options = short_run(dynamics::Integrator::generalized_alpha,
                                                    dynamics::StartKind::straight);
    options.end_s = 0.1;
    std::vector<dynamics::RunPoint> points;
    RunTape tape(3, true);
    const auto run_from = [&](const dynamics::RunPoint* from, bool taped) {
        dynamics::StageSolver solver(model, options.solver);
        dynamics::RunPart part;
        part.from = from;
        dynamics::RunObserver observer;
        if (taped) tape.record(observer);
        observer.reached = [&points, hung = observer.reached](const dynamics::RunPoint& point) {
            if (hung) hung(point);
            points.push_back(point);
        };
        EXPECT_TRUE(dynamics::simulate_part(solver, options, part, {}, observer).complete());
        return std::exchange(points, {});
    };
    const std::vector<dynamics::RunPoint> whole = run_from(nullptr, true);
    const std::vector<dynamics::RunPoint> once = run_from(&whole[7], false), twice = run_from(&whole[7], false);
    ASSERT_EQ(once.size(), whole.size() - 7);
    for (std::size_t k = 0; k < once.size(); ++k) {
        EXPECT_EQ(once[k].state.x, twice[k].state.x);
        EXPECT_EQ(once[k].state.force_lag, twice[k].state.force_lag);
        EXPECT_EQ(once[k].state.rate, twice[k].state.rate);
        EXPECT_LT((once[k].state.x - whole[k + 7].state.x).cwiseAbs().maxCoeff(), 1e-9);
    }
    dynamics::StageSolver solver(model, options.solver);
    for (std::size_t k = whole.size() - 1; !tape.empty();)
        for (std::vector<StepRecord> records = tape.take_last(solver); !records.empty(); records.pop_back()) {
            const dynamics::Kinematics &again = records.back().start, &then = whole[--k].state;
            EXPECT_EQ(again.x, then.x);
            EXPECT_EQ(again.v, then.v);
            EXPECT_EQ(again.force, then.force);
            EXPECT_EQ(again.v_lag, then.v_lag);
            EXPECT_EQ(again.force_lag, then.force_lag);
        }
}

TEST(RunParts, FitTheBudgetAndLeaveNoStepOut) {
    const TapeBytes cost{10.0, 30.0, 50.0};
    for (const int steps : {1, 2, 7, 160, 1000}) {
        const Result<RunParts> whole = plan_parts(steps, cost, 1e9);
        ASSERT_TRUE(whole);
        EXPECT_EQ(whole->parts, 1);
        for (double budget = whole->bytes; budget > 100.0; budget *= 0.9) {
            const Result<RunParts> plan = plan_parts(steps, cost, budget);
            if (!plan) break;
            EXPECT_LE(plan->bytes, budget);
            EXPECT_GE(plan->parts * plan->steps_per_part, steps);
            EXPECT_LT((plan->parts - 1) * plan->steps_per_part, steps);
        }
    }
    // Twice as many steps need about root 2 as much.
    double least = 1e9;
    while (plan_parts(1000, cost, 0.99 * least)) least *= 0.99;
    EXPECT_LT(least, 0.25 * plan_parts(1000, cost, 1e9)->bytes);
}

}  // namespace
}  // namespace myo::sensitivity
