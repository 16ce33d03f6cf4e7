#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numeric>

#include "sensitivity/driven_beam.hpp"

namespace myo::sensitivity {
namespace {

using Eigen::Matrix3Xd;

struct CreepCase {
    fem::ElementKind kind;
    dynamics::TimeScheme integrator;
    dynamics::StartKind start;
    double damping_s;
};

class CreepTangents : public testing::TestWithParam<CreepCase> {};

/// Modulus, damping and a level of actuation, over jumps of loads and signals.
TEST_P(CreepTangents, EqualCentralDifferencesOfTheDiscreteMotion) {
    const auto [kind, integrator, start, damping] = GetParam();
    model::Model model = test::driven_beam(kind);
    model.damping_s = damping;
    model.creep = material::MaxwellBranch{0.6, 0.02};
    const dynamics::SimulationOptions options = test::short_run(integrator, start);
    const double E = 2.6e5;
    const auto with_level = [](model::Model m, double by) {
        m.activation[0].values[1] += by;
        return m;
    };
    ModelTangent level;
    level.activation = {model.activation[0], model.activation[1]};
    for (fibre::Signal& signal : level.activation) std::fill(signal.values.begin(), signal.values.end(), 0.0);
    level.activation[0].values[1] = 1.0;
    const std::vector<std::pair<double, std::function<model::Model(double)>>> parameters = {
        {26.0,
         [&](double by) {
             model::Model m = model;
             for (material::Moduli& moduli : m.moduli)
                 moduli = {moduli.mu * (1.0 + by / E), moduli.kappa * (1.0 + by / E)};
             return m;
         }},
        {3e-6,
         [&](double by) {
             model::Model m = model;
             m.damping_s += by;
             return m;
         }},
        {1e-4, [&](double by) { return with_level(model, by); }},
    };
    std::vector<int> nodes(static_cast<std::size_t>(model.body->node_count()));
    std::iota(nodes.begin(), nodes.end(), 0);
    const SensitiveTrace run = simulate_with_tangents(
        model, options, {youngs_modulus_tangent(model, E), damping_tangent(), level}, nodes);
    ASSERT_TRUE(run.trace.complete()) << run.trace.message;
    for (std::size_t p = 0; p < parameters.size(); ++p) {
        const auto& [step, shifted] = parameters[p];
        const dynamics::Trace up = dynamics::simulate(shifted(step), options),
                              down = dynamics::simulate(shifted(-step), options);
        double error = 0.0, size = 0.0;
        bool identical = true;
        for (std::size_t k = 0; k < up.positions.size(); ++k) {
            const Matrix3Xd difference = (up.positions[k] - down.positions[k]) / (2.0 * step);
            error += (difference - run.tangents[p].positions[k]).squaredNorm();
            size += difference.squaredNorm();
            identical = identical && difference == run.tangents[p].positions[k];
        }
        EXPECT_GT(size, 0.0);
        EXPECT_LT(std::sqrt(error / size), 1e-5) << "parameter " << p;
        EXPECT_FALSE(identical);
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, CreepTangents,
    testing::Values(
        CreepCase{fem::ElementKind::hex8, dynamics::Integrator::tr_bdf2, dynamics::StartKind::straight, 0.003},
        CreepCase{fem::ElementKind::hex8, dynamics::Integrator::tr_bdf2, dynamics::StartKind::equilibrium, 0.003},
        CreepCase{fem::ElementKind::hex8, dynamics::Integrator::bdf2, dynamics::StartKind::equilibrium, 0.001},
        CreepCase{fem::ElementKind::hex8, dynamics::Integrator::generalized_alpha, dynamics::StartKind::straight,
                  0.003},
        CreepCase{fem::ElementKind::tet10, dynamics::Integrator::tr_bdf2, dynamics::StartKind::equilibrium, 0.001},
        CreepCase{fem::ElementKind::hex8_mean_dilatation, dynamics::Integrator::implicit_euler,
                  dynamics::StartKind::straight, 0.001}));

/// With the factors held, which they are exactly where nothing softens any more or nothing has begun to.
TEST(SofteningTangents, AreThoseOfTheFactorsHeld) {
    model::Model model = test::driven_beam(fem::ElementKind::hex8);
    const dynamics::SimulationOptions options = test::short_run(dynamics::Integrator::tr_bdf2,
                                                                dynamics::StartKind::straight);
    model.softening = material::StressSoftening{0.3, 1e-9};  // at its most from the first step on
    const double E = 2.6e5, step = 26.0;
    const SensitiveTrace run = simulate_with_tangents(model, options, {youngs_modulus_tangent(model, E)}, {3, 7});
    const auto shifted = [&](double by) {
        model::Model m = model;
        for (material::Moduli& moduli : m.moduli) moduli = {moduli.mu * (1.0 + by / E), moduli.kappa * (1.0 + by / E)};
        return dynamics::simulate(m, options);
    };
    const Matrix3Xd difference = (shifted(step).positions.back() - shifted(-step).positions.back()) / (2.0 * step);
    ASSERT_TRUE(run.trace.complete());
    EXPECT_LT((difference(Eigen::all, std::vector<int>{3, 7}) - run.tangents[0].positions.back()).norm(),
              1e-4 * difference.norm());
}

}  // namespace
}  // namespace myo::sensitivity
