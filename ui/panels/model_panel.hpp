#pragma once

#include "panels/widgets.hpp"

namespace myo {

/// Material, damping and time stepping, and the effects that were added.
class ModelPanel : public Panel {
public:
    std::string name() const override { return "model"; }
    std::string title() const override;
    PanelPlace place() const override { return PanelPlace::rail; }
    void draw(PanelContext& context) override;

private:
    void draw_numerical_damping(PanelContext& context);
    void draw_effects(PanelContext& context);

    OpenEdit edit_;
};

}  // namespace myo
