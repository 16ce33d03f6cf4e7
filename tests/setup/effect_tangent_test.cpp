#include <gtest/gtest.h>

#include <algorithm>

#include "effect/affected_tangent.hpp"
#include "effect/trial_context.hpp"
#include "sensitivity/tangent_run.hpp"
#include "setup/trial_effects.hpp"
#include "support/figures.hpp"

namespace myo::setup {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A beam that drops under its weight while a muscle lets go, at two of its nodes.
struct DroppedBeam {
    test::HeldBeam beam = test::held_beam({6, 2, 2});
    std::vector<int> nodes;

    DroppedBeam() {
        beam.affected.options.h_s = 0.004;
        beam.affected.options.end_s = 0.06;
        beam.affected.options.solver.tolerance = 1e-11;
        beam.affected.options.solver.tangent_tolerance = 1e-10;
        const int count = beam.affected.model.body->node_count();
        nodes = {count - 1, count / 2};
    }

    effect::EffectSearch search() const {
        effect::EffectSearch search;
        search.trials = {beam.context, beam.context};
        search.trials.front().session_time_s = 0.0;  // a drift shows between trials
        search.models = {beam.affected.model, beam.affected.model};
        search.largest_energy_density_J_m3 = 100.0;
        return search;
    }

    effect::Affected at(effect::EffectDeclaration effect, const EffectNumber& number, double value) const {
        set_effect_number(effect, number.parameter, number.component, value, number.base);
        return test::with_effect(beam, effect.id, effect.parameters);
    }

    /// Positions of the nodes after every step, one below the other.
    MatrixXd motion(const effect::Affected& affected) const {
        const dynamics::Trace trace = dynamics::simulate(affected.model, affected.options);
        EXPECT_TRUE(trace.complete()) << trace.message;
        MatrixXd result(3 * static_cast<Eigen::Index>(trace.positions.size()), static_cast<Eigen::Index>(nodes.size()));
        for (std::size_t k = 0; k < trace.positions.size(); ++k)
            result.middleRows<3>(3 * static_cast<Eigen::Index>(k)) = trace.positions[k](Eigen::all, nodes);
        return result;
    }

    MatrixXd difference(const effect::EffectDeclaration& effect, const EffectNumber& number, double value,
                        double step) const {
        return (motion(at(effect, number, value + step)) - motion(at(effect, number, value - step))) / (2.0 * step);
    }

    MatrixXd exact(const effect::EffectDeclaration& effect, const EffectNumber& number, double value,
                   double step) const {
        const effect::Affected between = at(effect, number, value);
        const auto tangent = effect::affected_tangent(at(effect, number, value - step), between,
                                                      at(effect, number, value + step), 2.0 * step);
        if (!tangent) return {};
        const sensitivity::SensitiveTrace run = sensitivity::simulate_with_tangents(between.model, between.options,
                                                                                    {*tangent}, nodes);
        EXPECT_TRUE(run.trace.complete()) << run.trace.message;
        MatrixXd result(3 * static_cast<Eigen::Index>(run.tangents[0].positions.size()),
                        static_cast<Eigen::Index>(nodes.size()));
        for (std::size_t k = 0; k < run.tangents[0].positions.size(); ++k)
            result.middleRows<3>(3 * static_cast<Eigen::Index>(k)) = run.tangents[0].positions[k];
        return result;
    }
};

/// Compares the tangent of the whole run along each number that a fit moves with differences of runs, extrapolated to
/// none; returns how many of the numbers moved the body. Keeps their relative errors.
/// @param difference  half of it, relative to the number's size
int compare_numbers(const DroppedBeam& dropped, const effect::EffectDeclaration& effect, double difference,
                    double tolerance, std::vector<double>& errors) {
    int compared = 0;
    for (const EffectNumber& number : effect_numbers(effect)) {
        const double value = effect_number(effect, number.parameter, number.component, number.base);
        const double size = number.over_decades ? std::max(std::abs(value), 0.05 * number.scale) : number.scale;
        const MatrixXd exact = dropped.exact(effect, number, value, 1e-4 * size);
        EXPECT_GT(exact.size(), 0) << number.name;
        if (exact.size() == 0) continue;
        const double step = difference * size;
        const MatrixXd wide = dropped.difference(effect, number, value, step),
                       narrow = dropped.difference(effect, number, value, 0.5 * step);
        const MatrixXd extrapolated = (4.0 * narrow - wide) / 3.0;
        const double least = 1e-6 /
                             size;  // a micrometre for a change that matters: some numbers of a probe move nothing
        EXPECT_LT((exact - extrapolated).norm(), tolerance * std::max(extrapolated.norm(), least))
            << number.name << " at " << value;
        if (!(extrapolated.norm() > least)) continue;
        errors.push_back((exact - extrapolated).norm() / extrapolated.norm());
        ++compared;
    }
    return compared;
}

TEST(EffectTangents, AreThoseOfTheWholeRunForEveryEffectOfTheCatalogue) {
    const DroppedBeam dropped;
    std::vector<double> errors;
    for (const effect::Effect& effect : effect::effect_catalogue()) {
        const std::vector<effect::EffectProbe> probes = effect.probes && effect.kind != effect::EffectKind::measurement
                                                            ? effect.probes(dropped.search())
                                                            : std::vector<effect::EffectProbe>{};
        if (probes.empty()) continue;
        int compared = 0;
        // The curvature by a delay jumps where a bend of the signal passes a step: a difference there is off in the
        // first order of its width.
        const bool jumps = effect.id == "actuation_delay";
        // The stiffness of a stop sets in within 0.05 mm, so that differences of the gap must be narrower.
        const bool narrow = jumps || effect.id == "end_stop";
        for (const effect::EffectProbe& probe : probes)
            compared += compare_numbers(dropped, {effect.id, probe.columns.back(), false}, narrow ? 0.001 : 0.01,
                                        jumps ? 1e-4 : 1e-5, errors);
        EXPECT_GT(compared, 0) << effect.id;
    }
    std::sort(errors.begin(), errors.end());
    test::record("numbers", static_cast<double>(errors.size()));
    test::record("median_relative_error", errors[errors.size() / 2]);
    test::record("worst_relative_error", errors.back());
}

/// What changes a run beyond the forces at a position: inertia, memory, shapes at rest, what is held and starts.
TEST(EffectTangents, HoldForEveryIntegratorFromAnEquilibriumAndWithAVelocityForce) {
    const std::vector<effect::EffectDeclaration> effects{
        {"point_mass", {{"mass_kg", 0.01}, {"position_m", VectorXd(Eigen::Vector3d(0.11, 0.01, 0.03))}}, false},
        {"hung_mass", {{"inertia_ratio", 0.5}}, false},
        {"viscoelastic_creep", {{"modulus_ratio", 0.3}, {"relaxation_time_s", 0.02}}, false},
        {"stress_softening", {{"damage_max", 0.4}, {"energy_scale_J_m3", 20.0}}, false},
        {"intrinsic_curvature", {{"curvature_1_m", 0.5}, {"axis", 2.0}}, false},
        {"clamp_compliance", {{"stiffness_Pa_per_m", 2e7}}, false},
        {"clamp_slip", {{"free_length_m", 0.006}}, false}};
    for (const dynamics::Integrator integrator :
         {dynamics::Integrator::tr_bdf2, dynamics::Integrator::implicit_euler, dynamics::Integrator::bdf2,
          dynamics::Integrator::trapezoidal, dynamics::Integrator::generalized_alpha})
        for (const dynamics::StartKind start : {dynamics::StartKind::straight, dynamics::StartKind::equilibrium}) {
            std::vector<double> errors;
            DroppedBeam dropped;
            dropped.beam.affected.options.integrator = integrator;
            dropped.beam.affected.options.start = start;
            dropped.beam.affected.options.end_s = 0.04;
            dropped.beam.affected.model.velocity_force_1_s = -2.0;
            for (const effect::EffectDeclaration& effect : effects) {
                SCOPED_TRACE(effect.id + ", " + to_string(integrator) +
                             (start == dynamics::StartKind::straight ? ", dropped" : ", from equilibrium"));
                // The equilibrium of softened cells is found to 1e-6 of their factors.
                const bool fixed_point = effect.id == "stress_softening" && start == dynamics::StartKind::equilibrium;
                EXPECT_GT(compare_numbers(dropped, effect, 0.01, fixed_point ? 1e-3 : 1e-5, errors), 0);
            }
        }
}

/// Its inertia joins and leaves with the force, within steps.
TEST(EffectTangents, OfABodyHungUpAndTakenDownWithinTheRunHoldForEveryIntegrator) {
    std::vector<double> errors;
    for (const dynamics::Integrator integrator :
         {dynamics::Integrator::tr_bdf2, dynamics::Integrator::implicit_euler, dynamics::Integrator::bdf2,
          dynamics::Integrator::trapezoidal, dynamics::Integrator::generalized_alpha}) {
        SCOPED_TRACE(to_string(integrator));
        DroppedBeam dropped;
        dropped.beam.affected.options.integrator = integrator;
        dropped.beam.affected.model.velocity_force_1_s = -2.0;
        dropped.beam.affected.model.forces.back().from_s = 0.0113;
        dropped.beam.affected.model.forces.back().until_s = 0.0391;
        EXPECT_EQ(compare_numbers(dropped, {"hung_mass", {{"inertia_ratio", 0.5}}, false}, 0.01, 1e-5, errors), 1);
    }
    test::record("relative_errors", errors);
}

}  // namespace
}  // namespace myo::setup
