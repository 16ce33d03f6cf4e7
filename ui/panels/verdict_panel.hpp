#pragma once

#include "panels/panel.hpp"

namespace myo::ui::panels {

/// Shows the verdict of the diagnosis in words, with confidence and errors; the ranking is below the view.
class VerdictPanel : public Panel {
public:
    std::string name() const override { return "verdict"; }
    std::string title() const override { return "What the model lacks"; }
    PanelPlace place() const override { return PanelPlace::side; }
    std::optional<commands::Step> step() const override { return commands::Step::diagnose; }
    void draw(PanelContext& context) override;
};

}  // namespace myo::ui::panels
