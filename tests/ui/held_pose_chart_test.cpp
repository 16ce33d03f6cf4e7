#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "panels/signal_series.hpp"
#include "ui/bare_workbench.hpp"
#include "ui/bladder_and_thread.hpp"
#include "ui/driver.hpp"

// Commands of chambers and tendons over time, also in a trial that has one time only.

namespace myo::ui::held_pose_chart {
namespace {

using test::Driver;
using Values = std::vector<double>;

/// The beam with a chamber and a tendon. Its first trial is a pose that is held; in the second the pressure rises.
class HeldBeam : public test::CoarseBeam {
public:
    Result<commands::Scene> open(const std::filesystem::path& path, std::optional<double> metres_per_unit,
                                 const Progress& progress) override {
        Result<commands::Scene> scene = CoarseBeam::open(path, metres_per_unit, progress);
        if (!scene) return scene;
        commands::SceneTrial& held = scene->trials[0];
        held.time_s = Eigen::VectorXd::Zero(1);
        for (Eigen::Matrix3Xd& track : held.measured) track = Eigen::Matrix3Xd(track.leftCols(1));
        held.commands["bladder"] = {fibre::Signal::constant(2e4), "kPa", 1e3};
        held.commands["thread"] = {fibre::Signal::constant(4e-3), "mm", 1e-3};
        scene->trials[1].commands["bladder"] = {{{0.5, 1.5}, {0.0, 2e4}}, "kPa", 1e3};
        return scene;
    }
    Result<commands::MeshedBody> mesh(const commands::Scene& scene, const commands::Settings& settings,
                                      const Progress& progress) override {
        Result<commands::MeshedBody> body = CoarseBeam::mesh(scene, settings, progress);
        if (!body) return body;
        test::add_bladder_and_thread(*body);
        return body;
    }
};

struct OpenedCommands {
    Driver driver{std::make_shared<HeldBeam>(), 1280, 800};

    OpenedCommands() {
        driver.window->open("/beam");
        EXPECT_TRUE(driver.wait_for_job());
        EXPECT_TRUE(driver.window->show_panel("signals"));
        driver.settle();
    }
    /// Where the line of the shown time stands in a plot, as a share of its width.
    double cursor(const std::string& unit) {
        const platform::Rectangle plot = driver.item("plot/command/" + unit),
                                  line = driver.item("plot/command/" + unit + "/cursor");
        return static_cast<double>((line.center().x - plot.lowest.x) / plot.width());
    }
};

TEST(HeldPoseChart, HasTheTimeOfThePoseInItsMiddle) {
    OpenedCommands opened;
    for (const char* unit : {"kPa", "mm"}) EXPECT_NEAR(opened.cursor(unit), 0.5, 0.01) << unit;
    const platform::Rectangle pressure = opened.driver.item("plot/command/kPa"),
                              shortening = opened.driver.item("plot/command/mm");
    EXPECT_EQ(pressure.lowest.x, shortening.lowest.x);
    EXPECT_EQ(pressure.highest.x, shortening.highest.x);
    EXPECT_NEAR(pressure.height(), shortening.height(), 20.0f) << "they share the panel";
    EXPECT_LT(pressure.highest.y, shortening.lowest.y);
    // There is no other time to go to, and nothing to play.
    opened.driver.click_at({pressure.lowest.x + 0.1f * pressure.width(), pressure.center().y});
    EXPECT_EQ(opened.driver.state().time_s, 0.0);
    EXPECT_NEAR(opened.cursor("kPa"), 0.5, 0.01);
    opened.driver.workbench->execute(commands::Play{});
    EXPECT_FALSE(opened.driver.state().playing);
}

TEST(CommandChart, OfATrialWithADurationIsAsLongAsTheTrial) {
    OpenedCommands opened;
    opened.driver.workbench->execute(commands::ChooseTrial{1});
    opened.driver.settle();
    EXPECT_FALSE(opened.driver.has("plot/command/mm")) << "the thread has no command in it";
    EXPECT_NEAR(opened.cursor("kPa"), 0.2 / 2.2, 0.01);
    const platform::Rectangle plot = opened.driver.item("plot/command/kPa");
    opened.driver.click_at({plot.lowest.x + 0.6f * plot.width(), plot.center().y});
    EXPECT_NEAR(opened.driver.state().time_s, -0.2 + 0.6 * 2.2, 0.02);
    EXPECT_NEAR(opened.cursor("kPa"), 0.6, 0.01);
}

TEST(SignalSeries, GoesOnToTheEndsOfTheRangeInTheShownUnit) {
    const fibre::Signal ramp{{0.0, 1.0}, {2e4, 3e4}};
    const auto series = [&](const chart::Range& range, const fibre::Signal& signal) {
        return panels::signal_series("bladder", signal, range, {1.0f, 0.0f, 0.0f, 1.0f}, 1e3);
    };
    EXPECT_EQ(series({-1.0, 2.0}, ramp).x, (Values{-1.0, 0.0, 1.0, 2.0}));
    EXPECT_EQ(series({-1.0, 2.0}, ramp).y, (Values{20.0, 20.0, 30.0, 30.0}));
    EXPECT_EQ(series({0.0, 1.0}, ramp).x, (Values{0.0, 1.0})) << "no point twice";
    EXPECT_EQ(series({0.25, 0.5}, ramp).x, (Values{0.0, 1.0})) << "its knots are kept beyond the range";
    EXPECT_EQ(series({-0.5, 0.5}, fibre::Signal::constant(5e3)).x, (Values{-0.5, 0.0, 0.5}));
    EXPECT_EQ(series({-0.5, 0.5}, fibre::Signal::constant(5e3)).y, (Values{5.0, 5.0, 5.0}));
    EXPECT_EQ(series({0.0, 1.0}, ramp).name, "bladder");
}

}  // namespace
}  // namespace myo::ui::held_pose_chart
