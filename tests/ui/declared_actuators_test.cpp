#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <variant>

#include "ui/driver.hpp"

// Rows of declared chambers and tendons: their commands in a trial, and limits of sought signals.

namespace myo::ui {
namespace {

using test::Driver;

/// The swinging beam as an experiment with a chamber and two tendons. The first trial has a file with the command of
/// one of them.
class BeamWithActuators : public test::SwingingBeam {
public:
    Result<commands::Scene> open(const std::filesystem::path& path, std::optional<double> metres_per_unit,
                                 const Progress& progress) override {
        Result<commands::Scene> scene = SwingingBeam::open(path, metres_per_unit, progress);
        if (!scene) return scene;
        scene->is_experiment = true;
        commands::DeclaredParts& declared = scene->declared;
        declared.chambers = {"bladder"};
        for (const char* name : {"left", "right"}) {
            commands::DeclaredTendon tendon;
            tendon.name = name;
            tendon.path_m = Eigen::Matrix3Xd::Zero(3, 2);
            tendon.path_m(0, 1) = 0.1;
            tendon.by_shortening = true;
            declared.tendons.push_back(tendon);
        }
        declared.limits = {{"pressure_Pa", 5e4}, {"shortening_m", 1e-3}};
        declared.commands.resize(scene->trials.size());
        declared.commands[0]["left"] = {commands::DeclaredCommand::Kind::file};
        return scene;
    }
};

struct OpenedActuators {
    std::shared_ptr<BeamWithActuators> beam = std::make_shared<BeamWithActuators>();
    Driver driver{beam, 1280, 1400};

    OpenedActuators() {
        driver.window->open("/beam");
        EXPECT_TRUE(driver.wait_for_job());
    }
    /// Value that a drag of a field by 40 pixels, 10 at a time, last declares. The beam's own value stays as it is, so
    /// that this is the effect of 10 pixels.
    double dragged(const std::string& field) {
        const ImVec2 from = driver.item(field).center();
        driver.drag(from, {from.x + 40.0f, from.y});
        return std::stod(std::get<commands::SetDeclared>(beam->edits.back()).value);
    }
};

TEST(SoughtLimits, FollowADragInStepsOfTheirShownUnit) {
    OpenedActuators opened;
    opened.driver.click("task/fit");
    const double pressure_Pa = opened.dragged("fit/limit/pressure_Pa");
    EXPECT_GT(pressure_Pa, 50.5e3);
    EXPECT_LT(pressure_Pa, 60e3) << "10 pixels of 50 kPa";
    const double shortening_m = opened.dragged("fit/limit/shortening_m");
    EXPECT_GT(shortening_m, 1.5e-3) << "10 pixels of 1 mm";
    EXPECT_LT(shortening_m, 5e-3);
}

TEST(CommandRows, OfferNoneOnlyWhereACommandCanBeRemoved) {
    OpenedActuators opened;
    Driver& driver = opened.driver;
    driver.window->show_panel("tendon");
    driver.settle();
    driver.click("tendon/list/left");
    driver.click("tendon/command/kind");
    EXPECT_TRUE(driver.has("tendon/command/kind/file"));
    EXPECT_TRUE(driver.has("tendon/command/kind/constant"));
    EXPECT_FALSE(driver.has("tendon/command/kind/rest")) << "the file would keep its column";
    driver.click("tendon/command/kind/file");
    EXPECT_TRUE(opened.beam->edits.empty());
    driver.click("tendon/list/right");
    driver.click("tendon/command/kind");
    EXPECT_FALSE(driver.has("tendon/command/kind/file"));
    EXPECT_TRUE(driver.has("tendon/command/kind/rest"));
}

}  // namespace
}  // namespace myo::ui
