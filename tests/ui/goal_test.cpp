#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "commands/search_target.hpp"
#include "ui/driver.hpp"

// The goals of a trial: their rows, and the marks in the view.

namespace myo::ui {
namespace {

using test::Driver;
using testing::HasSubstr;

/// The swinging beam as an experiment with goals. Edits are kept; the first place follows them.
class BeamWithGoals : public test::SwingingBeam {
public:
    Result<commands::Scene> open(const std::filesystem::path& path, std::optional<double> metres_per_unit,
                                 const Progress& progress) override {
        Result<commands::Scene> scene = SwingingBeam::open(path, metres_per_unit, progress);
        if (!scene || scene->trials.empty()) return scene;
        scene->is_experiment = true;
        commands::SceneGoal place;
        place.marker = "tip_top";
        place.number = 2;
        place.time_s = Eigen::VectorXd::Constant(1, 0.8);
        place.place_m = first_place_m;
        commands::SceneGoal path_over_time;
        path_over_time.marker = "middle";
        path_over_time.number = 3;
        path_over_time.time_s = Eigen::Vector2d(0.2, 1.0);
        path_over_time.place_m.resize(3, 2);
        path_over_time.place_m << 0.05, 0.05, 0.0, 0.0, 0.015, 0.03;
        path_over_time.is_path = true;
        scene->trials[0].goals = {place, path_over_time};
        return scene;
    }
    Result<commands::Declaration> edited(const commands::Scene& scene, const commands::Declaration& declaration,
                                         const std::vector<commands::DeclarationEdit>& asked) const override {
        all_edits.insert(all_edits.end(), asked.begin(), asked.end());
        if (const auto* appended = std::get_if<commands::AppendDeclared>(&asked.front())) {
            commands::Declaration result = declaration;
            result.text = std::make_shared<const std::string>(appended->body);
            return result;
        }
        return SwingingBeam::edited(scene, declaration, asked);
    }

    const Eigen::Vector3d first_place_m{0.1, 0.015, 0.05};
    mutable std::vector<commands::DeclarationEdit> all_edits;
};

struct OpenedGoals {
    std::shared_ptr<BeamWithGoals> beam = std::make_shared<BeamWithGoals>();
    Driver driver{beam, 1280, 1400};

    OpenedGoals() {
        driver.window->open("/beam");
        EXPECT_TRUE(driver.wait_for_job());
        driver.window->show_panel("goal");
        driver.settle();
    }
    const commands::SetDeclared& last_set() const { return std::get<commands::SetDeclared>(beam->all_edits.back()); }
};

TEST(GoalPanel, ListsGoalsWithPlacesAndTimes) {
    OpenedGoals opened;
    Driver& driver = opened.driver;
    for (const char* item : {"goal/0/place/x", "goal/0/place/z", "goal/0/time", "goal/0/weight", "goal/1/path"})
        EXPECT_TRUE(driver.has(item)) << item;
    EXPECT_FALSE(driver.has("goal/0/until")) << "no span";
    EXPECT_FALSE(driver.has("goal/1/time")) << "a path has its own times";
    EXPECT_EQ(commands::target_words(driver.state().scene->trials[0]), "2 goals of gravity_release");
    EXPECT_EQ(commands::target_words(driver.state().scene->trials[1]), "recording of pull_release");
}

TEST(GoalPanel, EditsPlaceAndTimeAndRemoves) {
    OpenedGoals opened;
    Driver& driver = opened.driver;
    driver.double_click("goal/0/time");
    driver.key(ImGuiKey_A, {.ctrl = true});
    driver.type("700 ms");
    driver.key(ImGuiKey_Enter);
    ASSERT_EQ(opened.beam->all_edits.size(), 1u);
    EXPECT_EQ(opened.last_set().path, (toml::TomlPath{"trial", std::size_t{0}, "goal", std::size_t{0}, "time_s"}));
    EXPECT_EQ(opened.last_set().value, "0.7");
    driver.double_click("goal/0/place/z");
    driver.key(ImGuiKey_A, {.ctrl = true});
    driver.type("6 cm");
    driver.key(ImGuiKey_Enter);
    ASSERT_EQ(opened.beam->all_edits.size(), 2u);
    EXPECT_EQ(opened.last_set().value, "[0.1, 0.015, 0.06]");
    driver.click("goal/1/remove");
    ASSERT_EQ(opened.beam->all_edits.size(), 3u);
    EXPECT_EQ(std::get<commands::RemoveDeclared>(opened.beam->all_edits.back()).path,
              (toml::TomlPath{"trial", std::size_t{0}, "goal", std::size_t{1}}));
}

TEST(GoalPanel, AddsAGoalForTheChosenMarkerWhereItIsInTheShownRun) {
    OpenedGoals opened;
    Driver& driver = opened.driver;
    driver.workbench->execute(commands::ChooseMarker{3});
    driver.click("goal/add");
    EXPECT_THAT(*driver.state().settings.declaration.text,
                HasSubstr("marker = \"middle\"\nplace_m = [0.05, 0.0, 0.015]"))
        << "at rest without a run";
    driver.workbench->execute(commands::Run{});
    ASSERT_TRUE(driver.wait_for_job());
    driver.workbench->execute(commands::SetTime{0.5});
    driver.settle();
    const Eigen::VectorXd& times = driver.state().scene_trial()->time_s;
    Eigen::Index sample = 0;
    (times.array() - 0.5).abs().minCoeff(&sample);
    const Eigen::Vector3d there = driver.state().simulated_trial()->markers[3].col(sample);
    driver.click("goal/add");
    const std::string text = *driver.state().settings.declaration.text;
    EXPECT_THAT(text, HasSubstr("time_s = 0.5"));
    double x = 0.0, y = 0.0, z = 0.0;
    ASSERT_EQ(std::sscanf(text.c_str(), "marker = \"middle\"\nplace_m = [%lf, %lf, %lf]", &x, &y, &z), 3) << text;
    EXPECT_LT((Eigen::Vector3d(x, y, z) - there).norm(), 2e-6);
}

/// A drag moves the goal in the plane of the image and is one edit; the camera stands still.
TEST(GoalTool, MovesAGoalInThePlaneOfTheImage) {
    OpenedGoals opened;
    Driver& driver = opened.driver;
    driver.workbench->execute(commands::SetTime{0.8});
    driver.settle();
    ASSERT_TRUE(driver.has("view/goal/0"));
    const viewport::Camera before = driver.window->viewport().camera;
    const ImVec2 from = test::pixel_of(driver, opened.beam->first_place_m), to{from.x + 40.0f, from.y - 30.0f};
    driver.drag(from, to);
    ASSERT_EQ(opened.beam->all_edits.size(), 1u) << "one undo step";
    EXPECT_TRUE(driver.window->viewport().camera == before);
    EXPECT_EQ(opened.last_set().path, (toml::TomlPath{"trial", std::size_t{0}, "goal", std::size_t{0}, "place_m"}));
    Eigen::Vector3d moved;
    ASSERT_EQ(std::sscanf(opened.last_set().value.c_str(), "[%lf, %lf, %lf]", &moved.x(), &moved.y(), &moved.z()), 3);
    const Eigen::Vector3d by = moved - opened.beam->first_place_m;
    EXPECT_GT(by.norm(), 1e-3);
    EXPECT_NEAR(by.normalized().dot(viewport::camera_axes(before).back), 0.0, 1e-6) << "its depth stays";
    const ImVec2 seen = test::pixel_of(driver, moved);
    EXPECT_NEAR(seen.x, to.x, 2.0);
    EXPECT_NEAR(seen.y, to.y, 2.0);
}

TEST(GoalTool, MovesOnePointOfAPath) {
    OpenedGoals opened;
    Driver& driver = opened.driver;
    const ImVec2 from = test::pixel_of(driver, {0.05, 0.0, 0.03});
    driver.drag(from, {from.x, from.y - 25.0f});
    ASSERT_EQ(opened.beam->all_edits.size(), 1u);
    EXPECT_EQ(opened.last_set().path.back(), toml::TomlPath{"places_m"}.back());
    EXPECT_THAT(opened.last_set().value, testing::StartsWith("[[0.05, 0.0, 0.015], ["));
}

/// Without goals and without a recording there is nothing to follow.
TEST(GoalPanel, SaysWhatOptimiseFollows) {
    commands::SceneTrial planned;
    planned.role = "simulate";
    planned.measured.resize(1);
    EXPECT_FALSE(commands::has_target(planned));
    planned.goals.resize(1);
    EXPECT_TRUE(commands::has_target(planned));
    planned.goals.clear();
    planned.role = "validate";
    EXPECT_TRUE(commands::has_target(planned));
}

}  // namespace
}  // namespace myo::ui
