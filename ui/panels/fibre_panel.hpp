#pragma once

#include "panels/widgets.hpp"

namespace myo::ui::panels {

/// Edits the muscles of the body and the settings of the brush that paints them.
class FibrePanel : public Panel {
public:
    std::string name() const override { return "fibres"; }
    std::string title() const override { return "Fibres"; }
    PanelPlace place() const override { return PanelPlace::side; }
    std::optional<commands::Step> step() const override { return commands::Step::fibres; }
    void draw(PanelContext& context) override;

private:
    void draw_list(PanelContext& context);
    void draw_muscle(PanelContext& context);
    void draw_name(PanelContext& context);
    void draw_link(PanelContext& context);
    void draw_paint_actions(PanelContext& context);
    void draw_brush(PanelContext& context);

    OpenEdit edit_;
    std::string typed_name_;  // text in the name field
    bool typing_ = false;     // the name field has the keyboard
};

/// Returns an unpainted muscle with a free name and colour and the body's stiffness. Its signal contracts by a fifth
/// within half a second.
commands::Muscle new_muscle(const commands::Settings& settings);

}  // namespace myo::ui::panels
