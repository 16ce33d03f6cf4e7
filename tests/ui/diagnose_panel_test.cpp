#include <gtest/gtest.h>

#include <cmath>

#include "commands/force_arrows.hpp"
#include "ui/driver.hpp"
#include "viewport/view_overlay.hpp"

namespace myo::ui {
namespace {

using test::Driver;

void open_panel(Driver& driver) {
    driver.open_beam();
    driver.click("panel/diagnose");
}

void diagnose(Driver& driver) {
    open_panel(driver);
    driver.click("diagnose/diagnose");
    ASSERT_TRUE(driver.wait_for_job());
    ASSERT_TRUE(driver.state().diagnosis);
}

TEST(DiagnosePanel, OffersNothingWithoutMeasurements) {
    Driver driver;
    driver.workbench->execute(commands::Diagnose{});
    EXPECT_EQ(driver.state().log.back().level, commands::LogLevel::warning);
    driver.workbench->execute(commands::Open{"/body.stl", 1e-3});
    ASSERT_TRUE(driver.wait_for_job());
    driver.click("panel/diagnose");
    EXPECT_FALSE(driver.has("diagnose/diagnose"));
    driver.workbench->execute(commands::Diagnose{});
    EXPECT_FALSE(driver.state().busy());
}

TEST(DiagnosePanel, RanksWhileItRunsAndStaysLive) {
    Driver driver;
    open_panel(driver);
    driver.backend->hold_diagnosis = true;
    driver.click("diagnose/diagnose");
    ASSERT_TRUE(driver.state().diagnosing());
    for (int i = 0; i < 2000 && !driver.has("diagnose/row/quadratic_drag"); ++i) driver.frame();
    ASSERT_TRUE(driver.state().diagnosing()) << "the ranking must show before the end";
    ASSERT_TRUE(driver.has("diagnose/row/quadratic_drag"));
    EXPECT_FALSE(driver.state().diagnosis->complete);
    EXPECT_EQ(driver.state().job->remaining_of, commands::TimeLeft::of_phase) << "every phase counts anew";
    // Choosing, scrubbing and plotting go on meanwhile.
    driver.click("diagnose/row/added_mass");
    EXPECT_EQ(driver.state().candidate, "added_mass");
    EXPECT_FALSE(driver.has("diagnose/add"));
    const platform::Rectangle plot = driver.item("diagnose/plot");
    driver.click_at({plot.lowest.x + 0.5f * plot.width(), plot.center().y});
    EXPECT_NEAR(driver.state().time_s, 0.9, 0.05);
    driver.backend->hold_diagnosis = false;
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_TRUE(driver.state().diagnosis->complete);
    EXPECT_EQ(driver.state().candidate, "added_mass") << "the end must not take the choice away";
    EXPECT_NE(driver.state().log.back().text.find("Linear drag is missing"), std::string::npos);
}

TEST(DiagnosePanel, CancelledItKeepsWhatItKnew) {
    Driver driver;
    open_panel(driver);
    driver.backend->hold_diagnosis = true;
    driver.click("diagnose/diagnose");
    for (int i = 0; i < 2000 && !driver.has("diagnose/row/quadratic_drag"); ++i) driver.frame();
    driver.click("diagnose/cancel");
    ASSERT_TRUE(driver.wait_for_job());
    ASSERT_TRUE(driver.state().diagnosis);
    EXPECT_TRUE(driver.state().diagnosis->stopped);
    EXPECT_FALSE(driver.state().diagnosis->complete);
    EXPECT_EQ(driver.state().diagnosis->rows.size(), 3u);
    EXPECT_TRUE(driver.has("diagnose/diagnose"));
}

TEST(DiagnosePanel, AFittedValueIsWrittenOut) {
    Driver driver(1600, 900);
    diagnose(driver);
    driver.settle();
    EXPECT_NEAR(driver.item("diagnose/value/linear_drag").width(), ImGui::CalcTextSize("41 \xc2\xb1 2 Pa s/m").x, 1.0f)
        << "without the name of its only parameter, and not cut";
}

TEST(DiagnosePanel, ShowsTheVerdictsRowAndAnyOther) {
    Driver driver;
    diagnose(driver);
    ASSERT_TRUE(driver.state().diagnosis_row());
    EXPECT_EQ(driver.state().diagnosis_row()->key, "linear_drag");
    // Rows stand in the order of the ranking.
    EXPECT_LT(driver.item("diagnose/row/linear_drag").center().y,
              driver.item("diagnose/row/quadratic_drag").center().y);
    EXPECT_LT(driver.item("diagnose/row/quadratic_drag").center().y, driver.item("diagnose/row/added_mass").center().y);
    EXPECT_TRUE(driver.has("diagnose/because"));
    driver.click("diagnose/row/quadratic_drag");
    EXPECT_EQ(driver.state().diagnosis_row()->key, "quadratic_drag");
    driver.click("diagnose/marker");
    driver.click("diagnose/marker/middle");
    EXPECT_EQ(driver.state().marker, 3);
    driver.click("diagnose/axis");
    driver.click("diagnose/axis/x");
    EXPECT_TRUE(driver.has("diagnose/plot"));
    driver.click("diagnose/show/errors");
    EXPECT_FALSE(driver.has("diagnose/plot"));
    driver.click("diagnose/error/pull_release");
    EXPECT_EQ(driver.state().trial, 1);
    driver.click("diagnose/show/residual");
    EXPECT_TRUE(driver.has("diagnose/plot"));
}

TEST(DiagnosePanel, DrawsTheForceAsArrowsOfItsSize) {
    Driver driver;
    driver.backend->unexplained = false;
    diagnose(driver);
    driver.workbench->execute(commands::SetTime{0.0});
    driver.settle();
    const viewport::DrawnScene& scene = driver.window->scene();
    ASSERT_TRUE(scene.arrows);
    EXPECT_NE(scene.arrows->name.find("linear drag"), std::string::npos);
    EXPECT_LT(scene.body_opacity, 1.0);
    // The clamp's twelve edges come first, then all arrows in one line: shaft and four barbs each.
    const auto longest = [](const viewport::DrawnScene& drawn) {
        double most = 0.0;
        for (const viewport::DrawnLine& line : drawn.lines)
            for (Eigen::Index i = 1; i < line.points.cols() && line.color == drawn.arrows->color; ++i)
                if (line.points.col(i).allFinite() && line.points.col(i - 1).allFinite())
                    most = std::max(most, (line.points.col(i) - line.points.col(i - 1)).norm());
        return most;
    };
    EXPECT_NEAR(longest(scene), scene.arrows->metres_per_N * 1e-2, 1e-9);
    driver.workbench->execute(commands::SetTime{1.0});
    driver.settle();
    EXPECT_NEAR(longest(driver.window->scene()), scene.arrows->metres_per_N * 1e-2 * std::exp(-1.0), 1e-6);
    // Off by the view's options, and with an effect that has none.
    driver.click("view/options");
    driver.click("view/effect_force");
    EXPECT_FALSE(driver.window->scene().arrows);
    driver.key(ImGuiKey_Escape);
    commands::ViewOptions view = driver.state().view;
    view.effect_force = true;
    driver.workbench->execute(commands::ChangeView{view});
    driver.workbench->execute(commands::ChooseCandidate{"quadratic_drag"});
    driver.settle();
    EXPECT_FALSE(driver.window->scene().arrows);
}

TEST(DiagnosePanel, ColoursTheBodyByTheForce) {
    Driver driver;
    driver.backend->unexplained = false;
    diagnose(driver);
    commands::ViewOptions view = driver.state().view;
    view.field = "effect_force";
    driver.workbench->execute(commands::ChangeView{view});
    driver.workbench->execute(commands::SetTime{1.0});
    driver.settle();
    ASSERT_TRUE(driver.window->scene().field);
    EXPECT_NEAR(driver.window->scene().field->highest, 10.0, 1e-9) << "of the whole trial [mN]";
    EXPECT_NEAR(driver.window->scene().field->values.maxCoeff(), 10.0 * std::exp(-1.0), 1e-6);
    EXPECT_FALSE(driver.window->must_draw()) << "the same content is the same picture";
    driver.workbench->execute(commands::ChooseCandidate{"quadratic_drag"});
    driver.settle();
    EXPECT_FALSE(driver.window->scene().field) << "it has no force";
}

TEST(DiagnosePanel, ShowsTheForceThatIsMissing) {
    Driver driver;
    driver.backend->unexplained = true;
    diagnose(driver);
    EXPECT_EQ(driver.state().diagnosis_row()->kind, commands::DiagnosisRow::Kind::missing_force);
    EXPECT_TRUE(driver.has("diagnose/plot"));
    EXPECT_FALSE(driver.has("diagnose/marker"));
    EXPECT_FALSE(driver.has("diagnose/add"));
    driver.workbench->execute(commands::AddEffect{"missing force"});
    EXPECT_TRUE(driver.state().settings.effects.empty());
    driver.workbench->execute(commands::SetTime{0.0});
    driver.settle();
    ASSERT_TRUE(driver.window->scene().arrows);
    EXPECT_EQ(driver.window->scene().arrows->name, "Missing force");
    // It was inferred for the first trial only.
    driver.workbench->execute(commands::ChooseTrial{1});
    driver.settle();
    EXPECT_FALSE(driver.window->scene().arrows);
}

TEST(DiagnosePanel, AddsTheEffectAndUndoes) {
    Driver driver;
    diagnose(driver);
    driver.click("run/run");
    ASSERT_TRUE(driver.wait_for_job());
    driver.click("panel/diagnose");
    ASSERT_TRUE(driver.state().run_is_current());
    driver.click("diagnose/add");
    ASSERT_EQ(driver.state().settings.effects.size(), 1u);
    EXPECT_EQ(driver.state().settings.effects.front().declaration.id, "linear_drag");
    EXPECT_EQ(driver.state().settings.youngs_modulus_Pa, 2.55e5) << "values that were fitted beside it come along";
    EXPECT_FALSE(driver.state().run_is_current()) << "the next run has it";
    EXPECT_TRUE(driver.state().mesh_is_current());
    driver.click("diagnose/add");  // it is there: nothing happens
    EXPECT_EQ(driver.state().settings.effects.size(), 1u);
    driver.key(ImGuiKey_Z, {.ctrl = true});
    EXPECT_TRUE(driver.state().settings.effects.empty());
    EXPECT_EQ(driver.state().settings.youngs_modulus_Pa, 2.6e5);
    EXPECT_TRUE(driver.state().run_is_current());
    driver.key(ImGuiKey_Y, {.ctrl = true});
    ASSERT_EQ(driver.state().settings.effects.size(), 1u);
    // Another candidate takes its place, and each can be taken out in the panel of effects.
    driver.click("diagnose/row/quadratic_drag");
    driver.click("diagnose/add");
    ASSERT_EQ(driver.state().settings.effects.size(), 1u);
    EXPECT_EQ(driver.state().settings.effects.front().declaration.id, "quadratic_drag");
    driver.window->show_panel("effect");
    driver.settle();
    driver.click("effect/added/0/remove");
    EXPECT_TRUE(driver.state().settings.effects.empty());
}

TEST(DiagnosePanel, IsForgottenWithItsExperiment) {
    Driver driver;
    diagnose(driver);
    driver.click("diagnose/row/quadratic_drag");
    driver.open_beam();
    EXPECT_FALSE(driver.state().diagnosis);
    EXPECT_TRUE(driver.state().candidate.empty());
    EXPECT_TRUE(driver.has("diagnose/diagnose"));
}

TEST(DiagnosePanel, NothingIsCutOffAtUsualSizes) {
    for (const auto& [width, height] : {std::pair{1280, 800}, std::pair{1600, 900}}) {
        Driver driver(width, height);
        diagnose(driver);
        for (const float scale : {1.0f, 1.25f, 1.5f, 2.0f}) {
            if (scale > 1.5f && width < 1600) continue;  // less room than any screen has at that scale
            driver.workbench->execute(commands::SetTheme{platform::ThemeName::light, scale});
            driver.settle();
            for (const char* name :
                 {"diagnose/diagnose", "diagnose/add", "diagnose/verdict", "diagnose/row/declared",
                  "diagnose/row/linear_drag", "diagnose/marker", "diagnose/axis", "diagnose/plot", "panel/messages"}) {
                // Where there is no room beside the ranking, one is shown at a time.
                const bool of_ranking = std::string(name).rfind("diagnose/row", 0) == 0;
                if (!driver.has(name) && driver.has("diagnose/show/ranking"))
                    driver.click(of_ranking ? "diagnose/show/ranking" : "diagnose/show/residual");
                const platform::Rectangle r = driver.item(name);
                EXPECT_GE(r.lowest.x, 0.0f) << name;
                EXPECT_LE(r.highest.x, static_cast<float>(width)) << name << " at " << scale << ", " << width;
                EXPECT_LE(r.highest.y, static_cast<float>(height)) << name << " at " << scale << ", " << width;
                EXPECT_GT(r.width(), 12.0f) << name << " at " << scale << ", " << width;
                EXPECT_GT(r.height(), 12.0f) << name << " at " << scale << ", " << width;
            }
            // At the largest size in the smallest window it is told on hovering.
            EXPECT_TRUE(scale > 1.25f || driver.has("diagnose/because")) << scale << ", " << width;
            EXPECT_LE(driver.item("diagnose/verdict").highest.x, driver.item("diagnose/add").lowest.x)
                << scale << ", " << width;
            EXPECT_GT(driver.item("diagnose/plot").height(), 40.0f) << scale << ", " << width;
        }
    }
}

TEST(ForceBar, HasNiceNumbersAndUnits) {
    EXPECT_EQ(viewport::make_scale_bar(1e-5, 120.0, "N").label, "1 mN");
    EXPECT_EQ(viewport::make_scale_bar(1e-8, 120.0, "N").label, "1 \xc2\xb5N");
    EXPECT_EQ(viewport::make_scale_bar(0.2, 120.0, "N").label, "20 N");
    EXPECT_NEAR(viewport::make_scale_bar(1e-5, 120.0, "N").pixels, 100.0, 1e-6);
}

}  // namespace
}  // namespace myo::ui
