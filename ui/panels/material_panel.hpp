#pragma once

#include "panels/widgets.hpp"

namespace myo::ui::panels {

/// What the body is made of, where it is held, and the effects that were added.
class MaterialPanel : public Panel {
public:
    std::string name() const override { return "material"; }
    std::string title() const override { return "Material & support"; }
    PanelPlace place() const override { return PanelPlace::side; }
    std::optional<commands::Step> step() const override { return commands::Step::material; }
    void draw(PanelContext& context) override;

private:
    void draw_effects(PanelContext& context);

    OpenEdit edit_;
    OpenEdit preview_edit_;
};

}  // namespace myo::ui::panels
