#pragma once

#include "panels/panel.hpp"
#include "panels/widgets.hpp"

namespace myo::ui::panels {

/// A recording on its way to become a trial: how it is read, how it lies on the body, which label is which marker,
/// where it starts.
class ImportPanel : public Panel {
public:
    std::string name() const override { return "import"; }
    std::string title() const override { return "Import a recording"; }
    PanelPlace place() const override { return PanelPlace::side; }
    std::optional<commands::Step> step() const override { return commands::Step::measure; }
    bool offered(const commands::WorkbenchState& state) const override { return state.import != nullptr; }
    void draw(PanelContext& context) override;

private:
    void draw_file(PanelContext& context);
    void draw_placing(PanelContext& context, commands::ImportChoices& choices);
    void draw_markers(PanelContext& context, commands::ImportChoices& choices);
    void draw_name(PanelContext& context, std::size_t label, commands::ImportChoices& choices);
    void draw_start(PanelContext& context, commands::ImportChoices& choices);
    void draw_trial(PanelContext& context, commands::ImportChoices& choices);

    OpenEdit edit_;
};

/// What is still missing, and the buttons that end it; for the foot of the side.
void draw_import_controls(PanelContext& context);

}  // namespace myo::ui::panels
