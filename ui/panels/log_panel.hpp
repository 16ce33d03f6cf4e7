#pragma once

#include <map>

#include "panels/panel.hpp"

namespace myo::ui::panels {

/// The messages of the workbench, newest last. Scrolls to a new message.
///
/// Emits nothing. The menu bar shows the newest message and links here. Item names begin with "messages/".
class LogPanel : public Panel {
public:
    std::string name() const override { return "messages"; }
    std::string title() const override;
    PanelPlace place() const override { return PanelPlace::strip; }
    void draw(PanelContext& context) override;

private:
    /// Drops all measured heights, for a new width of the lines [pixels] or scale of the text.
    void forget_heights(float width, float scale);

    std::size_t seen_ = 0;  // messages that were shown already
    // Measured heights by number since the start [pixels], valid for this width and scale.
    std::map<std::size_t, float> heights_;
    float width_ = 0.0f, scale_ = 0.0f;  // at which heights_ were measured
};

}  // namespace myo::ui::panels
