#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <variant>

#include "commands/command_knots.hpp"
#include "commands/knot_grid.hpp"
#include "commands/signal_shapes.hpp"
#include "toml/toml_text.hpp"
#include "ui/bladder_and_thread.hpp"
#include "ui/drawn_text.hpp"
#include "ui/driver.hpp"

// Knots of signals: round places, commands of chambers and tendons as curves, and their edits in the chart.

namespace myo::ui {
namespace {

using commands::DeclaredCommand;
using fibre::Signal;
using Kind = DeclaredCommand::Kind;

TEST(KnotGrid, GivesNumbersOfAsManyDecimalsAsItsStep) {
    EXPECT_EQ(commands::on_grid(0.3333, 0.1), 0.3);
    EXPECT_EQ(commands::on_grid(0.29, 0.05), 0.3);
    EXPECT_EQ(commands::on_grid(1234.0, 20.0), 1240.0);
    EXPECT_EQ(commands::on_grid(-7.4, 5.0), -5.0);
    EXPECT_FALSE(std::signbit(commands::on_grid(-0.01, 0.1))) << "no minus zero";
    for (const double step : {1e-4, 2e-4, 5e-4, 1e-3, 0.02, 0.5, 1.0, 50.0})
        for (double value = -3.0; value < 3.0; value += 0.037) {
            const double round = commands::on_grid(value, step);
            EXPECT_LE(std::abs(round - value), 0.5 * step * (1.0 + 1e-9));
            EXPECT_LE(toml::toml_number(round).size(), 8u) << toml::toml_number(round);
        }
}

TEST(CommandKnots, AreThoseOfTheShortestCommand) {
    const auto there_and_back = [](const DeclaredCommand& command) {
        return commands::command_of(commands::knots_of(&command));
    };
    for (const Kind kind : {Kind::constant, Kind::step}) {
        const DeclaredCommand same = there_and_back({kind, 2e4});
        EXPECT_EQ(same.kind, kind);
        EXPECT_EQ(same.value, 2e4);
    }
    const Signal rows{{0.0, 0.5, 0.5, 1.0}, {0.0, 1e4, 2e4, 0.0}};
    const DeclaredCommand curve = there_and_back({Kind::curve, 0.0, rows});
    EXPECT_EQ(curve.kind, Kind::curve);
    EXPECT_EQ(curve.curve, rows);
    EXPECT_EQ(commands::knots_of(nullptr), Signal::constant(0.0)) << "at rest";
    // A knot more makes a curve of any of them, one less a constant.
    const DeclaredCommand step{Kind::step, 2e4};
    const Signal added = commands::with_knot_added(commands::knots_of(&step), 0.5, 1e4);
    EXPECT_EQ(commands::command_of(added).curve, (Signal{{0.0, 0.0, 0.5}, {0.0, 2e4, 1e4}}));
    const Signal ramp{{0.0, 0.5}, {0.0, 1e4}};
    EXPECT_EQ(commands::command_of(commands::with_knot_removed(ramp, 0)).kind, Kind::constant);
    EXPECT_EQ(commands::command_of(commands::with_knot_removed(ramp, 0)).value, 1e4);
}

TEST(SignalShapes, MoveAJumpAsAWhole) {
    const Signal step{{0.0, 1.0, 1.0, 2.0}, {0.0, 0.0, 5.0, 5.0}};
    for (const std::size_t knot : {1u, 2u}) {
        const Signal moved = commands::with_knot_moved(step, knot, 1.5, 7.0);
        EXPECT_EQ(moved.times_s, (std::vector<double>{0.0, 1.5, 1.5, 2.0}));
        EXPECT_EQ(moved.values[knot], 7.0);
        EXPECT_EQ(moved.values[3 - knot], step.values[3 - knot]);
    }
    EXPECT_NEAR(commands::with_knot_moved(step, 1, 9.0, 0.0).times_s[2], 2.0, 1.01e-4);
    EXPECT_NEAR(commands::with_knot_moved(step, 2, -9.0, 5.0).times_s[1], 0.0, 1.01e-4);
}

/// The swinging beam with a chamber and a tendon; edits of their commands are made.
class DrivenBeam : public test::SwingingBeam {
public:
    Result<commands::Scene> open(const std::filesystem::path& path, std::optional<double> metres_per_unit,
                                 const Progress& progress) override {
        Result<commands::Scene> scene = SwingingBeam::open(path, metres_per_unit, progress);
        if (!scene) return scene;
        scene->is_experiment = true;
        scene->declared.chambers = {"bladder"};
        commands::DeclaredTendon thread;
        thread.name = "thread";
        thread.path_m = Eigen::Matrix3Xd::Zero(3, 2);
        thread.path_m(0, 1) = 0.1;
        scene->declared.tendons = {thread};
        scene->declared.commands.resize(scene->trials.size());
        scene->declared.commands[0]["bladder"] = {Kind::curve, 0.0, {{0.0, 1.0}, {0.0, 2e4}}};
        scene->declared.commands[0]["thread"] = {Kind::file};
        scene->trials[0].commands["bladder"] = {{{0.0, 1.0}, {0.0, 2e4}}, "kPa", 1e3};
        scene->trials[0].commands["thread"] = {{{0.0, 1.0}, {1.0, 2.0}}, "N", 1.0};
        scene->trials[1].commands["bladder"] = {Signal::constant(0.0), "kPa", 1e3};
        return scene;
    }
    Result<commands::MeshedBody> mesh(const commands::Scene& scene, const commands::Settings& settings,
                                      const Progress& progress) override {
        Result<commands::MeshedBody> body = SwingingBeam::mesh(scene, settings, progress);
        if (!body) return body;
        test::add_bladder_and_thread(*body);
        return body;
    }
    Result<commands::Declaration> edited(const commands::Scene& scene, const commands::Declaration& declaration,
                                         const std::vector<commands::DeclarationEdit>& asked) const override {
        for (const commands::DeclarationEdit& edit : asked)
            if (const auto* set = std::get_if<commands::SetDeclared>(&edit)) last = *set;
        return SwingingBeam::edited(scene, declaration, asked);
    }

    mutable commands::SetDeclared last;
};

class CommandKnotsPanel : public testing::Test {
protected:
    void SetUp() override {
        driver.window->open("/beam");
        ASSERT_TRUE(driver.wait_for_job());
        driver.window->show_panel("signals");
        driver.settle();
    }
    /// Knot of the bladder; those of the shown trial.
    ImVec2 knot(int index) { return driver.item("signals/knot/bladder/" + std::to_string(index)).center(); }
    /// Pixels of a value of the bladder, upwards.
    float pixels(double kPa) { return static_cast<float>(kPa / 20.0) * (knot(0).y - knot(1).y); }
    /// Whether these letters stand in a line; narrow spaces are not seen.
    bool drawn(const std::string& letters) {
        for (test::DrawnText text : test::drawn_text()) {
            std::erase(text.text, ' ');
            if (text.text.find(letters) != std::string::npos) return true;
        }
        return false;
    }

    std::shared_ptr<DrivenBeam> beam = std::make_shared<DrivenBeam>();
    test::Driver driver{beam, 1280, 900};
};

TEST_F(CommandKnotsPanel, ShowTheValueWithItsUnitWhileTheyAreDragged) {
    const ImVec2 from = knot(1);
    auto& input = driver.window->input();
    input.push(platform::MouseMoved{from.x, from.y});
    input.push(platform::MouseButton{0, true, {}});
    driver.settle();
    input.push(platform::MouseMoved{from.x, from.y - 20.0f});
    driver.settle();
    EXPECT_TRUE(drawn("kPaat1s")) << "name, value, unit and time";
    input.push(platform::MouseMoved{from.x, -1e6f});
    driver.settle();
    EXPECT_TRUE(drawn("atitslimit"));
    EXPECT_EQ(beam->last.value, "[[0.0, 0.0], [1.0, 1e+07]]") << "10 MPa, the largest pressure";
    input.push(platform::MouseButton{0, false, {}});
    driver.settle();
    EXPECT_FALSE(drawn("atitslimit"));
    driver.key(ImGuiKey_Z, {.ctrl = true});
    EXPECT_FALSE(driver.state().can_undo) << "one step of undo";
}

TEST_F(CommandKnotsPanel, SnapToRoundValues) {
    driver.click("signals/snap");
    const ImVec2 from = knot(1);
    driver.drag(from, {from.x + 3.0f, from.y + pixels(4.9)});
    EXPECT_EQ(beam->last.value, "[[0.0, 0.0], [1.0, 15000.0]]");
    EXPECT_EQ(beam->last.path, (toml::TomlPath{"trial", std::size_t{0}, "pressure_Pa", "bladder"}));
}

TEST_F(CommandKnotsPanel, AreRemovedByDeleteAndByTheirMenu) {
    driver.click_at(knot(0));
    driver.key(ImGuiKey_Delete);
    EXPECT_EQ(beam->last.value, "20000.0") << "a single knot is a constant";
    EXPECT_TRUE(driver.state().can_undo);
    driver.click_at(knot(1), 1);
    driver.click("signals/menu/remove");
    EXPECT_EQ(beam->last.value, "0.0");
}

TEST_F(CommandKnotsPanel, HaveTheirNumbersInTheMenu) {
    driver.click_at(knot(1), 1);
    driver.double_click("signals/menu/value");
    driver.key(ImGuiKey_A, {.ctrl = true});
    driver.type("1.5 bar");
    driver.key(ImGuiKey_Enter);
    EXPECT_EQ(beam->last.value, "[[0.0, 0.0], [1.0, 150000.0]]");
}

TEST_F(CommandKnotsPanel, MakeACurveOfWhatIsAtRest) {
    driver.workbench->execute(commands::ChooseTrial{1});
    driver.settle();
    const ImVec2 place{knot(0).x + 60.0f, knot(0).y - 20.0f};
    driver.window->input().push(platform::MouseMoved{place.x, place.y});
    for (const bool down : {true, false, true, false}) driver.window->input().push(platform::MouseButton{0, down, {}});
    driver.settle();
    EXPECT_TRUE(beam->last.value.starts_with("[[0.0, 0.0], [")) << beam->last.value;
    EXPECT_EQ(beam->last.path, (toml::TomlPath{"trial", std::size_t{1}, "pressure_Pa", "bladder"}))
        << "of the shown trial";
}

TEST_F(CommandKnotsPanel, OfAnActuationFileAreNotDrawn) {
    EXPECT_TRUE(driver.has("plot/command/N"));
    EXPECT_FALSE(driver.has("signals/knot/thread/0"));
}

TEST_F(CommandKnotsPanel, ShareThePanelWithThoseOfMuscles) {
    driver.window->show_panel("fibres");
    driver.settle();
    driver.click("fibres/add");
    EXPECT_TRUE(driver.has("signals/knot/0")) << "the new muscle is shown";
    driver.click("signals/muscle");
    driver.click("signals/commands");
    EXPECT_TRUE(driver.has("signals/knot/bladder/0"));
    driver.click("signals/muscle");
    driver.click("signals/muscle/muscle 1");
    EXPECT_TRUE(driver.has("signals/knot/0"));
}

}  // namespace
}  // namespace myo::ui
