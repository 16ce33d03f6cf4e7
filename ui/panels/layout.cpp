#include "panels/layout.hpp"

#include <algorithm>
#include <cmath>

namespace myo::ui::panels {

// All sizes are rounded to whole pixels, so that text in the parts stays sharp.
Layout make_layout(float width, float height, float scale, const commands::LayoutSizes& sizes) {
    // Fixed sizes [pixels at scale 1]: edges that can be dragged, menu bar and timeline.
    const float edge = std::round(4.0f * scale);
    const float bar = std::round(44.0f * scale);
    const float timeline = std::round(44.0f * scale);
    Layout layout;
    layout.narrow = width < 1000.0f * scale;
    // Narrow windows show icons only for the tasks.
    const float steps = std::round((layout.narrow ? 44.0f : 128.0f) * scale);
    // The limits keep room for the view and for a usable panel, in a window of any size.
    // With the tasks the side panel takes at most 60 % of the width; alone it has at least 240 pixels at scale 1, less
    // only where tasks and panel would exceed half of the window.
    const float rail = steps + std::round(std::clamp(sizes.rail * scale, std::min(240.0f * scale, 0.5f * width - steps),
                                                     0.6f * width - steps));
    const float strip = std::round(
        std::clamp(sizes.strip * scale, 80.0f, std::max(80.0f, 0.5f * (height - bar - timeline))));
    const float left = rail + edge;
    const float strip_top = height - strip;
    const float timeline_top = strip_top - edge - timeline;
    layout.bar = {{0.0f, 0.0f}, {width, bar}};
    layout.steps = {{0.0f, bar}, {steps, height}};
    layout.rail = {{steps, bar}, {rail, height}};
    layout.rail_edge = {{rail, bar}, {left, height}};
    // Each part begins where the one before ends, so that no pixel of the window is left unpainted.
    layout.view = {{left, bar}, {width, timeline_top}};
    layout.timeline = {{left, timeline_top}, {width, timeline_top + timeline}};
    layout.strip_edge = {{left, strip_top - edge}, {width, strip_top}};
    layout.strip = {{left, strip_top}, {width, height}};
    return layout;
}

Layout beside_help(Layout layout, float scale) {
    // Width of the help [pixels at scale 1], at most this share of the room that the view and the help share.
    constexpr float preferred = 380.0f, share = 0.55f;
    const float right = layout.view.highest.x,
                left = right - std::round(std::min(preferred * scale, share * layout.view.width()));
    layout.help = {{left, layout.view.lowest.y}, {right, layout.strip.highest.y}};
    for (platform::Rectangle* part : {&layout.view, &layout.timeline, &layout.strip, &layout.strip_edge})
        part->highest.x = left;
    return layout;
}

}  // namespace myo::ui::panels
