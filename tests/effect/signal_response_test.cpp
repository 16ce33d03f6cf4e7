#include "effect/signal_response.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "effect/catalogue.hpp"
#include "model/cavity_pressure.hpp"
#include "model/elastic_bed.hpp"
#include "model/loaded_face.hpp"
#include "model/tendon.hpp"
#include "support/hollow.hpp"
#include "support/tendon_body.hpp"

namespace myo::effect::signal_response_tests {
namespace {

using fibre::Signal;

/// A block with two muscles, a chamber, a bed and two tendons; actuators are named in this order.
struct Robot {
    TrialContext context;
    Affected affected;

    Robot() {
        model::Model& model = affected.model;
        model = test::hollow_block(fem::ElementKind::hex8);
        model.activation = {Signal{{0.0, 0.1}, {1.0, 0.6}}, Signal::constant(0.9)};
        const model::Body& body = *model.body;
        model.force_elements = {
            model::cavity_pressure(body, model::closed_cavities(body).at(0), Signal{{0.0, 0.1}, {0.0, 2e3}}),
            model::elastic_bed(body, model::free_faces(body), 1e4)};
        test::pull_by_tension({{-0.01, 0.004, 0.004}, {0.05, 0.004, 0.004}}, Signal{{0.0, 0.1}, {1.0, 3.0}}, model,
                              0.1);
        test::pull_by_tension({{-0.01, 0.026, 0.026}, {0.05, 0.026, 0.026}}, Signal::constant(5.0), model);
        context.body = model.body;
        context.actuator_names = {"left", "right", "bellows", "upper", "lower"};
        context.trial = "drop";
        affected.options.h_s = 0.04;
        affected.options.end_s = 0.1;
    }
    const model::ForceElement& element(std::size_t k) const { return *affected.model.force_elements.at(k); }
    /// First and last value of every signal, in the order of the names.
    std::vector<std::pair<double, double>> ends() const {
        std::vector<std::pair<double, double>> list;
        for (const Signal& signal : affected.model.activation)
            list.emplace_back(signal.values.front(), signal.values.back());
        for (const model::ForceElementPointer& element : affected.model.force_elements)
            if (const Signal* const command = element->command())
                list.emplace_back(command->values.front(), command->values.back());
        return list;
    }
};
using Ends = std::vector<std::pair<double, double>>;

TEST(SignalKinds, TellSignalsThatMoveFromThoseThatAct) {
    struct Case {
        Signal signal;
        double passive;
        bool is_moving, is_acting;
    };
    for (const Case& c : {Case{Signal::constant(1.0), 1.0, false, false},
                          {Signal::constant(1.0), 0.0, false, true},
                          {Signal{{0.0, 1.0}, {1.0, 1.0}}, 1.0, false, false},
                          {Signal::step(1.0, 1.0, 0.9), 1.0, true, true},
                          {Signal{{0.0, 1.0, 2.0}, {0.0, 0.0, 1e-300}}, 0.0, true, true}}) {
        EXPECT_EQ(moves(c.signal, c.passive), c.is_moving);
        EXPECT_EQ(acts(c.signal, c.passive), c.is_acting);
    }
}

/// Muscles are passive at 1, chambers and tendons at 0; elements without a command have no name.
TEST(ChangeSignals, GoesByTheNamesOfTheActuators) {
    const auto doubled = [](const std::string& only) {
        Robot robot;
        EffectParameters parameters;
        if (!only.empty()) parameters["signal"] = only;
        change_signals(robot.context, parameters, robot.affected.model, [](Signal& signal, double passive) {
            for (double& value : signal.values) value = passive + 2.0 * (value - passive);
        });
        return robot.ends();
    };
    const Ends before = Robot().ends(), all = doubled("");
    ASSERT_EQ(before.size(), 5u);
    const Ends expected{{1.0, 0.2}, {0.8, 0.8}, {0.0, 4e3}, {2.0, 6.0}, {10.0, 10.0}};
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_NEAR(all[i].first, expected[i].first, 1e-12) << i;
        EXPECT_NEAR(all[i].second, expected[i].second, 1e-12) << i;
        // One alone.
        const Ends one = doubled(Robot().context.actuator_names[i]);
        for (std::size_t k = 0; k < 5; ++k) EXPECT_EQ(one[k], k == i ? all[k] : before[k]) << i << " " << k;
    }
    EXPECT_EQ(doubled("tail"), before) << "nothing has this name";
    Robot nameless;
    nameless.context.actuator_names.clear();
    change_signals(nameless.context, {{"signal", std::string("left")}}, nameless.affected.model,
                   [](Signal& signal, double) { signal = Signal::constant(7.0); });
    EXPECT_EQ(nameless.ends(), before);
}

/// Samples are a quarter of the step apart and begin at the start, with two for a jump.
TEST(RespondToSignals, SamplesAQuarterOfTheStepApartAndAtJumps) {
    Robot robot;
    const double before_start = 0.5, jump = 0.033;
    robot.affected.model.activation = {
        Signal{{-1.0, 0.0, 0.0, jump, jump, 0.04, 0.04, 0.2}, {before_start, 0.5, 0.9, 0.9, 0.7, 0.7, 0.6, 0.6}}};
    robot.context.actuator_names = {"muscle"};
    std::vector<double> times, inputs;
    respond_to_signals(
        robot.context, {{"signal", std::string("muscle")}}, moves,
        [&](const std::vector<double>& at, const std::vector<double>& u) {
            times = at;
            inputs = u;
            return u;
        },
        robot.affected);
    ASSERT_GT(times.size(), 8u);
    EXPECT_EQ(times[0], 0.0);
    EXPECT_EQ(times[1], 0.0) << "a jump at the start";
    EXPECT_NEAR(inputs[0], before_start - 1.0, 1e-15);
    EXPECT_NEAR(inputs[1], 0.9 - 1.0, 1e-15);
    EXPECT_GE(times.back(), 0.1) << "up to the end of the run";
    int jumps = 0;
    for (std::size_t k = 1; k < times.size(); ++k) {
        EXPECT_GE(times[k], times[k - 1]);
        EXPECT_LE(times[k] - times[k - 1], 0.01 + 1e-12);
        jumps += times[k] == times[k - 1] ? 1 : 0;
    }
    EXPECT_EQ(jumps, 3);
    // A response that is the input leaves the signal as it was at all times.
    const Signal& out = robot.affected.model.activation[0];
    EXPECT_EQ(out.jumps(), (std::vector<double>{0.0, jump, 0.04}));
    for (const double t : {-0.5, 0.01, 0.0329, 0.035, 0.05, 0.1}) {
        const double expected = t < 0.0 ? before_start : t < jump ? 0.9 : t < 0.04 ? 0.7 : 0.6;
        EXPECT_NEAR(out.value(t), expected, 1e-12) << t;
    }
    EXPECT_NEAR(out.value_before(jump), 0.9, 1e-15);
    EXPECT_NEAR(out.value(jump), 0.7, 1e-15);
}

TEST(RespondToSignals, LeavesSignalsOfAnotherKindToTheLastBit) {
    const auto touched = [](SignalKind kind) {
        Robot robot;
        int calls = 0;
        respond_to_signals(
            robot.context, {}, kind,
            [&](const std::vector<double>& times, const std::vector<double>&) {
                ++calls;
                return std::vector<double>(times.size(), 0.0);
            },
            robot.affected);
        EXPECT_EQ(robot.affected.model.activation[1] == Signal::constant(0.9), kind == &moves);
        EXPECT_EQ(*robot.element(3).command() == Signal::constant(5.0), kind == &moves);
        return calls;
    };
    EXPECT_EQ(touched(moves), 3) << "one muscle, the chamber and one tendon";
    EXPECT_EQ(touched(acts), 5);
}

TEST(SignalSearch, SeesTheLargestInputOfAnyTrial) {
    EffectSearch search;
    EXPECT_FALSE(any_signal(acts, search));
    EXPECT_EQ(largest_input(search), 0.0);
    model::Model rest;
    rest.activation = {Signal::constant(1.0)};
    search.models = {rest};
    EXPECT_FALSE(any_signal(acts, search)) << "a muscle at 1 is passive";
    EXPECT_EQ(largest_input(search), 0.0);
    model::Model pulled = rest;
    pulled.activation = {Signal::constant(1.0), Signal::constant(0.7)};
    search.models = {rest, pulled, rest};
    EXPECT_TRUE(any_signal(acts, search));
    EXPECT_FALSE(any_signal(moves, search));
    EXPECT_NEAR(largest_input(search), 0.3, 1e-15);
    search.models.push_back(Robot().affected.model);
    EXPECT_TRUE(any_signal(moves, search));
    EXPECT_EQ(largest_input(search), 2e3) << "of a chamber, in its unit";
}

TEST(TendonFriction, IsAddedToTheTendonThatIsNamedOrToAll) {
    const auto frictions = [](const EffectParameters& parameters) {
        Robot robot;
        apply_effects(robot.context, {{"tendon_friction", parameters}}, robot.affected);
        // The coefficient is behind the knots of the command.
        return std::pair{model::parameter_values(robot.element(2))(2), model::parameter_values(robot.element(3))(1)};
    };
    const auto expect = [](const std::pair<double, double>& found, double upper, double lower) {
        EXPECT_NEAR(found.first, upper, 1e-15);
        EXPECT_NEAR(found.second, lower, 1e-15);
    };
    expect(frictions({{"coefficient", 0.25}}), 0.35, 0.25);
    expect(frictions({{"coefficient", 0.25}, {"tendon", std::string("upper")}}), 0.35, 0.0);
    expect(frictions({{"coefficient", 0.25}, {"tendon", std::string("lower")}}), 0.1, 0.25);
    expect(frictions({{"coefficient", 0.25}, {"tendon", std::string("bellows")}}), 0.1, 0.0);
    // A search tries all tendons together and each alone, under their names.
    const Robot robot;
    EffectSearch search;
    search.trials = {robot.context};
    search.models = {robot.affected.model};
    const std::vector<EffectProbe> probes = find_effect("tendon_friction")->probes(search);
    ASSERT_EQ(probes.size(), 3u);
    EXPECT_FALSE(has(probes[0].columns[0], "tendon"));
    EXPECT_EQ(text(probes[1].columns[0], "tendon"), "upper");
    EXPECT_EQ(text(probes[2].columns[0], "tendon"), "lower");
    search.models[0].force_elements.resize(3);
    EXPECT_EQ(find_effect("tendon_friction")->probes(search).size(), 1u) << "one tendon is all of them";
    search.models[0].force_elements.resize(2);
    EXPECT_TRUE(find_effect("tendon_friction")->probes(search).empty());
}

}  // namespace
}  // namespace myo::effect::signal_response_tests
