#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "backend/workbench_backend.hpp"
#include "panels/layout.hpp"
#include "support/folder.hpp"
#include "ui/drawn_text.hpp"
#include "ui/driver.hpp"
#include "workbench/example_copy.hpp"

// Every panel and dialog, in windows of several sizes: no text is cut off or lies over another one, and nothing
// reaches beyond its part of the window.

namespace myo {
namespace {

using test::Driver;
using ui::platform::Rectangle;

struct WindowSize {
    int width, height;
    float scale;
};
// The high ones show all of a panel at once, which the others must be scrolled for.
constexpr WindowSize sizes[] = {
    {1600, 900, 1.0f}, {1600, 900, 2.0f}, {1000, 640, 1.0f}, {1000, 2600, 1.0f}, {1600, 4200, 2.0f}};

/// Items whose right edge lies outside of the part of the window in which they begin.
std::vector<std::string> items_beyond(Driver& driver) {
    const ui::panels::Layout layout = ui::panels::make_layout(static_cast<float>(driver.width),
                                                              static_cast<float>(driver.height), driver.state().scale(),
                                                              driver.state().preferences.layout);
    std::vector<std::string> beyond;
    for (const auto& [name, place] : driver.window->items().all())
        for (const Rectangle& part : {layout.bar, layout.steps, layout.rail, layout.timeline, layout.strip})
            if (part.contains(place.lowest) && place.highest.x > part.highest.x + 1.0f)
                beyond.push_back(name + " ends at " + std::to_string(std::lround(place.highest.x)) + " of " +
                                 std::to_string(std::lround(part.highest.x)));
    return beyond;
}

class PanelLayout : public ::testing::Test {
protected:
    Driver driver{backend::make_core_backend(), 1600, 4200};

    void open(const std::filesystem::path& file) {
        driver.window->open(file);
        ASSERT_TRUE(driver.wait_for_job(60));
        ASSERT_TRUE(driver.state().scene) << driver.state().log.back().text;
    }
    void open_example(const std::string& example) {
        open(std::filesystem::path(MYOLOOP_SOURCE_DIR) / "assets" / "examples" / example);
    }
    void finish(const ui::commands::Command& job) {
        driver.workbench->execute(job);
        ASSERT_TRUE(driver.wait_for_job(240));
    }
    void resize(const WindowSize& size) {
        driver.width = size.width;
        driver.height = size.height;
        driver.workbench->execute(ui::commands::SetTheme{ui::platform::ThemeName::dark, size.scale});
        driver.settle();
    }
    /// Paths and names that are typed may be longer than their field.
    bool is_typed(const test::DrawnText& text) {
        for (const char* field : {"body/path", "report/folder", "browser/path", "browser/name"})
            if (const auto place = driver.window->items().find(field); place && place->contains(text.part.lowest))
                return true;
        return false;
    }
    void expect_readable_now(const std::string& what) {
        std::vector<test::DrawnText> texts = test::drawn_text();
        // Labels of the scene lie where its points are. Beside the help a small window has no room for plots and time.
        const bool beside_help = driver.has("help/close");
        std::erase_if(texts, [&](const test::DrawnText& text) {
            return text.window == "##view" || text.window == "##compared" || is_typed(text) ||
                   (beside_help && (text.window.starts_with("##strip") || text.window.starts_with("##timeline")));
        });
        for (const std::string& defect : test::text_defects(texts)) add_failure(what, defect);
    }
    void add_failure(const std::string& what, const std::string& defect) {
        ADD_FAILURE() << what << ", " << driver.width << " x " << driver.height << " at "
                      << 100.0f * driver.state().scale() << " %: " << defect;
    }
    void expect_readable(const std::string& state, const std::set<std::string>& panels) {
        for (const WindowSize& size : sizes) {
            resize(size);
            for (const std::string& panel : panels) {
                ASSERT_TRUE(driver.window->show_panel(panel));
                driver.settle();
                expect_readable_now(state + ", panel " + panel);
                for (const std::string& item : items_beyond(driver)) add_failure(state + ", panel " + panel, item);
            }
        }
    }
    void expect_all_readable(const std::string& state) {
        std::set<std::string> panels;
        for (const std::string& name : driver.window->panel_names()) panels.insert(name);
        for (const std::string help : {"tutorial", "manual", "keys"}) panels.erase(help);
        expect_readable(state, panels);
    }
    /// Presses a button of a panel in a window that shows all of it.
    void press(const std::string& panel, const std::string& item) {
        resize({1600, 4200, 1.0f});
        driver.window->show_panel(panel);
        driver.settle();
        driver.click(item);
        driver.settle();
        EXPECT_TRUE(driver.state().refused.empty()) << item << ": " << driver.state().refused;
    }
    void choose(const std::string& menu, const std::string& entry) {
        driver.click("menu/" + menu);
        driver.click("menu/" + entry);
        driver.settle();
    }
};

TEST_F(PanelLayout, OfTheStartPage) { expect_all_readable("start"); }

TEST_F(PanelLayout, OfABeamThatIsCalibratedAndDiagnosed) {
    ASSERT_NO_FATAL_FAILURE(open_example("silicone_beam"));
    expect_all_readable("as opened");
    ASSERT_NO_FATAL_FAILURE(finish(ui::commands::Calibrate{}));
    ASSERT_NO_FATAL_FAILURE(finish(ui::commands::Diagnose{}));
    expect_all_readable("diagnosed");
}

TEST_F(PanelLayout, OfAnArmWhoseSignalsAreFound) {
    ASSERT_NO_FATAL_FAILURE(open_example("soft_arm"));
    ASSERT_NO_FATAL_FAILURE(finish(ui::commands::Optimize{}));
    expect_all_readable("optimised");
}

TEST_F(PanelLayout, OfAFingerWithAChamber) {
    ASSERT_NO_FATAL_FAILURE(open_example("pneumatic_finger"));
    ASSERT_NO_FATAL_FAILURE(finish(ui::commands::Run{}));
    expect_all_readable("finger");
}

TEST_F(PanelLayout, OfATentacleWithTendons) {
    ASSERT_NO_FATAL_FAILURE(open_example("tendon_tentacle"));
    ASSERT_NO_FATAL_FAILURE(finish(ui::commands::Run{}));
    expect_all_readable("tentacle");
}

/// Everything that can be added with one click is added; what was added is open.
TEST_F(PanelLayout, OfWhatIsAdded) {
    const test::Folder folder("panel_layout");
    ASSERT_NO_FATAL_FAILURE(open(test::example_copy(folder, "silicone_beam")));
    for (const auto& [panel, item] :
         std::vector<std::pair<std::string, std::string>>{{"obstacle", "obstacle/add_plane"},
                                                          {"obstacle", "obstacle/add_sphere"},
                                                          {"obstacle", "obstacle/add_box"},
                                                          {"support", "support/more/add"},
                                                          {"part", "part/add"},
                                                          {"trial", "trial/add_force"},
                                                          {"trial", "trial/add_mass"},
                                                          {"goal", "goal/add"},
                                                          {"fibres", "fibres/add"}}) {
        ASSERT_NO_FATAL_FAILURE(press(panel, item));
        expect_readable(item, {panel});
    }
    ASSERT_NO_FATAL_FAILURE(press("effect", "effect/add"));
    driver.click("effect/add/point_mass");
    expect_readable("effect/add", {"effect"});
    ASSERT_NO_FATAL_FAILURE(press("unknown", "unknown/bounds/" + driver.state().scene->fitted.front().name));
    expect_readable("bounds", {"unknown"});
    for (const ui::commands::Choice& law : driver.state().materials) {
        ui::commands::Settings settings = driver.state().settings;
        settings.material = law.id;
        driver.workbench->execute(ui::commands::ChangeSettings{settings, "material"});
        expect_readable(law.id, {"material"});
    }
    ASSERT_NO_FATAL_FAILURE(press("live", "live/play"));
    expect_readable("live", {"live"});
}

TEST_F(PanelLayout, OfDialogsAndHelp) {
    ASSERT_NO_FATAL_FAILURE(open_example("silicone_beam"));
    for (const WindowSize& size : {sizes[0], sizes[1], sizes[2]}) {
        resize(size);
        for (const auto& [menu, entry] : std::vector<std::pair<std::string, std::string>>{{"file", "file.open"},
                                                                                          {"file", "file.save_as"},
                                                                                          {"file", "file.picture"},
                                                                                          {"file", "file.export"},
                                                                                          {"help", "help.about"},
                                                                                          {"help", "help.manual"},
                                                                                          {"help", "help.tutorial"},
                                                                                          {"help", "help.shortcuts"}}) {
            ASSERT_NO_FATAL_FAILURE(choose(menu, entry));
            expect_readable_now(entry);
            for (const char* close : {"browser/cancel", "picture/cancel", "export/cancel", "about/close", "help/close"})
                if (driver.has(close)) driver.click(close);
        }
        for (const std::string menu : {"file", "edit", "view", "run", "help"}) {
            driver.click("menu/" + menu);
            expect_readable_now("menu " + menu);
            driver.key(ImGuiKey_Escape);
        }
    }
}

}  // namespace
}  // namespace myo
