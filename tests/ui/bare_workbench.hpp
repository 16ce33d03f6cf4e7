#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "commands/workbench.hpp"
#include "ui/swinging_beam.hpp"

namespace myo::test {

/// The swinging beam with few elements, so that runs take no time.
class CoarseBeam : public SwingingBeam {
public:
    static constexpr double edge_m = 0.03;

    Result<ui::commands::Scene> open(const std::filesystem::path& path, std::optional<double> metres_per_unit,
                                     const Progress& progress) override {
        Result<ui::commands::Scene> scene = SwingingBeam::open(path, metres_per_unit, progress);
        if (scene) scene->settings.resolution_m = edge_m;
        return scene;
    }
};

/// The workbench without its window: commands and what they change, without a frame being drawn.
struct BareWorkbench {
    explicit BareWorkbench(std::shared_ptr<CoarseBeam> beam = std::make_shared<CoarseBeam>())
        : backend(std::move(beam)), workbench(backend) {}

    const ui::commands::WorkbenchState& state() const { return workbench.state(); }
    const ui::commands::Settings& settings() const { return state().settings; }
    void execute(const ui::commands::Command& command) { workbench.execute(command); }

    /// Waits until no job runs. Fails the test after 20 s.
    void wait() {
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
        for (workbench.advance(0.0); state().busy(); workbench.advance(0.0)) {
            ASSERT_LT(std::chrono::steady_clock::now(), end) << state().job->name;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }
    void execute_and_wait(const ui::commands::Command& command) {
        execute(command);
        wait();
    }
    /// Opens the beam and waits for its mesh.
    void open_beam() {
        execute_and_wait(ui::commands::Open{"/beam", {}});
        ASSERT_TRUE(state().mesh_is_current());
    }
    /// Changes the edge length [m], and meshes the body.
    void mesh_with(double resolution_m) {
        change([&](ui::commands::Settings& changed) { changed.resolution_m = resolution_m; }, "resolution");
        execute_and_wait(ui::commands::BuildMesh{});
    }
    /// One edit of the settings.
    template <class Edit>
    void change(const Edit& edit, const std::string& what, bool goes_on = false) {
        ui::commands::Settings changed = settings();
        edit(changed);
        execute(ui::commands::ChangeSettings{changed, what, goes_on});
    }
    /// One edit of the experiment: its gravity, of which the beam's declaration consists.
    void declare(const std::string& gravity) {
        execute(ui::commands::EditDeclaration{
            {ui::commands::SetDeclared{{"gravity", "acceleration_m_s2"}, gravity}}, "gravity", false});
    }
    /// Newest message of the log.
    std::string last_message() const { return state().log.empty() ? "" : state().log.back().text; }

    std::shared_ptr<CoarseBeam> backend;
    ui::commands::Workbench workbench;
};

}  // namespace myo::test
