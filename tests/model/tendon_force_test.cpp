#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "fibre/signal.hpp"
#include "model/elastic_bed.hpp"
#include "model/force_of.hpp"
#include "model/loaded_face.hpp"
#include "model/tendon.hpp"
#include "support/beam.hpp"
#include "support/tendon_body.hpp"

namespace myo::model::tendon_force_tests {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using fibre::Signal;
using test::force_of;
using test::moved_by;

constexpr double slack_m = 1e-5;  // of the tendons that pull_by_shortening() makes

/// Legs of 40, 15 and 60 mm along x, z and x; the first guide stands still before the body.
const std::vector<Vector3d> crooked{
    {-0.02, 0.015, 0.01}, {0.02, 0.015, 0.01}, {0.02, 0.015, 0.025}, {0.08, 0.015, 0.025}};
/// What a bend of a right angle counts.
const double bend = std::hypot(std::numbers::pi / 2.0, 1e-3) - 1e-3;

Model free_beam() {
    test::BeamSpec spec;
    spec.clamped = false;
    return test::make_beam(spec);
}
Model under_tension(const Signal& tension_N, double friction = 0.0) {
    Model model = free_beam();
    test::pull_by_tension(crooked, tension_N, model, friction);
    return model;
}
Model by_shortening(const Signal& shortening_m, double stiffness_N_m, double friction = 0.0) {
    Model model = free_beam();
    test::pull_by_shortening(crooked, shortening_m, stiffness_N_m, model, friction);
    return model;
}

/// Tension of the leg along z, and a tension of the legs along x, from the work along stretches of the body.
struct Legs {
    double z_N, x_work_J;
};
Legs legs_of(const Model& model, double time_s, bool before = false) {
    const Matrix3Xd X = model.body->mesh.nodes;
    const Matrix3Xd g = force_of(*model.force_elements.front(), *model.body, {X, nullptr, 0.0, time_s, before})
                            .gradient;
    return {g.row(2).dot(X.row(2)) / 0.015, g.row(0).dot(X.row(0))};
}

TEST(TendonForce, PullsTheBodyTowardsTheMotorWithItsTension) {
    const Model model = under_tension(Signal::constant(2.5));
    const Matrix3Xd x = model.body->mesh.nodes;
    const InternalEnergy out = force_of(*model.force_elements.front(), *model.body, {x});
    EXPECT_LT((test::resultant(out) - Vector3d(-2.5, 0.0, 0.0)).norm(), 1e-9);
    EXPECT_NEAR(out.energy, 0.0, 1e-12) << "at rest";
    const Matrix3Xd y = moved_by(*model.body, {0.05, 0.0, 0.0});
    EXPECT_NEAR(force_of(*model.force_elements.front(), *model.body, {y}).energy, 2.5 * 0.05, 1e-9);
    // Every leg has it.
    EXPECT_NEAR(legs_of(model, 0.0).z_N, 2.5, 1e-8);
    EXPECT_NEAR(legs_of(model, 0.0).x_work_J, 2.5 * (0.02 + 0.06), 1e-10);
    const TendonState state = tendon_state(*model.force_elements.front(), {y});
    EXPECT_EQ(state.tension_N, 2.5);
    EXPECT_NEAR(state.shortening_m, -0.05, 1e-10);
}

TEST(TendonForce, OfANegativeTensionIsNone) {
    for (const double command : {0.0, -3.0}) {
        const Model model = under_tension(Signal::constant(command));
        const Matrix3Xd x = moved_by(*model.body, {0.05, 0.0, 0.0});
        const InternalEnergy out = force_of(*model.force_elements.front(), *model.body, {x}, HessianKind::exact);
        EXPECT_EQ(out.energy, 0.0);
        EXPECT_EQ(out.gradient.norm(), 0.0);
        EXPECT_EQ(out.hessian.norm(), 0.0);
        EXPECT_EQ(tendon_state(*model.force_elements.front(), {x}).tension_N, 0.0);
    }
}

/// The command rises until 1 s and falls from then on: the tension falls along the thread, then it rises.
TEST(TendonForce, FallsByFrictionWhileTakingInAndRisesWhilePayingOut) {
    const double f = 0.3;
    const Model model = under_tension(Signal{{0.0, 1.0, 2.0}, {0.0, 4.0, 0.0}}, f);
    for (const double t : {0.5, 1.5}) {
        const double sense = t < 1.0 ? 1.0 : -1.0;
        const Legs legs = legs_of(model, t);
        EXPECT_NEAR(legs.z_N, 2.0 * std::exp(-sense * f * bend), 1e-8) << t;
        EXPECT_NEAR(legs.x_work_J, 2.0 * (0.02 + 0.06 * std::exp(-2.0 * sense * f * bend)), 1e-9) << t;
    }
    EXPECT_NEAR(legs_of(model, 1.0, true).z_N, 4.0 * std::exp(-f * bend), 1e-7) << "up to the turn";
    EXPECT_NEAR(legs_of(model, 1.0, false).z_N, 4.0 * std::exp(f * bend), 1e-7);
    const ForceElement& element = *model.force_elements.front();
    EXPECT_EQ(element.jumps(), std::vector<double>{1.0}) << "the turn of the sense";
    EXPECT_FALSE(element.has_potential());
    EXPECT_TRUE(under_tension(Signal{{0.0, 1.0, 2.0}, {0.0, 4.0, 0.0}}).force_elements.front()->jumps().empty());
}

/// The stiffness sets in over twice the slack about the onset of tension.
TEST(TendonForce, OfAShortenedThreadGrowsWithItsStretchBeyondTheSlack) {
    const double k = 900.0;
    struct Stretch {
        double by_slack, tension_by_slack;
    };
    for (const Stretch& at : {Stretch{-300.0, 0.0},
                              {-1.0001, 0.0},
                              {-1.0, 0.0},
                              {-0.5, 0.0625},
                              {0.0, 0.25},
                              {0.5, 0.5625},
                              {1.0, 1.0},
                              {1.0001, 1.0001},
                              {200.0, 200.0}}) {
        const Model model = by_shortening(Signal::constant(at.by_slack * slack_m), k);
        const Matrix3Xd x = model.body->mesh.nodes;
        const double tension = k * slack_m * at.tension_by_slack;
        EXPECT_NEAR(tendon_state(*model.force_elements.front(), {x}).tension_N, tension, 1e-9) << at.by_slack;
        EXPECT_NEAR(legs_of(model, 0.0).z_N, tension, 1e-8) << at.by_slack;
    }
    // A moved body stretches the thread as the motor does: half a millimetre each.
    const Model model = by_shortening(Signal::constant(5e-4), k);
    const Matrix3Xd x = moved_by(*model.body, {5e-4, 0.0, 0.0});
    const InternalEnergy out = force_of(*model.force_elements.front(), *model.body, {x});
    EXPECT_NEAR(-test::resultant(out).x(), 900.0 * 1e-3, 1e-9);
    EXPECT_NEAR(out.energy, 0.5 * k * (1e-6 + slack_m * slack_m / 3.0), 1e-12);
}

/// With friction the stiffness times the stretch is the mean tension by the legs' lengths at rest.
TEST(TendonForce, OfAShortenedThreadWithFrictionHasTheMeanOfItsStretch) {
    const double k = 900.0, s = 2e-3, f = 0.4;
    const Model model = by_shortening(Signal{{0.0, 1.0}, {0.0, 2.0 * s}}, k, f);
    const Matrix3Xd x = model.body->mesh.nodes;
    const ForceState at{x, nullptr, 0.0, 0.5};
    const double motor = tendon_state(*model.force_elements.front(), at).tension_N, step = std::exp(-f * bend);
    EXPECT_NEAR(motor * (0.04 + step * 0.015 + step * step * 0.06) / 0.115, k * s, 1e-8);
    EXPECT_GT(motor, 1.1 * k * s);
    EXPECT_NEAR(legs_of(model, 0.5).z_N, step * motor, 1e-7);
}

TEST(TendonForce, TakesOnFrictionAsACopy) {
    const Model model = under_tension(Signal{{0.0, 1.0}, {1.0, 2.0}}, 0.1);
    const ForceElementPointer& tendon = model.force_elements.front();
    const ForceElementPointer rubbing = with_added_friction(*tendon, 0.25);
    ASSERT_NE(rubbing, nullptr);
    EXPECT_NEAR(parameter_values(*rubbing)(2), 0.35, 1e-15);
    EXPECT_EQ(parameter_values(*tendon)(2), 0.1);
    EXPECT_EQ(*rubbing->command(), *tendon->command());
    Model rubbed = model;
    rubbed.force_elements = {rubbing};
    EXPECT_NEAR(legs_of(rubbed, 0.0).z_N / legs_of(model, 0.0).z_N, std::exp(-0.25 * bend), 1e-9);
    EXPECT_EQ(with_added_friction(*elastic_bed(*model.body, free_faces(*model.body), 1e5), 0.1), nullptr);
}

TEST(TendonForce, NamesItsParametersInTheirOrder) {
    const auto names = [](const Model& model) {
        std::vector<std::string> list;
        for (const ForceParameter& parameter : model.force_elements.front()->parameters())
            list.push_back(parameter.name);
        return list;
    };
    const std::vector<std::string> guides{"guide 2, x_m", "guide 2, y_m", "guide 2, z_m",
                                          "guide 3, x_m", "guide 3, y_m", "guide 3, z_m",
                                          "guide 4, x_m", "guide 4, y_m", "guide 4, z_m"};
    std::vector<std::string> of_tension{"tension_N, knot 0", "tension_N, knot 1", "friction"},
        of_length{"shortening_m, knot 0", "stiffness_N_m", "friction"};
    of_tension.insert(of_tension.end(), guides.begin(), guides.end());
    of_length.insert(of_length.end(), guides.begin(), guides.end());
    const Model tension = under_tension(Signal{{0.0, 1.0}, {1.0, 2.0}}), length = by_shortening(Signal{}, 70.0);
    EXPECT_EQ(names(tension), of_tension);
    EXPECT_EQ(names(length), of_length);
    EXPECT_EQ(tension.force_elements.front()->command_words(1.0, false), "2 N of a tendon");
    EXPECT_EQ(length.force_elements.front()->command_words(1.0, false), "1 m of a tendon");
    // Values that it has make the same element again.
    for (const Model* model : {&tension, &length}) {
        const ForceElement& element = *model->force_elements.front();
        const Matrix3Xd x = moved_by(*model->body, {0.01, 0.0, 0.02});
        const Matrix3Xd again = force_of(*element.changed(parameter_values(element)), *model->body, {x}).gradient;
        EXPECT_EQ(again, force_of(element, *model->body, {x}).gradient);
    }
}

/// Neighbouring guides of a prescribed tension are coupled, all guides of a prescribed length.
TEST(TendonCouplings, HoldTheNodesOfTheLegsOnce) {
    const Model model = free_beam();
    const std::vector<TendonGuide> guides = test::guides_along(model.body->mesh, crooked);
    const auto as_set = [](const std::vector<int>& nodes) { return std::set<int>(nodes.begin(), nodes.end()); };
    const std::vector<std::vector<int>> legs = tendon_couplings(guides, false), whole = tendon_couplings(guides, true);
    ASSERT_EQ(legs.size(), 3u);
    ASSERT_EQ(whole.size(), 1u);
    EXPECT_EQ(as_set(legs[0]), as_set(guides[1].on_body->nodes)) << "the fixed guide has no nodes";
    std::set<int> last = as_set(guides[2].on_body->nodes), all;
    last.insert(guides[3].on_body->nodes.begin(), guides[3].on_body->nodes.end());
    EXPECT_EQ(as_set(legs[2]), last);
    for (const std::vector<int>& group : legs) {
        EXPECT_EQ(as_set(group).size(), group.size());
        all.insert(group.begin(), group.end());
    }
    EXPECT_EQ(as_set(whole[0]), all);
    EXPECT_EQ(whole[0].size(), all.size());
    EXPECT_TRUE(tendon_couplings({}, false).empty());
    EXPECT_TRUE(tendon_couplings({guides[1]}, true).empty());
}

}  // namespace
}  // namespace myo::model::tendon_force_tests
