#pragma once

#include "panels/widgets.hpp"

namespace myo::ui::panels {

/// Edits the material of the body; shows its support, gravity, and the effects that the user added.
class MaterialPanel : public Panel {
public:
    std::string name() const override { return "material"; }
    std::string title() const override { return "Material & support"; }
    PanelPlace place() const override { return PanelPlace::side; }
    std::optional<commands::Step> step() const override { return commands::Step::material; }
    void draw(PanelContext& context) override;

private:
    /// List of the added effects with a button to remove each. Draws nothing without any.
    void draw_effects(PanelContext& context);

    OpenEdit edit_;          // drag in progress in the material fields
    OpenEdit preview_edit_;  // drag in progress in the preview length
};

}  // namespace myo::ui::panels
