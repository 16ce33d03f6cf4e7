#pragma once

#include <optional>

#include "commands/body_cut.hpp"
#include "commands/field_store.hpp"
#include "commands/scene_at_time.hpp"
#include "panels/panel.hpp"
#include "viewport/scene_renderer.hpp"
#include "viewport/viewport.hpp"

namespace myo::ui::panels {

/// The newest compared run, drawn next to the shown one with the same camera, time and colours. Used on the UI thread.
class ComparedView {
public:
    /// Creates the view. Requires a current OpenGL context.
    /// Error: a shader does not compile.
    static Result<ComparedView> make();

    /// The record that is drawn; null if the view shows one run only, during an import, and if the record has no mesh.
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
    /// Renders the scene and copies it into a window of `height` pixels, at the place where draw() put it.
    ///
    /// @param moving  the camera or the motion moves: fewer samples per pixel
    ///
    /// Error: the driver refuses the size.
    Result<void> render(const platform::Theme& theme, int height, bool moving);

    /// Values of the field are still being computed.
    bool waits() const { return fields_.waits(); }
    /// The drawn scene, for tests.
    const viewport::DrawnScene& scene() const { return scene_; }

private:
    viewport::SceneRenderer renderer_;
    viewport::ViewportState viewport_;    // place in the window, and camera of the shown view
    commands::FieldStore fields_;         // values on the compared run, which may have another mesh
    commands::BodyCut cut_;               // clip plane of the view, applied to the compared body
    viewport::DrawnScene scene_;          // see scene()
    std::optional<std::uint64_t> drawn_;  // revision of the shown scene that scene_ belongs to
    std::uint64_t revision_ = 0;          // of scene_
};

/// Name of a run over its half of the view.
void draw_run_name(const platform::Theme& theme, const platform::Rectangle& view, const std::string& name);

}  // namespace myo::ui::panels
