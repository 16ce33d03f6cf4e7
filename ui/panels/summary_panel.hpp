#pragma once

#include "panels/panel.hpp"

namespace myo::ui::panels {

/// The whole model as one table: body, mesh, material, time, effects, muscles, trials. The table can be copied for a
/// notebook or a paper.
///
/// Emits nothing. Item names begin with "summary/".
class SummaryPanel : public Panel {
public:
    std::string name() const override { return "summary"; }
    std::string title() const override;
    PanelPlace place() const override { return PanelPlace::strip; }
    bool offered(const commands::WorkbenchState& state) const override { return state.scene != nullptr; }
    void draw(PanelContext& context) override;
};

}  // namespace myo::ui::panels
