#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <string>

#include "backend/workbench_backend.hpp"
#include "base/files.hpp"
#include "commands/scene_at_time.hpp"
#include "support/folder.hpp"
#include "ui/driver.hpp"
#include "workbench/by_hand.hpp"

namespace myo::test {

/// A window of a person with a body of their own: everything is set by widgets, no file is edited by hand.
class OwnRobot : public testing::Test {
protected:
    Driver driver{backend::make_core_backend(), 1400, 1500};

    const ui::commands::WorkbenchState& state() const { return driver.state(); }
    void wait(int seconds) {
        ASSERT_TRUE(driver.wait_for_job(seconds));
        ASSERT_NE(state().log.back().level, ui::commands::LogLevel::failure) << state().log.back().text;
    }
    void type_into(const std::string& item, const std::string& text, bool enter = true) {
        myo::test::type_into(driver, item, text, enter);
    }
    void choose(const std::filesystem::path& path) { choose_file(driver, path); }
    void pick(const std::string& list, const std::string& choice) {
        driver.click(list);
        driver.click(list + "/" + choice);
        driver.settle();
    }
    void panel(const std::string& name) {
        driver.window->show_panel(name);
        driver.settle();
    }
    /// Clicks on the track of the timeline; its ends are 8 pixels from those of its item.
    void show_time(double time_s) {
        const ui::platform::Rectangle track = driver.item("timeline/track");
        const auto span = ui::commands::time_span(state());
        const double share = (time_s - span[0]) / (span[1] - span[0]);
        driver.click_at(
            {track.lowest.x + 8.0f + static_cast<float>(share) * (track.width() - 16.0f), track.center().y});
        EXPECT_NEAR(state().time_s, time_s, 2e-3 * (span[1] - span[0]));
    }
    void run() {
        driver.click("run/run");
        ASSERT_NO_FATAL_FAILURE(wait(200));
        ASSERT_TRUE(state().run && state().run->problem.empty()) << state().log.back().text;
    }
    /// Edits from here on are counted.
    void begin_edits() {
        edits_ = 0;
        could_undo_ = state().can_undo;
    }
    /// An edit, which has to change something; undo_edits() expects one step of undo for each.
    void edit(const std::function<void()>& make) {
        const ui::commands::Settings before = state().settings;
        make();
        EXPECT_FALSE(state().settings == before) << "edit " << edits_ << " changed nothing: " << state().refused;
        ++edits_;
    }
    /// Types a number into a field, as one edit.
    void edit_number(const std::string& item, const std::string& text) {
        edit([&] { type_into(item, text); });
    }
    void undo_edits() {
        for (int step = 0; step < edits_; ++step) {
            EXPECT_TRUE(state().can_undo) << "after " << step << " of " << edits_;
            driver.click("bar/undo");
        }
        EXPECT_EQ(state().can_undo, could_undo_) << "more steps than edits";
    }
    /// The experiment as it would be saved.
    std::string declaration(const Folder& folder) const {
        const auto& edited = state().settings.declaration.text;
        return edited ? *edited : *read_file(folder.path() / "robot" / "experiment.toml");
    }
    /// Place of a marker at the shown time, in the shown run [m].
    Eigen::Vector3d simulated_place(const std::string& marker) const {
        const auto& markers = state().scene->markers;
        const auto found = std::find_if(markers.begin(), markers.end(),
                                        [&](const auto& m) { return m.name == marker; });
        return ui::commands::at_time(
            state().simulated_trial()->markers.at(static_cast<std::size_t>(found - markers.begin())),
            ui::commands::place_in_time(state().scene_trial()->time_s, state().time_s));
    }
    /// Types a place in millimetres, as one edit for each coordinate that changes.
    void edit_place(const std::string& item, const Eigen::Vector3d& from_m, const Eigen::Vector3d& to_m) {
        for (const int k : {0, 1, 2})
            if (std::abs(to_m(k) - from_m(k)) > 1e-6)
                edit_number(item + "/" + std::string(1, "xyz"[k]), std::to_string(1e3 * to_m(k)) + " mm");
    }
    /// Opens a mesh in millimetres and makes an experiment of it.
    void open_body(const std::filesystem::path& stl, const Folder& folder) {
        driver.click("start/open");
        choose(stl);
        driver.click("unit/mm");
        ASSERT_NO_FATAL_FAILURE(wait(60));
        panel("support");
        driver.click("support/make");
        type_into("browser/path", folder.path().string());
        type_into("browser/name", "robot", false);
        driver.click("browser/open");
        ASSERT_NO_FATAL_FAILURE(wait(120));
        ASSERT_TRUE(state().scene->is_experiment) << state().log.back().text;
    }
    void mesh(const std::string& edge_mm) {
        driver.click("task/mesh");
        pick("body/element", "hex8");
        edit_number("body/edge_length", edge_mm);
        driver.click("body/build");
        ASSERT_NO_FATAL_FAILURE(wait(120));
        ASSERT_TRUE(state().body) << state().log.back().text;
    }
    /// A marker by a click on the surface, then at its measured place beside it.
    void add_marker(const std::string& name, const Eigen::Vector3d& on_surface, const Eigen::Vector3d& place_mm) {
        driver.click("probe/place");
        type_into("probe/next", name, false);
        driver.click_at(pixel_of(driver, on_surface));
        driver.settle();
        driver.click("probe/place");
        ASSERT_EQ(state().scene->markers.back().name, name) << state().refused;
        for (const int k : {0, 1, 2})
            type_into("probe/place/" + name + "/" + std::string(1, "xyz"[k]), std::to_string(place_mm(k)) + " mm");
        EXPECT_LT((state().scene->markers.back().rest_m - 1e-3 * place_mm).norm(), 1e-6) << state().refused;
    }

private:
    int edits_ = 0;
    bool could_undo_ = false;  // before the first of them
};

}  // namespace myo::test
