#include "panels/placing_tools.hpp"

#include "panels/escape.hpp"
#include "panels/view_points.hpp"

namespace myo::ui::panels {

using Kind = Placing::Kind;

// Faces and cavities are taken by a click and not by a press, so a drag turns the camera.
bool PlacingTools::takes(const PanelContext& context, const viewport::DrawnScene& scene,
                         const viewport::ViewportState& view, const Eigen::Vector2d& pixel) const {
    const double reach = static_cast<double>(marker_reach * context.theme.scale);
    if (context.placing.sets(Kind::markers)) return markers_.takes(context.state, scene, view, pixel, reach);
    if (context.placing.sets(Kind::guides))
        return guides_.takes(context.state, context.placing, scene, view, pixel, reach);
    return false;
}

void PlacingTools::follow(PanelContext& context, viewport::ViewportState& view) {
    const commands::WorkbenchState& state = context.state;
    const bool began = context.placing.kind != kind_ && context.placing.on();
    const bool brush = state.brush.tool != commands::BrushTool::none;
    if (began) {
        cancel();
        // The newest tool gets the clicks.
        view.measuring = false;
        commands::BrushSettings none = state.brush;
        none.tool = commands::BrushTool::none;
        if (brush) context.emit(commands::ChangeBrush{none});
        // Measuring or the brush was switched on later.
    } else if (context.placing.on() && (view.measuring || brush)) {
        context.placing = {};
    }
    // Places are declared on the meshed body at rest, which an import or another experiment replaces.
    if (!state.body || state.import || state.scene->path != path_) context.placing = {};
    path_ = state.scene->path;
}

bool PlacingTools::update(PanelContext& context, const viewport::DrawnScene& scene, viewport::ViewportState& view) {
    follow(context, view);
    // The first Escape drops what was begun, the second one ends the tool.
    if (context.placing.on() && escape_closes() && !cancel()) context.placing = {};
    kind_ = context.placing.kind;
    if (!context.placing.on()) {
        cancel();
        region_.clear();
        return false;
    }
    const ToolView tool{context, scene, view, surface_.of(*context.state.scene)};
    if (kind_ == Kind::markers) markers_.update(tool, context.placing);
    if (kind_ == Kind::guides) guides_.update(tool, context.placing);
    if (kind_ == Kind::box || kind_ == Kind::cavity) region_.update(tool, context.placing);
    return true;
}

void PlacingTools::show(const Placing& placing, const platform::Theme& theme, viewport::DrawnScene& drawn) const {
    if (placing.sets(Kind::markers)) markers_.show(drawn);
    if (placing.sets(Kind::guides)) guides_.show(theme, drawn);
    if (placing.sets(Kind::box) || placing.sets(Kind::cavity)) region_.show(theme, drawn);
}

bool PlacingTools::cancel() {
    // Both are cancelled, not only the first that has something.
    const bool marker = markers_.cancel(), guide = guides_.cancel();
    return marker || guide;
}

}  // namespace myo::ui::panels
