#pragma once

#include <optional>

#include "commands/body_cut.hpp"
#include "commands/field_store.hpp"
#include "commands/scene_at_time.hpp"
#include "panels/panel.hpp"
#include "viewport/scene_renderer.hpp"
#include "viewport/viewport.hpp"

namespace myo::ui::panels {

/// The newest compared run, drawn beside the shown one with the same camera, time and colours. Used on the UI thread.
class ComparedView {
public:
    /// Error: a shader does not compile.
    static Result<ComparedView> make();

    /// The record that is drawn; null if the view shows one run only.
    static const commands::JobRecord* record(const commands::WorkbenchState& state);

    /// Creates the scene again if it may have changed. Requires record().
    ///
    /// @param shown     scene of the shown run, whose range of colours is used
    /// @param revision  of that scene: another number means that anything may have changed
    void update(const commands::WorkbenchState& state, const platform::Theme& theme, const commands::Backend& backend,
                const viewport::DrawnScene& shown, std::uint64_t revision);
    /// Draws what lies over the image, into the current ImGui window, and moves the camera of the shown view with the
    /// mouse.
    void draw(PanelContext& context, viewport::ViewportState& shown);
    /// Renders the scene and copies it into a window of `height` pixels.
    ///
    /// Error: the driver refuses the size.
    Result<void> render(const platform::Theme& theme, int height, bool moving);

    /// Values of the field are still being computed.
    bool waits() const { return fields_.waits(); }
    /// The drawn scene, for tests.
    const viewport::DrawnScene& scene() const { return scene_; }

private:
    viewport::SceneRenderer renderer_;
    viewport::ViewportState viewport_;
    commands::FieldStore fields_;
    commands::BodyCut cut_;
    viewport::DrawnScene scene_;
    std::optional<std::uint64_t> drawn_;  // revision of the shown scene that scene_ belongs to
    std::uint64_t revision_ = 0;          // of scene_
};

/// Name of a run over its half of the view.
void draw_run_name(const platform::Theme& theme, const platform::Rectangle& view, const std::string& name);

}  // namespace myo::ui::panels
