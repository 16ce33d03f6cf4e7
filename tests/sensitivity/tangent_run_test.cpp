#include "sensitivity/tangent_run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numeric>

#include "sensitivity/driven_beam.hpp"
#include "support/beam.hpp"

namespace myo::sensitivity {
namespace {

using test::BeamSpec;

/// Parameters of the runs below: modulus, damping, level that the fibres step to.
struct Values {
    double youngs_modulus_Pa = 2.6e5;
    double damping_s = 0.003;
    double level = 0.9;
};

model::Model pushed_beam(fem::ElementKind kind, const Values& values) {
    BeamSpec spec;
    spec.kind = kind;
    spec.gravity_m_s2 = 9.81;
    spec.youngs_modulus_Pa = values.youngs_modulus_Pa;
    spec.damping_s = values.damping_s;
    if (fem::cell_type(kind) == mesh::CellType::tet10) spec.cells = {3, 1, 1};
    model::Model model = test::make_beam(spec);
    auto fibres = std::make_shared<std::vector<fibre::FibreGroup>>();
    fibres->push_back(fibre::fibres_in_box(model.body->mesh, Box{{0.02, 0, 0}, {0.09, 0.03, 0.01}},
                                           Eigen::Vector3d::UnitX(), 8e4, "muscle"));
    model.fibres = fibres;
    model.activation = {fibre::Signal::step(0.0, 1.0, values.level)};
    test::push_tip(model, spec, {0.0, 0.05, 0.0});
    model.forces.back().until_s = 0.012;  // ends inside a step
    model.velocity_force_1_s = 3.0;
    return model;
}

struct TangentCase {
    fem::ElementKind kind;
    dynamics::TimeScheme integrator;
    dynamics::StartKind start;
};

class TangentRun : public testing::TestWithParam<TangentCase> {};

TEST_P(TangentRun, EqualsCentralDifferencesOfTheDiscreteMotion) {
    const auto [kind, integrator, start] = GetParam();
    const dynamics::SimulationOptions options = test::short_run(integrator, start);
    const Values values;
    const model::Model model = pushed_beam(kind, values);
    ModelTangent level;
    level.activation = {fibre::Signal::step(0.0, 0.0, 1.0)};
    std::vector<int> nodes(static_cast<std::size_t>(model.body->node_count()));
    std::iota(nodes.begin(), nodes.end(), 0);
    const SensitiveTrace run = simulate_with_tangents(
        model, options, {youngs_modulus_tangent(model, values.youngs_modulus_Pa), damping_tangent(), level}, nodes);
    ASSERT_TRUE(run.trace.complete()) << run.trace.message;

    const std::vector<std::pair<double, std::function<void(Values&, double)>>> parameters = {
        {26.0, [](Values& v, double d) { v.youngs_modulus_Pa += d; }},
        {3e-6, [](Values& v, double d) { v.damping_s += d; }},
        {1e-4, [](Values& v, double d) { v.level += d; }},
    };
    for (std::size_t p = 0; p < parameters.size(); ++p) {
        const auto& [step, change] = parameters[p];
        const auto shifted = [&, kind = kind, &change = change](double by) {
            Values v = values;
            change(v, by);
            return dynamics::simulate(pushed_beam(kind, v), options);
        };
        const dynamics::Trace up = shifted(step), down = shifted(-step);
        double error = 0.0, size = 0.0;
        bool identical = true;
        for (std::size_t k = 0; k < up.positions.size(); ++k) {
            const Eigen::Matrix3Xd difference = (up.positions[k] - down.positions[k]) / (2.0 * step);
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
    All, TangentRun,
    testing::Values(
        TangentCase{fem::ElementKind::hex8, dynamics::Integrator::tr_bdf2, dynamics::StartKind::straight},
        TangentCase{fem::ElementKind::hex8, dynamics::Integrator::tr_bdf2, dynamics::StartKind::equilibrium},
        TangentCase{fem::ElementKind::hex8, dynamics::Integrator::implicit_euler, dynamics::StartKind::straight},
        TangentCase{fem::ElementKind::hex8, dynamics::Integrator::bdf2, dynamics::StartKind::straight},
        TangentCase{fem::ElementKind::tet10, dynamics::Integrator::bdf2, dynamics::StartKind::equilibrium},
        TangentCase{fem::ElementKind::hex8, dynamics::Integrator::trapezoidal, dynamics::StartKind::straight},
        TangentCase{fem::ElementKind::hex8, dynamics::Integrator::generalized_alpha, dynamics::StartKind::straight},
        TangentCase{
            fem::ElementKind::tet10, {dynamics::Integrator::generalized_alpha, 0.2}, dynamics::StartKind::equilibrium},
        TangentCase{fem::ElementKind::hex8_mean_dilatation, dynamics::Integrator::tr_bdf2,
                    dynamics::StartKind::straight},
        TangentCase{fem::ElementKind::tet10, dynamics::Integrator::tr_bdf2, dynamics::StartKind::equilibrium},
        TangentCase{fem::ElementKind::tet4, dynamics::Integrator::implicit_euler, dynamics::StartKind::equilibrium}));

TEST(TangentRunItself, DoesNotChangeTheMotion) {
    const model::Model model = pushed_beam(fem::ElementKind::hex8, {});
    const dynamics::SimulationOptions options = test::short_run(dynamics::Integrator::tr_bdf2,
                                                                dynamics::StartKind::straight);
    const SensitiveTrace with = simulate_with_tangents(model, options, {damping_tangent()}, {1, 2});
    const dynamics::Trace without = dynamics::simulate(model, options);
    ASSERT_EQ(with.trace.positions.size(), without.positions.size());
    for (std::size_t k = 0; k < without.positions.size(); ++k)
        EXPECT_LT((with.trace.positions[k] - without.positions[k]).cwiseAbs().maxCoeff(), 1e-10);
    EXPECT_EQ(with.tangents.front().positions.size(), without.positions.size());
}

}  // namespace
}  // namespace myo::sensitivity
