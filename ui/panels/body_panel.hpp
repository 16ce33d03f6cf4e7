#pragma once

#include <string>

#include "panels/panel.hpp"

namespace myo::ui::panels {

/// Task Body: opens an experiment, a mesh or a project, and shows the properties of what is open.
///
/// Emits Open; the button next to the path requests the file browser. Item names begin with "body/".
class BodyPanel : public Panel {
public:
    std::string name() const override { return "body"; }
    std::string title() const override { return "Body"; }
    PanelPlace place() const override { return PanelPlace::side; }
    std::optional<commands::Task> task() const override { return commands::Task::body; }
    void draw(PanelContext& context) override;

private:
    /// Field of the path, and the button that chooses a file.
    void draw_path(PanelContext& context);

    std::string path_;                              // text in the path field
    std::shared_ptr<const commands::Scene> scene_;  // scene whose path was written into the field
};

}  // namespace myo::ui::panels
