#include "experiment/body_queries.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "experiment/actuators.hpp"
#include "experiment/experiment.hpp"
#include "experiment/goal.hpp"
#include "mesh/surface_check.hpp"
#include "mesh/test_surfaces.hpp"

// Boxes and points against the surface of a body, at its tolerance; actuators in their order; places of goals.

namespace myo::experiment::body_queries_test {
namespace {

using Eigen::Vector3d;

/// A cube of 100 mm with a cavity of 20 mm in its middle. Lengths below 1e-8 m are rounding.
mesh::SurfaceMesh hollow_cube() {
    return test::together(mesh::box_surface({{0, 0, 0}, {0.1, 0.1, 0.1}}),
                          mesh::flipped(mesh::box_surface({{0.04, 0.04, 0.04}, {0.06, 0.06, 0.06}})));
}

constexpr double within = 5e-9, beyond = 1e-6;  // of the tolerance

struct Case {
    const char* name;
    Box box;
    bool material, volume, surface;
};

TEST(BodyQueries, TellMaterialVolumeAndSurfaceApart) {
    const mesh::SurfaceMesh body = hollow_cube();
    const BodyQueries queries(body);
    EXPECT_NEAR(queries.tolerance(), 1e-8, 1e-20);
    const std::vector<Case> cases{
        {"in the material", {{0.01, 0.01, 0.01}, {0.03, 0.03, 0.03}}, true, true, false},
        {"in the cavity", {{0.045, 0.045, 0.045}, {0.055, 0.055, 0.055}}, false, false, false},
        {"the cavity itself", {{0.04, 0.04, 0.04}, {0.06, 0.06, 0.06}}, true, false, true},
        {"a little more than the cavity", {{0.04 - beyond, 0.04, 0.04}, {0.06, 0.06, 0.06}}, true, true, true},
        {"outside", {{0.2, 0.0, 0.0}, {0.3, 0.1, 0.1}}, false, false, false},
        {"around everything", {{-1, -1, -1}, {1, 1, 1}}, true, true, true},
        {"touching a face", {{0.1, 0.0, 0.0}, {0.12, 0.1, 0.1}}, true, false, true},
        {"touching within rounding", {{0.1 + within, 0.02, 0.02}, {0.12, 0.03, 0.03}}, true, false, true},
        {"just apart", {{0.1 + beyond, 0.0, 0.0}, {0.12, 0.1, 0.1}}, false, false, false},
        {"just in", {{0.1 - beyond, 0.02, 0.02}, {0.12, 0.03, 0.03}}, true, true, true},
        {"touching an edge", {{0.1, 0.1, 0.0}, {0.12, 0.12, 0.1}}, false, false, false},
        {"touching a corner", {{0.1, 0.1, 0.1}, {0.12, 0.12, 0.12}}, false, false, false},
        {"a sheet in the material", {{0.02, 0.01, 0.01}, {0.02, 0.03, 0.03}}, true, false, false},
        {"a sheet in a face", {{0.1, 0.0, 0.0}, {0.1, 0.1, 0.1}}, true, false, true},
    };
    for (const Case& at : cases) {
        EXPECT_EQ(queries.holds_material(at.box), at.material) << at.name;
        EXPECT_EQ(queries.holds_volume(at.box), at.volume) << at.name;
        EXPECT_EQ(queries.holds_surface(at.box), at.surface) << at.name;
    }
}

TEST(BodyQueries, LieInABoxUpToTheTolerance) {
    const mesh::SurfaceMesh body = hollow_cube();
    const BodyQueries queries(body);
    EXPECT_TRUE(queries.lies_in({{0, 0, 0}, {0.1, 0.1, 0.1}}));
    for (int axis = 0; axis < 3; ++axis)
        for (const double cut : {within, beyond}) {
            Box low{{0, 0, 0}, {0.1, 0.1, 0.1}}, high = low;
            low.lowest[axis] += cut;
            high.highest[axis] -= cut;
            EXPECT_EQ(queries.lies_in(low), cut == within) << axis;
            EXPECT_EQ(queries.lies_in(high), cut == within) << axis;
        }
}

TEST(BodyQueries, KnowPointsAndDistances) {
    const mesh::SurfaceMesh body = hollow_cube();
    const BodyQueries queries(body);
    EXPECT_TRUE(queries.in_material({0.02, 0.05, 0.07}));
    EXPECT_FALSE(queries.in_material({0.05, 0.05, 0.05})) << "a cavity";
    EXPECT_FALSE(queries.in_material({0.05, 0.05, 0.2}));
    struct Point {
        Vector3d at;
        double distance;
    };
    for (const Point& point : std::vector<Point>{{{0.01, 0.05, 0.05}, 0.01},     // in the material, to the outer face
                                                 {{0.035, 0.05, 0.05}, 0.005},   // in the material, to the cavity
                                                 {{0.05, 0.05, 0.052}, 0.008},   // in the cavity
                                                 {{0.13, 0.14, 0.05}, 0.05},     // from an edge
                                                 {{-0.02, -0.03, -0.06}, 0.07},  // from a corner
                                                 {{0.1, 0.03, 0.03}, 0.0}})
        EXPECT_NEAR(queries.distance_to_surface(point.at), point.distance, 1e-15) << point.at.transpose();
}

TEST(Actuators, FollowTheirKindsAndDeclarations) {
    Experiment experiment;
    experiment.muscles.resize(2);
    experiment.muscles[0].name = "left";
    experiment.muscles[1].name = "right";
    experiment.chambers.resize(1);
    experiment.chambers[0].name = "upper";
    experiment.tendons.resize(2);
    experiment.tendons[0].name = "cable";
    experiment.tendons[1].name = "thread";
    experiment.tendons[1].drive = TendonDrive::shortening;
    const std::vector<Actuator> all = actuators(experiment);
    const std::vector<std::string> columns{"left", "right", "upper_Pa", "cable_N", "thread_m"};
    const std::vector<std::string> keys{"activation", "activation", "pressure_Pa", "tension_N", "shortening_m"};
    const std::vector<std::string> words{"activation", "activation", "pressure", "tension", "shortening"};
    const std::vector<std::size_t> indices{0, 1, 0, 0, 1};
    ASSERT_EQ(all.size(), 5u);
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(all[i].column, columns[i]);
        EXPECT_EQ(all[i].index, indices[i]) << "within its own list";
        EXPECT_EQ(constant_key(all[i].kind), keys[i]);
        EXPECT_EQ(quantity_word(all[i].kind), words[i]);
        EXPECT_EQ(all[i].rest, i < 2 ? 1.0 : 0.0) << "a muscle rests at its own length";
        EXPECT_EQ(find_actuator(experiment, all[i].name), i);
    }
    EXPECT_EQ(all[2].unit + all[3].unit + all[4].unit + all[0].unit, "PaNm");
    EXPECT_FALSE(find_actuator(experiment, "upper_Pa")) << "a column is no name";
    EXPECT_TRUE(actuators({}).empty());
}

TEST(GoalPlaces, LieBetweenTheirTimesAndStayBeyondThem) {
    GoalDeclaration goal;
    goal.times_s = Vector3d(1.0, 1.5, 3.5);
    goal.places_m.resize(3, 3);
    goal.places_m << 0, 1, 5, 0, 2, 2, 0, 0, -4;
    struct Knot {
        double time_s;
        Vector3d place;
    };
    for (const Knot& knot : std::vector<Knot>{{-7.0, {0, 0, 0}},
                                              {1.0, {0, 0, 0}},
                                              {1.25, {0.5, 1, 0}},
                                              {1.5, {1, 2, 0}},
                                              {2.0, {2, 2, -1}},
                                              {3.5, {5, 2, -4}},
                                              {9.0, {5, 2, -4}}})
        EXPECT_LT((place_at(goal, knot.time_s) - knot.place).norm(), 1e-15) << knot.time_s;
    goal.times_s = Eigen::VectorXd::Constant(1, 2.0);
    goal.places_m = Vector3d(1, 2, 3);
    for (const double time_s : {0.0, 2.0, 4.0}) EXPECT_EQ(place_at(goal, time_s), Vector3d(1, 2, 3)) << "one for all";
}

}  // namespace
}  // namespace myo::experiment::body_queries_test
