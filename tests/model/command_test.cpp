#include "model/command.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>

#include <vector>

#include "fibre/signal.hpp"
#include "model/cavity_pressure.hpp"
#include "model/elastic_bed.hpp"
#include "model/force_of.hpp"
#include "model/loaded_face.hpp"
#include "support/hollow.hpp"

namespace myo::model::command_tests {
namespace {

using Eigen::Matrix3Xd;
using Eigen::VectorXd;
using fibre::Signal;

/// A ramp, a jump at 2 s and a second ramp.
const Signal jumping{{1.0, 2.0, 2.0, 4.0}, {0.5, 1.0, -3.0, 5.0}};

struct Instant {
    double time_s;
    bool before;
    double value;
};
const std::vector<Instant> instants{{0.0, false, 0.5}, {1.0, false, 0.5},  {1.0, true, 0.5}, {1.5, false, 0.75},
                                    {2.0, true, 1.0},  {2.0, false, -3.0}, {3.0, true, 1.0}, {3.5, false, 3.0},
                                    {4.0, true, 5.0},  {9.0, false, 5.0}};

TEST(Command, IsTakenOnTheSideOfItsState) {
    const Matrix3Xd x(3, 0);
    for (const Instant& at : instants)
        EXPECT_NEAR(command_value(jumping, {x, nullptr, 0.0, at.time_s, at.before}), at.value, 1e-15) << at.time_s;
}

/// The value is linear in the knots: its change is that of a signal whose knots are the changes.
TEST(Command, ChangesByTheKnotsAroundItsTime) {
    const Matrix3Xd x(3, 0);
    const VectorXd change = Eigen::Vector4d(3.0, -5.0, 7.0, 11.0), more = VectorXd::LinSpaced(6, 3.0, 8.0);
    const Signal changed = with_values(jumping, change);
    EXPECT_EQ(changed.times_s, jumping.times_s);
    EXPECT_EQ(changed.values, (std::vector<double>{3.0, -5.0, 7.0, 11.0}));
    EXPECT_EQ(with_values(jumping, more).values.size(), 4u) << "further parameters are not its knots";
    for (const Instant& instant : instants) {
        const ForceState at{x, nullptr, 0.0, instant.time_s, instant.before};
        EXPECT_NEAR(command_change(jumping, at, change), command_value(changed, at), 1e-14) << instant.time_s;
        VectorXd work = VectorXd::Constant(6, 100.0);
        add_command_work(jumping, at, 2.0, work);
        EXPECT_NEAR((work.head(4).array() - 100.0).matrix().dot(change), 2.0 * command_value(changed, at), 1e-11)
            << instant.time_s;
        EXPECT_NEAR(work.sum() - 600.0, 2.0, 1e-11) << "weights of the knots add up to one";
        EXPECT_EQ(work.tail(2), VectorXd::Constant(2, 100.0));
    }
}

TEST(Command, NamesItsKnotsAndScalesThemByTheLargest) {
    const std::vector<ForceParameter> knots = command_parameters(jumping, "pressure_Pa", 1e3);
    ASSERT_EQ(knots.size(), 4u);
    EXPECT_EQ(knots[2].name, "pressure_Pa, knot 2");
    EXPECT_EQ(knots[2].value, -3.0);
    for (const ForceParameter& knot : knots) EXPECT_EQ(knot.scale, 5.0);
    EXPECT_EQ(command_parameters(Signal{{0.0, 1.0}, {-7.0, 2.0}}, "p", 1e3)[1].scale, 7.0);
    EXPECT_EQ(command_parameters(Signal::constant(0.0), "p", 1e3)[0].scale, 1e3);
}

TEST(Command, IsConstantBetweenTimesWithoutAKnotInside) {
    struct Interval {
        double from_s, to_s;
        bool constant;
    };
    for (const Interval& t : {Interval{-5.0, 1.0, true},
                              {-5.0, 1.0001, false},
                              {0.0, 0.5, true},
                              {1.2, 1.8, false},
                              {1.0, 2.0, false},
                              {4.0, 9.0, true},
                              {3.9999, 9.0, false},
                              {4.5, 4.5, true}})
        EXPECT_EQ(constant_between(jumping, t.from_s, t.to_s), t.constant) << t.from_s << " " << t.to_s;
    const Signal hold = Signal::held({0.0, 1.0, 2.0}, {3.0, 4.0, 4.0});
    EXPECT_TRUE(constant_between(hold, 0.0, 1.0)) << "the jumps at its ends are outside";
    EXPECT_FALSE(constant_between(hold, 0.5, 1.5));
    EXPECT_FALSE(constant_between(hold, 1.5, 2.5)) << "a knot, though its values are equal";
    EXPECT_TRUE(constant_between(Signal::constant(2.0), 0.0, 5.0)) << "its knot at 0 is the beginning";
}

/// Two pressures and a bed on one body.
Model commanded(const Signal& first, const Signal& second) {
    Model model = test::hollow_block(fem::ElementKind::hex8);
    const Body& body = *model.body;
    const std::vector<int> walls = closed_cavities(body).at(0);
    model.force_elements = {cavity_pressure(body, walls, first, "chamber upper"),
                            elastic_bed(body, free_faces(body), 1e5),
                            cavity_pressure(body, walls, second, "chamber lower")};
    return model;
}

TEST(CommandWords, TellAllThatDifferFromZero) {
    const Model model = commanded(Signal{{0.0, 1.0, 1.0}, {12000.0, 12000.0, 0.0}}, Signal::step(2.0, 0.0, -500.5));
    EXPECT_EQ(command_words(model, 0.5), "12000 Pa in chamber upper");
    EXPECT_EQ(command_words(model, 1.0), "");
    EXPECT_EQ(command_words(model, 1.0, true), "12000 Pa in chamber upper");
    EXPECT_EQ(command_words(model, 2.0), "-500.5 Pa in chamber lower");
    EXPECT_EQ(command_words(model, 2.0, true), "");
    EXPECT_EQ(command_words(commanded(Signal::constant(1.23456), Signal::constant(2e6)), 0.0),
              "1.235 Pa in chamber upper and 2000000 Pa in chamber lower");
    EXPECT_EQ(command_words(commanded(Signal::constant(9999.4), Signal::constant(-12345.6)), 0.0),
              "9999 Pa in chamber upper and -12346 Pa in chamber lower");
    EXPECT_EQ(command_words(Model{}, 0.0), "");
}

TEST(CommandWords, GoWithWhetherThereAreCommandsJustBefore) {
    const Model model = commanded(Signal::constant(0.0), Signal::step(2.0, 0.0, 7.0));
    EXPECT_FALSE(has_commands(model, 1.0));
    EXPECT_FALSE(has_commands(model, 2.0));
    EXPECT_TRUE(has_commands(model, 2.0001));
    EXPECT_FALSE(has_commands(Model{}, 2.0));
}

/// A copy whose commands stand at a part of what they were just before a time; what has none is the element itself.
TEST(ConstantCommands, StandAtAPartOfTheirValue) {
    const Model model = commanded(Signal{{0.0, 2.0}, {0.0, 8.0}}, Signal::step(1.0, 3.0, 50.0));
    const Model half = with_constant_commands(model, 0.5, 1.0);
    EXPECT_EQ(*half.force_elements[0]->command(), Signal::constant(2.0));
    EXPECT_EQ(half.force_elements[1], model.force_elements[1]);
    EXPECT_EQ(*half.force_elements[2]->command(), Signal::constant(1.5));
    EXPECT_EQ(model.force_elements[0]->command()->values.size(), 2u) << "the model that was given is left";
    EXPECT_TRUE(half.force_elements[0]->steady(0.0, 10.0));
    EXPECT_FALSE(model.force_elements[0]->steady(0.0, 1.0));
    // The forces are those of half the pressure, and the words stay.
    const Matrix3Xd& x = model.body->mesh.nodes;
    const Matrix3Xd whole = test::force_of(*model.force_elements[0], *model.body, {x, nullptr, 0.0, 1.0}).gradient,
                    part = test::force_of(*half.force_elements[0], *model.body, {x}).gradient;
    EXPECT_GT(whole.norm(), 0.0);
    EXPECT_LT((whole - 2.0 * part).norm(), 1e-13 * whole.norm());
    EXPECT_EQ(command_words(half, 0.0), "2 Pa in chamber upper and 1.5 Pa in chamber lower");
}

}  // namespace
}  // namespace myo::model::command_tests
