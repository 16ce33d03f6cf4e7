#include "diagnosis/missing_force/force_course.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "material/catalogue.hpp"
#include "mesh/box_mesh.hpp"

// Correlates of a force on one cell whose motion is prescribed: each quantity follows a course of its own.

namespace myo::diagnosis::force_course_test {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Course = std::function<double(double)>;

const KnotTimes knots{0.1, 11};  // one second

/// A free cell of 1 cm that is moved along z and stretched along x.
struct Moved {
    setup::Setup setup;
    effect::Affected trial;
    MissingForcePolicy policy;
    ForceMode mode;
    dynamics::Trace trace;

    Moved() {
        const mesh::VolumeMesh mesh = mesh::box_hex_mesh({Eigen::Vector3d::Zero(), {0.01, 0.01, 0.01}}, {1, 1, 1});
        trial.model.body = model::make_body(mesh, fem::ElementKind::hex8, {});
        trial.model.material = material::neo_hookean();
        trial.model.moduli = model::uniform_moduli(1, 1e5, 0.45);
        policy.curve_points = 21;  // every other step
        mode.pattern = Matrix3Xd::Zero(3, 8);
        mode.pattern.row(2).setConstant(0.125);
    }

    const Matrix3Xd& rest() const { return trial.model.body->mesh.nodes; }

    /// Correlates of a force that grows with time by 1 N/s, strongest first.
    /// @param shift    along z [m]
    /// @param speed    along z, independent of the shift, so that the quantities can be told apart [m/s]
    /// @param stretch  along x
    std::vector<statistics::Correlate> correlates(const Course& shift, const Course& speed, const Course& stretch) {
        trace = {};
        for (int k = 0; k <= 40; ++k) {
            const double t = 0.025 * k;
            Matrix3Xd x = rest(), v = Matrix3Xd::Zero(3, 8);
            x.row(0) *= 1.0 + stretch(t);
            x.row(2).array() += shift(t);
            v.row(2).setConstant(speed(t));
            trace.times_s.push_back(t);
            trace.positions.push_back(x);
            trace.velocities.push_back(v);
        }
        mode.amplitude_N = knots.times_s();
        return course_correlates(setup, trial, trace, knots, mode, policy);
    }
};

double none(double) { return 0.0; }

double of(const std::vector<statistics::Correlate>& list, const std::string& name) {
    const auto found = std::find_if(list.begin(), list.end(), [&](const auto& c) { return c.name == name; });
    EXPECT_NE(found, list.end()) << name;
    return found != list.end() ? found->correlation : std::nan("");
}

TEST(ForceCourse, FollowsTheDisplacementFromRest) {
    const auto list = Moved().correlates([](double t) { return 0.02 - 0.01 * t; }, none, none);
    EXPECT_EQ(list.size(), 6u);
    EXPECT_NEAR(of(list, "position"), -1.0, 1e-9);
    EXPECT_NEAR(of(list, "time"), 1.0, 1e-9);
    EXPECT_EQ(of(list, "acceleration"), 0.0) << "velocities are those of the trace, not differences of positions";
}

/// With v = -sqrt(t) the product |v| v is -t; the square of v would be +t.
TEST(ForceCourse, KeepsTheSignOfTheSquaredVelocity) {
    const auto list = Moved().correlates(
        none, [](double t) { return -std::sqrt(t); }, none);
    EXPECT_NEAR(of(list, "|v| v"), -1.0, 1e-9);
    EXPECT_LT(of(list, "velocity"), -0.9);
    EXPECT_GT(of(list, "velocity"), -0.999) << "a root is no straight line";
}

/// The elastic force along the pattern grows with the square of the time, hence its rate with the time.
TEST(ForceCourse, StrainRateIsTheRateOfTheElasticForce) {
    Moved moved;
    moved.mode.pattern.setZero();
    for (Index i = 0; i < 8; ++i) moved.mode.pattern(0, i) = moved.rest()(0, i) > 0.005 ? 0.125 : -0.125;
    const auto squared = [](double t) { return 1e-3 * t * t; };
    EXPECT_GT(of(moved.correlates(none, none, squared), "strain rate"), 0.999);
    moved.mode.pattern = -moved.mode.pattern;
    EXPECT_LT(of(moved.correlates(none, none, squared), "strain rate"), -0.999);
}

TEST(ForceCourse, IsComparedWithActuationThatChanges) {
    Moved moved;
    moved.setup.experiment.muscles.resize(2);
    moved.setup.experiment.muscles[0].name = "left";
    moved.setup.experiment.muscles[1].name = "idle";
    moved.trial.model.activation = {{{0.0, 1.0}, {1.0, 0.5}}, fibre::Signal::constant(0.7)};
    const auto list = moved.correlates(none, none, none);
    EXPECT_EQ(list.size(), 7u) << "a constant activation is left out";
    EXPECT_NEAR(of(list, "activation of left"), -1.0, 1e-9);
    moved.trace.times_s.resize(1);
    EXPECT_TRUE(course_correlates(moved.setup, moved.trial, moved.trace, knots, moved.mode, moved.policy).empty());
}

}  // namespace
}  // namespace myo::diagnosis::force_course_test
