#pragma once

#include "panels/number_field.hpp"

namespace myo::ui::panels {

/// Task Material: edits the material of the body.
///
/// Emits ChangeSettings and ChangePreview. Item names begin with "model/".
class MaterialPanel : public Panel {
public:
    std::string name() const override { return "material"; }
    std::string title() const override { return "Material"; }
    PanelPlace place() const override { return PanelPlace::side; }
    std::optional<commands::Task> task() const override { return commands::Task::material; }
    void draw(PanelContext& context) override;

private:
    /// Rows of the numbers that the chosen law has in addition to the moduli.
    void draw_law_numbers(PanelContext& context);

    NumberEdits edit_;          // edits in progress in the material fields
    NumberEdits preview_edit_;  // edit in progress in the preview length
};

}  // namespace myo::ui::panels
